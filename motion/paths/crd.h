// A coordinate system: two to four profiles that follow a path of lines, arcs and helices together.
//
// Segments and buffered commands wait in two FIFOs. Each segment is planned in closed form along
// its path when it begins (acceleration, cruise, deceleration); its end falls inside a cycle and
// the next one begins at that very instant, so that positions at shared instants do not depend on
// the cycle. Commands between segments act at the tick in which the segment before them ends.
//
// Coordinates are relative to the origin: profile = origin + coordinate. Units: ms, pulse,
// pulse/ms, pulse/ms^2. What reaches beyond the path (outputs, other profiles) is the motion
// core's part (motion_core.h). Nothing is allocated while time passes.
// Source: the public header's commands, programming manual examples 6-10 and 6-11.
// Tested by tests/motion/crd_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <tuple>

#include "motion/common/sizes.h"
#include "motion/paths/look_ahead.h"
#include "motion/paths/path_slot.h"
#include "motion/paths/segment.h"
#include "motion/profiles/plan.h"
#include "motion/profiles/profile.h"

namespace oncard::motion {

inline constexpr size_t kCrdFifoCount = 2;
/// Segments and buffered commands of a FIFO.
inline constexpr size_t kCrdFifoSize = 4096;
/// TCrdPrm.profile and originPos have room for this many.
inline constexpr size_t kCrdParameterAxes = 8;

/// TCrdPrm.
struct CrdParameters {
  int16_t dimension = 0;  ///< 0: the coordinate system does not exist
  /// The coordinate (1 X ... 4 A) of profile n + 1; 0: none.
  std::array<int16_t, kCrdParameterAxes> profile{};
  double velocity_max = 0;
  double acceleration_max = 0;
  int16_t even_time = 0;  ///< ms of constant velocity in each segment
  int16_t set_origin = 0;
  std::array<int32_t, kCrdParameterAxes> origin{};

  auto Fields() const {
    return std::tie(dimension, profile, velocity_max, acceleration_max, even_time, set_origin,
                    origin);
  }
};

/// Motion along the rest of a segment.
struct PathSpan {
  double begin = 0;         ///< path where the motion begins
  double end = 0;           ///< the segment's length
  double velocity = 0;      ///< at `begin`
  double target = 0;        ///< velocity to reach, > 0
  double end_velocity = 0;  ///< at `end`; the nearest reachable one is taken
  double acceleration = 0;
  double even_time = 0;  ///< ms that the constant velocity lasts at least
};

/// velocity -> target -> end_velocity. A velocity above the target falls to it first.
Plan PlanSpan(const PathSpan& span);

/// Decelerates until rest, or until the segment's end where the stop goes on in the next one. At
/// least as hard as it takes to reach span.end_velocity at the end.
Plan PlanSpanStop(const PathSpan& span, double deceleration);

struct CrdFifo {
  SlotQueue slots;
  LookAhead look_ahead;
  Coordinates tail{};      ///< where the last segment ends
  bool executing = false;  ///< `current` has begun and not ended: a breakpoint when nothing runs
  PathSlot current;
  double path = 0;           ///< reached in `current`
  bool awaits_move = false;  ///< `move`, which is modal, has begun; a pause does not end the wait
  BufferedCommand move;
  int32_t done = 0;         ///< segments completed (GT_CrdStatus)
  int32_t user_number = 0;  ///< GT_SetUserSegNum, for segments to come

  /// Nothing is waiting or under way.
  bool idle() const {
    return !executing && !awaits_move && slots.empty() && look_ahead.ring.empty();
  }
  size_t space() const { return kCrdFifoSize - slots.size(); }
  /// Segments that have not ended.
  size_t Remaining() const {
    return slots.CountSegments() + look_ahead.ring.CountSegments() + (executing ? 1 : 0);
  }
  /// Appends a slot; false when there is no room, then nothing has changed.
  bool Append(const PathSlot& slot);
  /// Empties the look-ahead ring into the FIFO; false when it did not fit.
  bool Flush();

  auto Fields() const {
    return std::tie(slots, look_ahead, tail, executing, current, path, awaits_move, move, done,
                    user_number);
  }
};

/// A profile outside the coordinate system that moves in step with one segment (GT_BufGear).
struct GearShare {
  int32_t profile = 0;
  double begin = 0;
  double displacement = 0;
  double ramp_up = 0;  ///< parts of the path, 0..1, together at most 1
  double ramp_down = 0;
  bool finished = false;  ///< its segment has ended

