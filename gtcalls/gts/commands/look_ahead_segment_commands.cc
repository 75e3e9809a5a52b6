// Segments and buffered commands of the multi-axis look-ahead, in mm and mm/s.
// Source: manual of the multi-axis look-ahead module, chapters 1 and 2. Tested by
// tests/gtcalls/look_ahead_segment_test.cc.
#include <algorithm>
#include <cmath>
#include <optional>

#include "gtcalls/gts/commands/look_ahead_support.h"
#include "gtcalls/gts/commands/segment_request.h"
#include "gtcalls/gts/numbers.h"
#include "motion/common/rounding.h"
#include "motion/common/trigonometry.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::BufferedKind;
using motion::Coordinates;
using motion::PathSlot;
using motion::Segment;

/// By how much an arc's radii may differ, mm (manual, GT_ArcXYCEx), with room for rounding. A
/// difference that is allowed is spread over the arc.
constexpr double kArcError = 0.01 + 1e-9;
/// Assumption: coordinates that differ by less are the same, pulses. The position of an axis is
/// rounded when the coordinate system has an origin.
constexpr double kSamePlace = 1e-6;
/// GT_HelixXYCZEx: synVel and synAcc are below this, mm/s and mm/s^2 (manual).
constexpr double kHelixBound = 32767;
/// Assumption: how close to a half circle an arc in space may come, radians.
constexpr double kHalfCircleError = 1e-6;

/// Where a segment appended now begins.
Coordinates StartOf(const Call& call) {
  const motion::CrdFifo& fifo = FifoOf(call);
  if (fifo.is_virtual()) return fifo.Tail();
  if (!BufferOf(call).has_start) return PathEnd(call);
  // What runs before the segment does not bring the axes to the start point.
  const bool runs = CrdOf(call).run.running && &CrdOf(call).active() == &fifo;
  return runs && fifo.Remaining() == 0 ? call.card.motion.CrdPosition(NumberOf(call)) : fifo.tail;
}

// --- Segments ----------------------------------------------------------------------------------

bool IsArc(const SegmentRequest& request) {
  return request.radius.has_value() || request.centre_count > 0 || request.has_between;
}

/// The request of a command in pulses and ms.
SegmentRequest ReadScaled(const Call& call, const Coordinates& start) {
  const double scale = BufferOf(call).scale;
  SegmentRequest request = ReadSegment(call, {});
  for (double& value : request.end) value *= scale;
  // Coordinates that the command does not have stay where they are.
  for (size_t i = 0; i < request.end.size(); ++i) {
    bool given = false;
    for (const Parameter& parameter : call.command.parameters) {
      given = given || (parameter.name.size() == 1 && parameter.name[0] == "xyza"[i]);
    }
    if (!given || std::fabs(request.end[i] - start[i]) < kSamePlace) request.end[i] = start[i];
  }
  if (request.radius.has_value()) *request.radius *= scale;
  for (double& value : request.centre) value *= scale;
  for (double& value : request.between) value *= scale;
  request.velocity *= scale / 1000;
  request.acceleration *= scale / 1e6;
  return request;
}

int16_t CheckArguments(Call& call, const SegmentRequest& request) {
  for (const double value : request.end) {
    const int16_t code =
        CheckSize(call, "coordinate in pulses", value, -kPositionMax, kPositionMax + 1);
    if (code != vm::kOk) return code;
  }
  int16_t code = CheckSize(call, "synVel in pulse/ms", request.velocity, kAboveZero, kRateBound);
  if (code == vm::kOk) {
    code = CheckSize(call, "synAcc in pulse/ms^2", request.acceleration, kAboveZero, kRateBound);
  }
  const bool helix = call.command.name == "GT_HelixXYCZEx";
  for (size_t i = 1; i < call.arguments.size() && code == vm::kOk; ++i) {
    const std::string_view name = call.command.parameters[i].name;
    if (helix && (name == "synVel" || name == "synAcc")) {
      code = CheckSize(call, name, call.value(i), 0, kHelixBound);
    }
    if (name == "circleDir" || name == "override2") {
      code = CheckWhole(call, name, call.value(i), 0, 1);
    }
  }
  return code;
}

