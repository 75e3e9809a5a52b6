// The hand wheel and auxiliary encoders of path cards. Source: GE manual 10.3 and chapter 12;
// public header. Tested by tests/gtcalls/ge/wheel_command_test.cc.
#include "gtcalls/ge/commands/path_support.h"

namespace oncard::gtcalls::ges {
namespace {

/// The encoder of the wheel.
constexpr size_t kWheelEncoder = motion::kAuxiliaryFirst;
/// GE manual 10.3: the wheel must have rested as long before another axis or ratio is chosen.
constexpr int64_t kWheelRestUs = 2'000'000;

size_t AuxiliaryOf(const Call& call) {
  return motion::kAuxiliaryFirst + static_cast<size_t>(call.integer(0) - 1);
}

/// Ends the mode. Assumption: the axis rests at once.
void LeaveWheel(Card& card) {
  HandWheel& wheel = PathIn(card).wheel;
  if (wheel.axis == 0) return;
  const auto axis = static_cast<size_t>(wheel.axis - 1);
  card.motion.ProfileAt(axis).Stop(true);
  card.motion.ProfileAt(axis).SelectMode(motion::ProfileMode::kCrd);
  wheel = {};
}

}  // namespace

int16_t GT_EncPos(Call& call) {
  call.Set(1, call.card.motion.encoder(AuxiliaryOf(call)).position);
  return vm::kOk;
}

int16_t GT_EncVel(Call& call) {
  call.Set(1, call.card.motion.encoder(AuxiliaryOf(call)).velocity);
  return vm::kOk;
}

int16_t GT_ClrEncPos(Call& call) {
  call.card.motion.EncoderAt(AuxiliaryOf(call)).SetPosition(0);
  return vm::kOk;
}

int16_t GT_HandWheel(Call& call) {
  const Path& path = PathOf(call);
  motion::MotionCore& core = call.card.motion;
  // Written so that the check fails for a NaN.
  if (!(call.value(1) < 0 || call.value(1) > 0)) {
    return call.Refuse(vm::kBadParameter,
                       {"the ratio is 0: the axis would not move", "倍率为 0：控制轴不会运动"});
  }
  int16_t code = CheckListClosed(call, kPathState);
  if (code == vm::kOk) code = CheckNoPath(call, kPathState);
  if (code != vm::kOk) return code;
  const int64_t rest_cycles = kWheelRestUs / core.config().cycle_us;
  if (path.wheel.axis != 0 && core.cycle() - path.wheel.last_count < rest_cycles) {
    return RefusePath(call, vm::kRefused, kPathState,
                      {"the wheel must have rested for 2 s before another axis or ratio is chosen",
                       "手轮须静止 2 s 后才能更换控制轴或倍率"});
  }
  if (path.velocity == 0 || path.acceleration == 0) {
    return RefusePath(call, kBadRate, kPathState,
                      {"there is no feed or acceleration, call GT_SetSynVel and GT_SetSynAcc first",
                       "未设置速度或加速度，请先调用 GT_SetSynVel 和 GT_SetSynAcc"});
  }
  DriverOf(call.card);
  LeaveWheel(call.card);
  const motion::ProfileHandle profile = core.ProfileAt(AxisOf(call));
  profile.SelectMode(motion::ProfileMode::kWheel);
  motion::WheelMode& follows = profile.wheel();
  follows.master = {.chosen = true,
                    .type = motion::MasterType::kEncoder,
                    .index = static_cast<uint8_t>(kWheelEncoder)};
  follows.ratio = call.value(1);
  follows.limits = {.velocity = path.velocity,
                    .acceleration = path.acceleration,
                    .deceleration = path.acceleration,
                    .start_velocity = path.start_velocity};
  follows.cycle = static_cast<double>(core.config().cycle_us) / 1000;
  profile.Start();
  PathOf(call).wheel = {.axis = call.integer(0),
                        .last_count = core.cycle(),
                        .position = core.encoder(kWheelEncoder).position};
  return vm::kOk;
}

int16_t GT_ExitHWheel(Call& call) {
  LeaveWheel(call.card);
  return vm::kOk;
}

void NoticeWheel(Card& card) {
  HandWheel& wheel = PathIn(card).wheel;
  const motion::MotionCore& core = card.motion;
  const double position = core.encoder(kWheelEncoder).position;
  if (wheel.axis == 0 || position == wheel.position) return;
  wheel.position = position;
  wheel.last_count = core.cycle();
}

}  // namespace oncard::gtcalls::ges
