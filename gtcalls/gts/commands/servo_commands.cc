// Servo controllers: closed loop, PID sets, following error, encoder check.
// Source: GTS manual table 10-2 and chapter 13; the public header for TPid and the checks; the GE
// manual for GT_CtrlMode. Tested by tests/gtcalls/servo_command_test.cc.
#include <cmath>

#include "gtcalls/gts/commands/motion_support.h"
#include "gtcalls/gts/defaults.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::Control;
using motion::PidSet;

/// GT_CtrlMode.
constexpr int kClosedLoopMode = 0;

/// Maximum of the gains; the minimum is 0 (GE manual).
constexpr double kGainMax = 32767;

/// The controller, to read and to change it.
const Control& ControlOf(const Call& call) {
  const motion::MotionCore& core = call.card.motion;
  return core.state().controls[NumberOf(call)];
}
motion::ControlHandle ControlAt(const Call& call) {
  return call.card.motion.ControlAt(NumberOf(call));
}
const PidSet& SetOf(const Call& call) { return ControlOf(call).sets[NumberOf(call, 1)]; }

}  // namespace

// --- Mode ------------------------------------------------------------------------------------

int16_t GT_CtrlMode(Call& call) {
  const size_t axis = NumberOf(call);
  const motion::MotionCore& core = call.card.motion;
  const bool closed = call.integer(1) == kClosedLoopMode;
  if (core.axis(axis).servo_on) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("the drive of axis {0} is enabled, call GT_AxisOff first",
                                   "轴 {0} 的驱动器已使能，请先调用 GT_AxisOff", axis + 1));
  }
  const int16_t code = CheckAxisAtRest(call, axis);
  if (code != vm::kOk) return code;
  if (closed && !core.encoder(axis).external) {
    return call.Refuse(
        vm::kRefused,
        MakeMessage("encoder {0} counts pulses; a closed loop needs the external encoder, call "
                    "GT_EncOn first",
                    "编码器 {0} 为脉冲计数方式；闭环控制需要外部编码器，请先调用 GT_EncOn",
                    axis + 1));
  }
  AxisAt(call).SetClosedLoop(closed);
  return vm::kOk;
}

// --- PID sets --------------------------------------------------------------------------------

namespace {

/// TPid as cells, in the order of its members.
enum PidCell : size_t {
  kKp,
  kKi,
  kKd,
  kKvff,
  kKaff,
  kIntegralLimit,
  kDerivativeLimit,
  kOutputLimit
};

}  // namespace

int16_t GT_SetPid(Call& call) {
  const std::span<double> pid = call.cells(2);
  for (size_t i = kKp; i <= kOutputLimit; ++i) {
    const bool gain = i <= kKaff;
    if (pid[i] >= 0 && (!gain || pid[i] <= kGainMax)) continue;
    const std::string_view name = call.command.parameters[2].structure->members[i].name;
    return call.Refuse(vm::kBadParameter,
                       gain ? MakeMessage("{0} is {1}; the range is [0, {2}]",
                                          "{0} 为 {1}；取值范围为 [0, {2}]", name, pid[i], kGainMax)
                            : MakeMessage("{0} is {1}; at least 0 is expected",
                                          "{0} 为 {1}；不得小于 0", name, pid[i]));
  }
  PidSet set = SetOf(call);
  set.kp = pid[kKp];
  set.ki = pid[kKi];
  set.kd = pid[kKd];
  set.kvff = pid[kKvff];
  set.kaff = pid[kKaff];
  set.integral_limit = static_cast<int32_t>(pid[kIntegralLimit]);
  set.derivative_limit = static_cast<int32_t>(pid[kDerivativeLimit]);
  set.limit = static_cast<int16_t>(pid[kOutputLimit]);
  ControlAt(call).SetPidSet(NumberOf(call, 1), set);
  return vm::kOk;
}

int16_t GT_GetPid(Call& call) {
  const PidSet& set = SetOf(call);
  call.Set(2, set.kp, kKp);
  call.Set(2, set.ki, kKi);
  call.Set(2, set.kd, kKd);
  call.Set(2, set.kvff, kKvff);
  call.Set(2, set.kaff, kKaff);
  call.Set(2, set.integral_limit, kIntegralLimit);
  call.Set(2, set.derivative_limit, kDerivativeLimit);
  call.Set(2, set.limit, kOutputLimit);
  return vm::kOk;
}

int16_t GT_SetControlFilter(Call& call) {
  ControlAt(call).SelectPidSet(NumberOf(call, 1));
  return vm::kOk;
}

int16_t GT_GetControlFilter(Call& call) {
  call.Set(1, ControlOf(call).selected + 1);
  return vm::kOk;
}

int16_t GT_SetKvffFilter(Call& call) {
  PidSet set = SetOf(call);
  set.kvff_filter = static_cast<int16_t>(call.integer(2));
  set.kvff_acc_max = call.value(3);
  ControlAt(call).SetPidSet(NumberOf(call, 1), set);
  return vm::kOk;
}

int16_t GT_GetKvffFilter(Call& call) {
  call.Set(2, SetOf(call).kvff_filter);
  call.Set(3, SetOf(call).kvff_acc_max);
  return vm::kOk;
}

// --- Following error and encoder check -------------------------------------------------------

int16_t GT_SetPosErr(Call& call) {
  ControlAt(call).SetErrorLimit(static_cast<int64_t>(call.value(1)));
  return vm::kOk;
}

int16_t GT_GetPosErr(Call& call) {
  call.Set(1, static_cast<double>(ControlOf(call).error_limit));
  return vm::kOk;
}

int16_t GT_SetEncResponseCheck(Call& call) {
  ControlAt(call).SetResponseCheck(static_cast<int16_t>(call.integer(1)), call.value(2),
                                   call.integer(3) * kTimeUnitUs);
  return vm::kOk;
}

int16_t GT_GetEncResponseCheck(Call& call) {
  const motion::ResponseCheck& check = ControlOf(call).check;
  call.Set(1, check.threshold);
  call.Set(2, check.min_velocity);
  call.Set(3, TimeUnits(check.time));
  return vm::kOk;
}

namespace {

int16_t SwitchCheck(Call& call, bool on) {
  ControlAt(call).SwitchResponseCheck(on);
  return vm::kOk;
}

}  // namespace

int16_t GT_EnableEncResponseCheck(Call& call) { return SwitchCheck(call, true); }
int16_t GT_DisableEncResponseCheck(Call& call) { return SwitchCheck(call, false); }

}  // namespace oncard::gtcalls::gts
