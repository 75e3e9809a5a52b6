// The motion core's part of coordinate systems: the effects of their paths and buffered commands on
// profiles, outputs and registers. Tested by tests/motion/crd_test.cc.
#include <algorithm>

#include "motion/motion_core.h"

namespace oncard::motion {

void MotionCore::SetUpCrd(size_t index, CrdParameters parameters) {
  Crd& crd = state_.crds[index];
  for (size_t i = 0; i < crd.dimension(); ++i) {
    Profile& left = state_.profiles[static_cast<size_t>(crd.members[i])];
    if (left.mode == ProfileMode::kCrd) left.mode = ProfileMode::kTrap;
  }
  for (uint32_t i = 0; i < crd.gear_count; ++i) {
    state_.profiles[static_cast<size_t>(crd.gears[i].profile)].driven = false;
  }
  crd = {};
  crd.smooth_stop = config_.defaults.smooth_stop;
  crd.abrupt_stop = config_.defaults.abrupt_stop;
  crd.parameters = parameters;
  for (size_t i = 0; i < kCrdParameterAxes; ++i) {
    if (parameters.profile[i] == 0) continue;
    const auto coordinate = static_cast<size_t>(parameters.profile[i] - 1);
    Profile& member = state_.profiles[i];
    crd.members[coordinate] = static_cast<int32_t>(i);
    crd.origin[coordinate] =
        parameters.set_origin != 0 ? parameters.origin[coordinate] : member.now.position;
    member.mode = ProfileMode::kCrd;
  }
  crd.position = CrdPosition(index);
  for (CrdFifo& fifo : crd.fifos) fifo.slots.slots.reserve(kCrdFifoSize);
}

Coordinates MotionCore::CrdPosition(size_t index) const {
  const Crd& crd = state_.crds[index];
  Coordinates position{};
  for (size_t i = 0; i < crd.dimension(); ++i) {
    const Profile& member = state_.profiles[static_cast<size_t>(crd.members[i])];
    position[i] = member.now.position - crd.origin[i];
  }
  return position;
}

bool MotionCore::AppendToCrd(size_t crd, size_t fifo, const PathSlot& slot) {
  const LookAhead& ahead = state_.crds[crd].fifos[fifo].look_ahead;
  double corner = 0;
  double wanted = 0;
  if (observer_ && slot.is_segment && ahead.on() && ahead.has_newest && !ahead.newest_rests) {
    corner = CornerVelocity(ahead.newest_tangent, slot.segment.TangentAt(0), ahead.time,
                            ahead.acceleration);
    wanted = std::min(slot.velocity, ahead.newest_velocity);
  }
  if (!state_.crds[crd].Append(fifo, slot, now())) return false;
  if (corner < wanted) Tell(HappeningKind::kCornerLimited, crd, corner, wanted);
  return true;
}

void MotionCore::StartCrd(size_t index, size_t fifo, bool single_step) {
  Crd& crd = state_.crds[index];
  crd.position = CrdPosition(index);
  crd.Start(fifo, single_step, now());
  if (crd.run.wait == CrdWait::kMove && !AwaitedMoveUnderWay(crd)) {
    StartBufferedMove(crd, BufferedCommand(crd.active().move));
  }
  WriteCrd(crd);
}

void MotionCore::StopCrd(size_t index, bool abrupt) {
  Crd& crd = state_.crds[index];
  crd.Stop(abrupt, now());
  if (!crd.run.running) WriteCrd(crd);
}

void MotionCore::AdvanceCrd(Crd& crd) {
  const BufferedCommand* command = nullptr;
  do {
    if (crd.run.wait == CrdWait::kMove) JudgeAwaitedMove(crd);
    command = nullptr;
    if (crd.run.running) {
      command = crd.Advance(now());
      if (observer_ && !crd.run.running) TellRunEnd(crd);
    }
    if (command != nullptr) CarryOut(crd, *command);
  } while (command != nullptr);
  WriteCrd(crd);
}

void MotionCore::TellRunEnd(const Crd& crd) const {
  const CrdFifo& fifo = crd.active();
  if (fifo.executing || !fifo.slots.empty()) return;
  if (!fifo.look_ahead.ring.empty()) {
    Tell(HappeningKind::kStarved, IndexOf(crd),
         static_cast<double>(fifo.look_ahead.ring.CountSegments()));
  } else if (crd.run.plan.end_velocity > 0) {
    Tell(HappeningKind::kEndedMoving, IndexOf(crd), crd.run.plan.end_velocity);
  }
}

void MotionCore::CarryOut(Crd& crd, const BufferedCommand& command) {
  const auto item = static_cast<size_t>(command.item);
  const std::array<double, 4>& values = command.values;
  switch (command.kind) {
    case BufferedKind::kDelay:
    case BufferedKind::kHold:
      break;
    case BufferedKind::kOutputs:
      state_.io.Write(static_cast<DoType>(command.item), static_cast<uint32_t>(values[0]),
                      static_cast<uint32_t>(values[1]));
      break;
    case BufferedKind::kPulses:
      state_.io.StartPulses(static_cast<DoType>(command.item), command.detail,
                            static_cast<int64_t>(values[0]), static_cast<int64_t>(values[1]),
                            static_cast<int64_t>(values[2]), values[3] != 0);
      break;
    case BufferedKind::kStopPulses:
      state_.io.StopTiming(static_cast<DoType>(command.item), command.detail);
      break;
    case BufferedKind::kAnalogOutput:
      if (state_.dacs[item].control < 0) state_.dacs[item].value = values[0];
      break;
    case BufferedKind::kLimits:
      if (command.detail != 1) state_.axes[item].positive_limit_on = values[0] != 0;
      if (command.detail != 0) state_.axes[item].negative_limit_on = values[0] != 0;
      break;
    case BufferedKind::kStopInput: {
      Axis& axis = state_.axes[item];
      (command.detail != 0 ? axis.abrupt_stop : axis.smooth_stop) = {
          static_cast<DiType>(values[0]), static_cast<int16_t>(values[1])};
      break;
    }
    case BufferedKind::kMove:
      StartBufferedMove(crd, command);
      break;
    case BufferedKind::kGear:
      StartGear(crd, command);
      break;
    case BufferedKind::kSynchronise:
      if (state_.profiles[item].now.moving) break;
      SetProfilePosition(item, state_.encoders[static_cast<size_t>(command.detail)].position);
      break;
    case BufferedKind::kOutside:
      state_.reached.push_back(command);
      break;
  }
}

void MotionCore::StartBufferedMove(Crd& crd, const BufferedCommand& command) {
  Profile& profile = state_.profiles[static_cast<size_t>(command.item)];
  if (profile.mode != ProfileMode::kTrap || profile.driven) return;
  profile.trap.parameters = {.acc = command.values[2], .dec = command.values[2]};
  profile.trap.target = static_cast<int32_t>(command.values[0]);
  profile.trap.velocity = command.values[1];
  profile.Start(now());
  if (command.detail != 0) crd.AwaitMove(command);
}

bool MotionCore::AwaitedMoveUnderWay(const Crd& crd) const {
  const BufferedCommand& move = crd.active().move;
  const Profile& profile = state_.profiles[static_cast<size_t>(move.item)];
  return profile.now.moving && profile.mode == ProfileMode::kTrap && profile.trap.running &&
         profile.trap.target == static_cast<int32_t>(move.values[0]);
}

void MotionCore::JudgeAwaitedMove(Crd& crd) {
  const BufferedCommand& move = crd.active().move;
  const Sample& awaited = state_.profiles[static_cast<size_t>(move.item)].now;
  if (awaited.moving) return;
  if (awaited.position == move.values[0]) {
    crd.EndMove(now());
  } else {
    Tell(HappeningKind::kMoveStopped, IndexOf(crd), awaited.position, move.item);
    // Stopped before its target: the path must not continue until the axis has reached it.
    crd.EndRun();
  }
}

void MotionCore::StartGear(Crd& crd, const BufferedCommand& command) {
  // Gears of segments that ended in this cycle are written first.
  WriteCrd(crd);
  Profile& profile = state_.profiles[static_cast<size_t>(command.item)];
  if (profile.now.moving || crd.gear_count == crd.gears.size()) return;
  profile.driven = true;
  crd.gears[crd.gear_count++] = {command.item,      profile.now.position, command.values[0],
                                 command.values[1], command.values[2],    false};
}

void MotionCore::WriteCrd(Crd& crd) {
  const bool running = crd.run.running;
  const CrdFifo& fifo = crd.active();
  const Segment& segment = fifo.current.segment;
  const double speed = crd.run.velocity;
  Coordinates tangent{};
  Coordinates curvature{};
  double part = 0;
  if (fifo.executing) {
    part = fifo.path / segment.length;
    crd.position = segment.PointAt(fifo.path);
    tangent = segment.TangentAt(fifo.path);
    curvature = segment.CurvatureAt(fifo.path);
  }
  for (size_t i = 0; i < crd.dimension(); ++i) {
    Profile& member = state_.profiles[static_cast<size_t>(crd.members[i])];
    member.now = {crd.origin[i] + crd.position[i], tangent[i] * speed,
                  tangent[i] * crd.run.acceleration + curvature[i] * speed * speed, running};
    member.driven = running;
  }
  uint32_t kept = 0;
  for (uint32_t i = 0; i < crd.gear_count; ++i) {
    const GearShare gear = crd.gears[i];
    Profile& profile = state_.profiles[static_cast<size_t>(gear.profile)];
    // GT_Update has started another motion of the profile.
    if (!profile.driven) continue;
    if (gear.finished) {
      profile.now = AtRest(gear.begin + gear.displacement);
      profile.driven = false;
      continue;
    }
    const double slope = fifo.executing ? gear.SlopeAt(part) / segment.length : 0;
    profile.now = {gear.PositionAt(part), slope * speed, slope * crd.run.acceleration, running};
    profile.driven = true;
    crd.gears[kept++] = gear;
  }
  crd.gear_count = kept;
}

}  // namespace oncard::motion
