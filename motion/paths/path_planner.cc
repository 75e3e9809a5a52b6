#include "motion/paths/path_planner.h"

#include <algorithm>
#include <cmath>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<AxisLimits> && kFieldsComplete<PathLimits> &&
              kFieldsComplete<WindowSpan> && kFieldsComplete<NewestSegment> &&
              kFieldsComplete<PathPlanner> && kFieldsComplete<CurveRun> &&
              kFieldsComplete<FollowRamps> && kFieldsComplete<WindowRule> &&
              kFieldsComplete<CornerWindow> && kFieldsComplete<PathSlot> &&
              kFieldsComplete<BufferedCommand> && kFieldsComplete<PathApproach>);

/// The largest speed with which a component of the tangent may change at once.
double JumpSpeed(double jump, double before, double after) {
  const double change = std::fabs(after - before);
  return jump < kUnlimited && change > 1e-12 ? jump / change : kUnlimited;
}

/// The shorter of two parts that are not 0, or 0.
double ShorterRamp(double up, double down) {
  return up > 0 && down > 0 ? std::min(up, down) : std::max(up, down);
}

/// The slopes at the end of a segment at which they have these ramps.
FollowSlopes WithoutRamps(FollowSlopes slopes, const std::array<double, kFollowerMax>& ramps) {
  for (size_t i = 0; i < slopes.size(); ++i) slopes[i] = ramps[i] > 0 ? 0 : slopes[i];
  return slopes;
}

/// The arc of a slot with what limits it.
CurvedSpan CurvedSpanOf(const PathSlot& slot, double top) {
  return {slot.segment, top, slot.acceleration, slot.planned.axis_velocity,
          slot.planned.axis_acceleration};
}

}  // namespace

void BeginCurve(const PathSlot& slot, const PathSpan& span, CurveRun* run) {
  PlanCurve(CurvedSpanOf(slot, span.target * span.target), span.begin,
            span.velocity * span.velocity, span.end_velocity * span.end_velocity, &run->squares);
  run->begin = span.begin;
  run->step = (span.end - span.begin) / static_cast<double>(run->squares.size() - 1);
  run->cell = 0;
}

double SquareBefore(const PathSlot& slot, double top, double after) {
  if (slot.planned.curved) return CurveReach(CurvedSpanOf(slot, top), after);
  return std::min(top, after + 2 * slot.acceleration * slot.segment.length);
}

Plan PlanCell(const CurveRun& run, double length) {
  Plan plan;
  const double first = std::sqrt(run.squares[run.cell]);
  const double last = std::sqrt(run.squares[run.cell + size_t{1}]);
  plan.end_position = run.begin + static_cast<double>(run.cell) * run.step;
  AppendRamp(first, last, run.step, &plan);
  plan.end_position =
      run.AtLast() ? length : run.begin + (static_cast<double>(run.cell) + 1) * run.step;
  plan.end_velocity = last;
  return plan;
}

// --- Limits of a segment -----------------------------------------------------------------------

void PathPlanner::LimitAxes(PathSlot& slot) const {
  slot.planned.axis_velocity.fill(kUnlimited);
  slot.planned.axis_acceleration.fill(kUnlimited);
  if (slot.segment.shape == SegmentShape::kLine) {
    const Coordinates tangent = slot.segment.TangentAt(0);
    for (size_t i = 0; i < tangent.size(); ++i) {
      const double share = std::fabs(tangent[i]);
      if (share * slot.velocity_limit > limits.axes[i].velocity) {
        slot.velocity_limit = limits.axes[i].velocity / share;
      }
      if (share * slot.acceleration > limits.axes[i].acceleration) {
        slot.acceleration = limits.axes[i].acceleration / share;
      }
    }
    return;
  }
  for (size_t i = 0; i < limits.axes.size(); ++i) {
    slot.planned.axis_velocity[i] = limits.axes[i].velocity;
    slot.planned.axis_acceleration[i] = limits.axes[i].acceleration;
  }
  slot.planned.curved = IsHeldBack(CurvedSpanOf(slot, slot.velocity_limit * slot.velocity_limit));
}

