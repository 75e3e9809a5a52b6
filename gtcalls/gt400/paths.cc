#include "gtcalls/gt400/paths.h"

#include <cmath>

#include "gtcalls/gt400/drives.h"
#include "gtcalls/gt400/events.h"
#include "gtcalls/gt400/gt400_state.h"
#include "gtcalls/gt400/stops.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::CoordinateMap;
using motion::Crd;

Path& PathIn(const Card& card) { return card.state<Gt400State>().path; }

constexpr uint16_t kNoMotionBit = 1u << 0;
constexpr uint16_t kListClosedBit = 1u << 1;
constexpr uint16_t kPathRefusedBit = 1u << 3;
constexpr uint16_t kNoSegmentBit = 1u << 4;
constexpr uint16_t kAxisJumpedBit = 1u << 5;
constexpr uint16_t kStopsTogetherBit = 1u << 6;
constexpr uint16_t kImmediateBit = 1u << 7;
constexpr uint16_t kStoppedByAxisBit = 1u << 9;
constexpr uint16_t kListEmptyBit = 1u << 13;

}  // namespace

// --- The coordinate system -------------------------------------------------------------------

const Crd& CrdOf(const CardView& card) {
  return card.motion.part<&motion::MotionState::crds>().front();
}

motion::CrdDriver DriverOf(Card& card) {
  motion::CrdDriver driver = card.motion.CrdAt(0);
  if (CrdOf(card.view()).exists()) return driver;
  motion::CrdParameters parameters;
  parameters.dimension = static_cast<int16_t>(motion::kCrdDimensionMax);
  parameters.velocity_max = motion::kUnlimited;
  driver.SetUp(parameters);
  driver.BeginMap();
  driver.SetJoints(kListFifo, motion::JointRule::kAxisJumps);
  for (size_t axis = 0; axis < kAxisMax; ++axis) driver.SetJump(axis, kRateMax);
  return driver;
}

double JumpLimitOf(const CardView& card, size_t axis) {
  const Crd& crd = CrdOf(card);
  return crd.map ? crd.map->jumps[axis] : kRateMax;
}

bool PathRuns(const CardView& card) { return CrdOf(card).run.running; }

bool ListRuns(const CardView& card) { return PathRuns(card) && CrdOf(card).run.fifo == kListFifo; }

uint16_t PathStatusWord(const CardView& card) {
  const Path& path = card.state<Gt400State>().path;
  const Crd& crd = CrdOf(card);
  uint16_t word = 0;
  const auto set = [&](uint16_t bit, bool on) {
    if (on) word = static_cast<uint16_t>(word | bit);
  };
  set(kNoMotionBit, !crd.run.running);
  set(kListClosedBit, !path.list.open);
  set(kPathRefusedBit, card.state<Gt400State>().path_refused);
  // A segment that begins with the next tick counts: a host may ask at once whether it has ended.
  set(kNoSegmentBit, !crd.run.running || crd.active().idle());
  set(kAxisJumpedBit, path.jumped);
  set(kStopsTogetherBit, !crd.map || crd.map->stops_together);
  set(kImmediateBit, path.immediate);
  set(kStoppedByAxisBit, crd.map && crd.map->held);
  set(kListEmptyBit, crd.fifos[kListFifo].idle());
  return word;
}

// --- Axes that stop a path -------------------------------------------------------------------

namespace {

/// True if the axis cannot follow a path.
bool IsAbnormal(const Card& card, size_t axis) {
  return IsInOpenLoop(card, axis) || !card.motion.axis(axis).servo_on ||
         (EventsOf(card.view(), axis) & kAlarmEventBit) != 0;
}

/// A path that has been started stops at once if an axis cannot follow it.
void StopAtStart(Card& card) {
  const motion::Coordinates direction = CrdOf(card.view()).FirstDirection();
  for (size_t axis = 0; axis < kAxisMax && PathRuns(card.view()); ++axis) {
    const CoordinateMap& map = *CrdOf(card.view()).map;
    if (!map.Has(axis)) continue;
    if (RefuseAtLimit(card, axis, map.Along(axis, direction)) || IsAbnormal(card, axis)) {
      DriverOf(card).StopFor(axis, true);
    }
  }
}

/// The motion core stops an axis that moves into a limit. One that is pushed there stops the path,
/// too.
void StopInTick(Card& card) {
  constexpr uint32_t kLimits = kPositiveLimitEventBit | kNegativeLimitEventBit;
  Path& path = PathIn(card);
  for (size_t axis = 0; axis < kAxisMax; ++axis) {
    const auto limits = static_cast<uint8_t>(EventsOf(card.view(), axis) & kLimits);
    const bool reached = (limits & ~path.limits[axis]) != 0;
    path.limits[axis] = limits;
    const CoordinateMap& map = *CrdOf(card.view()).map;
    if (!PathRuns(card.view()) || !map.Has(axis)) continue;
    if (IsAbnormal(card, axis) || (reached && map.stops_together)) {
      DriverOf(card).StopFor(axis, true);
    }
  }
}

/// Rounding makes no alarm of an acceleration that is exactly the limit.
constexpr double kJumpTolerance = 1 + 0x1p-20;

/// Judges by how much the velocities of axes have changed in the tick. Assumption: where segments
/// meet, what the path's own acceleration adds to a jump is allowed.
void JudgeJumps(Card& card) {
  Path& path = PathIn(card);
  const Crd& crd = CrdOf(card.view());
  const bool passed_joint = crd.active().done != path.done;
  path.done = crd.active().done;
  const double acceleration = passed_joint ? crd.active().current.acceleration : 0;
  for (size_t axis = 0; axis < kAxisMax; ++axis) {
    const double velocity = crd.map->Has(axis) ? card.motion.profile(axis).now.velocity : 0;
    const double change = std::fabs(velocity - path.velocities[axis]);
    path.velocities[axis] = velocity;
    const double scale =
        motion::LengthIn(motion::kAllCoordinates, crd.map->rows[axis].coefficients);
    const double allowed = crd.map->jumps[axis] * kJumpTolerance + scale * acceleration;
    if (crd.run.running && change > allowed) path.jumped = true;
  }
}

}  // namespace

