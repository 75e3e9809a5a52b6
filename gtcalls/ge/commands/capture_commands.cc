// Captures of the actual position, one for each axis. Source: GE manual chapters 7 and 12. Tested
// by tests/gtcalls/ge/capture_command_test.cc.
#include "gtcalls/ge/commands/commands.h"
#include "gtcalls/shared/senses.h"
#include "motion/common/rounding.h"

namespace oncard::gtcalls::ge {
namespace {

using motion::Capture;
using motion::CaptureSource;

const Capture& CaptureOf(const Call& call) {
  return call.card.motion.part<&motion::MotionState::capture>().capture(AxisOf(call));
}

int16_t Arm(Call& call, CaptureSource source) {
  if (CaptureOf(call).armed || CaptureOf(call).captured) {
    return RefuseAxis(call, AxisOf(call), kCaptureBusy,
                      MakeMessage("the capture of axis {0} is armed, or has captured: wait until "
                                  "bit 3 of GT_GetSts is 1, and call GT_ClrSts",
                                  "轴 {0} 的捕获已启动或已捕获：请等待 GT_GetSts 的第 3 位变为 "
                                  "1，并调用 GT_ClrSts",
                                  call.integer(0)));
  }
  call.card.motion.capture().Arm(AxisOf(call), source);
  return vm::kOk;
}

}  // namespace

int16_t GT_HomeSns(Call& call) {
  ChooseHomeEdges(static_cast<uint32_t>(call.integer(0)), call.card.motion);
  return vm::kOk;
}

int16_t GT_CaptHome(Call& call) { return Arm(call, CaptureSource::kHome); }
int16_t GT_CaptIndex(Call& call) { return Arm(call, CaptureSource::kIndex); }

int16_t GT_GetCapt(Call& call) {
  call.Set(1, motion::Whole(CaptureOf(call).value));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::ge
