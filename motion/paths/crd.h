// A coordinate system: two to four profiles that follow a path of lines, arcs and helices together.
//
// Segments and buffered commands wait in two FIFOs. Each segment is planned in closed form along
// its path when it begins (acceleration, cruise, deceleration); its end can be inside a cycle, and
// the next segment begins at that exact instant, so that positions do not depend on the length of
// the cycle. Commands between segments act at the tick in which the segment before them ends.
//
// Coordinates are relative to the origin: profile = origin + coordinate. Units: ms, pulse,
// pulse/ms, pulse/ms^2. Effects outside the path (outputs, other profiles) are done by the motion
// core (motion_core.h). Nothing is allocated during a tick. Source: the public header's commands,
// programming manual examples 6-10 and 6-11. Tested by tests/motion/crd_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "motion/common/card_defaults.h"
#include "motion/common/rare.h"
#include "motion/common/sizes.h"
#include "motion/paths/coordinate_map.h"
#include "motion/paths/path_planner.h"
#include "motion/paths/path_slot.h"
#include "motion/paths/path_span.h"
#include "motion/paths/segment.h"
#include "motion/profiles/plan.h"
#include "motion/profiles/profile.h"

namespace oncard::motion {

inline constexpr size_t kCrdFifoCount = 2;
/// Capacity of a FIFO in segments and buffered commands.
inline constexpr size_t kCrdFifoSize = 4096;
/// Profiles that can be members of a coordinate system: the first ones of a card.
inline constexpr size_t kCrdProfileCount = 8;

/// What a coordinate system consists of.
struct CrdParameters {
  int16_t dimension = 0;  ///< 0: the coordinate system does not exist
  /// The coordinate of each profile, from 1 (X) to 4 (A); 0: none.
  std::array<int16_t, kCrdProfileCount> coordinates{};
  double velocity_max = 0;
  double acceleration_max = 0;
  int16_t even_time = 0;     ///< minimum time of constant velocity in each segment, ms
  bool sets_origin = false;  ///< false: the origin is where the profiles are
  /// Of each coordinate, pulses; the elements after the last one mean nothing.
  std::array<int32_t, kCrdProfileCount> origin{};

  /// The coordinate of a profile, from 0; empty if it is no member.
  std::optional<size_t> CoordinateOf(size_t profile) const {
    if (profile >= coordinates.size() || coordinates[profile] == 0) return std::nullopt;
    return static_cast<size_t>(coordinates[profile] - 1);
  }

  auto Fields(auto visit) const {
    return visit(dimension, coordinates, velocity_max, acceleration_max, even_time, sets_origin,
                 origin);
  }
};

/// A buffer as a list of segments.
struct SegmentList {
  /// kGiven, kFeeds or kAxisJumps: the rule of slots that pass no window before they enter the
  /// buffer.
  JointRule joints = JointRule::kGiven;
  bool open = false;  ///< a run that has come to its end waits for more slots

  bool in_use() const { return plans_joints() || open; }
  /// True if a joint depends on all that follows in the buffer.
  bool plans_joints() const { return joints != JointRule::kGiven; }
  auto Fields(auto visit) const { return visit(joints, open); }
};

/// Where a path goes on when the line back to it has been run (Crd::Resume).
struct Interruption {
  bool executing = false;  ///< inside `slot`; otherwise behind it
  PathSlot slot;
  double path = 0;  ///< reached in it

  auto Fields(auto visit) const { return visit(executing, slot, path); }
};

struct CrdFifo {
  SlotQueue slots;
  SegmentList list;
  Rare<PathPlanner> planner;  ///< the window that slots pass before they enter the FIFO
  Coordinates tail{};         ///< where the last segment ends; not of a virtual run
  bool executing =
      false;  ///< `current` has begun and not ended; if nothing runs, this is a breakpoint
  PathSlot current;
  double path = 0;                  ///< reached in `current`
  Rare<Interruption> interruption;  ///< while `current` is the line back to it
  bool awaits_move = false;         ///< the modal `move` has begun; a pause does not end the wait
  BufferedCommand move;
  int32_t done = 0;         ///< segments completed (GT_CrdStatus)
  int32_t user_number = 0;  ///< GT_SetUserSegNum, for future segments