int16_t CheckDimension(Call& call, const SegmentRequest& request) {
  size_t needed = request.dimension;
  if (IsArc(request) && request.centre_count + (request.radius ? 1 : 0) > 0) {
    needed = std::max({needed, request.plane.first + size_t{1}, request.plane.second + size_t{1}});
  }
  if (needed <= CrdOf(call).dimension()) return vm::kOk;
  return call.Refuse(kPlatformRefuses,
                     MakeMessage("coordinate system {0} has {1} axes; this segment needs {2}",
                                 "坐标系 {0} 有 {1} 个轴；该插补段需要 {2} 个轴", call.integer(0),
                                 CrdOf(call).dimension(), needed));
}

int16_t RefuseArc(Call& call, const SegmentRequest& request) {
  if (request.has_between) {
    return call.Refuse(
        kLookAheadParameter,
        MakeMessage("an arc through three points may be no half and no full circle, and the points "
                    "may not lie on a line",
                    "空间圆弧不能是半圆或整圆，且起点、中间点和终点不能共线"));
  }
  if (request.radius.has_value()) {
    return call.Refuse(
        kLookAheadParameter,
        MakeMessage("no arc of radius {0} mm reaches the end: start and end must differ, by at "
                    "most the diameter and 0.01 mm",
                    "半径为 {0} mm 的圆弧不能到达终点：起点与终点不能重合，距离不得超过直径 "
                    "0.01 mm 以上",
                    *request.radius / BufferOf(call).scale));
  }
  return call.Refuse(
      kLookAheadParameter,
      MakeMessage("the distances of start and end from the centre, which is given relative to the "
                  "start, may differ by 0.01 mm and must not be 0",
                  "起点和终点到圆心的距离（圆心相对于起点给出）相差不得超过 0.01 mm，且不得为 0"));
}

/// The segment of a request; empty, with the reason and `code` recorded, if there is none.
std::optional<Segment> ShapeOrRefuse(Call& call, const Coordinates& start,
                                     const SegmentRequest& request, int16_t* code) {
  // Half of a chord is compared with a radius.
  const double error = kArcError * BufferOf(call).scale / (request.radius.has_value() ? 2 : 1);
  std::optional<Segment> segment = ShapeOf(start, request, error);
  const bool half = segment.has_value() && request.has_between &&
                    std::fabs(segment->sweep - motion::kPi) < kHalfCircleError;
  if (segment.has_value() && !half) {
    MeasureForPlanner(call, &*segment);
    return segment;
  }
  *code = RefuseArc(call, request);
  return std::nullopt;
}

/// 0, or 102 when a line has the first three coordinates of the command before.
int16_t CheckMoves(Call& call, const Coordinates& start, const SegmentRequest& request) {
  if (IsArc(request)) return vm::kOk;
  for (size_t i = 0; i < std::min(size_t{3}, CrdOf(call).dimension()); ++i) {
    if (request.end[i] != start[i]) return vm::kOk;
  }
  return call.Refuse(kSamePoint,
                     MakeMessage("the first three coordinates are those of the command before: "
                                 "leave the segment out",
                                 "前三个轴的位置与前一条指令完全相同：请去掉该段"));
}

PathSlot SlotOf(const Call& call, const Segment& segment, const SegmentRequest& request) {
  const motion::Crd& crd = CrdOf(call);
  const LookAheadBuffer& buffer = BufferOf(call);
  PathSlot slot;
  slot.is_segment = true;
  slot.segment = segment;
  slot.velocity = request.velocity;
  slot.acceleration = std::min(request.acceleration, crd.parameters.acceleration_max);
  slot.velocity_limit = std::min(crd.parameters.velocity_max, crd.VelocityLimit(segment));
  slot.ends_at_rest = request.ends_at_rest;
  slot.second_override = request.second_override;
  slot.user_number = buffer.numbered ? buffer.number : request.given_number;
  slot.given_number = request.given_number;
  return slot;
}