// --- Runs ------------------------------------------------------------------------------------

namespace {

void NoticeAxes(Card& card) {
  for (size_t axis = 0; axis < kAxisMax; ++axis) NoticeMotion(card, axis);
}

/// A run has ended.
void EndRun(Card& card) {
  Path& path = PathIn(card);
  const Crd& crd = CrdOf(card.view());
  const motion::CrdFifo& list = crd.fifos[kListFifo];
  const bool is_list = crd.run.fifo == kListFifo;
  // The run of an open list has no end of its own.
  const bool finished = crd.active().idle() && !(is_list && path.list.open);
  // A single segment has no break point.
  if (!is_list) DriverOf(card).Clear(kSingleFifo);
  if (finished) {
    // A list that waited for more, or one that has ended while it stopped.
    if (is_list && path.commanded) path.break_point = crd.position;
    return;
  }
  CloseList(card);
  if (!is_list || list.idle()) return;
  // On the way to the start point, or back, the break point stays what it was.
  const bool at_start = list.executing && list.current.approach.in_use();
  if (list.begun() && !at_start && !list.interruption) path.break_point = crd.position;
}

void NoticeRun(Card& card) {
  Path& path = PathIn(card);
  if (path.runs && !PathRuns(card.view())) EndRun(card);
  path.runs = PathRuns(card.view());
}

/// A run has begun.
void BeginRun(Card& card) {
  PathIn(card).runs = true;
  PathIn(card).commanded = false;
  NoticeAxes(card);
  StopAtStart(card);
  NoticeRun(card);
  NoticeAxes(card);
}

}  // namespace

void StartSegment(Card& card, const motion::PathSlot& segment) {
  Path& path = PathIn(card);
  path.immediate = true;
  path.jumped = false;
  motion::CrdDriver driver = DriverOf(card);
  driver.ForgetHold();
  driver.Append(kSingleFifo, segment);
  driver.Start(kSingleFifo, false);
  BeginRun(card);
}

void StartList(Card& card) {
  const PathList& list = PathIn(card).list;
  motion::PathSlot back;
  back.velocity = list.velocity;
  back.acceleration = list.acceleration;
  motion::CrdDriver driver = DriverOf(card);
  // Coordinates that no command names stay, wherever they were when segments were appended.
  driver.KeepCoordinates(kListFifo, list.dimension);
  driver.Resume(kListFifo, back);
  BeginRun(card);
}

void CloseList(Card& card) {
  PathIn(card).list.open = false;
  if (CrdOf(card.view()).exists()) DriverOf(card).CloseList(kListFifo);
}

void StopPath(Card& card, bool at_once) {
  PathIn(card).commanded = true;
  CloseList(card);
  const Crd& crd = CrdOf(card.view());
  if (crd.run.running) {
    motion::CrdDriver driver = DriverOf(card);
    if (at_once || !crd.active().executing) {
      driver.Halt();
    } else {
      const double deceleration = crd.active().current.acceleration;
      driver.SetStopDecelerations(deceleration, deceleration);
      driver.Stop(false);
    }
  }
  NoticeRun(card);
  NoticeAxes(card);
}

void NoticePathStop(Card& card) {
  if (!PathIn(card).runs || PathRuns(card.view())) return;
  NoticeRun(card);
  NoticeAxes(card);
}

void AdvancePath(Card& card) {
  if (!CrdOf(card.view()).exists()) return;
  JudgeJumps(card);
  StopInTick(card);
  NoticeRun(card);
}

}  // namespace oncard::gtcalls::gt400
