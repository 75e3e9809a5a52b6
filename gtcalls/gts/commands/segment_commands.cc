// Segments of a coordinate system: lines, arcs, helices. One function implements all these
// commands (segment_request.h).
// Source: the public header. Tested by tests/gtcalls/segment_command_test.cc.
#include <algorithm>
#include <optional>

#include "gtcalls/gts/commands/look_ahead_support.h"
#include "gtcalls/gts/commands/segment_request.h"
#include "gtcalls/gts/numbers.h"
#include "motion/paths/segment.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::Coordinates;
using motion::PathSlot;
using motion::Segment;

int16_t RefuseShape(Call& call, const SegmentRequest& request) {
  if (request.radius.has_value()) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("no circle of radius {0} passes through the start and the end: |radius| must "
                    "be at least half their distance, and they must differ",
                    "不存在半径为 {0} 且经过起点和终点的圆：|radius| "
                    "不得小于两点距离的一半，且两点不得重合",
                    *request.radius));
  }
  if (request.centre_count > 0) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("start and end must have the same distance from the centre, which is given "
                    "relative to the start; it may differ by 1 pulse and must not be 0",
                    "起点和终点到圆心的距离必须相等（圆心坐标相对于起点），允许相差 "
                    "1 个脉冲，且不得为 0"));
  }
  if (request.has_between) {
    return call.Refuse(vm::kBadParameter,
                       MakeMessage("start, intermediate point and end lie on a line; give three "
                                   "points of a circle",
                                   "起点、中间点和终点共线；应给出圆上的三点"));
  }
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("the segment has no length: it ends where the path already is",
                                 "插补段长度为零：终点与当前轨迹终点重合"));
}

int16_t AppendRequest(Call& call, const Coordinates& start, const SegmentRequest& request) {
  const motion::Crd& crd = CrdOf(call);
  if (request.dimension > crd.dimension()) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("coordinate system {0} has {1} axes; this segment needs {2}",
                                   "坐标系 {0} 有 {1} 个轴；该插补段需要 {2} 个轴", call.integer(0),
                                   crd.dimension(), request.dimension));
  }
  std::optional<Segment> segment = ShapeOf(start, request);
  if (!segment.has_value()) return RefuseShape(call, request);
  MeasureForPlanner(call, &*segment);
  PathSlot slot;
  slot.is_segment = true;
  slot.segment = *segment;
  slot.velocity = request.velocity;
  slot.acceleration = std::min(request.acceleration, crd.parameters.acceleration_max);
  slot.end_velocity = request.end_velocity;
  slot.velocity_limit = std::min(crd.parameters.velocity_max, crd.VelocityLimit(*segment));
  slot.ends_at_rest = request.ends_at_rest;
  slot.second_override = request.second_override;
  slot.user_number = FifoOf(call).user_number;
  slot.given_number = request.given_number;
  return AppendSlot(call, slot);
}

int16_t AppendSegment(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code != vm::kOk) return code;
  const Coordinates start = PathEnd(call);
  return AppendRequest(call, start, ReadSegment(call, start));
}

// --- TCrdData --------------------------------------------------------------------------------

// Cells of TCrdData.
constexpr size_t kPlaneCell = 1;
constexpr size_t kPositionCell = 2;
constexpr size_t kRadiusCell = 10;
constexpr size_t kDirectionCell = 11;
constexpr size_t kCentreCell = 12;
constexpr size_t kSegmentVelocityCell = 15;
constexpr size_t kSegmentAccelerationCell = 16;
constexpr size_t kEndsAtRestCell = 17;
constexpr size_t kEndVelocityCell = 33;

/// Assumption: TCrdData.motionType, as the public header's comments number it.
constexpr double kLineType = 0;
constexpr double kArcType = 1;

