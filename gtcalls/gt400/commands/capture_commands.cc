// Captures of the actual position, and the search for the home switch. Source: GT manual chapters
// 6, 9 and 11. Tested by tests/gtcalls/gt400/capture_command_test.cc and home_command_test.cc.
#include "gtcalls/gt400/commands/commands.h"
#include "gtcalls/gt400/events.h"
#include "gtcalls/gt400/homing.h"
#include "gtcalls/shared/senses.h"
#include "motion/common/rounding.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::Capture;
using motion::CaptureSource;

const Capture& CaptureOf(const Call& call) {
  return call.card.motion.part<&motion::MotionState::capture>().capture(CurrentAxis(call));
}

/// An axis has one capture, whatever it waits for.
int16_t Arm(Call& call, CaptureSource source, CommandCause busy) {
  const size_t axis = CurrentAxis(call);
  if (CaptureOf(call).armed || (EventsOf(call.card.view(), axis) & kCapturedBit) != 0) {
    return RefuseFor(call, busy,
                     MakeMessage("the capture of axis {0} is armed, or has captured: wait until "
                                 "bit 3 of GT_GetSts is 1, and call GT_ClrSts",
                                 "轴 {0} 的捕获已启动或已捕获：请等待 GT_GetSts 的第 3 位变为 "
                                 "1，并调用 GT_ClrSts",
                                 axis + 1));
  }
  call.card.motion.capture().Arm(axis, source);
  return vm::kOk;
}

}  // namespace

// --- Captures --------------------------------------------------------------------------------

int16_t GT_HomeSns(Call& call) {
  ChooseHomeEdges(static_cast<uint32_t>(call.integer(0)), call.card.motion);
  return vm::kOk;
}

int16_t GT_HomeSense(Call& call) { return GT_HomeSns(call); }

int16_t GT_CaptHome(Call& call) { return Arm(call, CaptureSource::kHome, kHomeBusy); }

int16_t GT_CaptIndex(Call& call) {
  const int16_t code = CheckServoCard(call);
  return code == vm::kOk ? Arm(call, CaptureSource::kIndex, kIndexBusy) : code;
}

/// Assumption: the probe rises, and replaces what else was armed.
int16_t GT_CaptProb(Call& call) {
  motion::CaptureUnit& unit = call.card.motion.capture();
  const auto arm = [&](size_t encoder) {
    unit.SetSense(encoder, CaptureSource::kProbe, true);
    unit.Arm(encoder, CaptureSource::kProbe);
  };
  for (size_t axis = 0; axis < call.card.motion.axis_count(); ++axis) arm(axis);
  for (size_t i = 0; i < kAuxiliaryMax; ++i) arm(motion::kAuxiliaryFirst + i);
  return vm::kOk;
}

int16_t GT_GetCapt(Call& call) {
  call.Set(0, motion::Whole(CaptureOf(call).value));
  return vm::kOk;
}

int16_t GT_ProbStopOn(Call& call) {
  StateOf(call).probe_stops = true;
  return vm::kOk;
}

int16_t GT_ProbStopOff(Call& call) {
  StateOf(call).probe_stops = false;
  return vm::kOk;
}

// --- The home switch -------------------------------------------------------------------------

/// Begins at the next tick, as an Update does.
int16_t GT_Home(Call& call) {
  if (call.ticked) return vm::kOk;
  int16_t code = CheckPosition(call, call.value(0));
  if (code == vm::kOk) code = CheckAtRest(call, kModeInUse);
  if (code != vm::kOk) return code;
  TakeHoming(call.card, CurrentAxis(call), call.integer(0));
  return call.WaitForTick();
}

int16_t GT_Index(Call& call) {
  CurrentState(call).homes_to_index = call.integer(0) != 0;
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gt400
