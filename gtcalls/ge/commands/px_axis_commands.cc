// Axes of point-to-point cards: status, positions, servo loops. Source: GE manual chapters 3, 4, 8
// and 12. Tested by tests/gtcalls/ge/axis_command_test.cc and servo_command_test.cc.
#include "gtcalls/ge/commands/commands.h"
#include "gtcalls/ge/status_words.h"
#include "motion/common/rounding.h"

namespace oncard::gtcalls::gep {
namespace {

const motion::Sample& PlannedOf(const Call& call) {
  return call.card.motion.profile(AxisOf(call)).now;
}

}  // namespace

int16_t GT_IndexSns(Call& call) {
  for (size_t axis = 0; axis < call.card.motion.axis_count(); ++axis) {
    const bool rising = (call.integer(0) >> axis & 1) != 0;
    call.card.motion.capture().SetSense(axis, motion::CaptureSource::kIndex, rising);
  }
  return vm::kOk;
}

int16_t GT_AxisOn(Call& call) {
  const int16_t code = CheckNoAlarm(call, kAlarm);
  if (code == vm::kOk) EnableDrive(call.card, AxisOf(call));
  return code;
}

// --- Status ----------------------------------------------------------------------------------

int16_t GT_GetSts(Call& call) {
  call.Set(1, StatusWord(call.card.view(), AxisOf(call)));
  return vm::kOk;
}

int16_t GT_GetMode(Call& call) {
  call.Set(1, ModeRegister(call.card.view(), AxisOf(call)));
  return vm::kOk;
}

int16_t GT_AuStpOn(Call& call) {
  GeAxisOf(call).auto_stop = true;
  return vm::kOk;
}

int16_t GT_AuStpOff(Call& call) {
  GeAxisOf(call).auto_stop = false;
  return vm::kOk;
}

// --- Positions -------------------------------------------------------------------------------

int16_t GT_SetAtlPos(Call& call) {
  const int16_t code = CheckAtRest(call, kInMotion);
  if (code == vm::kOk) PlaceAxis(call.card, AxisOf(call), call.integer(1));
  return code;
}

int16_t GT_GetPrfPos(Call& call) {
  call.Set(1, motion::Whole(PlannedOf(call).position));
  return vm::kOk;
}

int16_t GT_GetPrfVel(Call& call) {
  call.Set(1, PlannedOf(call).velocity);
  return vm::kOk;
}

int16_t GT_GetAtlVel(Call& call) {
  call.Set(1, call.card.motion.encoder(AxisOf(call)).velocity);
  return vm::kOk;
}

int16_t GT_GetAtlErr(Call& call) {
  const double actual = call.card.motion.encoder(AxisOf(call)).position;
  call.Set(1, motion::Whole(PlannedOf(call).position - actual));
  return vm::kOk;
}

// --- Servo loops -----------------------------------------------------------------------------

namespace {

int16_t SwitchLoop(Call& call, bool open) {
  const int16_t code = CheckDriveOff(call, kModeInUse);
  if (code != vm::kOk) return code;
  GeAxisOf(call).open_loop = open;
  ConnectDrive(call.card, AxisOf(call));
  return vm::kOk;
}

}  // namespace

int16_t GT_CloseLp(Call& call) { return SwitchLoop(call, false); }
int16_t GT_OpenLp(Call& call) { return SwitchLoop(call, true); }

/// The integral limit keeps the sum within 16 bits.
int16_t GT_GetIntgr(Call& call) {
  const motion::MotionCore& core = call.card.motion;
  call.Set(1, motion::Whole(core.state().controls[AxisOf(call)].sum));
  return vm::kOk;
}

int16_t GT_SetMtrCmd(Call& call) {
  if (!GeAxisOf(call).open_loop) {
    return RefuseAxis(call, AxisOf(call), kModeInUse,
                      MakeMessage("the loop of axis {0} is closed, call GT_OpenLp first",
                                  "轴 {0} 为闭环控制，请先调用 GT_OpenLp", call.integer(0)));
  }
  if (IsAnalogue(call.card, AxisOf(call)))
    call.card.motion.DacAt(AxisOf(call)).SetValue(call.value(1));
  return vm::kOk;
}

int16_t GT_GetMtrCmd(Call& call) {
  const motion::MotionCore& core = call.card.motion;
  call.Set(1, core.state().dacs[AxisOf(call)].Output());
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gep
