#include "gtcalls/gt400/drives.h"

#include <limits>

namespace oncard::gtcalls::gt400 {
namespace {

const Gt400Axis& StateOf(const Card& card, size_t axis) {
  return card.state<Gt400State>().axes[axis];
}

/// The position error is judged in closed loop only.
void UpdateErrorLimit(Card& card, size_t axis) {
  constexpr int64_t kNever = std::numeric_limits<int64_t>::max();
  const uint16_t limit = StateOf(card, axis).valid.error_limit;
  card.motion.ControlAt(axis).SetErrorLimit(card.motion.InClosedLoop(axis) ? limit : kNever);
}

}  // namespace

bool HasVoltages(const Card& card) { return card.motion.config().defaults.closed_loop; }

bool IsAnalogue(const Card& card, size_t axis) {
  return HasVoltages(card) && !StateOf(card, axis).pulses;
}

bool IsInOpenLoop(const Card& card, size_t axis) {
  return IsAnalogue(card, axis) && StateOf(card, axis).open_loop;
}

bool CanPlan(const Card& card, size_t axis) {
  return card.motion.axis(axis).servo_on && !IsInOpenLoop(card, axis) &&
         card.motion.profile(axis).mode != motion::ProfileMode::kCrd;
}

void ConnectDrive(Card& card, size_t axis) {
  const bool analogue = IsAnalogue(card, axis);
  const bool open = StateOf(card, axis).open_loop;
  // A drive that follows a voltage takes no pulses.
  card.motion.StepAt(axis).SetActive(!(analogue && open));
  card.motion.AxisAt(axis).SetClosedLoop(analogue && !open);
  UpdateOutput(card, axis);
  UpdateErrorLimit(card, axis);
  if (card.motion.axis(axis).servo_on) card.motion.AxisAt(axis).RestartDrive();
}

/// Assumption: in open loop bias and limit have no meaning.
void UpdateOutput(Card& card, size_t axis) {
  if (!HasVoltages(card)) return;
  const Gt400Axis& state = StateOf(card, axis);
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
  if (!HasVoltages(card)) return;
  const AxisRegisters& valid = StateOf(card, axis).valid;
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
  card.motion.ProfileAt(axis).SetPosition(position);
  card.motion.EncoderAt(axis).SetPosition(position);
  card.motion.AxisAt(axis).SynchPosition();
  Gt400Axis& state = card.state<Gt400State>().axes[axis];
  state.waiting.position = state.valid.position = position;
}

}  // namespace oncard::gtcalls::gt400