  /// True if nothing is waiting or in execution.
  bool idle() const { return !executing && !awaits_move && slots.empty() && Ahead().empty(); }
  /// True if slots pass a window before they enter the FIFO.
  bool looks_ahead() const { return planner && planner->capacity > 0; }
  /// True if the window knows limits of each axis.
  bool plans_axes() const { return planner && planner->limits.rule.joints == JointRule::kAxes; }
  /// The slots in the window.
  const SlotQueue& Ahead() const { return planner ? planner->ring : kNoSlots; }
  /// True if nothing reaches the FIFO, and only its time is computed.
  bool is_virtual() const { return planner && planner->virtual_run.on; }
  /// Where the last segment ends, also that of a virtual run, which never reaches the FIFO.
  Coordinates& Tail() { return is_virtual() ? planner->virtual_run.end : tail; }
  const Coordinates& Tail() const { return is_virtual() ? planner->virtual_run.end : tail; }
  /// True if one of its segments has begun.
  bool begun() const { return executing || done > 0; }
  /// The given number of the segment that is under way, or was the last one; 0 before the first.
  int32_t GivenNumber() const {
    if (!begun()) return 0;
    return interruption ? interruption->slot.given_number : current.given_number;
  }
  /// Where the path goes on.
  Coordinates Breakpoint() const {
    return interruption ? interruption->slot.segment.PointAt(interruption->path)
                        : current.segment.PointAt(path);
  }
  /// The segment that has begun and not ended, also during the line back to it; nullptr if there is
  /// none.
  PathSlot* SegmentInProgress();
  /// The segment that ends last, unless it has ended; nullptr if there is none.
  PathSlot* LastSegment();
  size_t space() const { return kCrdFifoSize - slots.size(); }
  /// Number of segments that have not ended.
  size_t Remaining() const {
    const bool begun = interruption ? interruption->executing : executing;
    return slots.CountSegments() + Ahead().CountSegments() + (begun ? 1 : 0);
  }
  /// Appends a slot; false if there is no space, and then nothing has changed.
  bool Append(const PathSlot& slot);
  /// Moves the content of the look-ahead ring to the FIFO; false if it did not fit.
  bool Flush();

  auto Fields(auto visit) const {
    return visit(slots, list, PlannerInHash{planner}, tail, executing, current, path, interruption,
                 awaits_move, move, done, user_number);
  }

  // Parts of the functions above.
  bool AppendPlanned(const PathSlot& slot);
  void TakePlanned(bool ended);
  /// Makes the interrupted segment the current one again.
  void LeaveLineBack();
};

/// A profile outside the coordinate system that moves in proportion to one segment (GT_BufGear).
struct GearShare {
  int32_t profile = 0;
  double begin = 0;
  double displacement = 0;
  double ramp_up = 0;  ///< fractions of the path, 0..1, sum at most 1
  double ramp_down = 0;
  bool finished = false;  ///< its segment has ended

  /// Position at a fraction 0..1 of the path, and its slope.
  double PositionAt(double part) const;
  double SlopeAt(double part) const;

  auto Fields(auto visit) const {
    return visit(profile, begin, displacement, ramp_up, ramp_down, finished);
  }
};

/// The event that a run waits for before it continues.
enum class CrdWait : uint8_t {
  kNone,
  kDelay,
  kMove,
  kOverride,  ///< at rest in a segment, until an override that is not 0 lets it go on
  kData       ///< for the next slot of an open list
};

struct CrdRun {
  bool running = false;
  size_t fifo = 0;
  Micros begin = 0;
  double at = 0;   ///< time since `begin` at which the plan, or the next slot, begins, ms
  Plan plan;       ///< along the path of the segment, or of a cell of `curve`
  CurveRun curve;  ///< of an arc whose axes hold it back
  double velocity = 0;
  double acceleration = 0;
  bool stopping = false;
  double stop_deceleration = 0;
  bool single_step = false;  ///< ends after one segment
  CrdWait wait = CrdWait::kNone;
  double wait_until = 0;    ///< ms since `begin`
  BufferedCommand command;  ///< being carried out

  /// True if time alone does not end the wait.
  bool WaitsForOthers() const { return wait != CrdWait::kNone && wait != CrdWait::kDelay; }

  auto Fields(auto visit) const {
    return visit(running, fifo, begin, at, plan, curve, velocity, acceleration, stopping,
                 stop_deceleration, single_step, wait, wait_until, command);
  }
};

/// How the path stops at a limit of one of its axes (GT_SetCrdLmtStopMode).
struct LimitStop {
  bool smooth = false;  ///< with the deceleration of a smooth stop, not of an abrupt one

  bool in_use() const { return smooth; }
  auto Fields(auto visit) const { return visit(smooth); }
};

/// How a path begins and ends (GT_SetStrtVel of GE).
struct PathStart {
  /// A run takes this velocity, or its feed if that is lower, at once when it leaves rest, and
  /// rests at once when it has slowed down to it.
  double velocity = 0;

  bool in_use() const { return velocity != 0; }
  auto Fields(auto visit) const { return visit(velocity); }
};

struct Crd {
  CrdParameters parameters;
  std::array<int32_t, kCrdDimensionMax> members{};  ///< profile of each coordinate, from 0
  Coordinates origin{};
  Coordinates position{};  ///< current position of the path
  double smooth_stop = CardDefaults{}.smooth_stop;
  double abrupt_stop = CardDefaults{}.abrupt_stop;
  LimitStop limit_stop;
  PathStart start;
  // An override of 0 brings the path to rest with the acceleration of its segments, and holds it
  // until it is raised.
  double override_ratio = 1;   ///< GT_SetOverride
  double second_override = 1;  ///< GT_SetOverride2, for the segments that select it
  bool step_mode = false;
  /// GT_SetCrdSingleMaxVel, pulse/ms.
  Coordinates axis_velocity_max = {kNoVelocityLimit, kNoVelocityLimit, kNoVelocityLimit,
                                   kNoVelocityLimit};
  std::array<CrdFifo, kCrdFifoCount> fifos;
  CrdRun run;
  std::array<GearShare, kAxisMax> gears;
  uint32_t gear_count = 0;
  Rare<CoordinateMap> map;  ///< its axes are the members

