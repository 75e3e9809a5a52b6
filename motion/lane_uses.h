// What lanes do with each member of a card's state while they hold the card (cycle_block.h). A new
// member does not compile until it is listed here, so that none is taken for one that lanes may
// pass over.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "motion/common/state_hash.h"
#include "motion/motion_state.h"

namespace oncard::motion {

/// Members of a structure, named by pointers to them.
template <auto... kMembers>
struct Members {
  static constexpr size_t kCount = sizeof...(kMembers);
  /// How often the list names a member.
  template <auto kMember>
  static constexpr size_t kTimes = (size_t{0} + ... +
                                    size_t{std::is_same_v<Members<kMember>, Members<kMembers>>});
};

/// The lists of a structure:
///   Laned   lanes hold its newest value, or that of a part of it
///   Beside  is advanced in the state, beside the lanes: the clock, timed outputs, paths, and
///           profiles that lanes do not plan
///   Rests   Load() makes sure that no cycle changes it
///   Read    no cycle of a plain card changes it
template <typename Struct>
struct LaneUses;

template <>
struct LaneUses<MotionState> {
  using Laned = Members<&MotionState::profiles, &MotionState::axes, &MotionState::encoders,
                        &MotionState::plants, &MotionState::steps, &MotionState::controls,
                        &MotionState::dacs, &MotionState::bus>;
  using Beside =
      Members<&MotionState::cycle, &MotionState::clock_cycle, &MotionState::io, &MotionState::crds>;
  using Rests = Members<&MotionState::compensations, &MotionState::compensates,
                        &MotionState::encoder_faults, &MotionState::adcs, &MotionState::world,
                        &MotionState::switches, &MotionState::capture, &MotionState::compare,
                        &MotionState::gantry, &MotionState::homing, &MotionState::homing_runs,
                        &MotionState::reached, &MotionState::shapers>;
  using Read = Members<&MotionState::pvt_tables, &MotionState::enable_axes, &MotionState::drives,
                       &MotionState::modules, &MotionState::index_marks, &MotionState::lasers,
                       &MotionState::spindle>;
};

template <>
struct LaneUses<Profile> {
  using Laned = Members<&Profile::now>;
  using Beside = Members<
#define PROFILE_MODE(enumerator, number, name, member, Class) &Profile::member,
#include "motion/profiles/modes.def"
      &Profile::driven, &Profile::stopping, &Profile::stop_deceleration, &Profile::stop_begin,
      &Profile::stop_plan>;
  using Rests = Members<>;
  using Read =
      Members<&Profile::active, &Profile::mode, &Profile::smooth_stop, &Profile::abrupt_stop>;
};

template <>
struct LaneUses<Sample> {
  using Laned = Members<&Sample::position, &Sample::velocity, &Sample::acceleration>;
  using Beside = Members<>;
  using Rests = Members<&Sample::moving>;
  using Read = Members<>;
};

template <>
struct LaneUses<Axis> {
  using Laned = Members<&Axis::profile, &Axis::encoder>;
  using Beside = Members<>;
  using Rests = Members<&Axis::latched, &Axis::in_band, &Axis::in_band_since, &Axis::in_position>;
  using Read =
      Members<&Axis::active, &Axis::alarm, &Axis::positive_limit, &Axis::negative_limit,
              &Axis::smooth_stop, &Axis::abrupt_stop, &Axis::profile_map, &Axis::encoder_map,
              &Axis::profile_scale, &Axis::encoder_scale, &Axis::alarm_on, &Axis::positive_limit_on,
              &Axis::negative_limit_on, &Axis::soft_positive, &Axis::soft_negative, &Axis::band,
              &Axis::band_time, &Axis::band_set, &Axis::servo_on>;
};

template <>
struct LaneUses<AxisValue> {
  using Laned = Members<&AxisValue::position, &AxisValue::velocity, &AxisValue::acceleration>;
  using Beside = Members<>;
  using Rests = Members<&AxisValue::filter>;
  using Read = Members<&AxisValue::offset>;
};

template <>
struct LaneUses<Encoder> {
  using Laned =
      Members<&Encoder::position, &Encoder::source, &Encoder::velocity, &Encoder::acceleration>;
  using Beside = Members<>;
  using Rests = Members<>;
  using Read =
      Members<&Encoder::active, &Encoder::external, &Encoder::reversed, &Encoder::wired_reversed>;
};

template <>
struct LaneUses<Plant> {
  using Laned = Members<&Plant::position, &Plant::velocity>;
  using Beside = Members<>;
  using Rests = Members<&Plant::stalled, &Plant::hand>;
  using Read = Members<&Plant::axis, &Plant::control, &Plant::lead>;
};

template <>
struct LaneUses<Step> {
  using Laned = Members<&Step::position>;
  using Beside = Members<>;
  using Rests = Members<>;
  using Read = Members<&Step::active, &Step::axis, &Step::mode, &Step::parameter, &Step::reversed,
                       &Step::lead>;
};

template <>
struct LaneUses<Control> {
  using Laned = Members<&Control::reference, &Control::sum, &Control::error_before, &Control::feed>;
  using Beside = Members<>;
  using Rests = Members<&Control::check>;
  using Read = Members<&Control::active, &Control::axis, &Control::encoder, &Control::closed,
                       &Control::sets, &Control::selected, &Control::error_limit>;
};

template <>
struct LaneUses<Dac> {
  using Laned = Members<&Dac::value>;
  using Beside = Members<>;
  using Rests = Members<>;
  using Read = Members<&Dac::active, &Dac::reversed, &Dac::control, &Dac::bias, &Dac::limit>;
};

// BusAxes::OnlyMove() makes sure of what rests.
template <>
struct LaneUses<BusPart> {
  using Laned = Members<&BusPart::line, &BusPart::axes>;
  using Beside = Members<>;
  using Rests = Members<>;
  using Read = Members<>;
};

template <>
struct LaneUses<BusAxis> {
  using Laned = Members<&BusAxis::raw, &BusAxis::counts>;
  using Beside = Members<>;
  using Rests =
      Members<&BusAxis::resets_fault, &BusAxis::homing, &BusAxis::alarm, &BusAxis::follows>;
  using Read = Members<&BusAxis::slave, &BusAxis::enable, &BusAxis::homing_prepared,
                       &BusAxis::homing_status, &BusAxis::scale, &BusAxis::lead>;
};

namespace internal {

template <typename... Lists>
struct Joined;
template <auto... kFirst, auto... kSecond, typename... Lists>
struct Joined<Members<kFirst...>, Members<kSecond...>, Lists...>
    : Joined<Members<kFirst..., kSecond...>, Lists...> {};
template <auto... kMembers>
struct Joined<Members<kMembers...>> {
  /// Each member is named once.
  static constexpr bool kDistinct = ((Members<kMembers...>::template kTimes<kMembers> == 1) && ...);
  static constexpr size_t kCount = sizeof...(kMembers);
};

template <typename Struct, typename Member>
LaneUses<Struct> UsesOfStructWith(Member Struct::*);

}  // namespace internal

/// True if the lists of a structure name each of its members once.
template <typename Struct>
inline constexpr bool kLaneUsesComplete = [] {
  using Uses = LaneUses<Struct>;
  using All = internal::Joined<typename Uses::Laned, typename Uses::Beside, typename Uses::Rests,
                               typename Uses::Read>;
  return All::kDistinct && kFieldsComplete<Struct> && All::kCount == kFieldCount<Struct>;
}();

/// True if lanes may hold a newer value of the member than the state.
template <auto kMember>
inline constexpr bool kLaned =
    decltype(internal::UsesOfStructWith(kMember))::Laned::template kTimes<kMember> != 0;

}  // namespace oncard::motion
