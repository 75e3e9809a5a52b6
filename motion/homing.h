// The state of homing, one for each axis: its parameters, where it is, and how it ended. What it
// does: homing_sequence.h.
#pragma once

#include <cstddef>
#include <cstdint>

#include "motion/axis.h"
#include "motion/common/sizes.h"
#include "motion/profiles/profile.h"

namespace oncard::motion {

/// What smart homing searches: the limit, the home switch, the index pulse. The forced modes search
/// the home switch on the other side too.
enum class HomeMode : uint8_t {
  kNone,
  kLimit,
  kLimitHome,
  kLimitIndex,
  kLimitHomeIndex,
  kHome,
  kHomeIndex,
  kIndex,
  kForcedHome,
  kForcedHomeIndex
};
enum class HomeStage : uint8_t {
  kIdle,
  kStart,
  kEscape,
  kSearchLimit,
  kSearchLimitStop,
  kLimitEscape,
  kLimitReturn,
  kLimitReturnStop,
  kSearchHome,
  kSearchHomeStop,
  kHomeReturn,
  kSearchIndex,
  kGoHome,
  kEnd
};
enum class HomeError : uint8_t {
  kNone,
  kNotTrap,
  kDisabled,
  kAlarm,
  kStop,
  kStage,
  kMode,
  kSetCaptureHome,
  kNoHome,
  kSetCaptureIndex,
  kNoIndex
};

bool SearchesLimit(HomeMode mode);
bool SearchesHome(HomeMode mode);
bool SearchesIndex(HomeMode mode);
bool IsForced(HomeMode mode);

/// A search distance of 0 means this value.
inline constexpr int32_t kSearchDistanceMax = 805306368;

/// The parameters of smart homing. Velocities in pulse/ms, accelerations in pulse/ms^2; they
/// default to 0 and must be set.
struct HomeParameters {
  HomeMode mode = HomeMode::kHome;
  int8_t move_direction = 1;
  int8_t index_direction = 1;
  bool rising = false;
  int16_t trigger_index = 0;  ///< of the capture, from 1; 0: the axis' own
  bool final_fast = false;    ///< the way to the origin at the high velocity
  double high = 0;
  double low = 0;
  double acc = 0;
  double dec = 0;
  int16_t smooth_time = 0;
  bool check_start = false;  ///< a switch or limit that is active is left first
  int32_t offset = 0;
  int32_t home_distance = 0;
  int32_t index_distance = 0;
  int32_t escape = 0;

  auto Fields(auto visit) const {
    return visit(mode, move_direction, index_direction, rising, trigger_index, final_fast, high,
                 low, acc, dec, smooth_time, check_start, offset, home_distance, index_distance,
                 escape);
  }
  bool operator==(const HomeParameters&) const = default;
};

/// What simple homing does after the capture; kSmart: smart homing.
enum class HomeKind : uint8_t { kSmart, kHome, kStop, kIndex, kWithin };

/// HomeKind::kWithin: the position at which the search ends without a result.
struct HomeBound {
  bool given = false;
  int32_t position = 0;

  bool in_use() const { return given; }
  auto Fields(auto visit) const { return visit(given, position); }
};

struct Homing {
  HomeParameters parameters;
  bool running = false;
  HomeStage stage = HomeStage::kIdle;
  HomeError error = HomeError::kNone;
  double captured = 0;  ///< as the capture gave it
  double origin = 0;    ///< the same position as a profile position
  double target = 0;

  HomeKind kind = HomeKind::kSmart;
  int8_t direction = 1;   ///< of the current search
  bool turned = false;    ///< a forced mode has reversed
  bool stopping = false;  ///< a stop started by homing is in progress
  bool failing = false;   ///< homing has ended with `error`, and the axis is stopping
  double ahead = 0;       ///< planned minus measured axis position at rest, without compensation
  bool prepared = false;  ///< GT_HomeInit
  /// Simple homing: its velocity, offset and result.
  double simple_velocity = 0;
  double simple_acc = 0;
  int32_t simple_offset = 0;
  bool found = false;
  bool index_follows = false;  ///< GT_Index: after the home switch comes the index pulse ...
  int32_t index_distance = 0;  ///< ... within this distance, in profile pulses
  int32_t index_offset = 0;
  HomeBound bound = {};

  auto Fields(auto visit) const {
    return visit(parameters, running, stage, error, captured, origin, target, kind, direction,
                 turned, stopping, failing, ahead, prepared, simple_velocity, simple_acc,
                 simple_offset, found, index_follows, index_distance, index_offset, bound);
  }
};

/// The reason why smart homing of an axis cannot begin.
HomeError CheckHoming(const Profile& profile, const Axis& axis, HomeMode mode);

}  // namespace oncard::motion
