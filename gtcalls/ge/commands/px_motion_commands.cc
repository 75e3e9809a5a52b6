// Motion of single axes: modes, their registers, updates, stops. A setter writes a register, and
// GT_Update begins or replans the motion with all of them. Source: GE manual chapters 5 and 12.
// Tested by tests/gtcalls/ge/motion_command_test.cc.
#include "gtcalls/ge/commands/register_commands.h"

namespace oncard::gtcalls::gep {
namespace {

using motion::ProfileMode;

int16_t ChooseMode(Call& call, ProfileMode mode) {
  const int16_t code = CheckAtRest(call, kModeInUse);
  if (code == vm::kOk) call.card.motion.ProfileAt(AxisOf(call)).SelectMode(mode);
  return code;
}

}  // namespace

int16_t GT_PrflT(Call& call) { return ChooseMode(call, ProfileMode::kTrap); }
int16_t GT_PrflS(Call& call) { return ChooseMode(call, ProfileMode::kSCurve); }
int16_t GT_PrflV(Call& call) { return ChooseMode(call, ProfileMode::kJog); }

// --- Registers -------------------------------------------------------------------------------

int16_t GT_SetPos(Call& call) { return WriteRegister<&GeRegisters::position>(call); }
int16_t GT_GetPos(Call& call) { return ReadRegister<&GeRegisters::position>(call); }
int16_t GT_GetVel(Call& call) { return ReadRegister<&GeRegisters::velocity>(call); }
int16_t GT_SetAcc(Call& call) { return WriteRegister<&GeRegisters::acceleration>(call); }
int16_t GT_GetAcc(Call& call) { return ReadRegister<&GeRegisters::acceleration>(call); }
int16_t GT_SetMAcc(Call& call) { return WriteRegister<&GeRegisters::max_acceleration>(call); }
int16_t GT_GetMAcc(Call& call) { return ReadRegister<&GeRegisters::max_acceleration>(call); }
int16_t GT_SetJerk(Call& call) { return WriteRegister<&GeRegisters::jerk>(call); }
int16_t GT_GetJerk(Call& call) { return ReadRegister<&GeRegisters::jerk>(call); }

int16_t GT_SetVel(Call& call) {
  const ProfileMode mode = call.card.motion.profile(AxisOf(call)).mode;
  if (call.value(1) < 0 && mode != ProfileMode::kJog) {
    call.cause = kOverflow;
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("vel is {0}; it may be below 0 in velocity mode only",
                                   "vel 为 {0}；仅速度模式下可为负值", call.value(1)));
  }
  return WriteRegister<&GeRegisters::velocity>(call);
}

// --- Updates ---------------------------------------------------------------------------------

namespace {

/// True if a register waits that may not change in motion. Assumption: the jerk of the S curve and
/// the acceleration of the velocity mode, which the manual does not mention.
bool HasFixedChange(ProfileMode mode, const GeRegisters& registers) {
  if (mode != ProfileMode::kSCurve) return registers.acceleration.Waits();
  return registers.velocity.Waits() || registers.max_acceleration.Waits() || registers.jerk.Waits();
}

/// 0, or 1 if the registers of an axis may not take effect now.
int16_t CheckUpdate(Call& call, size_t axis) {
  const motion::MotionCore& core = call.card.motion;
  const auto number = axis + 1;
  if ((core.axis(axis).latched & motion::kAlarmBit) != 0) {
    return RefuseAxis(call, axis, kIllegal,
                      MakeMessage("axis {0} has an alarm: remove its cause, and call GT_ClrSts",
                                  "轴 {0} 报警：请排除原因并调用 GT_ClrSts", number));
  }
  if (!core.profile(axis).now.moving) return vm::kOk;
  if (StateOf(call).axes[axis].stopping) {
    return RefuseAxis(call, axis, kInMotion,
                      MakeMessage("axis {0} is being stopped, wait until bit 10 of GT_GetSts is 0",
                                  "轴 {0} 正在停止，请等待 GT_GetSts 的第 10 位变为 0", number));
  }
  if (HasFixedChange(core.profile(axis).mode, StateOf(call).axes[axis].registers)) {
    return RefuseAxis(
        call, axis, kInMotion,
        MakeMessage("axis {0} is moving: in motion only the target position may change, in modes T "
                    "and V also the velocity",
                    "轴 {0} 正在运动：运动中只能修改目标位置，T 和速度模式下还可修改速度", number));
  }
  return vm::kOk;
}

/// Begins or replans the motion of an axis with the working values of its registers. Assumption:
/// without an acceleration an axis at rest stays there. In motion it has one.
void UpdateMotion(Card& card, size_t axis) {
  const GeRegisters& registers = card.state<GeState>().axes[axis].registers;
  const double acceleration = registers.acceleration.working;
  const motion::ProfileHandle profile = card.motion.ProfileAt(axis);
  const ProfileMode mode = card.motion.profile(axis).mode;
  if (mode == ProfileMode::kSCurve) {
    profile.SetSCurve(
        {registers.velocity.working, registers.max_acceleration.working, registers.jerk.working},
        registers.position.working);
  } else {
    if (acceleration < motion::kRateMin) return;
    profile.SetStopDecelerations(acceleration, card.motion.profile(axis).abrupt_stop);
    profile.SetVelocity(registers.velocity.working);
    if (mode == ProfileMode::kJog) {
      profile.SetParameters(motion::JogParameters{acceleration, acceleration, 0});
    } else {
      profile.SetParameters(motion::TrapParameters{acceleration, acceleration, 0, 0});
      profile.SetTarget(registers.position.working);
    }
  }
  profile.Start();
}

void UpdateAxis(Card& card, size_t axis) {
  GeAxis& state = card.state<GeState>().axes[axis];
  state.registers.Update();
  state.stopping = false;
  UpdateServo(card, axis);
  UpdateMotion(card, axis);
}

}  // namespace

int16_t GT_Update(Call& call) {
  const int16_t code = CheckUpdate(call, AxisOf(call));
  if (code == vm::kOk) UpdateAxis(call.card, AxisOf(call));
  return code;
}

int16_t GT_MltiUpdt(Call& call) {
  const auto mask = static_cast<uint32_t>(call.integer(0));
  if (mask == 0) return RefuseEmptyMask(call);
  const auto selected = [mask](size_t axis) { return (mask >> axis & 1) != 0; };
  const size_t axes = call.card.motion.axis_count();
  for (size_t axis = 0; axis < axes; ++axis) {
    const int16_t code = selected(axis) ? CheckUpdate(call, axis) : vm::kOk;
    if (code != vm::kOk) return code;
  }
  for (size_t axis = 0; axis < axes; ++axis) {
    if (selected(axis)) UpdateAxis(call.card, axis);
  }
  return vm::kOk;
}

// --- Stops -----------------------------------------------------------------------------------

int16_t GT_SmthStp(Call& call) {
  GeAxisOf(call).stopping = true;
  call.card.motion.ProfileAt(AxisOf(call)).Stop(false);
  return vm::kOk;
}

int16_t GT_AbptStp(Call& call) {
  call.card.motion.ProfileAt(AxisOf(call)).Stop(true);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gep
