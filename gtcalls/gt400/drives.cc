#include "gtcalls/gt400/drives.h"

#include "gtcalls/gt400/axis_state.h"
#include "gtcalls/shared/drives.h"

namespace oncard::gtcalls::gt400 {
namespace {

void UpdateErrorLimit(Card& card, size_t axis) {
  LimitFollowingError(axis, AxisState(card, axis).valid.error_limit, card.motion);
}

}  // namespace

bool IsAnalogue(const Card& card, size_t axis) {
  return HasVoltages(card.motion) && !AxisState(card, axis).pulses;
}

bool IsInOpenLoop(const Card& card, size_t axis) {
  return IsAnalogue(card, axis) && AxisState(card, axis).open_loop;
}

bool CanPlan(const Card& card, size_t axis) {
  return card.motion.axis(axis).servo_on && !IsInOpenLoop(card, axis) &&
         card.motion.profile(axis).mode != motion::ProfileMode::kCrd;
}

void ConnectDrive(Card& card, size_t axis) {
  SwitchOutput(axis, IsAnalogue(card, axis), AxisState(card, axis).open_loop, card.motion);
  UpdateOutput(card, axis);
  UpdateErrorLimit(card, axis);
  if (card.motion.axis(axis).servo_on) card.motion.AxisAt(axis).RestartDrive();
}

/// Assumption: in open loop bias and limit have no meaning.
void UpdateOutput(Card& card, size_t axis) {
  if (!HasVoltages(card.motion)) return;
  const Gt400Axis& state = AxisState(card, axis);
  const motion::DacHandle dac = card.motion.DacAt(axis);
  if (card.motion.InClosedLoop(axis)) {
    dac.SetBias(state.valid.bias);
    dac.SetLimit(static_cast<int16_t>(state.valid.output_limit));
  } else {
    dac.SetBias(0);
    dac.SetLimit(static_cast<int16_t>(motion::kDacFull));
    dac.SetValue(IsAnalogue(card, axis) ? state.open_output : 0);
  }
}

void UpdateServo(Card& card, size_t axis) {
  if (!HasVoltages(card.motion)) return;
  const AxisRegisters& valid = AxisState(card, axis).valid;
  motion::PidSet set = card.motion.state().controls[axis].sets[0];
  set.kp = valid.kp;
  set.ki = valid.ki;
  set.kd = valid.kd;
  set.kvff = valid.kvff;
  set.kaff = valid.kaff;
  set.integral_limit = valid.integral_limit;
  card.motion.ControlAt(axis).SetPidSet(0, set);
  // An integral without room is cleared, also while the drive is off.
  if (valid.integral_limit == 0) card.motion.ControlAt(axis).ClearIntegral();
  UpdateOutput(card, axis);
  UpdateErrorLimit(card, axis);
}

void PlaceAxis(Card& card, size_t axis, int32_t position) {
  PlaceAxisAt(axis, position, card.motion);
  Gt400Axis& state = AxisState(card, axis);
  state.waiting.position = state.valid.position = position;
}

}  // namespace oncard::gtcalls::gt400