/// False, with the reason recorded, unless the members of TCrdData that a segment needs are in
/// range.
bool CheckData(Call& call, bool arc) {
  const std::span<double> cells = call.cells(1);
  bool good = cells[kSegmentVelocityCell] >= kAboveZero &&
              cells[kSegmentVelocityCell] < kRateBound &&
              cells[kSegmentAccelerationCell] >= kAboveZero &&
              cells[kSegmentAccelerationCell] < kRateBound && cells[kEndVelocityCell] >= 0 &&
              cells[kEndVelocityCell] < kRateBound;
  for (size_t i = 0; i < motion::kCrdDimensionMax; ++i) {
    good = good && cells[kPositionCell + i] >= -kPositionMax &&
           cells[kPositionCell + i] <= kPositionMax;
  }
  if (arc) {
    good = good && cells[kPlaneCell] >= 0 && cells[kPlaneCell] <= 2 && cells[kDirectionCell] >= 0 &&
           cells[kDirectionCell] <= 1;
  }
  if (!good) {
    call.reason = MakeMessage(
        "a member of TCrdData is out of range: positions +-1073741823, vel "
        "and acc [1e-09, 32767), velEnd [0, 32767), circlePlat [0, 2], circleDir "
        "[0, 1]",
        "TCrdData 的成员超出范围：位置 ±1073741823，vel 和 acc 为 [1e-09, "
        "32767)，velEnd 为 [0, 32767)，circlePlat 为 [0, 2]，circleDir 为 "
        "[0, 1]");
  }
  return good;
}

int16_t AppendData(Call& call, bool arc) {
  if (!CheckData(call, arc)) return vm::kBadParameter;
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code != vm::kOk) return code;
  const std::span<double> cells = call.cells(1);
  const Coordinates start = PathEnd(call);
  SegmentRequest request;
  request.end = start;
  for (size_t i = 0; i < CrdOf(call).dimension(); ++i) request.end[i] = cells[kPositionCell + i];
  request.dimension = 1;
  request.velocity = cells[kSegmentVelocityCell];
  request.acceleration = cells[kSegmentAccelerationCell];
  request.end_velocity = cells[kEndVelocityCell];
  request.ends_at_rest = cells[kEndsAtRestCell] != 0;
  if (arc) {
    request.plane = *ArcPlaneOf(static_cast<int>(cells[kPlaneCell]));
    request.dimension = std::max(request.plane.first, request.plane.second) + size_t{1};
    request.counter_clockwise = cells[kDirectionCell] != 0;
    if (cells[kRadiusCell] != 0) {
      request.radius = cells[kRadiusCell];
    } else {
      // The members of `center` are X, Y, Z.
      request.centre = {cells[kCentreCell + request.plane.first],
                        cells[kCentreCell + request.plane.second]};
      request.centre_count = 2;
    }
  }
  return AppendRequest(call, start, request);
}

int16_t FlushLookAhead(Call& call) {
  int16_t code = CheckCrd(call, NumberOf(call));
  if (code == vm::kOk) code = CheckNotMixed(call);
  if (code != vm::kOk) return code;
  if (CrdAt(call).Flush(FifoNumber(call))) {
    BufferOf(call).auxiliaries = 0;
    return code;
  }
  return call.Refuse(vm::kRefused,
                     MakeMessage("FIFO {0} is full while the look-ahead buffer still holds {1}: "
                                 "call GT_CrdData with NULL again until it gives 0",
                                 "FIFO {0} 已满，前瞻缓冲区中还有 {1} 段：请再次以 NULL 调用 "
                                 "GT_CrdData，直到返回 0",
                                 FifoNumber(call), FifoOf(call).Ahead().size()));
}

}  // namespace

int16_t GT_CrdData(Call& call) {
  if (!call.given(1)) return FlushLookAhead(call);
  const double type = call.cells(1)[0];
  if (type == kLineType || type == kArcType) return AppendData(call, type == kArcType);
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("motionType is {0}; 0 (line) and 1 (arc) are supported",
                                 "motionType 为 {0}；支持 0（直线）和 1（圆弧）", type));
}

int16_t GT_CrdDataCircle(Call& call) { return AppendData(call, true); }

#define SEGMENT(name) \
  int16_t name(Call& call) { return AppendSegment(call); }
