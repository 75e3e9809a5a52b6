// Breakpoints: what the card does when an axis comes to a place, ends a motion, or captures. Each
// axis has one, which is judged in every tick and acts once. Source: GT manual 4.3.2. Tested by
// tests/gtcalls/gt400/breakpoint_command_test.cc.
#pragma once

#include <cstddef>

#include "gtcalls/card.h"
#include "gtcalls/gt400/gt400_state.h"

namespace oncard::gtcalls::gt400 {

/// Replaces the breakpoint of an axis. One for an event waits for the next: what has happened so
/// far does not count.
void SetBreakpoint(Card& card, size_t axis, Breakpoint breakpoint);
/// In the tick, after its events: those that are met set their bits and, if the host wants that,
/// update their axes.
void MeetBreakpoints(Card& card);

}  // namespace oncard::gtcalls::gt400
