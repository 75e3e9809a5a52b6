#include "motion/crd_driver.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace oncard::motion {
namespace {

MappedPositions MappedPositionsOf(std::span<const Profile> profiles) {
  MappedPositions positions;
  for (size_t i = 0; i < positions.size(); ++i) positions[i] = profiles[i].now.position;
  return positions;
}

}  // namespace

Coordinates PositionOf(const Crd& crd, std::span<const Profile> profiles) {
  if (crd.map) return crd.map->PointOf(MappedPositionsOf(profiles), crd.position);
  Coordinates position{};
  for (size_t i = 0; i < crd.dimension(); ++i) {
    const Profile& member = profiles[static_cast<size_t>(crd.members[i])];
    position[i] = member.now.position - crd.origin[i];
  }
  return position;
}

// --- Registers ---------------------------------------------------------------------------------

void CrdDriver::SetUp(CrdParameters parameters) {
  card_.LeaveLanes();
  for (size_t i = 0; i < crd_.dimension(); ++i) {
    Profile& left = card_.profile(crd_.members[i]);
    if (left.mode == ProfileMode::kCrd) left.mode = ProfileMode::kTrap;
  }
  for (uint32_t i = 0; i < crd_.gear_count; ++i) {
    card_.profile(crd_.gears[i].profile).driven = false;
  }
  crd_ = {};
  crd_.smooth_stop = card_.defaults().smooth_stop;
  crd_.abrupt_stop = card_.defaults().abrupt_stop;
  crd_.parameters = parameters;
  for (size_t i = 0; i < kCrdProfileCount; ++i) {
    const std::optional<size_t> coordinate = parameters.CoordinateOf(i);
    if (!coordinate) continue;
    Profile& member = card_.profiles()[i];
    crd_.members[*coordinate] = static_cast<int32_t>(i);
    crd_.origin[*coordinate] =
        parameters.sets_origin ? parameters.origin[*coordinate] : member.now.position;
    member.mode = ProfileMode::kCrd;
  }
  crd_.position = PositionOf(crd_, card_.profiles());
  for (CrdFifo& fifo : crd_.fifos) fifo.slots.slots.reserve(kCrdFifoSize);
}

void CrdDriver::SetStopDecelerations(double smooth, double abrupt) {
  crd_.smooth_stop = smooth;
  crd_.abrupt_stop = abrupt;
}

void CrdDriver::SetStepMode(bool on) {
  crd_.step_mode = on;
  crd_.Replan(card_.now());
}

void CrdDriver::SetOverride(double ratio) {
  crd_.override_ratio = ratio;
  crd_.Replan(card_.now());
}

void CrdDriver::SetSecondOverride(double ratio) {
  crd_.second_override = ratio;
  crd_.Replan(card_.now());
}

// --- The map -----------------------------------------------------------------------------------

void CrdDriver::BeginMap() {
  crd_.map.Emplace();
  crd_.position = {};
}

void CrdDriver::MapAxis(size_t axis, const MapRow& row) {
  card_.LeaveLanes();
  crd_.map->rows[axis] = row;
  card_.profiles()[axis].mode = ProfileMode::kCrd;
  crd_.position = crd_.map->PointOf(MappedPositionsOf(card_.profiles()), {});
  crd_.LimitJoints(card_.now());
}

void CrdDriver::SetJump(size_t axis, double velocity) {
  crd_.map->jumps[axis] = velocity;
  crd_.LimitJoints(card_.now());
}

void CrdDriver::LeaveMap(size_t axis) {
  card_.LeaveLanes();
  crd_.map->rows[axis] = {};
  Profile& left = card_.profiles()[axis];
  left.driven = false;
  left.now = AtRest(left.now.position);
  crd_.LimitJoints(card_.now());
}

// --- FIFOs -------------------------------------------------------------------------------------

void CrdDriver::BeginLookAhead(size_t fifo, double time, double acceleration, size_t capacity) {
  PathLimits limits;
  limits.rule = {JointRule::kCorners, acceleration};
  limits.corner_time = time;
  crd_.fifos[fifo].planner.Emplace({.limits = limits, .capacity = capacity});
}

void CrdDriver::BeginPlanner(size_t number, const PathLimits& limits, size_t capacity) {
  card_.LeaveLanes();
  CrdFifo& fifo = crd_.fifos[number];
  const Coordinates start = fifo.Remaining() == 0 ? PositionOf(crd_, card_.profiles()) : fifo.tail;
  // The planner's path begins at rest, also after a segment with an end velocity.
  if (!fifo.looks_ahead()) crd_.RestAfterLast(number, card_.now());
  fifo.planner.Emplace({.limits = limits, .capacity = capacity});
  fifo.tail = start;
}

