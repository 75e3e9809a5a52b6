// Paths: the map of the axes, lines and arcs with their velocity and acceleration, status and
// positions. With the list open a segment is appended to it, otherwise it is executed at once.
// Source: GT manual 5.1 to 5.4. Tested by tests/gtcalls/gt400/path_command_test.cc.
#include <algorithm>
#include <cmath>
#include <span>

#include "gtcalls/gt400/commands/path_support.h"
#include "gtcalls/gt400/events.h"
#include "gtcalls/shared/segment_request.h"

namespace oncard::gtcalls::gt400 {

using motion::Coordinates;

// --- The map ---------------------------------------------------------------------------------

namespace {

/// Assumption: positions of axes are numbers of pulses also where the map changes under a list.
constexpr double kMapFigureMax = kFarthest;

}  // namespace

int16_t GT_MapAxis(Call& call) {
  const std::span<const double> figures = call.cells(1);
  // Written so that the check fails for a NaN.
  const auto usable = [](double figure) { return std::fabs(figure) <= kMapFigureMax; };
  if (!std::ranges::all_of(figures, usable)) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("each figure of the map must be within {0}",
                                   "映射系数的绝对值不得超过 {0}", kMapFigureMax));
  }
  motion::MapRow row;
  std::copy_n(figures.begin(), row.coefficients.size(), row.coefficients.begin());
  row.offset = figures[row.coefficients.size()];
  if (row.coefficients == Coordinates{}) {
    return RefuseFigure(call, kNoMapping,
                        {"the axis would not move with any coordinate", "映射系数全为 0"});
  }
  const auto axis = static_cast<size_t>(call.integer(0) - 1);
  if (Moves(call.card.view(), axis)) {
    return RefuseFor(call, kPathState,
                     MakeMessage("axis {0} is moving, wait until bit 10 of GT_GetSts is 0",
                                 "轴 {0} 正在运动，请等待 GT_GetSts 的第 10 位变为 0", axis + 1));
  }
  // Assumption: the path of other axes would jump.
  const int16_t code = CheckNoPath(call);
  if (code == vm::kOk) DriverOf(call.card).MapAxis(axis, row);
  return code;
}

int16_t GT_SetAccLmt(Call& call) {
  const double limit = call.value(0);
  if (limit <= 0 || limit > kRateMax) {
    return RefuseFor(call, kIllegal,
                     MakeMessage("limit is {0}; the range is (0, {1}]",
                                 "limit 为 {0}；取值范围为 (0, {1}]", limit, kRateMax));
  }
  DriverOf(call.card).SetJump(CurrentAxis(call), limit);
  return vm::kOk;
}

int16_t GT_GetAccLmt(Call& call) {
  call.Set(0, std::trunc(JumpLimitOf(call.card.view(), CurrentAxis(call))));
  return vm::kOk;
}

// --- State -----------------------------------------------------------------------------------

int16_t GT_GetCrdSts(Call& call) {
  call.Set(0, PathStatusWord(call.card.view()));
  return vm::kOk;
}

int16_t GT_GetCrdVel(Call& call) {
  call.Set(0, CrdOf(call.card.view()).run.velocity);
  return vm::kOk;
}

namespace {

int16_t SetPoint(const Call& call, const Coordinates& point) {
  for (size_t i = 0; i < point.size(); ++i) call.Set(0, point[i], i);
  return vm::kOk;
}

}  // namespace

int16_t GT_GetPrfPnt(Call& call) { return SetPoint(call, call.card.motion.CrdPosition(0)); }
int16_t GT_GetBrkPnt(Call& call) { return SetPoint(call, PathOf(call).break_point); }

int16_t GT_GetMtnNm(Call& call) {
  call.Set(0, CrdOf(call.card.view()).fifos[kListFifo].GivenNumber());
  return vm::kOk;
}

int16_t GT_CrdAuStpOn(Call& call) {
  DriverOf(call.card).SetStopsTogether(true);
  return vm::kOk;
}

int16_t GT_CrdAuStpOff(Call& call) {
  DriverOf(call.card).SetStopsTogether(false);
  return vm::kOk;
}

// --- Velocity and acceleration ---------------------------------------------------------------

namespace {

/// Sets a register; with the list open, for the segments that are appended next.
int16_t SetRegister(Call& call, double Path::*value) {
  int16_t code = CheckRate(call, 0);
  const bool listed = ListOf(call).open;
  if (code == vm::kOk && listed) code = CheckListBegun(call);
  if (code == vm::kOk && listed) code = CheckRoom(call);
  if (code != vm::kOk) return code;
  if (listed) ListOf(call).words.AddCommand(WordsOf(call.command));
  PathOf(call).*value = call.value(0);
  return vm::kOk;
}

}  // namespace

int16_t GT_SetSynVel(Call& call) { return SetRegister(call, &Path::velocity); }
int16_t GT_SetSynAcc(Call& call) { return SetRegister(call, &Path::acceleration); }

// --- Lines and arcs --------------------------------------------------------------------------