  /// Position at a part 0..1 of the path, and its slope.
  double PositionAt(double part) const;
  double SlopeAt(double part) const;

  auto Fields() const {
    return std::tie(profile, begin, displacement, ramp_up, ramp_down, finished);
  }
};

/// What a run waits for before it goes on with the next slot.
enum class CrdWait : uint8_t { kNone, kDelay, kMove };

struct CrdRun {
  bool running = false;
  size_t fifo = 0;
  Micros begin = 0;
  double at = 0;  ///< ms since `begin` at which the plan, or what comes next, begins
  Plan plan;      ///< along the path of the segment
  double velocity = 0;
  double acceleration = 0;
  bool stopping = false;
  double stop_deceleration = 0;
  bool single_step = false;  ///< ends after one segment
  CrdWait wait = CrdWait::kNone;
  double wait_until = 0;    ///< ms since `begin`
  BufferedCommand command;  ///< being carried out

  auto Fields() const {
    return std::tie(running, fifo, begin, at, plan, velocity, acceleration, stopping,
                    stop_deceleration, single_step, wait, wait_until, command);
  }
};

struct Crd {
  CrdParameters parameters;
  std::array<int32_t, kCrdDimensionMax> members{};  ///< profile of each coordinate, from 0
  Coordinates origin{};
  Coordinates position{};  ///< where the path has come to
  double smooth_stop = kSmoothStopDefault;
  double abrupt_stop = kAbruptStopDefault;
  double override_ratio = 1;   ///< GT_SetOverride
  double second_override = 1;  ///< GT_SetOverride2, for the segments that say so
  bool step_mode = false;
  /// GT_SetCrdSingleMaxVel, pulse/ms.
  Coordinates axis_velocity_max = {kNoVelocityLimit, kNoVelocityLimit, kNoVelocityLimit,
                                   kNoVelocityLimit};
  std::array<CrdFifo, kCrdFifoCount> fifos;
  CrdRun run;
  std::array<GearShare, kAxisMax> gears;
  uint32_t gear_count = 0;

  static constexpr double kNoVelocityLimit = 32767;

  bool exists() const { return parameters.dimension > 0; }
  size_t dimension() const { return static_cast<size_t>(parameters.dimension); }
  bool HasMember(size_t profile) const;
  /// Writes the profile's output: a member, or a BufGear axis.
  bool Drives(size_t profile) const;
  CrdFifo& active() { return fifos[run.fifo]; }
  const CrdFifo& active() const { return fifos[run.fifo]; }

  /// The run has still to write a motion program's variable. What waits in the look-ahead ring does
  /// not come by itself.
  bool WillWriteVariables() const;

  /// The largest velocity along a segment that GT_SetCrdSingleMaxVel allows.
  double VelocityLimit(const Segment& segment) const;
  /// Appends a slot to a FIFO; false when there is no room, then nothing has changed.
  bool Append(size_t fifo, const PathSlot& slot, Micros now);
  /// Empties a FIFO and its look-ahead ring, and forgets the breakpoint.
  void Clear(size_t fifo);

  /// Begins a run, or resumes at the breakpoint, waiting for a modal move that has not ended; there
  /// must be something to do.
  void Start(size_t fifo, bool single_step, Micros now);
  /// Decelerates along the path; a faster stop replaces a slower one.
  void Stop(bool abrupt, Micros now);
  /// Plans the rest of the segment anew: an override or a limit has changed.
  void Replan(Micros now);
  /// Lets time pass until `now`. Not NULL: a command to carry out first; then call it again.
  const BufferedCommand* Advance(Micros now);
  /// Waits for a modal GT_BufMove until EndMove().
  void AwaitMove(const BufferedCommand& move);
  /// The profile that is waited for has arrived at `now`.
  void EndMove(Micros now);

  auto Fields() const {
    return std::tie(parameters, members, origin, position, smooth_stop, abrupt_stop, override_ratio,
                    second_override, step_mode, axis_velocity_max, fifos, run, gears, gear_count);
  }

  // Parts of the above.
  PathSpan SpanOfCurrent() const;
  Plan PlanCurrent() const;
  void EndPlan();
  void TakeSlot();
  void EndRun();
};

}  // namespace oncard::motion
