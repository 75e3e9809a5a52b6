// Position/time motion: buffers, loops, start.
// Source: GTS manual 7.4 and chapter 13; the public header for numbered segments. Tested by
// tests/gtcalls/pt_command_test.cc.
#include "gtcalls/gts/commands/motion_support.h"
#include "gtcalls/gts/numbers.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::ProfileMode;
using motion::PtMode;

int16_t CheckPt(Call& call) { return CheckMode(call, NumberOf(call), ProfileMode::kPt); }

const PtMode& PtOf(const Call& call) { return ProfileOf(call).pt; }
PtMode& ChangePt(const Call& call) { return ProfileAt(call).pt(); }

size_t PtBufferOf(const Call& call, size_t index) {
  return static_cast<size_t>(call.integer(index));
}

}  // namespace

int16_t GT_PrfPt(Call& call) {
  const int16_t code = ChooseMode(call, NumberOf(call), ProfileMode::kPt);
  if (code == vm::kOk) ChangePt(call).SetDynamic(call.integer(1) != 0);
  return code;
}

// --- Buffers ---------------------------------------------------------------------------------

int16_t GT_SetPtMemory(Call& call) {
  const int16_t code = CheckModeAtRest(call, NumberOf(call), ProfileMode::kPt);
  if (code != vm::kOk) return code;
  const PtMode& pt = PtOf(call);
  const bool large = call.integer(1) != 0;
  if (large != pt.large_memory && !pt.Empty()) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("the PT buffers of profile {0} hold data, call GT_PtClear "
                                   "before changing their size",
                                   "规划器 {0} 的 PT 缓存区内有数据，请先调用 GT_PtClear "
                                   "再改变其大小",
                                   call.integer(0)));
  }
  ChangePt(call).large_memory = large;
  return vm::kOk;
}

int16_t GT_GetPtMemory(Call& call) {
  const int16_t code = CheckPt(call);
  if (code == vm::kOk) call.Set(1, PtOf(call).large_memory ? 1 : 0);
  return code;
}

int16_t GT_PtSpace(Call& call) {
  const int16_t code = CheckPt(call);
  if (code == vm::kOk) {
    call.Set(1, static_cast<double>(PtOf(call).Space(PtBufferOf(call, 2))));
  }
  return code;
}

namespace {

/// Appends the segment of arguments 1 to 3.
int16_t Append(Call& call, size_t buffer, int32_t number) {
  const int16_t code = CheckPt(call);
  if (code != vm::kOk) return code;
  PtMode& pt = ChangePt(call);
  const int32_t time = call.integer(2);
  if (time <= pt.LastTime(buffer)) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("the segment ends at {0} ms, but the one before it ends at {1} "
                                   "ms; times count from the start and must increase",
                                   "数据段的终点时间为 {0} ms，而前一段为 {1} "
                                   "ms；时间从起点算起，必须递增",
                                   time, pt.LastTime(buffer)));
  }
  if (pt.Space(buffer) == 0) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("the PT buffer of profile {0} is full, wait until GT_PtSpace "
                                   "is not 0, or call GT_PtClear",
                                   "规划器 {0} 的 PT 缓存区已满，请等待 GT_PtSpace 不为 0，或调用 "
                                   "GT_PtClear",
                                   call.integer(0)));
  }
  pt.Append(buffer, call.value(1), time, *PtSegmentTypeOf(call.integer(3)), number);
  return vm::kOk;
}

}  // namespace

int16_t GT_PtData(Call& call) { return Append(call, PtBufferOf(call, 4), 0); }

int16_t GT_PtDataWN(Call& call) { return Append(call, PtBufferOf(call, 5), call.integer(4)); }

int16_t GT_PtGetSegNum(Call& call) {
  const int16_t code = CheckPt(call);
  if (code == vm::kOk) call.Set(1, PtOf(call).number);
  return code;
}

int16_t GT_GetPtRemainder(Call& call) {
  const int16_t code = CheckPt(call);
  if (code == vm::kOk) call.Set(1, static_cast<double>(PtOf(call).Remainder()));
  return code;
}

int16_t GT_PtClear(Call& call) {
  const int16_t code = CheckPt(call);
  if (code != vm::kOk) return code;
  PtMode& pt = ChangePt(call);
  const size_t buffer = PtBufferOf(call, 1);
  if (pt.running && (pt.dynamic || pt.run_buffer == buffer)) {
    return call.Refuse(
        vm::kRefused,
        MakeMessage("the PT buffer of profile {0} is in use, call GT_Stop first",
                    "规划器 {0} 的 PT 缓存区正在使用，请先调用 GT_Stop", call.integer(0)));
  }
  pt.Clear(buffer);
  return vm::kOk;
}

// --- Loops and start -------------------------------------------------------------------------

int16_t GT_SetPtLoop(Call& call) {
  const int16_t code = CheckPt(call);
  if (code == vm::kOk) ChangePt(call).loop_target = call.integer(1);
  return code;
}

int16_t GT_GetPtLoop(Call& call) {
  const int16_t code = CheckPt(call);
  if (code == vm::kOk) call.Set(1, PtOf(call).loop_count);
  return code;
}

int16_t GT_PtStart(Call& call) {
  const std::vector<size_t> profiles = SelectedProfiles(call);
  if (profiles.empty()) return vm::kRefused;
  const uint32_t option = BitWord(call.value(1));
  for (const size_t i : profiles) {
    const PtMode& pt = call.card.motion.profile(i).pt;
    int16_t code = CheckModeAtRest(call, i, ProfileMode::kPt);
    if (code == vm::kOk) code = CheckMayStart(call, i, pt.Direction(option >> i & 1));
    if (code != vm::kOk) return code;
    if (!pt.HasData(option >> i & 1)) {
      return call.Refuse(vm::kRefused,
                         MakeMessage("the PT buffer of profile {0} is empty, call GT_PtData first",
                                     "规划器 {0} 的 PT 缓存区为空，请先调用 GT_PtData", i + 1));
    }
  }
  for (const size_t i : profiles) {
    const motion::ProfileHandle profile = call.card.motion.ProfileAt(i);
    if (!profile.pt().dynamic) profile.pt().run_buffer = option >> i & 1;
    profile.Start();
  }
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
