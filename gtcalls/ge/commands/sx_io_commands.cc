// Inputs, outputs and captures that only path cards have. Source: GE manual 7, 9, 10.2, 10.4 and
// chapter 12; public header. Tested by tests/gtcalls/ge/sx_io_command_test.cc.
#include "gtcalls/ge/commands/path_support.h"
#include "gtcalls/shared/io_commands.h"

namespace oncard::gtcalls::ges {
namespace {

/// Assumption: no document names a version.
constexpr double kVersion = 100;

}  // namespace

/// Assumption: the falling edge; the captures of both auxiliary encoders are armed, too.
int16_t GT_CaptProb(Call& call) {
  const motion::CaptureUnit& captures = call.card.motion.part<&motion::MotionState::capture>();
  const size_t axes = call.card.motion.axis_count();
  for (size_t axis = 0; axis < axes; ++axis) {
    const motion::Capture& capture = captures.capture(axis);
    if (!capture.armed && !capture.captured) continue;
    return RefuseAxis(call, axis, kCaptureBusy,
                      MakeMessage("the capture of axis {0} is armed, or has captured: call "
                                  "GT_ClrSts when bit 3 of GT_GetSts is 1",
                                  "轴 {0} 的捕获已启动或已捕获：请在 GT_GetSts 的第 3 位为 1 "
                                  "时调用 GT_ClrSts",
                                  axis + 1));
  }
  for (size_t axis = 0; axis < axes; ++axis) {
    call.card.motion.capture().Arm(axis, motion::CaptureSource::kProbe);
  }
  for (size_t i = 0; i < 2; ++i) {
    call.card.motion.capture().Arm(motion::kAuxiliaryFirst + i, motion::CaptureSource::kProbe);
  }
  return vm::kOk;
}

int16_t GT_ExOptBit(Call& call) { return WriteGeneralOutput(call); }
int16_t GT_GetExOpt(Call& call) { return ReadGeneralOutputs(call); }

/// Assumption: all channels are sampled in each cycle.
int16_t GT_SetAdcChn(Call&) { return vm::kOk; }

namespace {

void SetSpindle(Call& call, double value) { call.card.motion.SetSpindle(value); }

}  // namespace

int16_t GT_SetSpindleVel(Call& call) {
  SetSpindle(call, call.value(0));
  return vm::kOk;
}

int16_t GT_CloseSpindle(Call& call) {
  SetSpindle(call, 0);
  return vm::kOk;
}

int16_t GT_GetDllVrsn(Call& call) {
  call.Set(0, kVersion);
  return vm::kOk;
}

int16_t GT_ChkVrsn(Call& call) {
  call.Set(0, kVersion);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::ges