  static constexpr double kNoVelocityLimit = 32767;

  bool exists() const { return parameters.dimension > 0; }
  size_t dimension() const { return static_cast<size_t>(parameters.dimension); }
  bool HasMember(size_t profile) const;
  /// True if it writes the profile's output, as that of a member or of a BufGear axis.
  bool Drives(size_t profile) const;
  CrdFifo& active() { return fifos[run.fifo]; }
  const CrdFifo& active() const { return fifos[run.fifo]; }

  /// True if the run will still reach a command for which the predicate holds. Slots in the
  /// look-ahead ring do not count: they do not reach the FIFO by themselves.
  template <typename Predicate>
  bool WillReach(Predicate predicate) const {
    if (!run.running) return false;
    const SlotQueue& slots = active().slots;
    for (size_t i = 0; i < slots.size(); ++i) {
      const PathSlot& slot = slots.At(i);
      if (!slot.is_segment && predicate(slot.command)) return true;
    }
    return false;
  }

  /// The direction in which a run that has been started begins; 0 if not with a segment.
  Coordinates FirstDirection() const;
  /// The largest velocity along a segment that GT_SetCrdSingleMaxVel allows.
  double VelocityLimit(const Segment& segment) const;
  /// Appends a slot to a FIFO; false if there is no space, and then nothing has changed.
  bool Append(size_t fifo, const PathSlot& slot, Micros now);
  /// Makes the last segment of a FIFO end at rest, even if it is being executed.
  void RestAfterLast(size_t fifo, Micros now);
  /// Empties a FIFO and its look-ahead ring, and discards the breakpoint.
  void Clear(size_t fifo);

  /// Begins a run, or resumes at the breakpoint, still waiting for a modal move that has not ended;
  /// the FIFO or the breakpoint must hold something.
  void Start(size_t fifo, bool single_step, Micros now);
  /// Starts a run from any position: a line with the velocity, acceleration and override of `back`
  /// leads to the breakpoint, where the path rests before it goes on. Without length the line is
  /// left out; a line back that was stopped is made anew, and so is an approach.
  void Resume(size_t fifo, const PathSlot& back, Micros now);
  /// Decelerates along the path; a faster stop replaces a slower one.
  void Stop(bool abrupt, Micros now);
  /// Rests at once where the path is.
  void Halt();
  /// Plans the rest of the segment again after a change of an override or a limit.
  void Replan(Micros now);
  /// Advances time to `now`. If the result is not NULL, it is a command that the caller must
  /// execute before it calls this function again.
  const BufferedCommand* Advance(Micros now);
  /// Waits for a modal GT_BufMove until EndMove().
  void AwaitMove(const BufferedCommand& move);
  /// The profile of the modal move has arrived at `now`.
  void EndMove(Micros now);
  /// Ends an open list, and a run that waits for its data.
  void CloseList(size_t fifo);
  /// Limits the joints of all FIFOs anew after a change of the map.
  void LimitJoints(Micros now);

  auto Fields(auto visit) const {
    return visit(parameters, members, origin, position, smooth_stop, abrupt_stop, limit_stop, start,
                 override_ratio, second_override, step_mode, axis_velocity_max, fifos, run, gears,
                 gear_count, map);
  }

  // Parts of the functions above.
  /// The velocity of a segment with the override that applies to it.
  double FeedOf(const PathSlot& slot) const;
  /// The velocity at the end of the current segment: as planned or as JointRule says, and with
  /// overrides also so that no later segment of the FIFO is entered faster than its override
  /// allows.
  double EndOfCurrent() const;
  /// The square of the largest velocity at which the next segment may be entered so that all later
  /// ones of the FIFO can be; what lies beyond a distance to brake from `most`, a square, does not
  /// count.
  double SquareAhead(double most, bool brakes) const;
  /// Limits the velocity at the joint of two segments of a list by the jumps of its axes.
  void LimitJoint(const SegmentList& list, PathSlot* before, const PathSlot& after) const;
  /// The largest velocity at the end of a segment, whatever follows. If the path brakes, only a
  /// rest limits it, and what the axes can bear.
  double EndLimit(const PathSlot& slot, bool brakes) const;
  PathSpan SpanOfCurrent() const;
  Plan PlanCurrent();
  void AwaitData();
  void EndPlan();
  void TakeSlot();
  /// Makes the line of the current slot, an approach, from the position; false if it has no length,
  /// and then nothing has changed.
  bool MakeApproach(CrdFifo& fifo) const;
  void EndSegment();
  void EndRun();
};

}  // namespace oncard::motion