int16_t AppendSegmentInMm(Call& call) {
  int16_t code = CheckEstablished(call);
  if (code != vm::kOk) return code;
  const bool arc = IsArc(ReadSegment(call, {}));
  if (arc && SetupOf(call).five_axes()) {
    return call.Refuse(kLookAheadParameter, MakeMessage("there are no arcs in five-axis modes",
                                                        "五轴模式下不允许圆弧插补"));
  }
  code = CheckInitialised(call);
  if (code != vm::kOk) return code;
  const Coordinates start = StartOf(call);
  const SegmentRequest request = ReadScaled(call, start);
  code = CheckArguments(call, request);
  if (code == vm::kOk) code = CheckDimension(call, request);
  if (code != vm::kOk) return code;
  LookAheadBuffer& buffer = BufferOf(call);
  if (buffer.awaits_start) {
    // A path that has not been executed yet goes on at its end, whichever point is given.
    const motion::CrdFifo& fifo = FifoOf(call);
    if (fifo.idle() || fifo.is_virtual()) CrdAt(call).SetTail(FifoNumber(call), request.end);
    buffer.awaits_start = false;
    buffer.has_start = true;
    return vm::kOk;
  }
  code = CheckMoves(call, start, request);
  if (code != vm::kOk) return code;
  const std::optional<Segment> segment = ShapeOrRefuse(call, start, request, &code);
  if (!segment.has_value()) return code;
  code = AppendToFifo(call, SlotOf(call, *segment, request), start);
  if (code != vm::kOk) return code;
  buffer.has_start = false;
  buffer.auxiliaries = 0;
  return vm::kOk;
}

// --- Buffered commands -------------------------------------------------------------------------

/// Appends an auxiliary command. The first one after GT_CrdDataEx only makes a start point.
int16_t AppendAuxiliary(Call& call, BufferedKind kind, int item, int detail,
                        const std::array<double, 4>& values) {
  LookAheadBuffer& buffer = BufferOf(call);
  if (buffer.awaits_start) {
    buffer.awaits_start = false;
    return vm::kOk;
  }
  int16_t code = CheckAuxiliaries(call);
  if (code != vm::kOk) return code;
  PathSlot slot;
  slot.command = {kind, item, detail, values};
  code = AppendToFifo(call, slot, StartOf(call));
  if (code == vm::kOk) ++buffer.auxiliaries;
  return code;
}

/// 0, or 107 with the reason unless argument 1 is a profile of the card outside the coordinate
/// system.
int16_t CheckProfile(Call& call, std::string_view name) {
  const int16_t code =
      CheckWhole(call, name, call.value(1), 1, static_cast<double>(call.card.motion.axis_count()));
  if (code != vm::kOk || !CrdOf(call).HasMember(NumberOf(call, 1))) return code;
  return call.Refuse(
      kLookAheadParameter,
      MakeMessage("profile {0} belongs to coordinate system {1}; another axis is "
                  "needed",
                  "规划器 {0} 属于坐标系 {1}；应使用其他轴", call.integer(1), call.integer(0)));
}

}  // namespace

#define SEGMENT(name) \
  int16_t name(Call& call) { return AppendSegmentInMm(call); }
SEGMENT(GT_LnXYEx)
SEGMENT(GT_LnXYG0Ex)
SEGMENT(GT_LnXYZEx)
SEGMENT(GT_LnXYZG0Ex)
SEGMENT(GT_LnXYZAEx)
SEGMENT(GT_LnXYZAG0Ex)
SEGMENT(GT_ArcXYCEx)
SEGMENT(GT_ArcXYREx)
SEGMENT(GT_ArcYZCEx)
SEGMENT(GT_ArcYZREx)
SEGMENT(GT_ArcZXCEx)
SEGMENT(GT_ArcZXREx)
SEGMENT(GT_ArcXYZEx)
SEGMENT(GT_HelixXYCZEx)
SEGMENT(GT_HelixXYRZEx)
#undef SEGMENT

