// Follow: tables of slave displacement against master displacement.
// Source: GTS manual 7.6 and chapter 13. Tested by tests/gtcalls/follow_command_test.cc.
#include "gtcalls/gts/commands/motion_support.h"
#include "gtcalls/gts/numbers.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::FollowMode;
using motion::FollowSegment;
using motion::ProfileMode;

const FollowMode& FollowOf(const Call& call) { return ProfileOf(call).follow; }
FollowMode& ChangeFollow(const Call& call) { return ProfileAt(call).follow(); }

int16_t CheckFollow(Call& call) { return CheckMode(call, NumberOf(call), ProfileMode::kFollow); }
int16_t CheckFollowAtRest(Call& call) {
  return CheckModeAtRest(call, NumberOf(call), ProfileMode::kFollow);
}

size_t FifoArgument(const Call& call, size_t index) {
  return static_cast<size_t>(call.integer(index));
}

}  // namespace

int16_t GT_PrfFollow(Call& call) {
  const auto direction = static_cast<int8_t>(call.integer(1));
  int16_t code = CheckDirection(call, ProfileMode::kFollow, FollowOf(call).direction, direction);
  if (code == vm::kOk) code = ChooseMode(call, NumberOf(call), ProfileMode::kFollow);
  if (code == vm::kOk) ChangeFollow(call).direction = direction;
  return code;
}

int16_t GT_SetFollowMaster(Call& call) {
  const auto master = ReadMasterArguments(call);
  if (!master) return vm::kBadParameter;
  const int16_t code = CheckFollowAtRest(call);
  if (code == vm::kOk) ChangeFollow(call).master = *master;
  return code;
}

int16_t GT_GetFollowMaster(Call& call) {
  const int16_t code = CheckFollow(call);
  if (code == vm::kOk) SetMasterOutputs(call, FollowOf(call).master);
  return code;
}

int16_t GT_SetFollowLoop(Call& call) {
  const int16_t code = CheckFollow(call);
  if (code == vm::kOk) ChangeFollow(call).loop = call.integer(1);
  return code;
}

int16_t GT_GetFollowLoop(Call& call) {
  const int16_t code = CheckFollow(call);
  if (code == vm::kOk) call.Set(1, FollowOf(call).passes);
  return code;
}

int16_t GT_SetFollowEvent(Call& call) {
  if (call.integer(2) == 0) {
    return call.Refuse(vm::kBadParameter, {"masterDir is 0; 1 is forward, -1 backward",
                                           "masterDir 为 0；1 为正向，-1 为负向"});
  }
  const int16_t code = CheckFollow(call);
  if (code != vm::kOk) return code;
  FollowMode& follow = ChangeFollow(call);
  follow.event = *FollowEventOf(call.integer(1));
  follow.event_direction = static_cast<int8_t>(call.integer(2));
  follow.event_position = call.integer(3);
  return vm::kOk;
}

int16_t GT_GetFollowEvent(Call& call) {
  const int16_t code = CheckFollow(call);
  if (code != vm::kOk) return code;
  const FollowMode& follow = FollowOf(call);
  call.Set(1, EventNumber(follow.event));
  call.Set(2, follow.event_direction);
  call.Set(3, follow.event_position);
  return vm::kOk;
}

int16_t GT_SetFollowMemory(Call& call) {
  const int16_t code = CheckFollowAtRest(call);
  if (code == vm::kOk) ChangeFollow(call).SetMemory(call.integer(1) != 0);
  return code;
}

int16_t GT_GetFollowMemory(Call& call) {
  const int16_t code = CheckFollow(call);
  if (code == vm::kOk) call.Set(1, FollowOf(call).large_memory ? 1 : 0);
  return code;
}

// --- Data ------------------------------------------------------------------------------------

int16_t GT_FollowSpace(Call& call) {
  const int16_t code = CheckFollow(call);
  if (code == vm::kOk) {
    call.Set(1, static_cast<double>(FollowOf(call).Space(FifoArgument(call, 2))));
  }
  return code;
}

namespace {

/// The master displacements of a FIFO must continue in one direction; false, with the reason
/// recorded, if the new one does not.
bool CheckMasterSegment(Call& call, const std::vector<FollowSegment>& segments, int32_t master) {
  const int32_t before = segments.empty() ? 0 : segments.back().master;
  const bool same_way = segments.empty() || (before > 0 ? master > before : master < before);
  if (master != 0 && same_way) return true;
  call.reason = MakeMessage(
      "masterSegment is {0} after {1}; it counts from the start of the table and must continue in "
      "one direction",
      "masterSegment 为 {0}，前一段为 {1}；该值从表头累计，必须沿同一方向变化", master, before);
  return false;
}

}  // namespace

