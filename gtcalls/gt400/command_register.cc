#include "gtcalls/gt400/command_register.h"

#include <algorithm>

#include "gtcalls/card.h"
#include "gtcalls/gt400/events.h"
#include "gtcalls/gt400/gt400_state.h"

namespace oncard::gtcalls::gt400 {
namespace {

bool IsOperating(const Command& command) {
  return std::ranges::any_of(command.accesses, &Access::write);
}

bool IsPathCommand(const Command& command) {
  return std::ranges::any_of(command.accesses, [](const Access& access) {
    return access.resource == Resource::kCrd && access.write;
  });
}

}  // namespace

int16_t WriteCommandRegister(Call& call, int16_t code) {
  if (code < 0 || code == vm::kBadParameter || code == kNotSimulated) return code;
  const bool refused = code != vm::kOk;
  if (!refused && !IsOperating(call.command)) return code;
  Gt400State& state = call.card.state<Gt400State>();
  state.command_register = refused ? call.cause : uint16_t{0};
  if (IsPathCommand(call.command)) {
    state.path_refused = refused;
  } else if (refused) {
    SetEvents(call.card, state.current, kRefusedBit);
  }
  return code;
}

}  // namespace oncard::gtcalls::gt400
