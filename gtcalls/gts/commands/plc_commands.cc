// Binds PLC blocks to variables. A block's variables are those of the function that a thread runs,
// or the globals if the thread is -1; all of them have type int.
// Source: public header of the thread extensions; meanings are assumed from its names.
// Tested by tests/gtcalls/plc_command_test.cc.
#include "gtcalls/gts/commands/commands.h"
#include "gtcalls/gts/numbers.h"

namespace oncard::gtcalls::gts {
namespace {

/// TBindCounter.resetVarId of a counter that is never reset.
constexpr int kNoVariable = -1;

int ThreadOf(const Call& call) { return call.integer(0); }
int VariableOf(const Call& call) { return static_cast<int>(call.cells(1)[0]); }
/// A member of the block's structure.
int Prm(const Call& call, size_t member) { return static_cast<int>(call.cells(2)[member]); }

int16_t Reject(Call& call, Message why) { return call.Refuse(vm::kBadParameter, std::move(why)); }

/// 0, or the refusal if the member is out of range.
int16_t CheckPrm(Call& call, size_t member, double minimum, double maximum) {
  const double value = call.cells(2)[member];
  if (value >= minimum && value <= maximum) return vm::kOk;
  const Structure& structure = *call.command.parameters[2].structure;
  return Reject(call, MakeMessage("{0}.{1} is {2}; the range is [{3}, {4}]",
                                  "{0}.{1} 为 {2}；取值范围为 [{3}, {4}]", structure.name,
                                  structure.members[member].name, value, minimum, maximum));
}

/// 0, or the refusal if the thread has no variables: it is not bound, or it is -1 and no program is
/// loaded.
int16_t CheckThread(Call& call) {
  const vm::Machine& machine = call.card.machine;
  const int thread = ThreadOf(call);
  if (thread == kGlobalVariables) {
    if (machine.image() != nullptr) return vm::kOk;
    return call.Refuse(vm::kRefused, MakeMessage("no program is downloaded; call GT_Download first",
                                                 "没有下载程序；应先调用 GT_Download"));
  }
  const vm::ThreadState& state = machine.thread(thread);
  if (state.run != vm::ThreadRun::kUnbound) return vm::kOk;
  return call.Refuse(vm::kRefused, DescribeThread(thread, state));
}

/// 0, or the refusal if the slot is not an int variable of the thread.
int16_t CheckVariable(Call& call, int id) {
  const vm::Machine& machine = call.card.machine;
  const int thread = ThreadOf(call);
  const vm::Object& object = machine.image()->object;
  const bool exists = id >= 0 && id < vm::kSlotCount;
  if (exists && HasNoSymbols(*machine.image())) return vm::kOk;
  const std::vector<vm::Symbol>& symbols =
      thread == kGlobalVariables ? object.globals
                                 : object.functions[machine.thread(thread).function].variables;
  if (exists && DeclaredType(symbols, id) == vm::DataType::kInt) return vm::kOk;
  return Reject(call, MakeMessage("{0} is not the id of an int variable; take it from GT_GetVarId",
                                  "{0} 不是 int 变量的标识；应由 GT_GetVarId 取得", id));
}

/// 0, or the refusal if the thread, the block's own variable or one of its inputs cannot be used.
int16_t CheckVariables(Call& call, std::initializer_list<int> inputs) {
  if (const int16_t code = CheckThread(call)) return code;
  if (const int16_t code = CheckVariable(call, VariableOf(call))) return code;
  for (const int id : inputs) {
    if (const int16_t code = CheckVariable(call, id)) return code;
  }
  return vm::kOk;
}

/// The current value of an input: an input that is already on then causes no edge.
bool IsOn(const Call& call, int id) {
  const vm::Machine& machine = call.card.machine;
  const int thread = ThreadOf(call);
  const bool global = thread == kGlobalVariables;
  return machine.ReadRaw({.global = global,
                          .page = global ? uint8_t{0} : machine.thread(thread).page,
                          .id = static_cast<uint16_t>(id)}) != 0;
}

int16_t Add(Call& call, const PlcFunction& function) {
  const PlcBlock block = {.thread = static_cast<int16_t>(ThreadOf(call)),
                          .variable = static_cast<uint16_t>(VariableOf(call)),
                          .function = function};
  if (call.card.state<GtsState>().plc.Bind(block)) return vm::kOk;
  return call.Refuse(
      vm::kRefused,
      MakeMessage("{0} blocks are bound and no more fit; call GT_UnbindVar",
                  "已绑定 {0} 个功能块，不能再增加；可调用 GT_UnbindVar", kPlcBlockMax));
}

}  // namespace

// --- Commands --------------------------------------------------------------------------------

int16_t GT_BindDi(Call& call) {
  if (const int16_t code = CheckPrm(call, 0, 0, kInputWordLast)) return code;
  const motion::DiType type = *DiTypeOf(Prm(call, 0));
  if (const int16_t code = CheckPrm(call, 1, 1, DiWidth(type))) return code;
  if (const int16_t code = CheckVariables(call, {})) return code;
  return Add(call, DiBlock{.type = type,
                           .bit = static_cast<int16_t>(Prm(call, 1) - 1),
                           .reverse = Prm(call, 2) != 0});
}

int16_t GT_BindDo(Call& call) {
  if (const int16_t code = CheckPrm(call, 0, kOutputWordFirst, kOutputWordLast)) return code;
  const motion::DoType type = *DoTypeOf(Prm(call, 0));
  if (const int16_t code = CheckPrm(call, 1, 1, DoWidth(type))) return code;
  if (const int16_t code = CheckVariables(call, {})) return code;
  return Add(call, DoBlock{.type = type,
                           .bit = static_cast<int16_t>(Prm(call, 1) - 1),
                           .reverse = Prm(call, 2) != 0});
}

int16_t GT_BindTimer(Call& call) {
  if (const int16_t code = CheckPrm(call, 0, 0, 2)) return code;
  if (const int16_t code = CheckPrm(call, 1, 0, INT32_MAX)) return code;
  const int input = Prm(call, 2);
  if (const int16_t code = CheckVariables(call, {input})) return code;
  return Add(call, TimerBlock{.type = static_cast<TimerType>(Prm(call, 0)),
                              .input = static_cast<uint16_t>(input),
                              .delay_us = int64_t{Prm(call, 1)} * 1000});
}

int16_t GT_BindCounter(Call& call) {
  if (const int16_t code = CheckPrm(call, 0, 0, 2)) return code;
  if (const int16_t code = CheckPrm(call, 1, 0, 2)) return code;
  for (const size_t member : {2U, 3U, 4U}) {
    if (const int16_t code = CheckPrm(call, member, INT32_MIN, INT32_MAX)) return code;
  }
  const int init = Prm(call, 2);
  const int begin = Prm(call, 4);
  const int end = Prm(call, 5);
  if (const int16_t code = CheckPrm(call, 5, begin, INT32_MAX)) return code;
  if (begin < end) {
    if (const int16_t code = CheckPrm(call, 2, begin, end)) return code;
  }
  if (const int16_t code = CheckPrm(call, 6, -1, 1)) return code;
  if (const int16_t code = CheckPrm(call, 7, 1, UINT32_MAX)) return code;
  const int input = Prm(call, 8);
  const int reset = Prm(call, 9);
  const int16_t code =
      reset == kNoVariable ? CheckVariables(call, {input}) : CheckVariables(call, {input, reset});
  if (code != vm::kOk) return code;
  return Add(call, CounterBlock{.type = static_cast<CounterType>(Prm(call, 0)),
                                .edge = static_cast<Edge>(Prm(call, 1)),
                                .init = init,
                                .target = Prm(call, 3),
                                .begin = begin,
                                .end = end,
                                .down = Prm(call, 6) < 0,
                                .unit = BitWord(call.cells(2)[7]),
                                .input = static_cast<uint16_t>(input),
                                .reset = static_cast<int16_t>(reset),
                                .count = init,
                                .last_input = IsOn(call, input)});
}

int16_t GT_BindFlank(Call& call) {
  if (const int16_t code = CheckPrm(call, 0, 0, 2)) return code;
  const int input = Prm(call, 1);
  if (const int16_t code = CheckVariables(call, {input})) return code;
  return Add(call, FlankBlock{.edge = static_cast<Edge>(Prm(call, 0)),
                              .input = static_cast<uint16_t>(input),
                              .last_input = IsOn(call, input)});
}

int16_t GT_BindSrff(Call& call) {
  const int set = Prm(call, 0);
  const int reset = Prm(call, 1);
  if (const int16_t code = CheckVariables(call, {set, reset})) return code;
  return Add(call, SrffBlock{.set = static_cast<uint16_t>(set),
                             .reset = static_cast<uint16_t>(reset),
                             .output = false});
}

int16_t GT_UnbindVar(Call& call) {
  call.card.state<GtsState>().plc.Unbind(ThreadOf(call));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
