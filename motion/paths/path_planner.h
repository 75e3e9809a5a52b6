// The window of segments before a buffer: how fast a path may be along its segments and from each
// to the next, given the segments that follow in the window, so that every limit of PathLimits is
// kept.
//
// Slots enter with Push and leave with Take, in order. A segment leaves with an end velocity from
// which all later limits can be kept, with rest at the end of the window. JointRule says what
// limits a joint.
//
// With JointRule::kAxes the path takes the shortest time. Within a segment the motion is one ramp
// up, a constant velocity and one ramp down (PlanSpan), or on an arc whose axes hold it back the
// motion of curved_span.h; both are the fastest between the velocities at their ends, so that a
// window that covers the whole path gives the fastest path.
//
// With x the square of the speed, each segment is a function from the x after it to the largest x
// before it, which never falls. Where even rest at the window's end and no end at all give the same
// x, nothing that follows can change it: it is settled, and is not computed again. A window longer
// than twice the distance to stop makes the cost of a segment independent of the window.
//
// With JointRule::kCorners the backward pass is a SpeedChain, which adds in another order: the
// results of GT_InitLookAhead keep their bits.
//
// Units: those of PathLimits; a card uses pulses and ms. Deterministic. Memory: the window. Not
// safe for several threads at once. Source: manual of the multi-axis look-ahead module, chapter 1.
// Tested by tests/motion/path_planner_test.cc and look_ahead_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/common/rare.h"
#include "motion/paths/curved_span.h"
#include "motion/paths/item_queue.h"
#include "motion/paths/path_limits.h"
#include "motion/paths/path_slot.h"
#include "motion/paths/path_span.h"
#include "motion/paths/speed_chain.h"

namespace oncard::motion {

/// The limits of a segment in the window. Speeds as squares.
struct WindowSpan {
  double length = 0;
  double acceleration = 0;
  double top = 0;       ///< the largest along it
  double junction = 0;  ///< the largest at its start, because of the segment before and the corner
  double reach = 0;     ///< the largest at its start from which all later limits can be kept
  uint64_t slot = 0;    ///< number of its slot, counted from the first that was pushed
  bool curved = false;  ///< as in PlannedMotion

  auto Fields(auto visit) const {
    return visit(length, acceleration, top, junction, reach, slot, curved);
  }
};

/// How the profiles that follow a segment move: change of position per length of path.
using FollowSlopes = std::array<double, kFollowerMax>;

/// The parts of a segment over which the slopes of its followers rise from 0 and fall to 0.
struct FollowRamps {
  bool any = false;
  std::array<double, kFollowerMax> up{};
  std::array<double, kFollowerMax> down{};

  bool in_use() const { return any; }
  auto Fields(auto visit) const { return visit(any, up, down); }
};

/// What the next segment must know of the newest one.
struct NewestSegment {
  bool exists = false;
  bool rests = false;  ///< the path is at rest after it
  bool line = false;
  Coordinates start{};
  Coordinates tangent{};  ///< at its end
  double commanded = 0;   ///< acceleration
  FollowSlopes follow{};  ///< at its end

  auto Fields(auto visit) const {
    return visit(exists, rests, line, start, tangent, commanded, follow);
  }
};

/// The time that a path would take (GT_InitLookAheadEx, motionMode 1).
struct VirtualRun {
  bool on = false;
  double cycle = 0;                      ///< of the card, ms: moves begin and end with it
  double time = 0;                       ///< ms
  double velocity = 0;                   ///< at the end of what has passed
  Coordinates end{};                     ///< where the last segment ends
  std::array<double, kAxisMax> moved{};  ///< where GT_BufMove has left the profiles
  CurveRun curve;

  bool in_use() const { return on; }
  auto Fields(auto visit) const { return visit(cycle, time, velocity, end, moved, curve); }
};

/// What JointRule::kCorners keeps beside the slots of the window.
struct CornerWindow {
  SpeedChain chain;     ///< of the segments
  double speed = 0;     ///< at the start of the oldest one
  double velocity = 0;  ///< the largest along the newest one

