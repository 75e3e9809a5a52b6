// The card's own numbered variables, shared by the host and buffered commands.
// Source: public header. Tested by tests/gtcalls/user_variable_command_test.cc.
#include "gtcalls/gts/commands/commands.h"

namespace oncard::gtcalls::gts {
namespace {

/// The catalogue's range ensures a number below kUserVariableCount.
size_t IndexOf(const Call& call) { return static_cast<size_t>(call.integer(0)); }

}  // namespace

int16_t GT_SetLongVar(Call& call) {
  call.card.state<GtsState>().long_vars[IndexOf(call)] = call.integer(1);
  return vm::kOk;
}

int16_t GT_GetLongVar(Call& call) {
  call.Set(1, call.card.state<GtsState>().long_vars[IndexOf(call)]);
  return vm::kOk;
}

int16_t GT_SetDoubleVar(Call& call) {
  call.card.state<GtsState>().double_vars[IndexOf(call)] = call.value(1);
  return vm::kOk;
}

int16_t GT_GetDoubleVar(Call& call) {
  call.Set(1, call.card.state<GtsState>().double_vars[IndexOf(call)]);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
