// Events that the card causes by itself and that a log should report: why it stopped, what a path
// could not do. They are reported to an observer when they happen and are not part of the card's
// state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace oncard::motion {

enum class CardEventKind : uint8_t {
  // Of an axis; `value` is its planned position.
  kPositiveLimitSwitch,
  kNegativeLimitSwitch,
  kPositiveSoftLimit,  ///< `bound`: the limit
  kNegativeSoftLimit,
  kAlarm,
  kSmoothStopInput,
  kAbruptStopInput,
  kFollowingError,    ///< `value`: the error, `bound`: its limit, pulses; the drive is switched off
  kBeyondErrorLimit,  ///< the same, but the axis goes on (CardDefaults::following_error_stops)
  kEncoderSilent,     ///< `value`: velocity of the encoder, `bound`: the least, pulse/ms
  kGantrySkew,        ///< of the master; `value`: the skew, `bound`: its limit, pulses
  kHeldAtLimit,       ///< of a profile: it would have moved towards a latched limit
  // Of an axis that begins to move while its drive is off; `bound`: coordinate system, from 0.
  kMovedBySegment,
  kMovedByPath,  ///< by GT_BufMove or GT_BufGear
  // Of an axis, beyond what its drive and mechanics can follow (DriveLimits); `bound`: the limit.
  kTooFast,   ///< `value`: its planned velocity, pulse/ms
  kTooSteep,  ///< `value`: its planned acceleration, or the mean one of a cycle, pulse/ms^2
  // Of a coordinate system.
  kStarved,         ///< the FIFO is empty; `value`: segments in the look-ahead ring
  kEndedMoving,     ///< the FIFO ran empty at the velocity `value`, which drops to 0
  kMoveStopped,     ///< `value`: position of the profile `bound` that a modal GT_BufMove waits for
  kCornerLimited,   ///< a segment was appended: `value` is the velocity of the corner, `bound` the
                    ///< commanded one
  kJunctionLimited  ///< the same with the multi-axis look-ahead
};

struct CardEvent {
  CardEventKind kind;
  size_t item = 0;  ///< axis, profile or coordinate system, from 0
  double value = 0;
  double bound = 0;
};

using CardEventObserver = std::function<void(const CardEvent&)>;

}  // namespace oncard::motion
