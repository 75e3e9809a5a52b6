// Axes: drives, status, inputs, limits, stops, the in-position band and the scales.
// Source: GTS manual chapters 4.3, 4.4, 6, 9, 11.7 and 13; the public header for the filters.
// Tested by tests/gtcalls/axis_command_test.cc.
#include <cstdlib>

#include "gtcalls/gts/commands/bus_support.h"
#include "gtcalls/gts/commands/crd_support.h"
#include "gtcalls/gts/defaults.h"
#include "gtcalls/gts/numbers.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::Axis;
using motion::InputChoice;

}  // namespace

// --- Drive -----------------------------------------------------------------------------------

int16_t GT_AxisOn(Call& call) {
  const Axis& axis = AxisOf(call);
  if (!axis.active) {
    return call.Refuse(vm::kRefused, MakeMessage("axis {0} is not active in the configuration",
                                                 "轴 {0} 在配置中未激活", call.integer(0)));
  }
  if (axis.alarm_on && call.card.motion.InputActive(axis.alarm)) {
    return call.Refuse(
        vm::kRefused, MakeMessage("the drive of axis {0} reports an alarm; remove its cause, or "
                                  "call GT_AlarmOff when no drive is connected",
                                  "轴 {0} 的驱动器报警；请排除原因，未接驱动器时可调用 GT_AlarmOff",
                                  call.integer(0)));
  }
  int16_t code = CheckAxisAtRest(call, NumberOf(call));
  if (code == vm::kOk) code = CheckBusStarted(call, NumberOf(call));
  if (code != vm::kOk) return code;
  AxisAt(call).ServoOn();
  return vm::kOk;
}

int16_t GT_AxisOff(Call& call) {
  AxisAt(call).ServoOff();
  return vm::kOk;
}

// --- Status ----------------------------------------------------------------------------------

int16_t GT_GetSts(Call& call) {
  return ReadEach(call, [&](size_t axis) { return call.card.view().StatusWord(axis); });
}

int16_t GT_ClrSts(Call& call) {
  for (int i = 0; i < call.integer(1); ++i) {
    call.card.motion.AxisAt(NumberOf(call) + static_cast<size_t>(i)).ClearStatus();
  }
  return vm::kOk;
}

// --- Inputs ----------------------------------------------------------------------------------

namespace {

/// 0, or 1 with the reason if the configuration assigns no such input to the axis.
int16_t CheckConfigured(Call& call, const InputChoice& input, std::string_view en,
                        std::string_view zh) {
  if (input.bit >= 0) return vm::kOk;
  return call.Refuse(vm::kRefused,
                     MakeMessage("the configuration assigns no {1} input to axis {0}",
                                 "配置中轴 {0} 没有{2}输入", call.integer(0), en, zh));
}

int16_t SwitchAlarm(Call& call, bool on) {
  const int16_t code = CheckConfigured(call, AxisOf(call).alarm, "alarm", "报警");
  if (code == vm::kOk) AxisAt(call).SwitchAlarm(on);
  return code;
}

}  // namespace

int16_t GT_AlarmOn(Call& call) { return SwitchAlarm(call, true); }
int16_t GT_AlarmOff(Call& call) { return SwitchAlarm(call, false); }

namespace {

/// Limit type -1 means both.
int16_t SwitchLimits(Call& call, bool on) {
  const Axis& axis = AxisOf(call);
  const bool positive = call.integer(1) != 1;
  const bool negative = call.integer(1) != 0;
  int16_t code = vm::kOk;
  if (positive) code = CheckConfigured(call, axis.positive_limit, "positive limit", "正限位");
  if (negative && code == vm::kOk) {
    code = CheckConfigured(call, axis.negative_limit, "negative limit", "负限位");
  }
  if (code != vm::kOk) return code;
  if (positive) AxisAt(call).SwitchPositiveLimit(on);
  if (negative) AxisAt(call).SwitchNegativeLimit(on);
  return vm::kOk;
}

}  // namespace

int16_t GT_LmtsOn(Call& call) { return SwitchLimits(call, true); }
int16_t GT_LmtsOff(Call& call) { return SwitchLimits(call, false); }

int16_t GT_SetSoftLimit(Call& call) {
  if (call.integer(1) <= call.integer(2)) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("the positive limit {0} must be greater than the negative limit "
                    "{1}",
                    "正限位 {0} 必须大于负限位 {1}", call.integer(1), call.integer(2)));
  }
  AxisAt(call).SetSoftLimits(call.integer(1), call.integer(2));
  return vm::kOk;
}

int16_t GT_GetSoftLimit(Call& call) {
  call.Set(1, AxisOf(call).soft_positive);
  call.Set(2, AxisOf(call).soft_negative);
  return vm::kOk;
}

