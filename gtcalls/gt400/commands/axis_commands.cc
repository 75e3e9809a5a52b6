// Setup and state of axes. Source: GT manual chapters 3, 4.4, 4.5, 7 and 11. Tested by
// tests/gtcalls/gt400/axis_command_test.cc.
#include <algorithm>

#include "gtcalls/gt400/commands/commands.h"
#include "gtcalls/gt400/drives.h"
#include "gtcalls/gt400/events.h"
#include "gtcalls/gt400/status_word.h"
#include "gtcalls/shared/senses.h"
#include "motion/common/rounding.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::DoType;

/// GT_CtrlMode.
constexpr int kPulseMode = 1;

/// Assumption: how long the CLEAR output is on, sample times.
constexpr int64_t kClearPulse = 100;
/// The motion core takes a sample time for a millisecond.
constexpr int64_t kUsPerCycle = 1000;

motion::AxisHandle HandleOf(const Call& call) { return call.card.motion.AxisAt(CurrentAxis(call)); }

}  // namespace

int16_t GT_Axis(Call& call) {
  StateOf(call).current = static_cast<uint8_t>(call.integer(0) - 1);
  return vm::kOk;
}

// --- Drives ----------------------------------------------------------------------------------

int16_t GT_AxisOn(Call& call) {
  const size_t axis = CurrentAxis(call);
  if ((EventsOf(call.card.view(), axis) & kAlarmEventBit) != 0) {
    return RefuseFor(call, kAlarm,
                     MakeMessage("axis {0} has had an alarm: remove its cause and call GT_ClrSts, "
                                 "or GT_AlarmOff when no drive is connected",
                                 "轴 {0} 曾报警：请排除原因并调用 GT_ClrSts，未接驱动器时可调用 "
                                 "GT_AlarmOff",
                                 axis + 1));
  }
  if (!call.card.motion.axis(axis).servo_on) HandleOf(call).ServoOn();
  SetEvents(call.card, axis, kCompleteBit);
  return vm::kOk;
}

/// Assumption: an end of motion is an event here, too.
int16_t GT_AxisOff(Call& call) {
  HandleOf(call).ServoOff();
  NoticeMotion(call.card, CurrentAxis(call));
  return vm::kOk;
}

int16_t GT_DrvRst(Call& call) {
  const size_t axis = CurrentAxis(call);
  if (call.card.motion.axis(axis).servo_on) {
    return RefuseFor(call, kDriveOn,
                     MakeMessage("the drive of axis {0} is enabled, call GT_AxisOff first",
                                 "轴 {0} 的驱动器已使能，请先调用 GT_AxisOff", axis + 1));
  }
  call.card.motion.digital_io().WriteForAWhile(DoType::kClear, static_cast<int>(axis), true,
                                               kClearPulse * kUsPerCycle);
  return vm::kOk;
}

// --- Outputs ---------------------------------------------------------------------------------

int16_t GT_CtrlMode(Call& call) {
  const int16_t code = CheckServoCard(call);
  if (code != vm::kOk) return code;
  CurrentState(call).pulses = call.integer(0) == kPulseMode;
  ConnectDrive(call.card, CurrentAxis(call));
  return vm::kOk;
}

int16_t GT_StepDir(Call& call) {
  call.card.motion.StepAt(CurrentAxis(call)).SetMode(motion::kPulseAndDirection);
  return vm::kOk;
}

int16_t GT_StepPulse(Call& call) {
  call.card.motion.StepAt(CurrentAxis(call)).SetMode(motion::kForwardAndBackward);
  return vm::kOk;
}

namespace {

int16_t SwitchLoop(Call& call, bool open) {
  const int16_t code = CheckServoCard(call);
  if (code != vm::kOk) return code;
  CurrentState(call).open_loop = open;
  ConnectDrive(call.card, CurrentAxis(call));
  return vm::kOk;
}

}  // namespace

int16_t GT_CloseLp(Call& call) { return SwitchLoop(call, false); }
int16_t GT_OpenLp(Call& call) { return SwitchLoop(call, true); }

// --- Inputs ----------------------------------------------------------------------------------

namespace {

int16_t SwitchEncoder(Call& call, bool external) {
  call.card.motion.EncoderAt(CurrentAxis(call)).SetExternal(external);
  return vm::kOk;
}

int16_t SwitchLimits(Call& call, bool on) {
  const motion::AxisHandle axis = HandleOf(call);
  axis.SwitchPositiveLimit(on);
  axis.SwitchNegativeLimit(on);
  return vm::kOk;
}

}  // namespace

