// Analogue outputs and inputs.
// Source: GTS manual table 10-2; the public header for parameters.
// Tested by tests/gtcalls/analog_command_test.cc.
#include "gtcalls/gts/commands/motion_support.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::Adc;
using motion::Dac;

const Dac& DacOf(const Call& call, size_t index) {
  const motion::MotionCore& core = call.card.motion;
  return core.state().dacs[index];
}
motion::DacHandle DacAt(const Call& call, size_t offset = 0) {
  return call.card.motion.DacAt(NumberOf(call) + offset);
}
const Adc& AdcOf(const Call& call, size_t index) {
  return call.card.motion.part<&motion::MotionState::adcs>()[index];
}

int16_t CheckDac(Call& call, int offset) {
  const Dac& dac = DacOf(call, NumberOf(call) + static_cast<size_t>(offset));
  if (dac.control < 0) return vm::kOk;
  return call.Refuse(
      vm::kRefused,
      MakeMessage("analogue output {0} belongs to servo controller {1}; call GT_CtrlMode with mode "
                  "1 first",
                  "模拟量输出 {0} 由伺服控制器 {1} 控制；请先以模式 1 调用 GT_CtrlMode",
                  call.integer(0) + offset, dac.control + 1));
}

}  // namespace

int16_t GT_SetDac(Call& call) {
  for (int i = 0; i < call.integer(2); ++i) {
    const int16_t code = CheckDac(call, i);
    if (code != vm::kOk) return code;
  }
  for (int i = 0; i < call.integer(2); ++i) {
    const auto cell = static_cast<size_t>(i);
    DacAt(call, cell).SetValue(call.cells(1)[cell]);
  }
  return vm::kOk;
}

int16_t GT_GetDac(Call& call) {
  return ReadEach(call, [&](size_t i) { return DacOf(call, i).Output(); });
}

int16_t GT_SetMtrBias(Call& call) {
  DacAt(call).SetBias(static_cast<int16_t>(call.integer(1)));
  return vm::kOk;
}

int16_t GT_GetMtrBias(Call& call) {
  call.Set(1, DacOf(call, NumberOf(call)).bias);
  return vm::kOk;
}

int16_t GT_SetMtrLmt(Call& call) {
  DacAt(call).SetLimit(static_cast<int16_t>(call.integer(1)));
  return vm::kOk;
}

int16_t GT_GetMtrLmt(Call& call) {
  call.Set(1, DacOf(call, NumberOf(call)).limit);
  return vm::kOk;
}

namespace {

/// The inputs from `adc` on must exist.
int16_t CheckLastAdc(Call& call) {
  const int last = call.integer(0) + call.integer(2) - 1;
  if (last <= kAdcMax) return vm::kOk;
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("{0} inputs starting at {1} extend to {2}; this card has 1 to {3}",
                                 "从 {1} 起共 {0} 个，到 {2} 为止；本控制卡的编号为 1 到 {3}",
                                 call.integer(2), call.integer(0), last, kAdcMax));
}

}  // namespace

int16_t GT_GetAdc(Call& call) {
  const int16_t code = CheckLastAdc(call);
  if (code != vm::kOk) return code;
  return ReadEach(call, [&](size_t i) { return AdcOf(call, i).Volts(); });
}

int16_t GT_GetAdcValue(Call& call) {
  const int16_t code = CheckLastAdc(call);
  if (code != vm::kOk) return code;
  return ReadEach(call, [&](size_t i) { return AdcOf(call, i).Value(); });
}

int16_t GT_SetAdcFilter(Call& call) {
  call.card.motion.SetAdcFilter(NumberOf(call), static_cast<int16_t>(call.integer(1)));
  return vm::kOk;
}

/// Assumption: an older name for the same command.
int16_t GT_GetDacValue(Call& call) { return GT_GetDac(call); }

}  // namespace oncard::gtcalls::gts
