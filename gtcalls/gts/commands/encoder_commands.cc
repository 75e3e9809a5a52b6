// The source and direction of encoders, and the form of pulse outputs.
// Source: GTS manual chapters 4.3.2 and 4.5.2, table 10-2; the GE manual for the pulse outputs.
// Tested by tests/gtcalls/encoder_command_test.cc.
#include "gtcalls/gts/commands/motion_support.h"
#include "gtcalls/shared/senses.h"

namespace oncard::gtcalls::gts {

int16_t GT_EncOn(Call& call) {
  call.card.motion.EncoderAt(NumberOf(call)).SetExternal(true);
  return vm::kOk;
}

/// A closed loop needs the external encoder (GTS manual 4.3.2).
int16_t GT_EncOff(Call& call) {
  for (const motion::Control& control : call.card.motion.state().controls) {
    if (!control.closed || control.encoder != call.integer(0) - 1) continue;
    return call.Refuse(
        vm::kRefused,
        MakeMessage("encoder {0} closes the loop of axis {1}; call GT_CtrlMode with mode 1 first",
                    "编码器 {0} 用于轴 {1} 的闭环控制；请先以模式 1 调用 GT_CtrlMode",
                    call.integer(0), control.axis + 1));
  }
  call.card.motion.EncoderAt(NumberOf(call)).SetExternal(false);
  return vm::kOk;
}

/// Bit n-1 reverses encoder n, auxiliary ones included.
int16_t GT_EncSns(Call& call) {
  ReverseEncoders(BitWord(call.value(0)), 0, kAxisMax, call.card.motion);
  return vm::kOk;
}

// --- Pulse outputs ---------------------------------------------------------------------------

namespace {

/// Refused while the axis is in closed loop, as in the GE manual.
int16_t SetStepMode(Call& call, int16_t mode) {
  motion::MotionCore& core = call.card.motion;
  const int axis = core.part<&motion::MotionState::steps, &motion::Step::axis>(NumberOf(call));
  if (axis >= 0 && core.InClosedLoop(static_cast<size_t>(axis))) {
    return call.Refuse(
        vm::kRefused,
        MakeMessage(
            "axis {0} is in closed loop and outputs no pulses; call GT_CtrlMode with mode 1 first",
            "轴 {0} 处于闭环模式，不输出脉冲；请先以模式 1 调用 GT_CtrlMode", axis + 1));
  }
  core.StepAt(NumberOf(call)).SetMode(mode);
  return vm::kOk;
}

}  // namespace

int16_t GT_StepDir(Call& call) { return SetStepMode(call, motion::kPulseAndDirection); }
int16_t GT_StepPulse(Call& call) { return SetStepMode(call, motion::kForwardAndBackward); }

}  // namespace oncard::gtcalls::gts