  bool in_use() const { return !chain.empty(); }
  auto Fields(auto visit) const { return visit(chain, speed, velocity); }
};

/// A corner before a segment: the velocity that it allows, and that both segments allow.
struct CornerAhead {
  double allowed = 0;
  double wanted = 0;
};

struct PathPlanner {
  PathLimits limits{};
  size_t capacity = 1;  ///< segments in the window (lookAheadNum), or slots; 0: none
  SlotQueue ring{};
  ItemQueue<WindowSpan> spans{};  ///< of the segments in the ring
  uint64_t taken = 0;             ///< slots that have left
  size_t settled = 0;             ///< spans whose `reach` cannot change any more, oldest first
  double speed = 0;               ///< square at the start of the oldest segment
  NewestSegment newest{};
  FollowSlopes following{};  ///< displacements of GT_BufGear for the next segment
  FollowRamps ramps{};       ///< theirs
  VirtualRun virtual_run{};
  CornerWindow corners{};

  /// False for a window of corners, which joins the hash another way (PlannerInHash).
  bool in_use() const { return !of_corners(); }
  /// What counts against `capacity`.
  size_t Held() const { return of_corners() ? ring.size() : spans.size(); }
  /// How many slots leave when this one enters.
  size_t LeavingFor(const PathSlot& slot) const;
  /// True if they leave before it enters.
  bool LeavesFirst() const { return of_corners(); }
  /// The corner between the newest segment and this one, if a rule of corners will limit it.
  CornerAhead CornerBefore(const PathSlot& slot) const;
  /// Adds a slot. A segment's length is measured with limits.length_axes by its owner.
  void Push(const PathSlot& pushed);
  /// The path in the window ends at rest. With corners it goes on if another segment enters before
  /// the window is empty.
  void EndPath() { newest.rests = newest.rests || !of_corners(); }
  /// The oldest slot with its end velocity planned; the ring must not be empty. `ended`: the newest
  /// segment is the path's last.
  PathSlot Take(bool ended);
  /// Adds the time of a slot that has left to virtual_run.
  void Pass(const PathSlot& slot);
  void Clear();

  auto Fields(auto visit) const {
    return visit(limits, capacity, ring, spans, taken, settled, speed, newest, following, ramps,
                 virtual_run, corners);
  }

  // Parts of the functions above.
  bool of_corners() const { return limits.rule.joints == JointRule::kCorners; }
  void PushCorner(PathSlot& slot);
  PathSlot TakeCorner();
  double CornerBefore(const Coordinates& tangent) const;
  /// The slots before the second segment.
  size_t LeavingNext() const;
  const PathSlot& SlotOf(const WindowSpan& span) const {
    return ring.At(static_cast<size_t>(span.slot - taken));
  }
  void PushSegment(PathSlot& slot);
  void LimitAxes(PathSlot& slot) const;
  void LimitFollowers(const FollowSlopes& slopes, PathSlot& slot) const;
  double JunctionBefore(const PathSlot& slot, double commanded, const FollowSlopes& slopes) const;
  double LimitCurve(PathSlot& slot, double commanded);
  double Before(const WindowSpan& span, double after) const;
  double After(const WindowSpan& span, double after) const;
  /// The square of a speed that every limit of the newest segment will allow, whatever follows.
  double SureTop() const;
  void PassBackward(bool ended);
  void PassSegment(const PathSlot& slot);
  void PassMove(const BufferedCommand& move);
};

/// A planner in the hash of its buffer: a window of corners, or an empty one, and then a window of
/// axes if there is one. Hashes of older versions, which had one of each, stay the same.
struct PlannerInHash {
  const Rare<PathPlanner>& planner;

  auto Fields(auto visit) const {
    const PathPlanner& window = planner && !planner->in_use() ? *planner : kNoWindow;
    return visit(window.limits.corner_time, window.limits.rule.acceleration, window.capacity,
                 window.ring, window.corners.chain, window.corners.speed, window.newest.exists,
                 window.newest.rests, window.corners.velocity, window.newest.tangent, planner);
  }

  static const PathPlanner kNoWindow;
};
inline const PathPlanner PlannerInHash::kNoWindow = {.capacity = 0};

/// Begins the motion along the rest of a curved segment.
void BeginCurve(const PathSlot& slot, const PathSpan& span, CurveRun* run);
/// The largest square of the speed at a planned segment's start, at most `top`, from which `after`
/// at its end, or less, can be reached.
double SquareBefore(const PathSlot& slot, double top, double after);
/// The motion along the present cell of an arc with that length.
Plan PlanCell(const CurveRun& run, double length);

}  // namespace oncard::motion