void CrdDriver::BeginVirtualRun(size_t fifo, const Coordinates& begin) {
  card_.LeaveLanes();
  VirtualRun& run = crd_.fifos[fifo].planner->virtual_run;
  run.on = true;
  run.cycle = static_cast<double>(card_.cycle_us()) / 1000;
  for (size_t i = 0; i < run.moved.size(); ++i) run.moved[i] = card_.profiles()[i].now.position;
  run.end = begin;
}

void CrdDriver::DropPlanners() {
  for (CrdFifo& fifo : crd_.fifos) {
    if (fifo.plans_axes()) fifo.planner.Reset();
  }
}

void CrdDriver::KeepCoordinates(size_t number, size_t first) {
  card_.LeaveLanes();
  CrdFifo& fifo = crd_.fifos[number];
  const Coordinates position = PositionOf(crd_, card_.profiles());
  const auto keep = [&](Coordinates& point) {
    for (size_t i = first; i < point.size(); ++i) point[i] = position[i];
  };
  const auto keep_segment = [&](Segment& segment) {
    keep(segment.start);
    keep(segment.end);
    keep(segment.centre);
  };
  keep_segment(fifo.current.segment);
  if (fifo.interruption) keep_segment(fifo.interruption->slot.segment);
  for (size_t i = 0; i < fifo.slots.size(); ++i) keep_segment(fifo.slots.At(i).segment);
  keep(fifo.tail);
}

bool CrdDriver::Append(size_t fifo, const PathSlot& slot) {
  CornerAhead corner;
  if (card_.observed() && slot.is_segment && crd_.fifos[fifo].planner) {
    corner = crd_.fifos[fifo].planner->CornerBefore(slot);
  }
  if (!crd_.Append(fifo, slot, card_.now())) return false;
  if (slot.is_segment) TellJunction(crd_.fifos[fifo]);
  if (corner.allowed < corner.wanted) {
    card_.Tell(CardEventKind::kCornerLimited, corner.allowed, corner.wanted);
  }
  return true;
}

void CrdDriver::TellJunction(const CrdFifo& fifo) const {
  if (!card_.observed() || !fifo.planner) return;
  const auto& spans = fifo.planner->spans;
  if (spans.size() < 2) return;
  const WindowSpan& newest = spans.back();
  const double wanted = std::min(newest.top, spans.At(spans.size() - 2).top);
  // 0 has been commanded.
  if (newest.junction == 0 || newest.junction >= wanted) return;
  card_.Tell(CardEventKind::kJunctionLimited, std::sqrt(newest.junction), std::sqrt(wanted));
}

// --- The run -----------------------------------------------------------------------------------

void CrdDriver::Start(size_t fifo, bool single_step) {
  card_.LeaveLanes();
  crd_.position = PositionOf(crd_, card_.profiles());
  crd_.Start(fifo, single_step, card_.now());
  if (crd_.run.wait == CrdWait::kMove && !AwaitedMoveUnderWay()) {
    StartMove(BufferedCommand(crd_.active().move));
  }
  Write();
}

void CrdDriver::Resume(size_t fifo, const PathSlot& back) {
  card_.LeaveLanes();
  crd_.position = PositionOf(crd_, card_.profiles());
  crd_.Resume(fifo, back, card_.now());
  Write();
}

void CrdDriver::Stop(bool abrupt) {
  card_.LeaveLanes();
  const bool ran = crd_.run.running;
  crd_.Stop(abrupt, card_.now());
  WriteEnd(ran);
}

void CrdDriver::Halt() {
  card_.LeaveLanes();
  const bool ran = crd_.run.running;
  crd_.Halt();
  WriteEnd(ran);
}

void CrdDriver::StopFor(size_t profile, bool abrupt) {
  if (!crd_.map) return Stop(abrupt);
  if (!crd_.map->stops_together) return LeaveMap(profile);
  crd_.map->held = true;
  Halt();
}

void CrdDriver::CloseList(size_t fifo) {
  card_.LeaveLanes();
  const bool ran = crd_.run.running;
  crd_.CloseList(fifo);
  WriteEnd(ran);
}

void CrdDriver::Advance() {
  const BufferedCommand* command = nullptr;
  do {
    if (crd_.run.wait == CrdWait::kMove) JudgeAwaitedMove();
    command = nullptr;
    if (crd_.run.running) {
      command = crd_.Advance(card_.now());
      if (card_.observed() && !crd_.run.running) TellRunEnd();
    }
    if (command != nullptr) CarryOut(*command);
  } while (command != nullptr);
  Write();
}

void CrdDriver::TellRunEnd() const {
  const CrdFifo& fifo = crd_.active();
  if (fifo.executing || !fifo.slots.empty()) return;
  if (!fifo.Ahead().empty()) {
    card_.Tell(CardEventKind::kStarved, static_cast<double>(fifo.Ahead().CountSegments()));
  } else if (crd_.run.plan.end_velocity > 0) {
    card_.Tell(CardEventKind::kEndedMoving, crd_.run.plan.end_velocity);
  }
}

