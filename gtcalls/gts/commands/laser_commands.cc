// The laser signals of the high-speed outputs. Source: public header; public laser demonstration
// programs. Tested by tests/gtcalls/laser_command_test.cc.
#include "gtcalls/gts/commands/commands.h"
#include "gtcalls/gts/commands/crd_support.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::Laser;
using motion::LaserBounds;
using motion::LaserMode;

/// The laser of the channel in an argument, to read and to change it.
const Laser& LaserOf(const Call& call, size_t argument) {
  const auto channel = static_cast<size_t>(call.integer(argument));
  return call.card.motion.part<&motion::MotionState::lasers>().channels[channel];
}
Laser& LaserAt(const Call& call, size_t argument) {
  return call.card.motion.laser(static_cast<size_t>(call.integer(argument)));
}

int16_t RefuseBounds(Call& call, double least, double most) {
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("the least power {0} is greater than the most, {1}",
                                 "最小功率 {0} 大于最大功率 {1}", least, most));
}

/// 0, or 7 with the reason if a parameter has a value whose effect no document describes.
int16_t CheckZero(Call& call, size_t argument) {
  if (call.value(argument) == 0) return vm::kOk;
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("{0} is {1}; no document describes its effect, pass 0",
                                 "{0} 为 {1}；没有资料说明其作用，应传入 0",
                                 call.command.parameters[argument].name, call.value(argument)));
}

/// 0, or 7 with the reason if a power is outside the bounds of the laser's mode.
int16_t CheckPower(Call& call, const LaserBounds& bounds, double power) {
  if (power >= bounds.least && power <= bounds.most) return vm::kOk;
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("the power {0} is outside [{1}, {2}], the range that "
                                 "GT_LaserPowerMode has set",
                                 "功率 {0} 超出 GT_LaserPowerMode 设定的范围 [{1}, {2}]", power,
                                 bounds.least, bounds.most));
}

int16_t Append(Call& call, motion::BufferedKind kind, size_t channel, int detail,
               const std::array<double, 4>& values) {
  motion::PathSlot slot;
  slot.command = {kind, call.integer(channel), detail, values};
  return AppendSlot(call, slot);
}

}  // namespace

int16_t GT_SetHSIOOpt(Call& call) {
  LaserAt(call, 1).on = call.integer(0) != 0;
  return vm::kOk;
}

int16_t GT_GetHSIOOpt(Call& call) {
  call.Set(0, LaserOf(call, 1).on ? 1 : 0);
  return vm::kOk;
}

int16_t GT_LaserPowerMode(Call& call) {
  const int16_t code = CheckZero(call, 4);
  if (code != vm::kOk) return code;
  const LaserBounds bounds = {call.value(2), call.value(1)};
  if (bounds.least > bounds.most) return RefuseBounds(call, bounds.least, bounds.most);
  Laser& laser = LaserAt(call, 3);
  laser.mode = static_cast<LaserMode>(call.integer(0));
  laser.bounds = bounds;
  laser.power = bounds.Within(0);
  laser.follows = false;
  return vm::kOk;
}

int16_t GT_LaserPrfCmd(Call& call) {
  Laser& laser = LaserAt(call, 1);
  const int16_t code = CheckPower(call, laser.bounds, call.value(0));
  if (code != vm::kOk) return code;
  laser.power = call.value(0);
  laser.follows = false;
  return vm::kOk;
}

int16_t GT_LaserOutFrq(Call& call) {
  LaserAt(call, 1).pulse_frequency = call.value(0);
  return vm::kOk;
}

int16_t GT_SetPulseWidth(Call& call) {
  LaserAt(call, 1).pulse_width = call.value(0);
  return vm::kOk;
}

int16_t GT_BufLaserOn(Call& call) {
  return Append(call, motion::BufferedKind::kLaserSwitch, 2, 1, {});
}

int16_t GT_BufLaserOff(Call& call) {
  return Append(call, motion::BufferedKind::kLaserSwitch, 2, 0, {});
}

int16_t GT_BufLaserPrfCmd(Call& call) {
  const int16_t code = CheckPower(call, LaserOf(call, 3).bounds, call.value(1));
  if (code != vm::kOk) return code;
  return Append(call, motion::BufferedKind::kLaserPower, 3, 0, {call.value(1)});
}

int16_t GT_BufLaserFollowRatio(Call& call) {
  if (call.value(2) > call.value(3)) return RefuseBounds(call, call.value(2), call.value(3));
  return Append(call, motion::BufferedKind::kLaserFollow, 5, call.integer(0) - 1,
                {call.value(1), call.value(2), call.value(3)});
}

int16_t GT_BufLaserFollowMode(Call& call) {
  const int16_t code = CheckZero(call, 4);
  if (code != vm::kOk) return code;
  return Append(call, motion::BufferedKind::kLaserSource, 3, call.integer(1), {});
}

}  // namespace oncard::gtcalls::gts
