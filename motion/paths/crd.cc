#include "motion/paths/crd.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<Crd> && kFieldsComplete<CrdParameters> && kFieldsComplete<CrdFifo> &&
              kFieldsComplete<CrdRun> && kFieldsComplete<GearShare> && kFieldsComplete<LimitStop> &&
              kFieldsComplete<PathStart> && kFieldsComplete<SegmentList> &&
              kFieldsComplete<Interruption>);

}  // namespace

// --- FIFOs -------------------------------------------------------------------------------------

bool CrdFifo::Append(const PathSlot& slot) {
  if (looks_ahead()) {
    if (!AppendPlanned(slot)) return false;
  } else {
    if (space() == 0) return false;
    slots.Push(slot);
  }
  if (slot.is_segment) Tail() = slot.segment.end;
  return true;
}

bool CrdFifo::AppendPlanned(const PathSlot& slot) {
  const size_t leaving = planner->LeavingFor(slot);
  if (!is_virtual() && space() < leaving) return false;
  const size_t before = planner->LeavesFirst() ? leaving : 0;
  for (size_t i = 0; i < before; ++i) TakePlanned(false);
  planner->Push(slot);
  for (size_t i = before; i < leaving; ++i) TakePlanned(false);
  return true;
}

void CrdFifo::TakePlanned(bool ended) {
  const PathSlot slot = planner->Take(ended);
  if (is_virtual()) {
    planner->Pass(slot);
  } else {
    slots.Push(slot);
  }
}

bool CrdFifo::Flush() {
  if (planner) planner->EndPath();
  while (planner && !planner->ring.empty()) {
    if (!is_virtual() && space() == 0) return false;
    TakePlanned(true);
  }
  return true;
}

void CrdFifo::LeaveLineBack() {
  if (!interruption) return;
  executing = interruption->executing;
  current = interruption->slot;
  path = interruption->path;
  interruption.Reset();
}

PathSlot* CrdFifo::SegmentInProgress() {
  if (interruption) return interruption->executing ? &interruption->slot : nullptr;
  return executing ? &current : nullptr;
}

PathSlot* CrdFifo::LastSegment() {
  PathSlot* last = slots.LastSegment();
  return last != nullptr ? last : SegmentInProgress();
}

bool Crd::Append(size_t fifo, const PathSlot& slot, Micros now) {
  CrdFifo& to = fifos[fifo];
  const bool joins =
      slot.is_segment && to.list.plans_joints() && run.running && run.fifo == fifo && to.executing;
  const double end = joins ? EndOfCurrent() : 0;
  if (to.space() > 0) LimitJoint(to.list, to.LastSegment(), slot);
  if (!to.Append(slot)) return false;
  if (joins && EndOfCurrent() != end) Replan(now);
  if (run.wait == CrdWait::kData && run.fifo == fifo) {
    run.wait = CrdWait::kNone;
    run.at = MsBetween(run.begin, now);
  }
  if (slot.is_segment || !slot.command.NeedsRest() || to.looks_ahead()) return true;
  RestAfterLast(fifo, now);
  return true;
}

void Crd::RestAfterLast(size_t fifo, Micros now) {
  CrdFifo& of = fifos[fifo];
  if (PathSlot* last = of.slots.LastSegment()) {
    last->ends_at_rest = true;
  } else if (of.executing) {
    (of.interruption ? of.interruption->slot : of.current).ends_at_rest = true;
    if (run.fifo == fifo) Replan(now);
  }
}

void Crd::Clear(size_t fifo) {
  CrdFifo& cleared = fifos[fifo];
  cleared.slots.Clear();
  if (cleared.planner) cleared.planner->Clear();
  cleared.executing = false;
  cleared.path = 0;
  cleared.interruption.Reset();
  cleared.awaits_move = false;
  cleared.done = 0;
}

bool Crd::HasMember(size_t profile) const {
  if (map) return profile < kMappedAxisMax && map->Has(profile);
  for (size_t i = 0; i < dimension(); ++i) {
    if (members[i] == static_cast<int32_t>(profile)) return true;
  }
  return false;
}

