// Downloads a program word by word: GT_ClearPlc clears the program memory, GT_LoadPlc begins a
// function, GT_LoadPlcCommand appends words of its records, as in a `.bin` file.
//
// Assumption: no public source says when such a program takes effect. Here the words wait until
// GT_Bind is called for one of their functions; then all of them together become the program, as
// after a download: every thread unbound, every variable 0. There are no names, so variables are
// accessed by their ids (TVarInfo.id and dataType).
// Source: public header of the thread extensions; sizes from GTS manual 10.3.
// Tested by tests/gtcalls/plc_word_command_test.cc.
#include <algorithm>
#include <utility>

#include "gtcalls/gts/commands/commands.h"
#include "vm/record.h"

namespace oncard::gtcalls::gts {
namespace {

/// 0, or the refusal if a thread is executing the program.
int16_t CheckNoThreadActive(Call& call) {
  for (int i = 0; i < vm::kThreadCount; ++i) {
    const vm::ThreadState& thread = call.card.machine.thread(i);
    if (IsActive(thread)) return call.Refuse(vm::kRefused, DescribeThread(i, thread));
  }
  return vm::kOk;
}

WordFunction* FindWords(PlcBlocks& plc, int id) {
  const auto found = std::find_if(plc.functions.begin(), plc.functions.end(),
                                  [&](const WordFunction& function) { return function.id == id; });
  return found == plc.functions.end() ? nullptr : &*found;
}

}  // namespace

/// Clears the program memory: the loaded program and the words received.
int16_t GT_ClearPlc(Call& call) {
  if (const int16_t code = CheckNoThreadActive(call)) return code;
  call.card.state<GtsState>().plc = {};
  call.card.machine.Load(nullptr);
  return vm::kOk;
}

/// Begins a function; one that exists already is emptied.
int16_t GT_LoadPlc(Call& call) {
  const int id = call.integer(0);
  const int type = call.integer(1);
  if (id < 1 || id > vm::kFunctionMax) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("function id {0} is out of range; ids are 1 to {1}",
                                   "函数标识 {0} 超出范围；应为 1 到 {1}", id, vm::kFunctionMax));
  }
  if (type < static_cast<int>(vm::DataType::kVoid) ||
      type > static_cast<int>(vm::DataType::kDouble)) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("return type {0} is not known; 0 (void), 1 (int) or 2 (double) is expected",
                    "未知的返回类型 {0}；应为 0（void）、1（int）或 2（double）", type));
  }
  PlcBlocks& plc = call.card.state<GtsState>().plc;
  const auto place = std::find_if(plc.functions.begin(), plc.functions.end(),
                                  [&](const WordFunction& function) { return function.id >= id; });
  WordFunction function = {
      .id = static_cast<int16_t>(id), .return_type = static_cast<vm::DataType>(type), .words = {}};
  if (place != plc.functions.end() && place->id == id) {
    *place = std::move(function);
  } else {
    plc.functions.insert(place, std::move(function));
  }
  plc.functions_pending = true;
  return vm::kOk;
}

int16_t GT_LoadPlcCommand(Call& call) {
  PlcBlocks& plc = call.card.state<GtsState>().plc;
  WordFunction* function = FindWords(plc, call.integer(0));
  if (function == nullptr) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("function {0} is not open; call GT_LoadPlc first",
                                   "函数 {0} 未打开；应先调用 GT_LoadPlc", call.integer(0)));
  }
  const std::span<const double> words = call.cells(2);
  size_t used = words.size();
  for (const WordFunction& other : plc.functions) used += other.words.size();
  if (used > kPlcWordMax) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("{0} words do not fit; the memory has {1}",
                                   "存储区容纳不下 {0} 个字；容量为 {1} 个字", used, kPlcWordMax));
  }
  for (const double word : words) {
    function->words.push_back(static_cast<uint16_t>(static_cast<int32_t>(word)));
  }
  plc.functions_pending = true;
  return vm::kOk;
}

namespace {

/// The functions as an object without symbols.
Result<vm::Object> Assemble(const std::vector<WordFunction>& functions) {
  vm::Object object;
  for (const WordFunction& source : functions) {
    if (static_cast<size_t>(source.id) != object.functions.size() + 1) {
      return MakeError(vm::kBadParameter,
                       "function {0} is missing; ids must follow each other from 1",
                       "缺少函数 {0}；标识应从 1 起连续编号", object.functions.size() + 1);
    }
    vm::Function function;
    function.return_type = source.return_type;
    std::span<const uint16_t> words = source.words;
    while (!words.empty()) {
      auto record = vm::DecodeRecord(words);
      if (!record.ok()) return record.error();
      function.instructions.push_back(std::move(record.value().instruction));
      words = words.subspan(record.value().word_count);
    }
    function.lines.assign(function.instructions.size(), 0);
    object.functions.push_back(std::move(function));
  }
  return object;
}

}  // namespace

int16_t LinkPendingWords(Call& call, int function_id) {
  PlcBlocks& plc = call.card.state<GtsState>().plc;
  if (!plc.functions_pending || FindWords(plc, function_id) == nullptr) return vm::kOk;
  if (const int16_t code = CheckNoThreadActive(call)) return code;
  auto object = Assemble(plc.functions);
  if (!object.ok()) return call.Refuse(vm::kBadParameter, object.error().message);
  const CardCommands commands(&call.card);
  auto image = vm::LinkObject(std::move(object).value(), commands, vm::Symbols::kAbsent);
  if (!image.ok()) return call.Refuse(vm::kBadParameter, image.error().message);
  plc.UnbindAll();
  plc.functions_pending = false;
  call.card.machine.Load(std::move(image).value());
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
