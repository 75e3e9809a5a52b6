#include "gtcalls/ge/commands/segment_support.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "gtcalls/ge/commands/path_support.h"
#include "motion/common/trigonometry.h"

namespace oncard::gtcalls::ges {
namespace {

/// Half of what a chord may exceed the diameter by: one pulse.
constexpr double kChordTolerance = 0.5;
constexpr double kFullCircle = 360;

motion::ArcPlane PlaneOf(std::string_view command) {
  if (command.starts_with("GT_ArcYZ")) return motion::kYzPlane;
  if (command.starts_with("GT_ArcZX")) return motion::kZxPlane;
  return motion::kXyPlane;
}

/// The coordinate that a parameter's name begins with.
size_t CoordinateOf(std::string_view name) {
  constexpr std::string_view kNames = "xyza";
  return kNames.find(name.front());
}

}  // namespace

SegmentRequest ReadSegment(const Call& call, double scale) {
  SegmentRequest request;
  request.plane = PlaneOf(call.command.name);
  request.rests = call.command.name.find("G0") != std::string_view::npos;
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
  return request;
}

SegmentResult MakeSegment(const motion::Coordinates& start, const SegmentRequest& request) {
  motion::Coordinates end = start;
  for (size_t i = 0; i < end.size(); ++i) {
    if ((request.given >> i & 1) != 0) end[i] = request.end[i];
  }
  const motion::ArcPlane plane = request.plane;
  const bool counter_clockwise = request.centre ? request.angle > 0 : request.direction > 0;
  if (request.centre) {
    if (request.angle == 0) return {std::nullopt, kNoRadius};
    const double sweep = std::fabs(request.angle) / kFullCircle * 2 * motion::kPi;
    const auto arc = motion::MakeArcWithSweep(
        start, plane, (*request.centre)[0] - start[plane.first],
        (*request.centre)[1] - start[plane.second], sweep, counter_clockwise);
    return {arc, arc ? vm::kOk : kNoRadius};
  }
  if (request.radius) {
    const double radius = *request.radius;
    const bool chord =
        end[plane.first] != start[plane.first] || end[plane.second] != start[plane.second];
    if (radius == 0 || !chord) return {std::nullopt, kNoRadius};
    const auto arc =
        motion::MakeArcWithRadius(start, end, plane, radius, counter_clockwise, kChordTolerance);
    return {arc, arc ? vm::kOk : kChordTooLong};
  }
  const auto line = motion::MakeLine(start, end);
  return {line, line ? vm::kOk : kNoLength};
}

}  // namespace oncard::gtcalls::ges
