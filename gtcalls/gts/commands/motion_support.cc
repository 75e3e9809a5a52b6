#include "gtcalls/gts/commands/motion_support.h"

#include "gtcalls/gts/commands/bus_support.h"
#include "gtcalls/gts/numbers.h"

namespace oncard::gtcalls::gts {

using motion::Axis;
using motion::MotionState;
using motion::ProfileMode;

int16_t CheckAtRest(Call& call, size_t profile) {
  if (!call.card.motion.profile(profile).now.moving) return vm::kOk;
  return call.Refuse(vm::kRefused,
                     MakeMessage("profile {0} is moving, call GT_Stop and wait until bit 10 of "
                                 "GT_GetSts is 0",
                                 "规划器 {0} 正在运动，请先调用 GT_Stop 并等待 GT_GetSts 的第 10 "
                                 "位变为 0",
                                 profile + 1));
}

int16_t CheckAxisAtRest(Call& call, size_t axis) {
  const uint32_t map = call.card.motion.axis(axis).profile_map;
  for (size_t i = 0; i < call.card.motion.axis_count(); ++i) {
    const int16_t code = (map >> i & 1) != 0 ? CheckAtRest(call, i) : vm::kOk;
    if (code != vm::kOk) return code;
  }
  return vm::kOk;
}

int16_t CheckMode(Call& call, size_t profile, ProfileMode mode) {
  const ProfileMode present = call.card.motion.profile(profile).mode;
  if (present == mode) return vm::kOk;
  return call.Refuse(vm::kRefused, MakeMessage("profile {0} is in mode {1}; this needs mode {2}",
                                               "规划器 {0} 处于 {1} 模式；该指令需要 {2} 模式",
                                               profile + 1, NameOf(present), NameOf(mode)));
}

int16_t CheckModeAtRest(Call& call, size_t profile, ProfileMode mode) {
  const int16_t code = CheckMode(call, profile, mode);
  return code != vm::kOk ? code : CheckAtRest(call, profile);
}

int16_t ChooseMode(Call& call, size_t profile, ProfileMode mode) {
  int16_t code = CheckNotHoming(call, profile);
  if (code == vm::kOk) code = CheckAtRest(call, profile);
  if (code != vm::kOk) return code;
  call.card.motion.ProfileAt(profile).SelectMode(mode);
  return vm::kOk;
}

int16_t CheckNoGantrySlave(Call& call, size_t axis) {
  if (!call.card.motion.IsGantrySlave(axis)) return vm::kOk;
  return call.Refuse(
      vm::kRefused,
      MakeMessage("axis {0} is the slave of a gantry: command its master, axis {1}, or call "
                  "GT_DisableGantry",
                  "轴 {0} 是龙门从轴：请控制主轴 {1}，或调用 GT_DisableGantry", axis + 1,
                  call.card.motion.part<&MotionState::gantry>().master + 1));
}

int16_t CheckNotHoming(Call& call, size_t axis) {
  if (!call.card.motion.part<&MotionState::homing>()[axis].running) return vm::kOk;
  return call.Refuse(vm::kRefused,
                     MakeMessage("axis {0} is homing, wait until it is done or call GT_Stop",
                                 "轴 {0} 正在回零，请等待完成或调用 GT_Stop", axis + 1));
}

int16_t CheckMayStart(Call& call, size_t profile, double direction) {
  const motion::MotionCore& core = call.card.motion;
  if (!core.profile(profile).active) {
    return call.Refuse(vm::kRefused, MakeMessage("profile {0} is not active in the configuration",
                                                 "规划器 {0} 在配置中未激活", profile + 1));
  }
  const motion::Gantry& gantry = core.part<&MotionState::gantry>();
  if (gantry.on && (gantry.slave_map >> profile & 1) != 0) {
    const int16_t code = CheckNoGantrySlave(call, profile);
    if (code != vm::kOk) return code;
  }
  for (size_t i = 0; i < core.axis_count(); ++i) {
    const uint32_t map = core.part<&MotionState::axes, &Axis::profile_map>(i);
    if ((map >> profile & 1) == 0) continue;
    const Axis& axis = core.axis(i);
    if (!axis.active) continue;
    const auto refuse = [&](std::string_view en, std::string_view zh) {
      return call.Refuse(vm::kRefused, MakeMessage("axis {0} {1}, call GT_ClrSts",
                                                   "轴 {0} {2}，请调用 GT_ClrSts", i + 1, en, zh));
    };
    if ((axis.latched & motion::kAlarmBit) != 0) return refuse("alarm latched", "报警已锁存");
    if ((axis.latched & (motion::kSmoothStopBit | motion::kAbruptStopBit)) != 0) {
      return refuse("stop input latched", "停止输入已锁存");
    }
    if (const int16_t code = CheckBusObeys(call, i); code != vm::kOk) return code;
    const double along = axis.profile_scale.reverses() ? -direction : direction;
    if (along > 0 && (axis.latched & motion::kPositiveLimitBit) != 0) {
      return refuse("positive limit latched: move away from it", "正限位已锁存：请反向离开限位");
    }
    if (along < 0 && (axis.latched & motion::kNegativeLimitBit) != 0) {
      return refuse("negative limit latched: move away from it", "负限位已锁存：请反向离开限位");
    }
  }
  return vm::kOk;
}

int16_t CheckDirection(Call& call, ProfileMode mode, int present, int wanted) {
  if (ProfileOf(call).mode != mode || present == wanted) return vm::kOk;
  return call.Refuse(
      vm::kRefused,
      MakeMessage("profile {0} is in mode {1} with direction {2}: choose another mode "
                  "before another direction",
                  "规划器 {0} 已处于 {1} 模式，方向为 {2}：改变方向前请先切换到其它模式",
                  NumberOf(call) + 1, NameOf(mode), present));
}

std::optional<motion::Master> ReadMasterArguments(Call& call) {
  motion::Master master;
  const int index = call.integer(1);
  master.chosen = true;
  master.type = *MasterTypeOf(call.integer(2));
  master.encoder_side = call.integer(3) != 0;
  const int last = call.card.motion.config().axis_count;
  const bool auxiliary = master.type == motion::MasterType::kEncoder && index > last &&
                         call.card.motion.HasEncoder(static_cast<size_t>(index) - 1);
  if (index < 1 || (index > last && !auxiliary)) {
    call.reason = MakeMessage("masterIndex is {0}; this card has 1 to {1}",
                              "masterIndex 为 {0}；本控制卡的编号为 1 到 {1}", index, last);
    return std::nullopt;
  }
  master.index = static_cast<uint8_t>(index - 1);
  if (master.index == NumberOf(call)) {
    call.reason = MakeMessage("profile {0} cannot follow itself", "规划器 {0} 不能跟随自身", index);
    return std::nullopt;
  }
  return master;
}

void SetMasterOutputs(const Call& call, const motion::Master& master) {
  call.Set(1, master.chosen ? master.index + 1 : 0);
  call.Set(2, MasterNumber(master.type));
  call.Set(3, master.encoder_side ? 1 : 0);
}

std::vector<size_t> SelectedProfiles(Call& call) {
  std::vector<size_t> selected;
  const uint32_t mask = BitWord(call.value(0));
  for (size_t i = 0; i < call.card.motion.axis_count(); ++i) {
    if ((mask >> i & 1) != 0) selected.push_back(i);
  }
  if (selected.empty()) {
    call.reason = MakeMessage("the mask selects no axis of this card; bit 0 is axis 1",
                              "掩码未选中本控制卡的任何轴；第 0 位对应轴 1");
  }
  return selected;
}

}  // namespace oncard::gtcalls::gts