void CrdDriver::CarryOut(const BufferedCommand& command) {
  if (command.kind == BufferedKind::kMove) {
    StartMove(command);
  } else if (command.kind == BufferedKind::kGear) {
    StartGear(command);
  } else {
    card_.CarryOut(command);
  }
}

void CrdDriver::StartMove(const BufferedCommand& command) {
  Profile& profile = card_.profile(command.item);
  if (profile.mode != ProfileMode::kTrap || profile.driven) return;
  profile.trap.parameters = {.acc = command.values[2], .dec = command.values[2]};
  profile.trap.target = static_cast<int32_t>(command.values[0]);
  profile.trap.velocity = command.values[1];
  profile.Start(card_.now());
  card_.TellDriveOff(CardEventKind::kMovedByPath, command.item);
  if (command.detail != 0) crd_.AwaitMove(command);
}

bool CrdDriver::AwaitedMoveUnderWay() const {
  const BufferedCommand& move = crd_.active().move;
  const Profile& profile = card_.profile(move.item);
  return profile.now.moving && profile.mode == ProfileMode::kTrap && profile.trap.running &&
         profile.trap.target == static_cast<int32_t>(move.values[0]);
}

void CrdDriver::JudgeAwaitedMove() {
  const BufferedCommand& move = crd_.active().move;
  const Sample& awaited = card_.profile(move.item).now;
  if (awaited.moving) return;
  if (awaited.position == move.values[0]) {
    crd_.EndMove(card_.now());
  } else {
    card_.Tell(CardEventKind::kMoveStopped, awaited.position, move.item);
    // Stopped before its target: the path must not continue until the axis has reached it.
    crd_.EndRun();
  }
}

void CrdDriver::StartGear(const BufferedCommand& command) {
  // Gears of segments that ended in this cycle are written first.
  Write();
  Profile& profile = card_.profile(command.item);
  if (profile.now.moving || crd_.gear_count == crd_.gears.size()) return;
  profile.driven = true;
  card_.TellDriveOff(CardEventKind::kMovedByPath, command.item);
  crd_.gears[crd_.gear_count++] = {command.item,      profile.now.position, command.values[0],
                                   command.values[1], command.values[2],    false};
}

void CrdDriver::Write() {
  const bool running = crd_.run.running;
  const CrdFifo& fifo = crd_.active();
  const Segment& segment = fifo.current.segment;
  const double speed = crd_.run.velocity;
  Coordinates tangent{};
  Coordinates curvature{};
  double part = 0;
  if (fifo.executing) {
    part = fifo.path / segment.length;
    crd_.position = segment.PointAt(fifo.path);
    tangent = segment.TangentAt(fifo.path);
    curvature = segment.CurvatureAt(fifo.path);
  }
  if (crd_.map) return WriteMapped(tangent, curvature);
  for (size_t i = 0; i < crd_.dimension(); ++i) {
    Profile& member = card_.profile(crd_.members[i]);
    const bool rested = member.now.velocity == 0;
    member.now = {crd_.origin[i] + crd_.position[i], tangent[i] * speed,
                  tangent[i] * crd_.run.acceleration + curvature[i] * speed * speed, running};
    member.driven = running;
    if (rested && member.now.velocity != 0) {
      card_.TellDriveOff(CardEventKind::kMovedBySegment, crd_.members[i]);
    }
  }
  uint32_t kept = 0;
  for (uint32_t i = 0; i < crd_.gear_count; ++i) {
    const GearShare gear = crd_.gears[i];
    Profile& profile = card_.profile(gear.profile);
    // GT_Update has started another motion of the profile.
    if (!profile.driven) continue;
    if (gear.finished) {
      profile.now = AtRest(gear.begin + gear.displacement);
      profile.driven = false;
      continue;
    }
    const double slope = fifo.executing ? gear.SlopeAt(part) / segment.length : 0;
    profile.now = {gear.PositionAt(part), slope * speed, slope * crd_.run.acceleration, running};
    profile.driven = true;
    crd_.gears[kept++] = gear;
  }
  crd_.gear_count = kept;
}

void CrdDriver::WriteMapped(const Coordinates& tangent, const Coordinates& curvature) {
  const CoordinateMap& map = *crd_.map;
  const CrdRun& run = crd_.run;
  for (size_t axis = 0; axis < map.rows.size(); ++axis) {
    if (!map.Has(axis)) continue;
    Profile& member = card_.profiles()[axis];
    const double slope = map.Along(axis, tangent);
    member.now = {
        map.PositionOf(axis, crd_.position), slope * run.velocity,
        slope * run.acceleration + map.Along(axis, curvature) * run.velocity * run.velocity,
        run.running};
    member.driven = run.running;
  }
}

void CrdDriver::WriteEnd(bool ran) {
  if (ran && !crd_.run.running) Write();
}

}  // namespace oncard::motion
