// Internal to gtcalls: the commands of GT400 cards, one function each, and what they have in
// common. As in gtcalls/gts/commands, arguments have passed the checks of the catalogue, and a
// refused command changes nothing but the command register and the event bit of the current axis.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"
#include "gtcalls/gt400/command_register.h"
#include "gtcalls/gt400/gt400_state.h"

namespace oncard::gtcalls::gt400 {

#define COMMAND(number, name, ...) int16_t name(Call& call);
#include "gtcalls/gt400/catalogue.def"

inline Gt400State& StateOf(const Call& call) { return call.card.state<Gt400State>(); }
/// The current axis, counted from 0.
inline size_t CurrentAxis(const Call& call) { return StateOf(call).current; }
inline Gt400Axis& CurrentState(const Call& call) { return StateOf(call).axes[CurrentAxis(call)]; }

/// Refuses a command with 1.
int16_t RefuseFor(Call& call, CommandCause cause, Message why);
/// 0, or 1 on a card without voltages.
int16_t CheckServoCard(Call& call);
/// 0, or 1 with this cause while the current axis moves or is a gear slave.
int16_t CheckAtRest(Call& call, CommandCause cause);
/// 0, or 1 for a position that no register holds.
int16_t CheckPosition(Call& call, double position);

}  // namespace oncard::gtcalls::gt400
