// The host's access to a motion program's variables.
//
// A variable's slot has no type of its own; the type comes from the program's symbols. For a data
// page these are the symbols of the function that a thread bound to that page runs; if no thread
// uses the page, those of the first function that declares the slot as TVarInfo describes it. A
// program downloaded word by word declares nothing: there only TVarInfo gives the type.
// Source: GTS manual 10.3.5 and chapter 13. Tested by tests/gtcalls/variable_command_test.cc.
#include <array>

#include "gtcalls/gts/commands/commands.h"

namespace oncard::gtcalls::gts {
namespace {

using vm::DataType;
using vm::Symbol;

constexpr int kGlobalPage = -1;
/// Variables per call (GTS manual chapter 13).
constexpr size_t kCountMax = 6;

/// The variables that a call reads or writes.
struct Target {
  int page = kGlobalPage;
  int id = 0;
  int data_type = 0;  ///< as TVarInfo says
  int count = 1;
};

Target TargetOf(const Call& call) {
  return {.page = call.integer(0),
          .id = static_cast<int>(call.cells(1)[0]),
          .data_type = static_cast<int>(call.cells(1)[1]),
          .count = call.integer(3)};
}

/// The function of the thread that is bound to a page, nullptr if there is none.
const vm::Function* FunctionOfPage(const vm::Machine& machine, int page) {
  for (int i = 0; i < vm::kThreadCount; ++i) {
    const vm::ThreadState& thread = machine.thread(i);
    if (thread.run != vm::ThreadRun::kUnbound && thread.page == page) {
      return &machine.image()->object.functions[thread.function];
    }
  }
  return nullptr;
}

/// The symbols with the types of the target's slots, nullptr if there are none.
const std::vector<Symbol>* SymbolsFor(const vm::Machine& machine, const Target& target) {
  const vm::Object& object = machine.image()->object;
  if (target.page == kGlobalPage) return &object.globals;
  if (const vm::Function* function = FunctionOfPage(machine, target.page)) {
    return &function->variables;
  }
  for (const vm::Function& function : object.functions) {
    const std::optional<DataType> type = DeclaredType(function.variables, target.id);
    if (type && static_cast<int>(*type) == target.data_type) return &function.variables;
  }
  return nullptr;
}

std::optional<DataType> TypeFromInfo(const Target& target, int id) {
  if (id < 0 || id >= vm::kSlotCount) return std::nullopt;
  switch (target.data_type) {
    case static_cast<int>(DataType::kInt):
      return DataType::kInt;
    case static_cast<int>(DataType::kDouble):
      return DataType::kDouble;
    default:
      return std::nullopt;
  }
}

using Slots = std::array<vm::SlotAddress, kCountMax>;

/// The slots of the target; empty, with the reason recorded, if one of them is not a variable.
std::optional<Slots> FindSlots(Call& call, const Target& target) {
  const vm::Machine& machine = call.card.machine;
  if (machine.image() == nullptr) {
    call.reason = MakeMessage("no program is downloaded; call GT_Download first",
                              "没有下载程序；应先调用 GT_Download");
    return std::nullopt;
  }
  const bool no_symbols = HasNoSymbols(*machine.image());
  const std::vector<Symbol>* symbols = no_symbols ? nullptr : SymbolsFor(machine, target);
  const bool global = target.page == kGlobalPage;
  Slots slots;
  for (int i = 0; i < target.count; ++i) {
    const int id = target.id + i;
    std::optional<DataType> type;
    if (no_symbols) type = TypeFromInfo(target, id);
    if (symbols != nullptr) type = DeclaredType(*symbols, id);
    if (!type) {
      call.reason = MakeMessage(
          "slot {0} of page {1} is not a variable of the program; take TVarInfo from GT_GetVarId",
          "数据页 {1} 的存储单元 {0} 不是程序的变量；应由 GT_GetVarId 取得 TVarInfo", id,
          target.page);
      return std::nullopt;
    }
    slots[static_cast<size_t>(i)] = {.global = global,
                                     .page = static_cast<uint8_t>(global ? 0 : target.page),
                                     .id = static_cast<uint16_t>(id),
                                     .type = *type};
  }
  return slots;
}

Message DescribeMisfit(const vm::SlotAddress& slot, double value) {
  return MakeMessage("variable {0} is of type {1} and cannot hold {2}",
                     "变量 {0} 的类型为 {1}，不能存放 {2}", slot.id,
                     slot.type == DataType::kInt ? "int" : "double", value);
}

}  // namespace

int16_t GT_SetVarValue(Call& call) {
  const Target target = TargetOf(call);
  const std::optional<Slots> slots = FindSlots(call, target);
  if (!slots) return vm::kBadParameter;
  vm::Machine& machine = call.card.machine;
  std::array<int64_t, kCountMax> before{};
  for (size_t i = 0; i < static_cast<size_t>(target.count); ++i) {
    const vm::SlotAddress& slot = (*slots)[i];
    before[i] = machine.ReadRaw(slot);
    if (machine.Write(slot, call.cells(2)[i])) continue;
    while (i-- > 0) machine.WriteRaw((*slots)[i], before[i]);
    const auto cell = static_cast<size_t>(slot.id - target.id);
    return call.Refuse(vm::kBadParameter, DescribeMisfit(slot, call.cells(2)[cell]));
  }
  return vm::kOk;
}

int16_t GT_GetVarValue(Call& call) {
  const Target target = TargetOf(call);
  const std::optional<Slots> slots = FindSlots(call, target);
  if (!slots) return vm::kBadParameter;
  for (size_t i = 0; i < static_cast<size_t>(target.count); ++i) {
    call.Set(2, call.card.machine.Read((*slots)[i]), i);
  }
  return vm::kOk;
}

std::optional<vm::SlotAddress> FindVariable(Call& call, int page, std::span<const double> info,
                                            double value) {
  const Target target = {
      .page = page, .id = static_cast<int>(info[0]), .data_type = static_cast<int>(info[1])};
  const std::optional<Slots> slots = FindSlots(call, target);
  if (!slots) return std::nullopt;
  const vm::SlotAddress slot = slots->front();
  vm::Machine& machine = call.card.machine;
  const int64_t before = machine.ReadRaw(slot);
  const bool fits = machine.Write(slot, value);
  machine.WriteRaw(slot, before);
  if (fits) return slot;
  call.reason = DescribeMisfit(slot, value);
  return std::nullopt;
}

bool HasNoSymbols(const vm::Image& image) {
  const std::vector<vm::Function>& functions = image.object.functions;
  return !functions.empty() && functions.front().name.empty();
}

std::optional<DataType> DeclaredType(const std::vector<Symbol>& symbols, int id) {
  for (const Symbol& symbol : symbols) {
    if (id >= symbol.id && id < symbol.id + symbol.slots()) return symbol.type;
  }
  return std::nullopt;
}

}  // namespace oncard::gtcalls::gts