bool Crd::Drives(size_t profile) const {
  if (HasMember(profile)) return true;
  for (uint32_t i = 0; i < gear_count; ++i) {
    if (gears[i].profile == static_cast<int32_t>(profile)) return true;
  }
  return false;
}

Coordinates Crd::FirstDirection() const {
  const CrdFifo& fifo = active();
  if (fifo.executing) return fifo.current.segment.TangentAt(fifo.path);
  if (fifo.slots.empty() || !fifo.slots.front().is_segment) return {};
  const PathSlot& first = fifo.slots.front();
  return first.approach.in_use() ? Between(position, first.ApproachEnd(position))
                                 : first.segment.TangentAt(0);
}

double Crd::VelocityLimit(const Segment& segment) const {
  double limit = std::numeric_limits<double>::max();
  for (size_t i = 0; i < dimension(); ++i) {
    const double circle = segment.radius * segment.sweep *
                          std::sqrt(segment.toward_start[i] * segment.toward_start[i] +
                                    segment.sideways[i] * segment.sideways[i]);
    const double share = (circle + std::fabs(segment.travel[i])) / segment.length;
    if (share * limit > axis_velocity_max[i]) limit = axis_velocity_max[i] / share;
  }
  return limit;
}

// --- The run -----------------------------------------------------------------------------------

void Crd::Start(size_t fifo, bool single_step, Micros now) {
  const BufferedCommand command = run.command;
  run = {};
  run.command = command;
  run.running = true;
  run.fifo = fifo;
  run.begin = now;
  run.single_step = single_step;
  if (active().planner) run.curve.squares.reserve(kCurveNodeMax);
  if (active().executing) run.plan = PlanCurrent();
  if (active().awaits_move) run.wait = CrdWait::kMove;
}

void Crd::Resume(size_t fifo, const PathSlot& back, Micros now) {
  CrdFifo& from = fifos[fifo];
  from.LeaveLineBack();
  if (from.executing && from.current.approach.in_use()) {
    from.path = MakeApproach(from) ? 0 : from.current.segment.length;
  } else if (from.executing || from.done > 0) {
    if (const std::optional<Segment> line = MakeLine(position, from.Breakpoint())) {
      from.interruption.Emplace({from.executing, from.current, from.path});
      from.executing = true;
      from.current = back;
      from.current.is_segment = true;
      from.current.segment = *line;
      from.current.ends_at_rest = true;
      from.path = 0;
    }
  }
  Start(fifo, false, now);
}

void Crd::Stop(bool abrupt, Micros now) {
  if (!run.running) return;
  if (run.velocity == 0) {
    EndRun();
    return;
  }
  const double deceleration = abrupt ? abrupt_stop : smooth_stop;
  if (run.stopping && deceleration <= run.stop_deceleration) return;
  run.stopping = true;
  run.stop_deceleration = deceleration;
  Replan(now);
}

void Crd::Halt() {
  if (run.running) EndRun();
}

void Crd::Replan(Micros now) {
  if (!run.running || !active().executing) return;
  run.at = MsBetween(run.begin, now);
  run.wait = CrdWait::kNone;
  run.plan = PlanCurrent();
}

void Crd::AwaitMove(const BufferedCommand& move) {
  run.velocity = 0;
  run.wait = CrdWait::kMove;
  active().awaits_move = true;
  active().move = move;
}

void Crd::EndMove(Micros now) {
  active().awaits_move = false;
  run.wait = CrdWait::kNone;
  run.at = MsBetween(run.begin, now);
}

void Crd::AwaitData() {
  run.velocity = 0;
  run.acceleration = 0;
  run.wait = CrdWait::kData;
}

void Crd::CloseList(size_t fifo) {
  fifos[fifo].list.open = false;
  if (run.wait == CrdWait::kData && run.fifo == fifo) EndRun();
}

void Crd::LimitJoints(Micros now) {
  for (CrdFifo& fifo : fifos) {
    SlotQueue& slots = fifo.slots;
    PathSlot* before = fifo.SegmentInProgress();
    for (size_t i = 0; i < slots.size(); ++i) {
      LimitJoint(fifo.list, before, slots.At(i));
      before = &slots.At(i);
    }
  }
  Replan(now);
}

