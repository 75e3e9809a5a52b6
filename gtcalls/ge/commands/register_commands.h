// The bodies of commands that write or read one register of an axis, whose number is their first
// argument: what they write waits for GT_Update. Tested by
// tests/gtcalls/ge/servo_command_test.cc and motion_command_test.cc.
#pragma once

#include <type_traits>

#include "gtcalls/ge/commands/commands.h"

namespace oncard::gtcalls::ge {

template <auto kRegister>
int16_t WriteRegister(Call& call) {
  auto& waiting = (GeAxisOf(call).registers.*kRegister).waiting;
  waiting = static_cast<std::remove_reference_t<decltype(waiting)>>(call.value(1));
  return vm::kOk;
}

template <auto kRegister>
int16_t ReadRegister(Call& call) {
  call.Set(1, (GeAxisOf(call).registers.*kRegister).waiting);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::ge