namespace {

/// Assumption: by which part of the radius half a chord may exceed it.
constexpr double kChordTolerance = 0x1p-20;

int16_t RefuseGeometry(Call& call, SegmentFault fault) {
  switch (fault) {
    case SegmentFault::kNoLength:
      return RefuseFigure(call, kNoLength, {"the line has no length", "直线长度为 0"});
    case SegmentFault::kNoAngle:
      return call.Refuse(vm::kBadParameter, {"the angle of the arc is 0", "圆弧的角度为 0"});
    case SegmentFault::kNoChord:
      return RefuseFigure(call, kBadEnd,
                          {"the radius or the chord of the arc is 0", "圆弧的半径或弦长为 0"});
    case SegmentFault::kChordTooLong:
      return RefuseFigure(
          call, kBadEnd,
          {"the chord of the arc is longer than its diameter", "圆弧的弦长大于直径"});
    default:
      return RefuseFigure(call, kNoRadius, {"the radius of the arc is 0", "圆弧的半径为 0"});
  }
}

/// 0, or 2 if a radius is beyond the largest position, for an axis or in length units.
int16_t CheckRadius(Call& call, const motion::Segment& arc) {
  const motion::Crd& crd = CrdOf(call.card.view());
  double radius = arc.radius;
  for (size_t axis = 0; crd.map && axis < kAxisMax; ++axis) {
    const Coordinates& row = crd.map->rows[axis].coefficients;
    for (size_t i = 0; i < row.size(); ++i) {
      const bool turns = arc.toward_start[i] != 0 || arc.sideways[i] != 0;
      if (turns) radius = std::max(radius, std::fabs(row[i]) * arc.radius);
    }
  }
  if (radius <= kFarthest) return vm::kOk;
  return RefuseFigure(call, kNoRadius,
                      MakeMessage("the radius of the arc is {0}; it is at most {1}",
                                  "圆弧的半径为 {0}；不得超过 {1}", radius, kFarthest));
}

motion::PathSlot SlotOf(const Path& path, const motion::Segment& segment) {
  motion::PathSlot slot;
  slot.is_segment = true;
  slot.segment = segment;
  slot.velocity = path.velocity;
  slot.acceleration = path.acceleration;
  return slot;
}

int16_t AppendToList(Call& call, const motion::Segment& segment, size_t dimension) {
  int16_t code = CheckListBegun(call);
  if (code == vm::kOk) code = CheckRoom(call);
  if (code != vm::kOk) return code;
  PathList& list = ListOf(call);
  motion::PathSlot slot = SlotOf(PathOf(call), segment);
  slot.given_number = ++list.last_number;
  list.dimension = std::max(list.dimension, dimension);
  list.words.AddSegment(WordsOf(call.command));
  DriverOf(call.card).Append(kListFifo, slot);
  return vm::kOk;
}

int16_t ExecuteNow(Call& call, const motion::Segment& segment) {
  const int16_t code = CheckNoPath(call);
  if (code != vm::kOk) return code;
  const Path& path = PathOf(call);
  if (path.velocity == 0 || path.acceleration == 0) {
    return RefuseFigure(
        call, kBadRate,
        {"there is no velocity or acceleration, call GT_SetSynVel and GT_SetSynAcc first",
         "未设置速度或加速度，请先调用 GT_SetSynVel 和 GT_SetSynAcc"});
  }
  StartSegment(call.card, SlotOf(path, segment));
  return vm::kOk;
}

int16_t Travel(Call& call) {
  const SegmentRequest request = ReadSegment(call, 1);
  int16_t code = CheckDirection(call, request);
  if (code == vm::kOk) code = CheckFinite(call);
  if (code != vm::kOk) return code;
  const bool listed = ListOf(call).open;
  const Coordinates start =
      listed ? CrdOf(call.card.view()).fifos[kListFifo].tail : call.card.motion.CrdPosition(0);
  const double tolerance = kChordTolerance * std::fabs(request.radius.value_or(0));
  const SegmentResult result = MakeSegment(start, request, tolerance);
  if (!result.segment) return RefuseGeometry(call, result.fault);
  code = CheckRadius(call, *result.segment);
  if (code == vm::kOk) code = CheckPoint(call, result.segment->end);
  if (code != vm::kOk) return code;
  return listed ? AppendToList(call, *result.segment, request.dimension)
                : ExecuteNow(call, *result.segment);
}

}  // namespace

int16_t GT_LnXY(Call& call) { return Travel(call); }
int16_t GT_LnXYZ(Call& call) { return Travel(call); }
int16_t GT_LnXYZA(Call& call) { return Travel(call); }
int16_t GT_ArcXY(Call& call) { return Travel(call); }
int16_t GT_ArcXYP(Call& call) { return Travel(call); }
int16_t GT_ArcYZ(Call& call) { return Travel(call); }
int16_t GT_ArcYZP(Call& call) { return Travel(call); }
int16_t GT_ArcZX(Call& call) { return Travel(call); }
int16_t GT_ArcZXP(Call& call) { return Travel(call); }

}  // namespace oncard::gtcalls::gt400