int16_t GT_FollowData(Call& call) {
  const int16_t code = CheckFollow(call);
  FollowMode& follow = ChangeFollow(call);
  const size_t which = FifoArgument(call, 4);
  std::vector<FollowSegment>& segments = follow.fifos[which];
  if (!CheckMasterSegment(call, segments, call.integer(1))) return vm::kBadParameter;
  if (code != vm::kOk) return code;
  if (follow.Space(which) == 0) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("FIFO {0} is full, call GT_FollowSpace first",
                                   "FIFO {0} 已满，请先用 GT_FollowSpace 查询空间", which));
  }
  segments.reserve(follow.Capacity());
  segments.push_back({call.integer(1), call.value(2), *FollowSegmentTypeOf(call.integer(3))});
  return vm::kOk;
}

int16_t GT_FollowClear(Call& call) {
  const int16_t code = CheckFollow(call);
  if (code != vm::kOk) return code;
  const FollowMode& follow = FollowOf(call);
  const size_t which = FifoArgument(call, 1);
  if (follow.running && (follow.fifo == which || follow.switching)) {
    return call.Refuse(
        vm::kRefused,
        MakeMessage("FIFO {0} is in use or switched to, stop the profile or wait for the "
                    "switch",
                    "FIFO {0} 正在使用或即将切换，请先停止运动或等待切换完成", which));
  }
  ChangeFollow(call).fifos[which].clear();
  return vm::kOk;
}

// --- Start -----------------------------------------------------------------------------------

namespace {

int16_t RefuseEmpty(Call& call, size_t profile, size_t which) {
  return call.Refuse(
      vm::kRefused,
      MakeMessage("FIFO {1} of profile {0} is empty, call GT_FollowData",
                  "规划器 {0} 的 FIFO {1} 为空，请调用 GT_FollowData", profile + 1, which));
}

size_t StartFifo(const Call& call, size_t profile) { return BitWord(call.value(1)) >> profile & 1; }

int16_t CheckFollowStart(Call& call, size_t profile) {
  const int16_t code = CheckModeAtRest(call, profile, ProfileMode::kFollow);
  if (code != vm::kOk) return code;
  const FollowMode& follow = call.card.motion.profile(profile).follow;
  if (!follow.master.chosen) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("profile {0} has no master, call GT_SetFollowMaster",
                                   "规划器 {0} 没有主轴，请调用 GT_SetFollowMaster", profile + 1));
  }
  const size_t which = StartFifo(call, profile);
  if (follow.fifos[which].empty()) return RefuseEmpty(call, profile, which);
  const motion::MasterValue master = call.card.motion.ReadMaster(follow.master);
  return CheckMayStart(call, profile, follow.Direction(static_cast<uint8_t>(which), master));
}

}  // namespace

int16_t GT_FollowStart(Call& call) {
  const std::vector<size_t> selected = SelectedProfiles(call);
  if (selected.empty()) return vm::kRefused;
  for (const size_t profile : selected) {
    if (const int16_t code = CheckFollowStart(call, profile); code != vm::kOk) return code;
  }
  motion::MotionCore& core = call.card.motion;
  for (const size_t profile : selected) {
    const motion::ProfileHandle slave = core.ProfileAt(profile);
    slave.follow().fifo = static_cast<uint8_t>(StartFifo(call, profile));
    slave.Start();
  }
  return vm::kOk;
}

namespace {

int16_t CheckFollowSwitch(Call& call, size_t profile) {
  const int16_t code = CheckMode(call, profile, ProfileMode::kFollow);
  if (code != vm::kOk) return code;
  const FollowMode& follow = call.card.motion.profile(profile).follow;
  if (!follow.running) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("profile {0} does not follow, call GT_FollowStart",
                                   "规划器 {0} 未在跟随，请调用 GT_FollowStart", profile + 1));
  }
  const size_t other = 1u - follow.fifo;
  return follow.fifos[other].empty() ? RefuseEmpty(call, profile, other) : vm::kOk;
}

}  // namespace

int16_t GT_FollowSwitch(Call& call) {
  const std::vector<size_t> selected = SelectedProfiles(call);
  if (selected.empty()) return vm::kRefused;
  for (const size_t profile : selected) {
    if (const int16_t code = CheckFollowSwitch(call, profile); code != vm::kOk) return code;
  }
  for (const size_t profile : selected) {
    call.card.motion.ProfileAt(profile).follow().switching = true;
  }
  return vm::kOk;
}

int16_t GT_GetFollowStatus(Call& call) {
  const int16_t code = CheckFollow(call);
  if (code != vm::kOk) return code;
  call.Set(1, FollowOf(call).fifo);
  call.Set(2, FollowOf(call).switching ? 1 : 0);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