void Crd::LimitJoint(const SegmentList& list, PathSlot* before, const PathSlot& after) const {
  if (list.joints != JointRule::kAxisJumps || !map || before == nullptr) return;
  if (before->ends_at_rest || !before->is_segment || !after.is_segment) return;
  const Segment& segment = before->segment;
  before->end_velocity =
      map->SpeedAtTurn(Between(segment.TangentAt(segment.length), after.segment.TangentAt(0)));
}

double Crd::FeedOf(const PathSlot& slot) const {
  const double ratio = slot.second_override ? second_override : override_ratio;
  return std::min({slot.velocity * ratio, parameters.velocity_max, slot.velocity_limit});
}

double Crd::EndOfCurrent() const {
  const PathSlot& slot = active().current;
  if (active().list.plans_joints()) {
    // A path that brakes keeps its rests; joints between other segments do not make it brake
    // harder.
    const bool brakes = run.stopping || FeedOf(slot) == 0;
    const double most = std::min(brakes ? run.velocity : FeedOf(slot), EndLimit(slot, brakes));
    return std::sqrt(std::min(most * most, SquareAhead(most * most, brakes)));
  }
  if (!slot.planned.planned || (override_ratio == 1 && second_override == 1)) {
    return slot.end_velocity;
  }
  const double most = slot.end_velocity * slot.end_velocity;
  return std::sqrt(std::min(most, SquareAhead(most, false)));
}

double Crd::EndLimit(const PathSlot& slot, bool brakes) const {
  if (slot.ends_at_rest || slot.end_velocity <= start.velocity) return start.velocity;
  return brakes && active().list.joints == JointRule::kFeeds ? kUnlimited : slot.end_velocity;
}

double Crd::SquareAhead(double most, bool brakes) const {
  const SlotQueue& slots = active().slots;
  size_t count = 0;
  double gain = 0;
  for (; count < slots.size() && gain < most; ++count) {
    gain += 2 * slots.At(count).acceleration * slots.At(count).segment.length;
  }
  const double rest = start.velocity * start.velocity;
  const bool ends = active().list.plans_joints() && count == slots.size();
  double square = ends ? rest : std::numeric_limits<double>::max();
  for (size_t i = count; i-- > 0;) {
    const PathSlot& next = slots.At(i);
    if (!next.is_segment) continue;
    if (next.approach.in_use()) {
      square = rest;
      continue;
    }
    const double end = EndLimit(next, brakes);
    // A joint at the start velocity or below is a rest, which the path reaches with the former.
    const double after = std::max(std::min(square, end * end), rest);
    const double feed = brakes ? kUnlimited : FeedOf(next);
    square = SquareBefore(next, feed * feed, after);
  }
  return square;
}

PathSpan Crd::SpanOfCurrent() const {
  const PathSlot& slot = active().current;
  const bool rests = slot.ends_at_rest || step_mode || run.single_step;
  const double target = FeedOf(slot);
  // Rest is left with the start velocity, and reached from it.
  const auto moving = [&](double velocity) {
    return velocity > start.velocity ? velocity : std::min(start.velocity, target);
  };
  return {.begin = active().path,
          .end = slot.segment.length,
          .velocity = moving(run.velocity),
          .target = target,
          .end_velocity = moving(rests ? 0 : EndOfCurrent()),
          .acceleration = slot.acceleration,
          .even_time = slot.planned.planned ? 0 : static_cast<double>(parameters.even_time),
          .rest_velocity = start.velocity};
}

Plan Crd::PlanCurrent() {
  const PathSpan span = SpanOfCurrent();
  run.curve.squares.clear();
  if (run.stopping) return PlanSpanStop(span, run.stop_deceleration);
  if (!(span.target > 0)) return PlanSpanStop(span, span.acceleration);
  if (!active().current.planned.curved || !(span.begin < span.end)) return PlanSpan(span);
  BeginCurve(active().current, span, &run.curve);
  return PlanCell(run.curve, span.end);
}

