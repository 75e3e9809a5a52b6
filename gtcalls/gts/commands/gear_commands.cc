// Electronic gear.
// Source: GTS manual 7.5 and chapter 13; the public header for events.
// Tested by tests/gtcalls/gear_command_test.cc.
#include "gtcalls/gts/commands/motion_support.h"
#include "gtcalls/gts/numbers.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::GearMode;
using motion::ProfileMode;

const GearMode& GearOf(const Call& call) { return ProfileOf(call).gear; }
GearMode& ChangeGear(const Call& call) { return ProfileAt(call).gear(); }

int16_t CheckGear(Call& call) { return CheckMode(call, NumberOf(call), ProfileMode::kGear); }

}  // namespace

int16_t GT_PrfGear(Call& call) {
  const auto direction = static_cast<int8_t>(call.integer(1));
  int16_t code = CheckDirection(call, ProfileMode::kGear, GearOf(call).direction, direction);
  if (code == vm::kOk) code = ChooseMode(call, NumberOf(call), ProfileMode::kGear);
  if (code == vm::kOk) ChangeGear(call).direction = direction;
  return code;
}

int16_t GT_SetGearMaster(Call& call) {
  const auto master = ReadMasterArguments(call);
  if (!master) return vm::kBadParameter;
  const int16_t code = CheckModeAtRest(call, NumberOf(call), ProfileMode::kGear);
  if (code == vm::kOk) ChangeGear(call).master = *master;
  return code;
}

int16_t GT_GetGearMaster(Call& call) {
  const int16_t code = CheckGear(call);
  if (code == vm::kOk) SetMasterOutputs(call, GearOf(call).master);
  return code;
}

int16_t GT_SetGearRatio(Call& call) {
  if (call.integer(3) == 1) {
    return call.Refuse(vm::kBadParameter,
                       {"masterSlope is 1; it is 0 for no clutch, or 2 and more pulses",
                        "masterSlope 为 1；应为 0（无离合区）或不小于 2"});
  }
  const int16_t code = CheckGear(call);
  if (code != vm::kOk) return code;
  GearMode& gear = ChangeGear(call);
  gear.master_even = call.integer(1);
  gear.slave_even = call.integer(2);
  gear.slope = call.integer(3);
  gear.ratio_set = true;
  if (gear.running) gear.ChangeRatio(ProfileOf(call).now);
  return vm::kOk;
}

int16_t GT_GetGearRatio(Call& call) {
  const int16_t code = CheckGear(call);
  if (code != vm::kOk) return code;
  const GearMode& gear = GearOf(call);
  call.Set(1, gear.master_even);
  call.Set(2, gear.slave_even);
  call.Set(3, gear.slope);
  return vm::kOk;
}

int16_t GT_SetGearEvent(Call& call) {
  const auto event = GearEventOf(call.integer(1));
  if (!event) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("event {0} is unknown; 1 starts at once, 2 when the master passes a position, "
                    "5 inside an area",
                    "事件 {0} 无效；1 为立即启动，2 为主轴穿越位置，5 为位于区域内",
                    call.integer(1)));
  }
  const int16_t code = CheckModeAtRest(call, NumberOf(call), ProfileMode::kGear);
  if (code != vm::kOk) return code;
  GearMode& gear = ChangeGear(call);
  gear.event = *event;
  gear.event_first = call.integer(2);
  gear.event_last = call.integer(3);
  return vm::kOk;
}

int16_t GT_GetGearEvent(Call& call) {
  const int16_t code = CheckGear(call);
  if (code != vm::kOk) return code;
  const GearMode& gear = GearOf(call);
  call.Set(1, EventNumber(gear.event));
  call.Set(2, gear.event_first);
  call.Set(3, gear.event_last);
  return vm::kOk;
}

namespace {

int16_t CheckGearStart(Call& call, size_t profile) {
  const int16_t code = CheckModeAtRest(call, profile, ProfileMode::kGear);
  if (code != vm::kOk) return code;
  const GearMode& gear = call.card.motion.profile(profile).gear;
  if (!gear.master.chosen) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("profile {0} has no master, call GT_SetGearMaster",
                                   "规划器 {0} 没有主轴，请调用 GT_SetGearMaster", profile + 1));
  }
  if (!gear.ratio_set) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("profile {0} has no ratio, call GT_SetGearRatio",
                                   "规划器 {0} 没有传动比，请调用 GT_SetGearRatio", profile + 1));
  }
  return CheckMayStart(call, profile, gear.Direction(call.card.motion.ReadMaster(gear.master)));
}

}  // namespace

int16_t GT_GearStart(Call& call) {
  const std::vector<size_t> selected = SelectedProfiles(call);
  if (selected.empty()) return vm::kRefused;
  for (const size_t profile : selected) {
    if (const int16_t code = CheckGearStart(call, profile); code != vm::kOk) return code;
  }
  for (const size_t profile : selected) call.card.motion.ProfileAt(profile).Start();
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
