#include "gtcalls/gts/commands/segment_request.h"

#include <algorithm>
#include <string_view>

#include "gtcalls/gts/commands/motion_support.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::ArcPlane;

bool Contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

ArcPlane PlaneOf(std::string_view command) {
  if (Contains(command, "ArcYZ") || Contains(command, "HelixYZ")) return motion::kYzPlane;
  if (Contains(command, "ArcZX") || Contains(command, "HelixZX")) return motion::kZxPlane;
  return motion::kXyPlane;
}

/// The coordinate of parameter x, y, z or a; 4 for other names.
size_t CoordinateOf(std::string_view name) {
  constexpr std::string_view kNames = "xyza";
  return name.size() == 1 ? std::min(kNames.find(name[0]), kNames.size()) : kNames.size();
}

}  // namespace

SegmentRequest ReadSegment(const Call& call, const motion::Coordinates& start) {
  SegmentRequest request;
  request.end = start;
  request.ends_at_rest = Contains(call.command.name, "G0");
  request.second_override = Contains(call.command.name, "Override2");
  request.plane = PlaneOf(call.command.name);
  for (size_t i = 1; i < call.arguments.size(); ++i) {
    const std::string_view name = call.command.parameters[i].name;
    const double value = call.value(i);
    if (const size_t coordinate = CoordinateOf(name); coordinate < motion::kCrdDimensionMax) {
      request.end[coordinate] = value;
      request.dimension = std::max(request.dimension, coordinate + 1);
    } else if (name == "synVel") {
      request.velocity = value;
    } else if (name == "synAcc") {
      request.acceleration = value;
    } else if (name == "velEnd") {
      request.end_velocity = value;
    } else if (name == "override2") {
      request.second_override = value != 0;
    } else if (name == "segNum") {
      request.given_number = call.integer(i);
    } else if (name == "radius") {
      request.radius = value;
    } else if (name == "circleDir") {
      request.counter_clockwise = value != 0;
    } else if (name.ends_with("Center")) {
      request.centre[request.centre_count++] = value;
    } else if (name.starts_with("inter")) {
      request.between[static_cast<size_t>(name.back() - 'X')] = value;
      request.has_between = true;
    }
  }
  return request;
}

std::optional<motion::Segment> ShapeOf(const motion::Coordinates& start,
                                       const SegmentRequest& request, double tolerance) {
  if (request.radius.has_value()) {
    return motion::MakeArcWithRadius(start, request.end, request.plane, *request.radius,
                                     request.counter_clockwise, tolerance);
  }
  if (request.centre_count > 0) {
    return motion::MakeArcAroundCentre(start, request.end, request.plane, request.centre[0],
                                       request.centre[1], request.counter_clockwise, tolerance);
  }
  if (request.has_between) return motion::MakeArcThroughPoint(start, request.end, request.between);
  return motion::MakeLine(start, request.end);
}

}  // namespace oncard::gtcalls::gts