int16_t GT_BufDelayEx(Call& call) {
  const int16_t code = CheckInitialised(call);
  return code != vm::kOk ? code
                         : AppendAuxiliary(call, BufferedKind::kDelay, 0, 0, {call.value(1)});
}

int16_t GT_BufIOEx(Call& call) {
  int16_t code = CheckInitialised(call);
  if (code == vm::kOk) {
    code = CheckWhole(call, "doType", call.value(1), kOutputWordFirst, kOutputWordLast);
  }
  if (code != vm::kOk) return code;
  return AppendAuxiliary(call, BufferedKind::kOutputs, static_cast<int>(*DoTypeOf(call.integer(1))),
                         0, {call.value(2), call.value(3)});
}

int16_t GT_BufDAEx(Call& call) {
  int16_t code = CheckInitialised(call);
  if (code == vm::kOk) {
    const size_t axes = call.card.motion.axis_count();
    code = CheckWhole(call, "chn", call.value(1), 1,
                      static_cast<double>(std::min(axes, kLookAheadAxes)));
  }
  if (code != vm::kOk) return code;
  // -32768 is -10 V as well.
  return AppendAuxiliary(call, BufferedKind::kAnalogOutput, call.integer(1) - 1, 0,
                         {std::max(call.value(2), -motion::kDacFull)});
}

int16_t GT_BufGearEx(Call& call) {
  int16_t code = CheckInitialised(call);
  if (code == vm::kOk) code = CheckProfile(call, "gearAxis");
  const double displacement = code == vm::kOk ? call.value(2) * BufferOf(call).scale : 0;
  if (code == vm::kOk) {
    code = CheckSize(call, "deltaPos in pulses", displacement, -kPositionMax, kPositionMax + 1);
  }
  if (code != vm::kOk) return code;
  return AppendAuxiliary(call, BufferedKind::kGear, call.integer(1) - 1, 0, {displacement});
}

int16_t GT_BufMoveEx(Call& call) {
  int16_t code = CheckInitialised(call);
  if (code == vm::kOk) code = CheckProfile(call, "moveAxis");
  if (code == vm::kOk) code = CheckWhole(call, "modal", call.value(5), 0, 1);
  if (code != vm::kOk) return code;
  const double scale = BufferOf(call).scale;
  const double position = motion::Whole(call.value(2) * scale);
  const double velocity = call.value(3) * scale / 1000;
  const double acceleration = call.value(4) * scale / 1e6;
  code = CheckSize(call, "pos in pulses", position, -kPositionMax, kPositionMax + 1);
  if (code == vm::kOk) {
    code = CheckSize(call, "vel in pulse/ms", velocity, kAboveZero, kRateBound);
  }
  if (code == vm::kOk) {
    code = CheckSize(call, "acc in pulse/ms^2", acceleration, kAboveZero, kRateBound);
  }
  if (code != vm::kOk) return code;
  if (CheckMode(call, NumberOf(call, 1), motion::ProfileMode::kTrap) != vm::kOk) {
    return kPlatformRefuses;
  }
  return AppendAuxiliary(call, BufferedKind::kMove, call.integer(1) - 1, call.integer(5),
                         {position, velocity, acceleration});
}

int16_t GT_SetUserSegNumEx(Call& call) {
  const int16_t code = CheckInitialised(call);
  if (code != vm::kOk) return code;
  LookAheadBuffer& buffer = BufferOf(call);
  if (buffer.awaits_start) {
    buffer.awaits_start = false;
    return vm::kOk;
  }
  buffer.numbered = true;
  buffer.number = call.integer(1);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