SEGMENT(GT_LnXY)
SEGMENT(GT_LnXYOverride2)
SEGMENT(GT_LnXYWN)
SEGMENT(GT_LnXYOverride2WN)
SEGMENT(GT_LnXYG0)
SEGMENT(GT_LnXYG0Override2)
SEGMENT(GT_LnXYG0WN)
SEGMENT(GT_LnXYG0Override2WN)
SEGMENT(GT_LnXYZ)
SEGMENT(GT_LnXYZOverride2)
SEGMENT(GT_LnXYZWN)
SEGMENT(GT_LnXYZOverride2WN)
SEGMENT(GT_LnXYZG0)
SEGMENT(GT_LnXYZG0Override2)
SEGMENT(GT_LnXYZG0WN)
SEGMENT(GT_LnXYZG0Override2WN)
SEGMENT(GT_LnXYZA)
SEGMENT(GT_LnXYZAOverride2)
SEGMENT(GT_LnXYZAWN)
SEGMENT(GT_LnXYZAOverride2WN)
SEGMENT(GT_LnXYZAG0)
SEGMENT(GT_LnXYZAG0Override2)
SEGMENT(GT_LnXYZAG0WN)
SEGMENT(GT_LnXYZAG0Override2WN)
SEGMENT(GT_ArcXYC)
SEGMENT(GT_ArcXYCOverride2)
SEGMENT(GT_ArcXYCWN)
SEGMENT(GT_ArcXYCOverride2WN)
SEGMENT(GT_ArcXYR)
SEGMENT(GT_ArcXYROverride2)
SEGMENT(GT_ArcXYRWN)
SEGMENT(GT_ArcXYROverride2WN)
SEGMENT(GT_ArcXYZ)
SEGMENT(GT_ArcXYZWN)
SEGMENT(GT_ArcYZC)
SEGMENT(GT_ArcYZCOverride2)
SEGMENT(GT_ArcYZCWN)
SEGMENT(GT_ArcYZCOverride2WN)
SEGMENT(GT_ArcYZR)
SEGMENT(GT_ArcYZROverride2)
SEGMENT(GT_ArcYZRWN)
SEGMENT(GT_ArcYZROverride2WN)
SEGMENT(GT_ArcZXC)
SEGMENT(GT_ArcZXCOverride2)
SEGMENT(GT_ArcZXCWN)
SEGMENT(GT_ArcZXCOverride2WN)
SEGMENT(GT_ArcZXR)
SEGMENT(GT_ArcZXROverride2)
SEGMENT(GT_ArcZXRWN)
SEGMENT(GT_ArcZXROverride2WN)
SEGMENT(GT_HelixXYCZ)
SEGMENT(GT_HelixXYCZOverride2)
SEGMENT(GT_HelixXYCZWN)
SEGMENT(GT_HelixXYCZOverride2WN)
SEGMENT(GT_HelixXYRZ)
SEGMENT(GT_HelixXYRZOverride2)
SEGMENT(GT_HelixXYRZWN)
SEGMENT(GT_HelixXYRZOverride2WN)
SEGMENT(GT_HelixYZCX)
SEGMENT(GT_HelixYZCXOverride2)
SEGMENT(GT_HelixYZCXWN)
SEGMENT(GT_HelixYZCXOverride2WN)
SEGMENT(GT_HelixYZRX)
SEGMENT(GT_HelixYZRXOverride2)
SEGMENT(GT_HelixYZRXWN)
SEGMENT(GT_HelixYZRXOverride2WN)
SEGMENT(GT_HelixZXCY)
SEGMENT(GT_HelixZXCYOverride2)
SEGMENT(GT_HelixZXCYWN)
SEGMENT(GT_HelixZXCYOverride2WN)
SEGMENT(GT_HelixZXRY)
SEGMENT(GT_HelixZXRYOverride2)
SEGMENT(GT_HelixZXRYWN)
SEGMENT(GT_HelixZXRYOverride2WN)
#undef SEGMENT

}  // namespace oncard::gtcalls::gts
