#include "gtcalls/gt400/interrupts.h"

#include "gtcalls/gt400/background.h"
#include "gtcalls/gt400/events.h"
#include "gtcalls/gt400/gt400_state.h"
#include "gtcalls/gt400/status_word.h"

namespace oncard::gtcalls::gt400 {
namespace {

/// The events that can interrupt: bits 0 to 6 of the status word.
constexpr uint32_t kInterruptEvents = 0x7F;
/// Those of an axis whose drive is off: the alarm and the motion error.
constexpr uint32_t kEventsWhileOff = kAlarmEventBit | kMotionErrorBit;

InterruptUnit& UnitOf(Card& card) { return card.state<Gt400State>().interrupts; }

/// The events of an axis that request an interrupt.
uint32_t RequestingEvents(const CardView& card, size_t axis) {
  const uint32_t mask = card.state<Gt400State>().interrupts.masks[axis] & kInterruptEvents;
  if (mask == 0) return 0;
  const bool on = card.motion.axis(axis).servo_on;
  return EventsOf(card, axis) & mask & (on ? kInterruptEvents : kEventsWhileOff);
}

void Interrupt(Card& card, const Message& what) {
  if (card.interrupt_host) card.interrupt_host(what);
}

void RequestForTime(Card& card) {
  InterruptUnit& unit = UnitOf(card);
  if (unit.period == 0 || ++unit.elapsed < unit.period) return;
  unit.elapsed = 0;
  // What comes while one is in service is lost.
  if (unit.service != InterruptKind::kNone) return;
  if (unit.answers.by_driver()) {
    unit.word = 0;
  } else {
    unit.service = InterruptKind::kTime;
  }
  Interrupt(card, {"irq time", "irq 定时"});
}

/// Assumption: the driver clears the events that have caused an interrupt, or they would cause the
/// next one at once.
void RequestForEvent(Card& card, size_t axis, uint32_t causes) {
  InterruptUnit& unit = UnitOf(card);
  unit.axis = static_cast<uint8_t>(axis);
  unit.word = static_cast<uint16_t>(StatusWord(card.view(), axis));
  if (unit.answers.by_driver()) {
    ClearEvents(card, axis, ~causes);
    RunBackgroundSet(card, axis, unit.word);
  } else {
    unit.service = InterruptKind::kEvent;
  }
  Interrupt(card,
            MakeMessage("irq axis {0} 0x{1:04X}", "irq 轴 {0} 0x{1:04X}", axis + 1, unit.word));
}

}  // namespace

void RequestInterrupt(Card& card) {
  const InterruptUnit& unit = UnitOf(card);
  if (unit.timed) return RequestForTime(card);
  if (unit.service != InterruptKind::kNone) return;
  for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) {
    const uint32_t causes = RequestingEvents(card.view(), axis);
    if (causes != 0) return RequestForEvent(card, axis, causes);
  }
}

int64_t CyclesBeforeInterrupt(const CardView& card) {
  const InterruptUnit& unit = card.state<Gt400State>().interrupts;
  if (unit.service != InterruptKind::kNone) return kNeverActs;
  if (unit.timed) return unit.period == 0 ? kNeverActs : unit.period - unit.elapsed;
  for (const uint16_t mask : unit.masks) {
    if ((mask & kInterruptEvents) != 0) return 1;
  }
  return kNeverActs;
}

void ChangeAnswers(InterruptUnit* unit) {
  if (!unit->answers.any()) unit->service = InterruptKind::kNone;
}

}  // namespace oncard::gtcalls::gt400