void PathPlanner::LimitFollowers(const FollowSlopes& slopes, PathSlot& slot) const {
  for (size_t i = 0; i < slopes.size(); ++i) {
    const double share = std::fabs(slopes[i]);
    if (share * slot.velocity_limit > limits.followers[i].velocity) {
      slot.velocity_limit = limits.followers[i].velocity / share;
    }
    double allowed = limits.followers[i].acceleration;
    const double ramp = ShorterRamp(ramps.up[i], ramps.down[i]) * slot.segment.length;
    if (ramp > 0 && share > 0 && allowed < kUnlimited) {
      // In a ramp the slope changes as well: half for that, and half for the path's acceleration.
      allowed /= 2;
      slot.velocity_limit = std::min(slot.velocity_limit, std::sqrt(allowed * ramp / share));
    }
    if (share * slot.acceleration > allowed) slot.acceleration = allowed / share;
  }
}

double PathPlanner::LimitCurve(PathSlot& slot, double commanded) {
  if (!limits.geometric) return kUnlimited;
  if (slot.segment.shape == SegmentShape::kArc) {
    // Measured along the path, also on a helix.
    const Segment& arc = slot.segment;
    const double turning = arc.sweep / arc.length;
    const double radius = std::min(arc.radius, arc.radius + arc.radius_change);
    const double bend = radius * turning * turning;
    return bend > 0 ? limits.radius_ratio * commanded / bend : kUnlimited;
  }
  if (!newest.exists || newest.rests || !newest.line) return kUnlimited;
  const double radius =
      RadiusThrough(limits.length_axes, newest.start, slot.segment.start, slot.segment.end);
  if (radius == kUnlimited) return kUnlimited;
  // The line before is a chord of the same circle.
  WindowSpan& before = spans.back();
  before.top = std::min(before.top, limits.radius_ratio * newest.commanded * radius);
  before.junction = std::min(before.junction, before.top);
  PathSlot& limited = ring.At(static_cast<size_t>(before.slot - taken));
  limited.velocity_limit = std::min(limited.velocity_limit, std::sqrt(before.top));
  return limits.radius_ratio * commanded * radius;
}

double PathPlanner::JunctionBefore(const PathSlot& slot, double commanded,
                                   const FollowSlopes& slopes) const {
  if (!newest.exists || newest.rests) return 0;
  const Coordinates tangent = slot.segment.TangentAt(0);
  double junction = slot.velocity_limit;
  if (limits.geometric) {
    junction =
        std::min(junction, CornerSpeed(limits.length_axes, newest.tangent, tangent,
                                       std::min(commanded, newest.commanded), limits.corner_time));
  }
  for (size_t i = 0; i < tangent.size(); ++i) {
    junction = std::min(junction, JumpSpeed(limits.axes[i].jump, newest.tangent[i], tangent[i]));
  }
  for (size_t i = 0; i < slopes.size(); ++i) {
    junction = std::min(junction, JumpSpeed(limits.followers[i].jump, newest.follow[i], slopes[i]));
  }
  return std::min(spans.back().top, junction * junction);
}

// --- The window --------------------------------------------------------------------------------

void PathPlanner::Push(const PathSlot& pushed) {
  ring.Push(pushed);
  PathSlot& slot = ring.back();
  if (slot.is_segment && of_corners()) {
    PushCorner(slot);
    return;
  }
  if (slot.is_segment) {
    PushSegment(slot);
    return;
  }
  newest.rests = newest.rests || slot.command.NeedsRest();
  const auto profile = static_cast<size_t>(slot.command.item);
  if (slot.command.kind == BufferedKind::kGear && profile < kFollowerMax) {
    // With ramps the slope is larger in between (GearShare).
    const double up = slot.command.values[1];
    const double down = slot.command.values[2];
    following[profile] = slot.command.values[0] / (1 - up / 2 - down / 2);
    ramps.up[profile] = up;
    ramps.down[profile] = down;
    ramps.any = ramps.any || up > 0 || down > 0;
  }
}

