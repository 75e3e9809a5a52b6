// What the commands of GE cards have in common.
#include <algorithm>
#include <utility>

#include "gtcalls/ge/commands/commands.h"
#include "gtcalls/shared/drives.h"

namespace oncard::gtcalls::ge {

int16_t RefuseAxis(Call& call, size_t axis, CommandCause cause, Message why) {
  call.cause = cause;
  StateOf(call).axes[axis].refused = true;
  return call.Refuse(vm::kRefused, std::move(why));
}

int16_t CheckDriveOff(Call& call, CommandCause cause) {
  if (!call.card.motion.axis(AxisOf(call)).servo_on) return vm::kOk;
  return RefuseAxis(call, AxisOf(call), cause,
                    MakeMessage("the drive of axis {0} is enabled, call GT_AxisOff first",
                                "轴 {0} 的驱动器已使能，请先调用 GT_AxisOff", call.integer(0)));
}

int16_t CheckAtRest(Call& call, CommandCause cause) {
  if (!call.card.motion.profile(AxisOf(call)).now.moving) return vm::kOk;
  return RefuseAxis(
      call, AxisOf(call), cause,
      MakeMessage("axis {0} is moving, wait until bit 10 of GT_GetSts is 0",
                  "轴 {0} 正在运动，请等待 GT_GetSts 的第 10 位变为 0", call.integer(0)));
}

int16_t CheckNoAlarm(Call& call, CommandCause cause) {
  const motion::Axis& axis = call.card.motion.axis(AxisOf(call));
  if (!axis.alarm_on || !call.card.motion.InputActive(axis.alarm)) return vm::kOk;
  return RefuseAxis(
      call, AxisOf(call), cause,
      MakeMessage("the drive of axis {0} reports an alarm; remove its cause, or call GT_AlarmOff "
                  "when no drive is connected",
                  "轴 {0} 的驱动器报警；请排除原因，未接驱动器时可调用 GT_AlarmOff",
                  call.integer(0)));
}

int16_t RefuseEmptyMask(Call& call) {
  call.cause = kEmptyMask;
  return call.Refuse(vm::kRefused,
                     {"the mask is 0; bit 0 is axis 1", "mask 为 0；第 0 位对应轴 1"});
}

bool IsAnalogue(const Card& card, size_t axis) {
  return HasVoltages(card.motion) && !card.state<GeState>().axes[axis].pulses;
}

namespace {

/// Assumption: the following error is judged in closed loop only.
void UpdateErrorLimit(Card& card, size_t axis) {
  const GeRegisters& registers = card.state<GeState>().axes[axis].registers;
  LimitFollowingError(axis, registers.error_limit.working, card.motion);
}

}  // namespace

void ConnectDrive(Card& card, size_t axis) {
  const bool open_loop = card.state<GeState>().axes[axis].open_loop;
  SwitchOutput(axis, IsAnalogue(card, axis), open_loop, card.motion);
  UpdateErrorLimit(card, axis);
}

void UpdateServo(Card& card, size_t axis) {
  if (!HasVoltages(card.motion)) return;
  const GeRegisters& registers = card.state<GeState>().axes[axis].registers;
  motion::PidSet set = card.motion.state().controls[axis].sets[0];
  set.kp = registers.kp.working;
  set.ki = registers.ki.working;
  set.kd = registers.kd.working;
  set.kvff = registers.kvff.working;
  set.kaff = registers.kaff.working;
  set.integral_limit = registers.integral_limit.working;
  card.motion.ControlAt(axis).SetPidSet(0, set);
  card.motion.DacAt(axis).SetBias(registers.bias.working);
  card.motion.DacAt(axis).SetLimit(static_cast<int16_t>(registers.output_limit.working));
  UpdateErrorLimit(card, axis);
}

void PlaceAxis(Card& card, size_t axis, int32_t position) {
  PlaceAxisAt(axis, position, card.motion);
  card.state<GeState>().axes[axis].registers.position.Set(position);
}

void EnableDrive(Card& card, size_t axis) {
  // Assumption: for a drive that is enabled already nothing changes.
  if (card.motion.axis(axis).servo_on) return;
  card.motion.ProfileAt(axis).Stop(true);
  const double actual = card.motion.encoder(axis).position;
  PlaceAxis(card, axis, static_cast<int32_t>(std::clamp(actual, kPositionMin, kPositionMax)));
  card.motion.AxisAt(axis).ServoOn();
}

}  // namespace oncard::gtcalls::ge
