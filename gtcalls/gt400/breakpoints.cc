#include "gtcalls/gt400/breakpoints.h"

#include "gtcalls/gt400/axis_state.h"
#include "gtcalls/gt400/events.h"
#include "gtcalls/gt400/registers.h"

namespace oncard::gtcalls::gt400 {
namespace {

bool IsMet(const CardView& card, size_t axis) {
  const Gt400Axis& state = AxisState(card, axis);
  const double actual = card.motion.encoder(axis).position;
  switch (state.breakpoint) {
    case Breakpoint::kNone:
      return false;
    case Breakpoint::kPositive:
      return actual >= state.valid.breakpoint;
    case Breakpoint::kNegative:
      return actual <= state.valid.breakpoint;
    case Breakpoint::kMotion:
      return (state.new_events & kCompleteBit) != 0;
    case Breakpoint::kCapture:
      return (state.new_events & kCapturedBit) != 0;
  }
  return false;
}

}  // namespace

void SetBreakpoint(Card& card, size_t axis, Breakpoint breakpoint) {
  Gt400Axis& state = AxisState(card, axis);
  state.breakpoint = breakpoint;
  state.new_events = 0;
}

void MeetBreakpoints(Card& card) {
  for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) {
    Gt400Axis& state = AxisState(card, axis);
    const bool met = IsMet(card.view(), axis);
    state.new_events = 0;
    if (!met) continue;
    state.breakpoint = Breakpoint::kNone;
    SetEvents(card, axis, kBreakpointBit);
    if (state.auto_update) UpdateAtOnce(card, 1u << axis);
  }
}

}  // namespace oncard::gtcalls::gt400