void PathPlanner::PushSegment(PathSlot& slot) {
  const double commanded = slot.acceleration;
  FollowSlopes slopes;
  for (size_t i = 0; i < slopes.size(); ++i) slopes[i] = following[i] / slot.segment.length;
  following = {};
  slot.planned.planned = true;
  slot.velocity_limit = std::min(slot.velocity_limit, slot.velocity);
  LimitFollowers(slopes, slot);
  const double curve = LimitCurve(slot, commanded);
  slot.velocity_limit = std::min(slot.velocity_limit, std::sqrt(curve));
  LimitAxes(slot);
  spans.Push({.length = slot.segment.length,
              .acceleration = slot.acceleration,
              .top = slot.velocity_limit * slot.velocity_limit,
              .junction = JunctionBefore(slot, commanded, WithoutRamps(slopes, ramps.up)),
              .reach = 0,
              .slot = taken + ring.size() - 1,
              .curved = slot.planned.curved});
  newest = {.exists = true,
            .rests = slot.ends_at_rest,
            .line = slot.segment.shape == SegmentShape::kLine,
            .start = slot.segment.start,
            .tangent = slot.segment.TangentAt(slot.segment.length),
            .commanded = commanded,
            .follow = WithoutRamps(slopes, ramps.down)};
  ramps = {};
}

size_t PathPlanner::LeavingFor(const PathSlot& slot) const {
  if (of_corners()) return ring.size() < capacity ? 0 : 1;
  if (slot.is_segment) return spans.size() < capacity ? 0 : LeavingNext();
  // Commands before the first segment wait for nothing.
  return spans.empty() ? 1 : 0;
}

size_t PathPlanner::LeavingNext() const {
  if (spans.size() < 2) return ring.size();
  return static_cast<size_t>(spans.At(1).slot - taken);
}

double PathPlanner::Before(const WindowSpan& span, double after) const {
  if (span.curved) {
    return std::min(span.junction, CurveReach(CurvedSpanOf(SlotOf(span), span.top), after));
  }
  return std::min(span.junction, after + 2 * span.acceleration * span.length);
}

double PathPlanner::After(const WindowSpan& span, double after) const {
  if (span.curved) return CurveEnd(CurvedSpanOf(SlotOf(span), span.top), speed, after);
  return std::min(after, speed + 2 * span.acceleration * span.length);
}

double PathPlanner::SureTop() const {
  if (!limits.geometric || !newest.line || newest.rests) return kUnlimited;
  // The next line can make this one a chord of a circle. It turns by less than 30 degrees, so that
  // the circle's radius is at least the length of the chord.
  return limits.radius_ratio * newest.commanded * spans.back().length;
}

void PathPlanner::PassBackward(bool ended) {
  const size_t count = spans.size();
  double planned = 0;
  // At the newest segment's start at least rest is possible, and at most its junction.
  double least = 0;
  double most = 0;
  size_t joined = 0;
  for (size_t i = count; i > std::max(settled, size_t{1}); --i) {
    WindowSpan& span = spans.At(i - 1);
    planned = Before(span, planned);
    if (i == count) {
      most = span.junction;
      if (!ended) planned = std::min(planned, SureTop());
    } else if (joined == 0) {
      least = Before(span, least);
      most = Before(span, most);
    }
    span.reach = planned;
    if (joined == 0 && least == most) joined = i;
  }
  // The newest segment's own limits still depend on the next one.
  settled = std::max(settled, std::min(joined, count - 1));
}

PathSlot PathPlanner::Take(bool ended) {
  if (of_corners()) return TakeCorner();
  if (!ring.front().is_segment) {
    const PathSlot slot = ring.front();
    ring.Pop();
    ++taken;
    if (ring.empty()) newest.exists = false;
    return slot;
  }
  double after = 0;
  if (spans.size() > 1) {
    if (settled < 2) PassBackward(ended);
    after = spans.At(1).reach;
  }
  speed = std::max(After(spans.front(), after), 0.0);
  PathSlot slot = ring.front();
  slot.end_velocity = std::sqrt(speed);
  ring.Pop();
  ++taken;
  spans.Pop();
  if (settled > 0) --settled;
  if (spans.empty()) {
    newest.exists = false;
    newest.rests = false;
  }
  return slot;
}

// --- A window of corners -----------------------------------------------------------------------

double PathPlanner::CornerBefore(const Coordinates& tangent) const {
  return CornerSpeed(kAllCoordinates, newest.tangent, tangent, limits.rule.acceleration,
                     limits.corner_time);
}

