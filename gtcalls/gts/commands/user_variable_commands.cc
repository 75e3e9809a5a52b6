// The card's own numbered variables, shared by the host and buffered commands.
// Source: public header. Tested by tests/gtcalls/user_variable_command_test.cc.
#include "gtcalls/gts/commands/commands.h"

namespace oncard::gtcalls {
namespace {

/// The catalogue's range keeps the number below motion::kUserVariableCount.
size_t IndexOf(const Call& call) { return static_cast<size_t>(call.integer(0)); }

int16_t SetLongVar(Call& call) {
  call.card.motion.state().long_vars[IndexOf(call)] = call.integer(1);
  return vm::kOk;
}

int16_t GetLongVar(Call& call) {
  call.Set(1, call.card.motion.state().long_vars[IndexOf(call)]);
  return vm::kOk;
}

int16_t SetDoubleVar(Call& call) {
  call.card.motion.state().double_vars[IndexOf(call)] = call.value(1);
  return vm::kOk;
}

int16_t GetDoubleVar(Call& call) {
  call.Set(1, call.card.motion.state().double_vars[IndexOf(call)]);
  return vm::kOk;
}

constexpr CommandEntry kEntries[] = {
    {"GT_SetLongVar", SetLongVar},
    {"GT_GetLongVar", GetLongVar},
    {"GT_SetDoubleVar", SetDoubleVar},
    {"GT_GetDoubleVar", GetDoubleVar},
};

}  // namespace

std::span<const CommandEntry> UserVariableCommands() { return kEntries; }

}  // namespace oncard::gtcalls