int16_t GT_EncOn(Call& call) { return SwitchEncoder(call, true); }
int16_t GT_EncOff(Call& call) { return SwitchEncoder(call, false); }

int16_t GT_EncSns(Call& call) {
  const int16_t code = CheckServoCard(call);
  if (code != vm::kOk) return code;
  const auto sense = static_cast<uint32_t>(call.integer(0));
  ReverseEncoders(sense, 0, kAxisMax, call.card.motion);
  ReverseEncoders(sense >> kAxisMax, motion::kAuxiliaryFirst, kAuxiliaryMax, call.card.motion);
  return vm::kOk;
}

int16_t GT_LmtsOn(Call& call) { return SwitchLimits(call, true); }
int16_t GT_LmtsOff(Call& call) { return SwitchLimits(call, false); }

int16_t GT_LmtSns(Call& call) {
  InvertLimits(static_cast<uint32_t>(call.integer(0)), call.card.motion);
  return vm::kOk;
}

int16_t GT_AlarmOn(Call& call) {
  HandleOf(call).SwitchAlarm(true);
  return vm::kOk;
}

int16_t GT_AlarmOff(Call& call) {
  HandleOf(call).SwitchAlarm(false);
  return vm::kOk;
}

int16_t GT_AuStpOn(Call& call) {
  CurrentState(call).auto_stop = true;
  return vm::kOk;
}

int16_t GT_AuStpOff(Call& call) {
  CurrentState(call).auto_stop = false;
  return vm::kOk;
}

// --- Status ----------------------------------------------------------------------------------

int16_t GT_GetSts(Call& call) {
  call.Set(0, StatusWord(call.card.view(), CurrentAxis(call)));
  return vm::kOk;
}

int16_t GT_GetStsEx(Call& call) { return GT_GetSts(call); }

int16_t GT_GetMode(Call& call) {
  call.Set(0, ModeRegister(call.card.view(), CurrentAxis(call)));
  return vm::kOk;
}

int16_t GT_ClrSts(Call& call) {
  ClearEvents(call.card, CurrentAxis(call), 0);
  return vm::kOk;
}

int16_t GT_RstSts(Call& call) {
  ClearEvents(call.card, CurrentAxis(call), static_cast<uint32_t>(call.integer(0)));
  return vm::kOk;
}

// --- Positions -------------------------------------------------------------------------------

int16_t GT_ZeroPos(Call& call) {
  const int16_t code = CheckAtRest(call, kInMotion);
  if (code == vm::kOk) PlaceAxis(call.card, CurrentAxis(call), 0);
  return code;
}

int16_t GT_SetAtlPos(Call& call) {
  int16_t code = CheckPosition(call, call.value(0));
  if (code == vm::kOk) code = CheckAtRest(call, kInMotion);
  if (code == vm::kOk) PlaceAxis(call.card, CurrentAxis(call), call.integer(0));
  return code;
}

namespace {

const motion::Sample& PlannedOf(const Call& call) {
  return call.card.motion.profile(CurrentAxis(call)).now;
}

const motion::Encoder& EncoderOf(const Call& call) {
  return call.card.motion.encoder(CurrentAxis(call));
}

}  // namespace

int16_t GT_GetAtlPos(Call& call) {
  call.Set(0, EncoderOf(call).position);
  return vm::kOk;
}

int16_t GT_GetAtlVel(Call& call) {
  call.Set(0, EncoderOf(call).velocity);
  return vm::kOk;
}

/// Assumption: an error beyond 16 bits is read as the nearest one within them.
int16_t GT_GetAtlErr(Call& call) {
  const int16_t code = CheckServoCard(call);
  if (code != vm::kOk) return code;
  const double error = motion::Whole(PlannedOf(call).position - EncoderOf(call).position);
  call.Set(0, std::clamp(error, -32768.0, 32767.0));
  return vm::kOk;
}

int16_t GT_GetPrfPos(Call& call) {
  call.Set(0, motion::Whole(PlannedOf(call).position));
  return vm::kOk;
}

int16_t GT_GetPrfVel(Call& call) {
  call.Set(0, PlannedOf(call).velocity);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gt400
