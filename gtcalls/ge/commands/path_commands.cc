// Paths: their parameters, lines and arcs, status and positions. With the list open a segment is
// appended to it, otherwise it is executed at once. Source: GE manual chapters 4.5, 6 and 12.
// Tested by tests/gtcalls/ge/path_command_test.cc.
#include "gtcalls/ge/commands/path_support.h"
#include "gtcalls/ge/status_words.h"
#include "gtcalls/shared/segment_request.h"

namespace oncard::gtcalls::ges {
namespace {

using motion::Coordinates;
using motion::Crd;

/// MapCnt: GE manual chapter 12.
constexpr double kOffsetMax = -kPositionMin;

}  // namespace

// --- State -----------------------------------------------------------------------------------

int16_t GT_GetCrdSts(Call& call) {
  call.Set(0, PathStatusWord(call.card.view()));
  return vm::kOk;
}

int16_t GT_GetPrfVel(Call& call) {
  call.Set(0, CrdOf(call.card).run.velocity);
  return vm::kOk;
}

int16_t GT_GetPrfPnt(Call& call) {
  for (size_t i = 0; i < call.card.motion.axis_count(); ++i) {
    call.Set(0, call.card.motion.profile(i).now.position, i);
  }
  return vm::kOk;
}

int16_t GT_GetSegPnt(Call& call) {
  const Crd& crd = CrdOf(call.card);
  const bool in_segment = crd.run.running && crd.active().executing;
  for (size_t i = 0; i < call.card.motion.axis_count(); ++i) {
    const double position = call.card.motion.profile(i).now.position;
    call.Set(0, in_segment ? crd.origin[i] + crd.active().current.segment.end[i] : position, i);
  }
  return vm::kOk;
}

int16_t GT_GetBrkPnt(Call& call) {
  for (size_t i = 0; i < call.card.motion.axis_count(); ++i) {
    call.Set(0, PathOf(call).break_point[i], i);
  }
  return vm::kOk;
}

int16_t GT_GetMtnNm(Call& call) {
  call.Set(0, CrdOf(call.card).fifos[kListFifo].GivenNumber());
  return vm::kOk;
}

// --- Parameters ------------------------------------------------------------------------------

int16_t GT_SetSynVel(Call& call) {
  int16_t code = CheckRate(call, 0);
  if (code != vm::kOk) return code;
  if (!ListOf(call).open) {
    PathOf(call).velocity = call.value(0);
    return vm::kOk;
  }
  const uint32_t words = WordsOf(call.command);
  code = CheckListBegun(call, false);
  if (code == vm::kOk) code = CheckRoom(call, words);
  if (code != vm::kOk) return code;
  ListOf(call).words.AddCommand(words);
  ListOf(call).feed = call.value(0);
  return vm::kOk;
}

int16_t GT_SetDccVel(Call& call) {
  const uint32_t words = WordsOf(call.command);
  int16_t code = CheckRate(call, 0, true);
  if (code == vm::kOk) code = CheckListBegun(call, false);
  if (code == vm::kOk) code = CheckRoom(call, words);
  if (code != vm::kOk) return code;
  ListOf(call).words.AddCommand(words);
  ListOf(call).end_velocity = call.value(0);
  return vm::kOk;
}

int16_t GT_SetSynAcc(Call& call) {
  int16_t code = CheckRate(call, 0);
  if (code == vm::kOk) code = CheckListClosed(call, kPathState);
  if (code == vm::kOk) code = CheckNoPath(call, kPathState);
  if (code == vm::kOk) PathOf(call).acceleration = call.value(0);
  return code;
}

namespace {

/// Sets a register that no path in motion may lose.
int16_t SetRegister(Call& call, double Path::*value, bool may_be_zero = false) {
  int16_t code = CheckRate(call, 0, may_be_zero);
  if (code == vm::kOk) code = CheckNoPath(call, kPathState);
  if (code == vm::kOk) PathOf(call).*value = call.value(0);
  return code;
}

}  // namespace

int16_t GT_SetStrtVel(Call& call) { return SetRegister(call, &Path::start_velocity, true); }
int16_t GT_SetMaxVel(Call& call) { return SetRegister(call, &Path::max_velocity); }
int16_t GT_SetStpAcc(Call& call) { return SetRegister(call, &Path::stop_acceleration); }
int16_t GT_SetEStpAcc(Call& call) { return SetRegister(call, &Path::emergency_acceleration); }

int16_t GT_Override(Call& call) {
  DriverOf(call.card).SetOverride(call.value(0));
  return vm::kOk;
}

int16_t GT_OverrideG0(Call& call) {
  DriverOf(call.card).SetSecondOverride(call.value(0));
  return vm::kOk;
}

/// Assumption: machine position = work coordinate + count.
int16_t GT_MapCnt(Call& call) {
  const double count = call.value(1);
  if (count < -kOffsetMax || count > kOffsetMax) {
    return RefusePath(
        call, vm::kRefused, kModeInUse,
        MakeMessage("count is {0}; the range is [{1}, {2}]", "count 为 {0}；取值范围为 [{1}, {2}]",
                    count, -kOffsetMax, kOffsetMax));
  }
  int16_t code = CheckListClosed(call, kModeInUse);
  if (code == vm::kOk) code = CheckNoPath(call, kModeInUse);
  if (code == vm::kOk) DriverOf(call.card).SetOrigin(AxisOf(call), count);
  return code;
}

// --- Lines and arcs --------------------------------------------------------------------------

namespace {

int16_t RefuseGeometry(Call& call, SegmentFault fault) {
  switch (fault) {
    case SegmentFault::kNoLength:
      return RefusePath(call, kNoLength, kPathState, {"the line has no length", "直线长度为 0"});
    case SegmentFault::kChordTooLong:
      return RefusePath(call, kChordTooLong, kPathState,
                        {"the chord of the arc is longer than its diameter", "圆弧的弦长大于直径"});
    default:
      return RefusePath(
          call, kNoRadius, kPathState,
          {"the radius, the chord or the angle of the arc is 0", "圆弧的半径、弦长或角度为 0"});
  }
}

/// Appends a segment to the list.
int16_t AppendToList(Call& call, const SegmentRequest& request) {
  List& list = ListOf(call);
  int16_t code = CheckListBegun(call, false);
  if (code != vm::kOk) return code;
  if (request.dimension > list.dimension) {
    return RefusePath(call, vm::kRefused, kPathState,
                      MakeMessage("the list has begun with {0} coordinates",
                                  "缓冲区起点只有 {0} 个坐标", list.dimension));
  }
  const SegmentResult result =
      MakeSegment(CrdOf(call.card).fifos[kListFifo].tail, request, kChordTolerance);
  if (!result.segment) return RefuseGeometry(call, result.fault);
  const uint32_t words = WordsOf(call.command);
  code = CheckRoom(call, words);
  if (code != vm::kOk) return code;
  motion::PathSlot slot;
  slot.is_segment = true;
  slot.segment = *result.segment;
  slot.velocity = list.feed;
  slot.acceleration = list.acceleration;
  slot.end_velocity = list.end_velocity.value_or(motion::kUnlimited);
  slot.ends_at_rest = IsG0(call.command);
  slot.second_override = slot.ends_at_rest;
  list.end_velocity.reset();
  // A line of G0 begins at rest, too.
  if (slot.ends_at_rest) DriverOf(call.card).RestAfterLast(kListFifo);
  AppendSegment(call.card, slot, words);
  return vm::kOk;
}

/// Executes a segment at once.
int16_t ExecuteNow(Call& call, const SegmentRequest& request) {
  const Path& path = PathOf(call);
  const int16_t code = CheckNoPath(call, kPathState);
  if (code != vm::kOk) return code;
  const Crd& crd = CrdOf(call.card);
  Coordinates start{};
  for (size_t i = 0; i < call.card.motion.axis_count(); ++i) {
    start[i] = call.card.motion.profile(i).now.position - crd.origin[i];
  }
  const SegmentResult result = MakeSegment(start, request, kChordTolerance);
  if (!result.segment) return RefuseGeometry(call, result.fault);
  if (path.velocity == 0 || path.acceleration == 0) {
    return RefusePath(call, kBadRate, kPathState,
                      {"there is no feed or acceleration, call GT_SetSynVel and GT_SetSynAcc first",
                       "未设置速度或加速度，请先调用 GT_SetSynVel 和 GT_SetSynAcc"});
  }
  motion::PathSlot slot;
  slot.is_segment = true;
  slot.segment = *result.segment;
  slot.velocity = path.velocity;
  slot.acceleration = path.acceleration;
  slot.ends_at_rest = true;
  slot.second_override = IsG0(call.command);
  motion::CrdDriver driver = DriverOf(call.card);
  driver.Clear(kImmediateFifo);
  driver.Append(kImmediateFifo, slot);
  StartPath(call.card, kImmediateFifo);
  return vm::kOk;
}

int16_t Travel(Call& call) {
  const SegmentRequest request = ReadSegment(call, 1);
  int16_t code = CheckDirection(call, request);
  if (code == vm::kOk) code = CheckAxisCount(call, request.dimension);
  if (code == vm::kOk) code = CheckAxesFree(call);
  if (code != vm::kOk) return code;
  return ListOf(call).open ? AppendToList(call, request) : ExecuteNow(call, request);
}

}  // namespace

int16_t GT_LnXY(Call& call) { return Travel(call); }
int16_t GT_LnXYZ(Call& call) { return Travel(call); }
int16_t GT_LnXYZA(Call& call) { return Travel(call); }
int16_t GT_LnXYG0(Call& call) { return Travel(call); }
int16_t GT_LnXYZG0(Call& call) { return Travel(call); }
int16_t GT_LnXYZAG0(Call& call) { return Travel(call); }
int16_t GT_ArcXY(Call& call) { return Travel(call); }
int16_t GT_ArcXYP(Call& call) { return Travel(call); }
int16_t GT_ArcYZ(Call& call) { return Travel(call); }
int16_t GT_ArcYZP(Call& call) { return Travel(call); }
int16_t GT_ArcZX(Call& call) { return Travel(call); }
int16_t GT_ArcZXP(Call& call) { return Travel(call); }

}  // namespace oncard::gtcalls::ges