int16_t GT_SetStopIo(Call& call) {
  const auto type = *DiTypeOf(call.integer(2));
  const int index = call.integer(3);
  if (index != kNoInput && (index < 1 || index > DiWidth(type))) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("input {0} of word {1} does not exist; the word has 1 to {2}, and -1 removes "
                    "the stop input",
                    "访问第 {1} 类输入的 {0}；其编号为 1 到 {2}，-1 表示取消停止输入", index,
                    call.integer(2), DiWidth(type)));
  }
  const InputChoice input{type, static_cast<int16_t>(index == kNoInput ? -1 : index - 1)};
  if (call.integer(1) == kAbruptStopType) {
    AxisAt(call).SetAbruptStopInput(input);
  } else {
    AxisAt(call).SetSmoothStopInput(input);
  }
  return vm::kOk;
}

// --- Stops -----------------------------------------------------------------------------------

int16_t GT_SetStopDec(Call& call) {
  ProfileAt(call).SetStopDecelerations(call.value(1), call.value(2));
  return vm::kOk;
}

int16_t GT_GetStopDec(Call& call) {
  call.Set(1, ProfileOf(call).smooth_stop);
  call.Set(2, ProfileOf(call).abrupt_stop);
  return vm::kOk;
}

/// Bit n-1 of the mask: profile n; CrdBitsOf names those of coordinate systems. If the same bit of
/// the option is 0 the stop is smooth, if it is 1 abrupt.
int16_t GT_Stop(Call& call) {
  const std::vector<size_t> profiles = SelectedProfiles(call);
  const uint32_t mask = BitWord(call.value(0));
  const size_t axis_count = call.card.motion.axis_count();
  const std::vector<size_t> crds = CrdsOf(CrdBitsOf(mask, axis_count));
  if (profiles.empty() && crds.empty()) return vm::kRefused;
  call.reason = {};
  const uint32_t abrupt = BitWord(call.value(1));
  const uint32_t abrupt_crds = CrdBitsOf(mask & abrupt, axis_count);
  for (const size_t i : crds) call.card.motion.CrdAt(i).Stop((abrupt_crds >> i & 1) != 0);
  for (const size_t i : profiles) call.card.motion.AxisAt(i).Stop((abrupt >> i & 1) != 0);
  return vm::kOk;
}

// --- In position -----------------------------------------------------------------------------

int16_t GT_SetAxisBand(Call& call) {
  AxisAt(call).SetBand(call.integer(1), call.integer(2) * kTimeUnitUs);
  return vm::kOk;
}

int16_t GT_GetAxisBand(Call& call) {
  call.Set(1, AxisOf(call).band);
  call.Set(2, TimeUnits(AxisOf(call).band_time));
  return vm::kOk;
}

// --- Scales and filters ----------------------------------------------------------------------

namespace {

/// 0, or the refusal if the scale is not a ratio of at most 1 or the axis is moving.
int16_t CheckScale(Call& call) {
  const int alpha = call.integer(1);
  const int beta = call.integer(2);
  if (beta == 0 || std::abs(alpha) < std::abs(beta)) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("alpha {0} and beta {1}: both must differ from 0, and |alpha| "
                                   "must be at least |beta|",
                                   "alpha 为 {0}，beta 为 {1}：两者均不得为 0，且 |alpha| 不得小于 "
                                   "|beta|",
                                   alpha, beta));
  }
  return CheckAxisAtRest(call, NumberOf(call));
}

motion::Scale ScaleOf(const Call& call) {
  return {static_cast<int16_t>(call.integer(1)), static_cast<int16_t>(call.integer(2))};
}

}  // namespace

int16_t GT_ProfileScale(Call& call) {
  int16_t code = CheckScale(call);
  if (code == vm::kOk) code = CheckNoGantrySlave(call, NumberOf(call));
  if (code == vm::kOk) AxisAt(call).SetProfileScale(ScaleOf(call));
  return code;
}

int16_t GT_EncScale(Call& call) {
  const int16_t code = CheckScale(call);
  if (code == vm::kOk) AxisAt(call).SetEncoderScale(ScaleOf(call));
  return code;
}

int16_t GT_SetAxisPrfVelFilter(Call& call) {
  AxisAt(call).SetProfileVelocityFilter(static_cast<int16_t>(call.integer(1)));
  return vm::kOk;
}

int16_t GT_SetAxisEncVelFilter(Call& call) {
  AxisAt(call).SetEncoderVelocityFilter(static_cast<int16_t>(call.integer(1)));
  return vm::kOk;
}

int16_t GT_GetAxisPrfVelFilter(Call& call) {
  call.Set(1, AxisOf(call).profile.filter.exponent);
  return vm::kOk;
}

int16_t GT_GetAxisEncVelFilter(Call& call) {
  call.Set(1, AxisOf(call).encoder.filter.exponent);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
