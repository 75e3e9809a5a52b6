#include "runtime/sim/body_parts.h"

#include <algorithm>
#include <utility>

namespace oncard::runtime {
namespace {

using motion::MotionState;

/// What each axis has one element of, by its number.
template <typename State>
auto AxisArrays(State& state) {
  return std::tie(state.profiles, state.axes, state.compensations, state.encoders,
                  state.encoder_faults, state.drives, state.plants, state.steps, state.controls,
                  state.dacs, state.index_marks, state.homing);
}

template <typename State>
auto IoFields(State& state) {
  return std::tie(state.io, state.adcs, state.modules);
}

auto ClockFields(const MotionState& state) { return std::tie(state.cycle, state.clock_cycle); }

template <typename State>
auto RestFields(State& state) {
  return std::tie(state.pvt_tables, state.crds, state.enable_axes, state.compensates,
                  state.switches, state.capture, state.compare, state.lasers, state.gantry,
                  state.homing_runs, state.reached, state.bus, state.shapers, state.spindle);
}

uint64_t EventsOf(const MotionState& state) {
  return state.world.events == nullptr ? 0 : state.world.events->size();
}

template <typename Tuple>
constexpr size_t kSize = std::tuple_size_v<Tuple>;

static_assert(kSize<decltype(AxisArrays(std::declval<const MotionState&>()))> +
                      kSize<decltype(IoFields(std::declval<const MotionState&>()))> +
                      kSize<decltype(ClockFields(std::declval<const MotionState&>()))> +
                      kSize<decltype(RestFields(std::declval<const MotionState&>()))> +
                      std::size_t{1} ==  // MotionState::world
                  motion::kFieldCount<MotionState>,
              "every member of the state of motion belongs to one part");

/// Calls `visit` with the element of each array and the same member of the part.
template <typename State, typename Elements, typename Visit>
void ForEachElement(State& state, size_t axis, Elements elements, const Visit& visit) {
  const auto both = [&]<size_t... kIndex>(std::index_sequence<kIndex...>) {
    const auto arrays = AxisArrays(state);
    (visit(std::get<kIndex>(arrays)[axis], std::get<kIndex>(elements)), ...);
  };
  both(std::make_index_sequence<kSize<Elements>>());
}

void AddAxis(const MotionState& state, size_t axis, motion::StateWords* words) {
  std::apply([&](const auto&... arrays) { (words->Add(arrays[axis]), ...); }, AxisArrays(state));
}

void CopyAxis(const MotionState& from, size_t axis, MotionState* to) {
  const auto copy = [&]<size_t... kIndex>(std::index_sequence<kIndex...>) {
    const auto read = AxisArrays(from);
    const auto written = AxisArrays(*to);
    ((std::get<kIndex>(written)[axis] = std::get<kIndex>(read)[axis]), ...);
  };
  copy(std::make_index_sequence<kSize<decltype(AxisArrays(from))>>());
}

bool OwnOrNone(int number, size_t own) { return number < 0 || static_cast<size_t>(number) == own; }

bool AxisIsApart(const MotionState& state, size_t axis) {
  const uint32_t bit = uint32_t{1} << axis;
  const motion::Profile& profile = state.profiles[axis];
  return state.axes[axis].profile_map == bit && state.axes[axis].encoder_map == bit &&
         OwnOrNone(state.controls[axis].axis, axis) &&
         OwnOrNone(state.controls[axis].encoder, axis) && OwnOrNone(state.steps[axis].axis, axis) &&
         OwnOrNone(state.plants[axis].axis, axis) && profile.SelectedMaster() == nullptr &&
         profile.mode != motion::ProfileMode::kCrd;
}

bool RestLeavesApart(const MotionState& state) {
  const auto exists = [](const motion::Crd& crd) { return crd.exists(); };
  return std::ranges::none_of(state.crds, exists) && !state.gantry.on && state.reached.empty() &&
         !state.bus && !state.shapers;
}

}  // namespace

void BodyDivision::AddValues(const CardBody& body, size_t part, motion::StateWords* words) const {
  // A member that is not named here does not compile.
  const auto& [motion, family, pending_ns, pending_statements, clock, reactions] = body;
  if (part == kClock) {
    std::apply([&](const auto&... fields) { (words->Add(fields), ...); }, ClockFields(motion));
    words->Add(pending_ns).Add(pending_statements);
  } else if (part == kIo) {
    std::apply([&](const auto&... fields) { (words->Add(fields), ...); }, IoFields(motion));
  } else if (part == kWorld) {
    for (uint64_t i = motion.world.next; i < EventsOf(motion); ++i) {
      words->Add((*motion.world.events)[static_cast<size_t>(i)]);
    }
  } else if (part == kRest) {
    std::apply([&](const auto&... fields) { (words->Add(fields), ...); }, RestFields(motion));
    for (size_t i = axis_count_; i < motion.axes.size(); ++i) AddAxis(motion, i, words);
    words->Add(family).Add(static_cast<bool>(clock)).Add(clock);
    words->Add(static_cast<bool>(reactions)).Add(reactions);
  } else {
    AddAxis(motion, part - kFirstAxis, words);
  }
}

BodyDivision::Part BodyDivision::PartOf(const CardBody& body, size_t part) const {
  const MotionState& motion = body.motion;
  if (part == kClock) {
    return Part(
        Part::Clock{motion.cycle, motion.clock_cycle, body.pending_ns, body.pending_statements});
  }
  if (part == kIo) return Part(Part::Io{motion.io, motion.adcs, motion.modules});
  if (part == kWorld) return Part(Part::World{EventsOf(motion) - motion.world.next});
  if (part == kRest) return Part(std::make_unique<const CardBody>(body));
  Part::Axis axis;
  ForEachElement(motion, part - kFirstAxis, axis.Elements(),
                 [](const auto& element, auto& value) { value = element; });
  return Part(std::move(axis));
}

void BodyDivision::Put(const Part& value, size_t part, CardBody* body) const {
  MotionState& motion = body->motion;
  if (part == kClock) {
    const auto& clock = std::get<Part::Clock>(value.value_);
    motion.cycle = clock.cycle;
    motion.clock_cycle = clock.clock_cycle;
    body->pending_ns = clock.pending_ns;
    body->pending_statements = clock.pending_statements;
  } else if (part == kIo) {
    const auto& io = std::get<Part::Io>(value.value_);
    motion.io = io.digital;
    motion.adcs = io.adcs;
    motion.modules = io.modules;
  } else if (part == kWorld) {
    motion.world.next = EventsOf(motion) - std::get<Part::World>(value.value_).left;
  } else if (part == kRest) {
    const CardBody& rest = *std::get<Part::Rest>(value.value_);
    RestFields(motion) = RestFields(rest.motion);
    for (size_t i = axis_count_; i < motion.axes.size(); ++i) CopyAxis(rest.motion, i, &motion);
    body->family = rest.family;
    body->clock = rest.clock;
    body->reactions = rest.reactions;
  } else {
    ForEachElement(motion, part - kFirstAxis, std::get<Part::Axis>(value.value_).Elements(),
                   [](auto& element, const auto& kept) { element = kept; });
  }
}

bool BodyDivision::LeavesAxesApart(const CardBody& body, size_t part) const {
  if (part == kRest) return RestLeavesApart(body.motion);
  return part < kFirstAxis || AxisIsApart(body.motion, part - kFirstAxis);
}

}  // namespace oncard::runtime