const BufferedCommand* Crd::Advance(Micros now) {
  const double t = MsBetween(run.begin, now);
  while (run.running && !run.WaitsForOthers()) {
    if (run.wait == CrdWait::kDelay) {
      if (t < run.wait_until) return nullptr;
      run.at = run.wait_until;
      run.wait = CrdWait::kNone;
    }
    if (active().executing) {
      const double elapsed = t - run.at;
      if (elapsed < run.plan.duration) {
        const Sample sample = run.plan.At(elapsed);
        active().path = sample.position;
        run.velocity = sample.velocity;
        run.acceleration = sample.acceleration;
        return nullptr;
      }
      EndPlan();
      continue;
    }
    if (active().slots.empty()) {
      if (active().list.open) {
        AwaitData();
      } else {
        EndRun();
      }
      return nullptr;
    }
    const bool is_segment = active().slots.front().is_segment;
    TakeSlot();
    if (!is_segment && run.running && run.wait == CrdWait::kNone) return &run.command;
  }
  return nullptr;
}

void Crd::EndPlan() {
  CrdFifo& fifo = active();
  run.at += run.plan.duration;
  run.velocity = run.plan.end_velocity;
  run.acceleration = 0;
  fifo.path = run.plan.end_position;
  const bool halted = run.stopping && run.velocity <= start.velocity;
  if (run.curve.in_use() && !run.curve.AtLast()) {
    ++run.curve.cell;
    run.plan = PlanCell(run.curve, fifo.current.segment.length);
    return;
  }
  if (fifo.path >= fifo.current.segment.length) {
    EndSegment();
  } else if (!run.stopping) {
    run.velocity = 0;
    run.wait = CrdWait::kOverride;
  }
  if (halted) EndRun();
}

void Crd::EndSegment() {
  CrdFifo& fifo = active();
  position = fifo.current.segment.end;
  if (fifo.interruption) {
    fifo.LeaveLineBack();
    run.velocity = 0;
    if (fifo.executing) run.plan = PlanCurrent();
    return;
  }
  fifo.executing = false;
  ++fifo.done;
  for (uint32_t i = 0; i < gear_count; ++i) gears[i].finished = true;
  if (step_mode || run.single_step) EndRun();
}

bool Crd::MakeApproach(CrdFifo& fifo) const {
  PathSlot& slot = fifo.current;
  const std::optional<Segment> line = MakeLine(position, slot.ApproachEnd(position));
  if (line) slot.segment = *line;
  return line.has_value();
}

void Crd::TakeSlot() {
  CrdFifo& fifo = active();
  if (fifo.slots.front().is_segment) {
    fifo.current = fifo.slots.front();
    fifo.slots.Pop();
    fifo.executing = true;
    fifo.path = 0;
    if (fifo.current.approach.in_use() && !MakeApproach(fifo)) {
      fifo.current.segment.end = position;
      EndSegment();
    } else {
      run.plan = PlanCurrent();
    }
    return;
  }
  run.command = fifo.slots.front().command;
  fifo.slots.Pop();
  if (run.command.kind == BufferedKind::kDelay) {
    run.velocity = 0;
    run.wait = CrdWait::kDelay;
    run.wait_until = run.at + run.command.values[0];
  } else if (run.command.kind == BufferedKind::kHold) {
    EndRun();
  }
}

void Crd::EndRun() {
  run.running = false;
  run.stopping = false;
  run.single_step = false;
  run.wait = CrdWait::kNone;
  run.velocity = 0;
  run.acceleration = 0;
}

// --- Gears -------------------------------------------------------------------------------------

double GearShare::PositionAt(double part) const {
  // The slope rises evenly over ramp_up, is k, falls evenly over ramp_down; its integral is 1.
  const double k = 1 / (1 - ramp_up / 2 - ramp_down / 2);
  double done = k * (part - ramp_up / 2);
  if (part < ramp_up) {
    done = k * part * part / (2 * ramp_up);
  } else if (part > 1 - ramp_down) {
    done = 1 - k * (1 - part) * (1 - part) / (2 * ramp_down);
  }
  return begin + displacement * done;
}

double GearShare::SlopeAt(double part) const {
  const double k = displacement / (1 - ramp_up / 2 - ramp_down / 2);
  if (part < ramp_up) return k * part / ramp_up;
  return part > 1 - ramp_down ? k * (1 - part) / ramp_down : k;
}

}  // namespace oncard::motion
