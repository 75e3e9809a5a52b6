#include "gtcalls/shared/segment_request.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "motion/common/trigonometry.h"

namespace oncard::gtcalls {
namespace {

constexpr double kFullCircle = 360;

/// The coordinate that a parameter's name begins with.
size_t CoordinateOf(std::string_view name) {
  constexpr std::string_view kNames = "xyza";
  return kNames.find(name.front());
}

/// The plane in which an arc turns from one coordinate to the other.
motion::ArcPlane PlaneOf(const Command& command) {
  const size_t first = CoordinateOf(command.parameters[0].name);
  if (first == motion::kYzPlane.first) return motion::kYzPlane;
  if (first == motion::kZxPlane.first) return motion::kZxPlane;
  return motion::kXyPlane;
}

SegmentResult Found(std::optional<motion::Segment> segment, SegmentFault otherwise) {
  if (segment) return {segment, SegmentFault::kNone};
  return {std::nullopt, otherwise};
}

}  // namespace

motion::Coordinates SegmentRequest::EndFrom(const motion::Coordinates& start) const {
  motion::Coordinates point = start;
  for (size_t i = 0; i < point.size(); ++i) {
    if ((given >> i & 1) != 0) point[i] = end[i];
  }
  return point;
}

SegmentRequest ReadSegment(const Call& call, double scale) {
  SegmentRequest request;
  size_t centres = 0;
  for (size_t i = 0; i < call.arguments.size(); ++i) {
    const std::string_view name = call.command.parameters[i].name;
    const double length = call.value(i) * scale;
    if (name == "angle") {
      request.angle = call.value(i);
    } else if (name == "r") {
      request.radius = length;
    } else if (name == "direction") {
      request.direction = call.integer(i);
    } else if (name.ends_with("_center")) {
      if (centres == 0) request.centre.emplace();
      (*request.centre)[centres++] = length;
      request.dimension = std::max(request.dimension, CoordinateOf(name) + 1);
    } else if ((name.size() == 1 || name.ends_with("_end")) &&
               CoordinateOf(name) < motion::kCrdDimensionMax) {
      request.end[CoordinateOf(name)] = length;
      request.given |= 1u << CoordinateOf(name);
      request.dimension = std::max(request.dimension, CoordinateOf(name) + 1);
    }
  }
  if (request.is_arc()) request.plane = PlaneOf(call.command);
  return request;
}

int16_t CheckDirection(Call& call, const SegmentRequest& request) {
  if (request.direction == 1 || request.direction == -1) return vm::kOk;
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("direction is {0}; it must be 1 or -1",
                                 "direction 为 {0}；应为 1 或 -1", request.direction));
}

SegmentResult MakeSegment(const motion::Coordinates& start, const SegmentRequest& request,
                          double tolerance) {
  const motion::Coordinates end = request.EndFrom(start);
  const motion::ArcPlane plane = request.plane;
  const bool counter_clockwise = request.centre ? request.angle > 0 : request.direction > 0;
  if (request.centre) {
    if (request.angle == 0) return {std::nullopt, SegmentFault::kNoAngle};
    const double sweep = std::fabs(request.angle) / kFullCircle * 2 * motion::kPi;
    return Found(motion::MakeArcWithSweep(start, plane, (*request.centre)[0] - start[plane.first],
                                          (*request.centre)[1] - start[plane.second], sweep,
                                          counter_clockwise),
                 SegmentFault::kNoRadius);
  }
  if (request.radius) {
    const double radius = *request.radius;
    const bool chord =
        end[plane.first] != start[plane.first] || end[plane.second] != start[plane.second];
    if (radius == 0 || !chord) return {std::nullopt, SegmentFault::kNoChord};
    return Found(motion::MakeArcWithRadius(start, end, plane, radius, counter_clockwise, tolerance),
                 SegmentFault::kChordTooLong);
  }
  return Found(motion::MakeLine(start, end), SegmentFault::kNoLength);
}

}  // namespace oncard::gtcalls
