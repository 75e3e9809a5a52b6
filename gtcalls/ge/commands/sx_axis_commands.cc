// Axes of path cards: status, positions, drives, outputs of servo controllers. Source: GE manual
// chapters 3, 4, 8 and 12; public header. Tested by tests/gtcalls/ge/sx_axis_command_test.cc.
#include "gtcalls/ge/commands/path_support.h"
#include "gtcalls/ge/status_words.h"
#include "motion/common/rounding.h"

namespace oncard::gtcalls::ges {

// --- Inputs and drives -----------------------------------------------------------------------

int16_t GT_AlarmOn(Call& call) {
  const int16_t code = CheckDriveOff(call, kDriveOn);
  return code == vm::kOk ? ge::GT_AlarmOn(call) : code;
}

int16_t GT_AlarmOff(Call& call) {
  const int16_t code = CheckDriveOff(call, kDriveOn);
  return code == vm::kOk ? ge::GT_AlarmOff(call) : code;
}

int16_t GT_AxisOn(Call& call) {
  const int16_t code = CheckNoAlarm(call, kDriveOn);
  if (code != vm::kOk) return code;
  if (PathRuns(call.card)) {
    // Assumption: the plan is not touched by an axis that joins a path under way.
    call.card.motion.AxisAt(AxisOf(call)).ServoOn();
  } else {
    EnableDrive(call.card, AxisOf(call));
  }
  return vm::kOk;
}

int16_t GT_AxisOff(Call& call) {
  PathOf(call).commanded = true;
  ge::GT_AxisOff(call);
  NoticePath(call.card);
  return vm::kOk;
}

// These are the same on both kinds of cards.
int16_t GT_IndexSns(Call& call) { return gep::GT_IndexSns(call); }
int16_t GT_GetAtlErr(Call& call) { return gep::GT_GetAtlErr(call); }
int16_t GT_GetAtlVel(Call& call) { return gep::GT_GetAtlVel(call); }
int16_t GT_GetIntgr(Call& call) { return gep::GT_GetIntgr(call); }
int16_t GT_GetMtrCmd(Call& call) { return gep::GT_GetMtrCmd(call); }

int16_t GT_AuStpOn(Call&) { return vm::kOk; }
int16_t GT_AuStpOff(Call&) { return vm::kOk; }

// --- Status and positions --------------------------------------------------------------------

int16_t GT_GetSts(Call& call) {
  call.Set(1, StatusWord(call.card.view(), AxisOf(call)));
  return vm::kOk;
}

int16_t GT_SetAtlPos(Call& call) {
  const int16_t code = CheckAtRest(call, kInMotion);
  if (code == vm::kOk) {
    PlaceAxis(call.card, AxisOf(call), static_cast<int32_t>(motion::Whole(call.value(1))));
  }
  return code;
}

// --- Outputs ---------------------------------------------------------------------------------

namespace {

/// 0, or 1 if the axis is not controlled as the command needs it.
int16_t CheckOutput(Call& call, bool analogue) {
  if (IsAnalogue(call.card, AxisOf(call)) == analogue) return vm::kOk;
  return RefuseAxis(call, AxisOf(call), kModeInUse,
                    analogue
                        ? MakeMessage("axis {0} puts out pulses and has no servo controller",
                                      "轴 {0} 输出脉冲，没有伺服控制器", call.integer(0))
                        : MakeMessage("axis {0} puts out a voltage, call GT_CtrlMode first",
                                      "轴 {0} 输出模拟量，请先调用 GT_CtrlMode", call.integer(0)));
}

int16_t WithOutput(Call& call, bool analogue, CommandFunction command) {
  const int16_t code = CheckOutput(call, analogue);
  return code == vm::kOk ? command(call) : code;
}

}  // namespace

int16_t GT_StepDir(Call& call) { return WithOutput(call, false, ge::GT_StepDir); }
int16_t GT_StepPulse(Call& call) { return WithOutput(call, false, ge::GT_StepPulse); }
int16_t GT_SetKp(Call& call) { return WithOutput(call, true, ge::GT_SetKp); }
int16_t GT_SetKi(Call& call) { return WithOutput(call, true, ge::GT_SetKi); }
int16_t GT_SetKd(Call& call) { return WithOutput(call, true, ge::GT_SetKd); }
int16_t GT_SetKvff(Call& call) { return WithOutput(call, true, ge::GT_SetKvff); }
int16_t GT_SetKaff(Call& call) { return WithOutput(call, true, ge::GT_SetKaff); }
int16_t GT_SetILmt(Call& call) { return WithOutput(call, true, ge::GT_SetILmt); }
int16_t GT_SetMtrLmt(Call& call) { return WithOutput(call, true, ge::GT_SetMtrLmt); }
int16_t GT_SetMtrBias(Call& call) { return WithOutput(call, true, ge::GT_SetMtrBias); }

// --- Registers -------------------------------------------------------------------------------

namespace {

void UpdateRegisters(Card& card, size_t axis) {
  card.state<GeState>().axes[axis].registers.Update();
  UpdateServo(card, axis);
}

}  // namespace

int16_t GT_Update(Call& call) {
  UpdateRegisters(call.card, AxisOf(call));
  return vm::kOk;
}

int16_t GT_MltiUpdt(Call& call) {
  const auto mask = static_cast<uint32_t>(call.integer(0));
  if (mask == 0) return RefuseEmptyMask(call);
  for (size_t axis = 0; axis < call.card.motion.axis_count(); ++axis) {
    if ((mask >> axis & 1) != 0) UpdateRegisters(call.card, axis);
  }
  return vm::kOk;
}

int16_t GT_SetBacklash(Call& call) {
  call.card.motion.AxisAt(AxisOf(call))
      .SetBacklash({.value = call.integer(1), .change = 0, .positive = false});
  return vm::kOk;
}

}  // namespace oncard::gtcalls::ges
