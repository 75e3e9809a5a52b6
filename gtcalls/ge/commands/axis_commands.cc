// Axes: inputs, outputs, drives, events, positions. Source: GE manual chapters 3, 4.1, 6.7.2 and
// 12. Tested by tests/gtcalls/ge/axis_command_test.cc.
#include "gtcalls/ge/commands/commands.h"
#include "gtcalls/ge/status_words.h"
#include "gtcalls/shared/drives.h"
#include "gtcalls/shared/senses.h"

namespace oncard::gtcalls::ge {
namespace {

using motion::DoType;

/// GT_CtrlMode.
constexpr int kPulseMode = 1;

/// Assumption: how long the CLEAR output is on.
constexpr int64_t kClearPulseUs = 10'000;

}  // namespace

int16_t GT_GetCmdSts(Call& call) {
  call.Set(0, StateOf(call).command_register);
  return vm::kOk;
}

// --- Inputs ----------------------------------------------------------------------------------

int16_t GT_AlarmOn(Call& call) {
  call.card.motion.AxisAt(AxisOf(call)).SwitchAlarm(true);
  return vm::kOk;
}

int16_t GT_AlarmOff(Call& call) {
  call.card.motion.AxisAt(AxisOf(call)).SwitchAlarm(false);
  return vm::kOk;
}

namespace {

int16_t SwitchLimits(Call& call, bool on) {
  const motion::AxisHandle axis = call.card.motion.AxisAt(AxisOf(call));
  axis.SwitchPositiveLimit(on);
  axis.SwitchNegativeLimit(on);
  return vm::kOk;
}

}  // namespace

int16_t GT_LmtsOn(Call& call) { return SwitchLimits(call, true); }
int16_t GT_LmtsOff(Call& call) { return SwitchLimits(call, false); }

int16_t GT_LmtSns(Call& call) {
  InvertLimits(static_cast<uint32_t>(call.integer(0)), call.card.motion);
  return vm::kOk;
}

int16_t GT_EncSns(Call& call) {
  motion::MotionCore& core = call.card.motion;
  ReverseEncoders(static_cast<uint32_t>(call.integer(0)), 0, core.axis_count(), core);
  return vm::kOk;
}

namespace {

int16_t SwitchEncoder(Call& call, bool external) {
  const int16_t code = CheckDriveOff(call, kDriveOn);
  if (code == vm::kOk) call.card.motion.EncoderAt(AxisOf(call)).SetExternal(external);
  return code;
}

}  // namespace

int16_t GT_EncOn(Call& call) { return SwitchEncoder(call, true); }
int16_t GT_EncOff(Call& call) { return SwitchEncoder(call, false); }

// --- Outputs ---------------------------------------------------------------------------------

int16_t GT_CtrlMode(Call& call) {
  const size_t axis = AxisOf(call);
  const bool pulses = call.integer(1) == kPulseMode;
  if (!pulses && !HasVoltages(call.card.motion)) {
    return call.Refuse(vm::kBadParameter, {"this card puts out pulses only: mode must be 1",
                                           "本控制卡只有脉冲输出：mode 应为 1"});
  }
  int16_t code = CheckDriveOff(call, kModeInUse);
  if (code == vm::kOk) code = CheckAtRest(call, kModeInUse);
  if (code != vm::kOk) return code;
  GeAxisOf(call).pulses = pulses;
  ConnectDrive(call.card, axis);
  call.card.motion.EncoderAt(axis).SetExternal(!pulses);
  return vm::kOk;
}

int16_t GT_StepDir(Call& call) {
  call.card.motion.StepAt(AxisOf(call)).SetMode(motion::kPulseAndDirection);
  return vm::kOk;
}

int16_t GT_StepPulse(Call& call) {
  call.card.motion.StepAt(AxisOf(call)).SetMode(motion::kForwardAndBackward);
  return vm::kOk;
}

// --- Drives ----------------------------------------------------------------------------------

int16_t GT_DrvRst(Call& call) {
  const int16_t code = CheckDriveOff(call, kDriveOn);
  if (code != vm::kOk) return code;
  call.card.motion.digital_io().WriteForAWhile(DoType::kClear, call.integer(0) - 1, true,
                                               kClearPulseUs);
  return vm::kOk;
}

int16_t GT_AxisOff(Call& call) {
  call.card.motion.AxisAt(AxisOf(call)).ServoOff();
  return vm::kOk;
}

// --- Events ----------------------------------------------------------------------------------

namespace {

/// True if the events of an axis are such that it stops a path.
bool AnyAxisHolds(const Card& card) {
  constexpr uint32_t kHolding = motion::kAlarmBit | motion::kFollowingErrorBit |
                                motion::kPositiveLimitBit | motion::kNegativeLimitBit;
  for (size_t axis = 0; axis < card.motion.axis_count(); ++axis) {
    if ((card.motion.Conditions(axis) & kHolding) != 0) return true;
  }
  return false;
}

/// Forgets the events whose bits are not kept.
void ClearEvents(Card& card, size_t axis, uint32_t kept) {
  uint32_t cleared = ConditionsOf(~kept & kEventBits);
  if (card.motion.FollowingErrorExceeded(axis)) cleared &= ~motion::kFollowingErrorBit;
  card.motion.AxisAt(axis).ClearConditions(cleared);
  if ((kept & kCapturedBit) == 0) card.motion.capture().Clear(axis);
  GeState& state = card.state<GeState>();
  if ((kept & kRefusedBit) == 0) state.axes[axis].refused = false;
  if (state.path && !AnyAxisHolds(card)) state.path->held = false;
}

}  // namespace

int16_t GT_ClrSts(Call& call) {
  ClearEvents(call.card, AxisOf(call), 0);
  return vm::kOk;
}

int16_t GT_RstSts(Call& call) {
  ClearEvents(call.card, AxisOf(call), static_cast<uint32_t>(call.integer(1)));
  return vm::kOk;
}

// --- Positions -------------------------------------------------------------------------------

int16_t GT_ZeroPos(Call& call) {
  const int16_t code = CheckAtRest(call, kInMotion);
  if (code == vm::kOk) PlaceAxis(call.card, AxisOf(call), 0);
  return code;
}

int16_t GT_GetAtlPos(Call& call) {
  call.Set(1, call.card.motion.encoder(AxisOf(call)).position);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::ge
