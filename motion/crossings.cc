#include "motion/crossings.h"

#include "motion/common/rounding.h"

namespace oncard::motion {

bool Crossings::Wanted(const MotionState& state) {
  return !state.switches.empty() || state.capture.armed() || state.compare.active();
}

Crossings::Crossings(MotionState& state, const MotionConfig& config)
    : state_(state), config_(config), readings_(state, config) {
  for (size_t i = 0; i < kAxisMax; ++i) {
    motors_[i] = state_.plants[i].position;
    encoders_.from[i] = readings_.CountedPosition(i);
  }
}

void Crossings::Finish() {
  for (size_t i = 0; i < kAxisMax; ++i) encoders_.to[i] = readings_.CountedPosition(i);
  if (state_.capture.armed()) PassWorldEdges();
  for (const PositionSwitch& contact : state_.switches) OperateSwitch(contact);
  if (state_.capture.armed()) PassIndexMarks();
  if (state_.compare.active()) PassComparePoints();
  state_.capture.CountArmed();
}

double Crossings::PositionAt(size_t encoder, double fraction) const {
  const double from = encoders_.from[encoder];
  return Whole(from + fraction * (encoders_.to[encoder] - from));
}

double Crossings::PositionWhere(size_t encoder, size_t motor, double place) const {
  const Encoder& counter = state_.encoders[encoder];
  if (encoder == motor && counter.external && counter.active && !readings_.OnBus(encoder)) {
    // Computed directly rather than with the fraction, which would not be exact.
    const double direction = counter.reversed == counter.wired_reversed ? 1 : -1;
    return counter.position - counter.source +
           Whole(direction * place + state_.encoder_faults[encoder].slip);
  }
  const double length = state_.plants[motor].position - motors_[motor];
  return PositionAt(encoder, length == 0 ? 1 : (place - motors_[motor]) / length);
}

void Crossings::PassWorldEdges() {
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
                        [&](size_t encoder) { return PositionAt(encoder, fraction); });
  }
}

void Crossings::PassComparePoints() {
  const Micros begin = now() - config_.cycle_us;
  state_.compare.Advance(begin, config_.cycle_us, encoders_);
  for (const HsioEdge& edge : state_.compare.edges()) {
    const double fraction =
        (edge.instant - static_cast<double>(begin)) / static_cast<double>(config_.cycle_us);
    state_.capture.OutputEdge(edge.channel, edge.level,
                              [&](size_t encoder) { return PositionAt(encoder, fraction); });
  }
}

void Crossings::OperateSwitch(const PositionSwitch& contact) {
  const size_t motor = contact.axis;
  const double to = state_.plants[motor].position;
  const bool level = contact.Level(to);
  const bool before = (state_.io.Pins(contact.type) >> contact.bit & 1) != 0;
  state_.io.SetPin(contact.type, contact.bit, level);
  if (!state_.capture.armed()) return;
  const auto edge = [&](bool rising, double place) {
    state_.capture.Edge(contact.type, contact.bit, rising,
                        [&](size_t encoder) { return PositionWhere(encoder, motor, place); });
  };
  SwitchPassage passage;
  if (contact.connected) passage = PassSwitch(contact, motors_[motor], to);
  if (passage.enters) edge(!contact.active_low, passage.entry);
  if (passage.leaves) edge(contact.active_low, passage.exit);
  if (!passage.enters && !passage.leaves && level != before) edge(level, to);
}

void Crossings::PassIndexMarks() {
  for (size_t i = 0; i < kAxisMax; ++i) {
    if (!state_.capture.WaitsForIndex(i)) continue;
    ForEachMark(state_.index_marks[i], motors_[i], state_.plants[i].position, [&](double place) {
      state_.capture.Index(i, [&](size_t encoder) { return PositionWhere(encoder, i, place); });
      return state_.capture.WaitsForIndex(i);
    });
  }
}

}  // namespace oncard::motion