CornerAhead PathPlanner::CornerBefore(const PathSlot& slot) const {
  if (!of_corners() || !newest.exists || newest.rests) return {};
  return {CornerBefore(slot.segment.TangentAt(0)), std::min(slot.velocity, corners.velocity)};
}

void PathPlanner::PushCorner(PathSlot& slot) {
  const double radius = slot.segment.radius;
  if (radius > 0) {
    slot.velocity_limit =
        std::min(slot.velocity_limit, std::sqrt(limits.rule.acceleration * radius));
  }
  const double velocity = std::min(slot.velocity, slot.velocity_limit);
  double junction = 0;
  if (newest.exists && !newest.rests) {
    junction = std::min({velocity, corners.velocity, CornerBefore(slot.segment.TangentAt(0))});
  }
  corners.chain.Push({junction * junction, 2 * slot.acceleration * slot.segment.length});
  corners.velocity = velocity;
  newest.exists = true;
  newest.rests = slot.ends_at_rest;
  newest.tangent = slot.segment.TangentAt(slot.segment.length);
}

PathSlot PathPlanner::TakeCorner() {
  PathSlot slot = ring.front();
  ring.Pop();
  if (slot.is_segment) {
    corners.chain.Pop();
    const double reachable =
        corners.speed * corners.speed + 2 * slot.acceleration * slot.segment.length;
    corners.speed = std::sqrt(std::min(corners.chain.SpeedSquare(), reachable));
    slot.end_velocity = corners.speed;
  }
  if (ring.empty()) {
    newest.exists = false;
    newest.rests = false;
  }
  return slot;
}

// --- The time of a virtual run -----------------------------------------------------------------

void PathPlanner::Pass(const PathSlot& slot) {
  if (slot.is_segment) {
    PassSegment(slot);
  } else if (slot.command.kind == BufferedKind::kDelay) {
    virtual_run.time += slot.command.values[0];
    virtual_run.velocity = 0;
  } else if (slot.command.kind == BufferedKind::kMove) {
    PassMove(slot.command);
  }
}

void PathPlanner::PassSegment(const PathSlot& slot) {
  VirtualRun& run = virtual_run;
  const PathSpan span = {.begin = 0,
                         .end = slot.segment.length,
                         .velocity = run.velocity,
                         .target = std::min(slot.velocity, slot.velocity_limit),
                         .end_velocity = slot.ends_at_rest ? 0 : slot.end_velocity,
                         .acceleration = slot.acceleration,
                         .even_time = 0};
  Plan plan;
  if (slot.planned.curved) {
    BeginCurve(slot, span, &run.curve);
    plan = PlanCell(run.curve, span.end);
    while (!run.curve.AtLast()) {
      run.time += plan.duration;
      ++run.curve.cell;
      plan = PlanCell(run.curve, span.end);
    }
    run.curve = {};
  } else {
    plan = PlanSpan(span);
  }
  run.time += plan.duration;
  run.velocity = plan.end_velocity;
}

void PathPlanner::PassMove(const BufferedCommand& move) {
  VirtualRun& run = virtual_run;
  double& position = run.moved[static_cast<size_t>(move.item)];
  const Plan plan =
      PlanToPosition(position, 0, move.values[0], {move.values[1], move.values[2], move.values[2]});
  position = move.values[0];
  if (move.detail == 0) return;
  // It begins with a cycle, and so does what follows.
  const auto to_cycle = [&](double time) {
    return run.cycle > 0 ? std::ceil(time / run.cycle - 1e-9) * run.cycle : time;
  };
  run.time = to_cycle(to_cycle(run.time) + plan.duration);
  run.velocity = 0;
}

void PathPlanner::Clear() {
  ring.Clear();
  spans.Clear();
  settled = 0;
  speed = 0;
  corners.chain = {};
  corners.speed = 0;
  // A window of corners keeps the direction of its last segment.
  newest = {.tangent = of_corners() ? newest.tangent : Coordinates{}};
  following = {};
  ramps = {};
  virtual_run.time = 0;
  virtual_run.velocity = 0;
}

}  // namespace oncard::motion
