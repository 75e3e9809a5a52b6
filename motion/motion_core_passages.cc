// The part of the motion core that determines where within a cycle the machine passes switches,
// index marks and compare points, and what captures then latch.
// Tested by tests/motion/marks_test.cc and, in tests/gtcalls, by capture_command_test.cc and
// compare_command_test.cc.
#include "motion/common/rounding.h"
#include "motion/motion_core.h"

namespace oncard::motion {

double MotionCore::CountedPosition(size_t index) const {
  const Encoder& encoder = state_.encoders[index];
  if (!encoder.active) return encoder.position;
  return encoder.position + (SourcePosition(index) - encoder.source);
}

double MotionCore::PositionAt(size_t encoder, double fraction, const CycleWay& way) const {
  const double from = way.encoders.from[encoder];
  return Whole(from + fraction * (way.encoders.to[encoder] - from));
}

double MotionCore::PositionWhere(size_t encoder, size_t machine, double place,
                                 const CycleWay& way) const {
  const Encoder& counter = state_.encoders[encoder];
  if (encoder == machine && counter.external && counter.active) {
    // Computed directly rather than with the fraction, which would not be exact.
    const double direction = counter.reversed == counter.wired_reversed ? 1 : -1;
    return counter.position - counter.source +
           Whole(direction * place + state_.encoder_faults[encoder].slip);
  }
  const double length = state_.plants[machine].position - way.machines[machine];
  return PositionAt(encoder, length == 0 ? 1 : (place - way.machines[machine]) / length, way);
}

bool MotionCore::Observed() const {
  return !state_.switches.empty() || state_.capture.armed() || state_.compare.active();
}

void MotionCore::AdvanceObserved() {
  CycleWay way;
  for (size_t i = 0; i < kAxisMax; ++i) {
    way.machines[i] = state_.plants[i].position;
    way.encoders.from[i] = CountedPosition(i);
  }
  AdvanceMachine();
  for (size_t i = 0; i < kAxisMax; ++i) way.encoders.to[i] = CountedPosition(i);
  if (state_.capture.armed()) PassWorldEdges(way);
  for (const PositionSwitch& contact : state_.switches) OperateSwitch(contact, way);
  if (state_.capture.armed()) PassIndexMarks(way);
  if (state_.compare.active()) PassComparePoints(way);
  state_.capture.CountArmed();
}

void MotionCore::PassWorldEdges(const CycleWay& way) {
  const WorldProgress& world = state_.world;
  if (world.events == nullptr) return;
  const WorldEvents& events = *world.events;
  const Micros begin = now() - config_.cycle_us;
  // The filters sample the pins in the next cycle; a capture sees the edges themselves.
  std::array<uint32_t, kDiTypeCount> pins{};
  for (size_t i = 0; i < pins.size(); ++i) pins[i] = state_.io.Pins(static_cast<DiType>(i));
  for (auto i = static_cast<size_t>(world.next); i < events.size() && events[i].at < now(); ++i) {
    const WorldEvent& event = events[i];
    if (event.kind != WorldEventKind::kPin) continue;
    const uint32_t mask = uint32_t{1} << event.index;
    const bool level = event.value != 0;
    if (((pins[event.item] & mask) != 0) == level) continue;
    pins[event.item] ^= mask;
    const double fraction =
        static_cast<double>(event.at - begin) / static_cast<double>(config_.cycle_us);
    state_.capture.Edge(static_cast<DiType>(event.item), event.index, level,
                        [&](size_t encoder) { return PositionAt(encoder, fraction, way); });
  }
}

void MotionCore::PassComparePoints(const CycleWay& way) {
  const Micros begin = now() - config_.cycle_us;
  state_.compare.Advance(begin, config_.cycle_us, way.encoders);
  for (const HsioEdge& edge : state_.compare.edges()) {
    const double fraction =
        (edge.instant - static_cast<double>(begin)) / static_cast<double>(config_.cycle_us);
    state_.capture.OutputEdge(edge.channel, edge.level,
                              [&](size_t encoder) { return PositionAt(encoder, fraction, way); });
  }
}

void MotionCore::OperateSwitch(const PositionSwitch& contact, const CycleWay& way) {
  const size_t machine = contact.axis;
  const double to = state_.plants[machine].position;
  const bool level = contact.Level(to);
  const bool before = (state_.io.Pins(contact.type) >> contact.bit & 1) != 0;
  state_.io.SetPin(contact.type, contact.bit, level);
  if (!state_.capture.armed()) return;
  const auto edge = [&](bool rising, double place) {
    state_.capture.Edge(contact.type, contact.bit, rising, [&](size_t encoder) {
      return PositionWhere(encoder, machine, place, way);
    });
  };
  SwitchPassage passage;
  if (contact.connected) passage = PassSwitch(contact, way.machines[machine], to);
  if (passage.enters) edge(!contact.active_low, passage.entry);
  if (passage.leaves) edge(contact.active_low, passage.exit);
  if (!passage.enters && !passage.leaves && level != before) edge(level, to);
}

void MotionCore::PassIndexMarks(const CycleWay& way) {
  for (size_t i = 0; i < kAxisMax; ++i) {
    if (!state_.capture.WaitsForIndex(i)) continue;
    ForEachMark(state_.index_marks[i], way.machines[i], state_.plants[i].position,
                [&](double place) {
                  state_.capture.Index(
                      i, [&](size_t encoder) { return PositionWhere(encoder, i, place, way); });
                  return state_.capture.WaitsForIndex(i);
                });
  }
}

}  // namespace oncard::motion
