#include "motion/paths/segment.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "motion/common/state_hash.h"
#include "motion/common/trigonometry.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<Segment>);

using Vector = Eigen::Vector4d;
using Eigen::Vector3d;

Eigen::Map<const Vector> AsVector(const Coordinates& values) {
  return Eigen::Map<const Vector>(values.data());
}

Coordinates AsCoordinates(const Vector& vector) {
  return {vector[0], vector[1], vector[2], vector[3]};
}

/// Completes an arc for which centre, unit vectors, radii, sweep and linear travel are set.
std::optional<Segment> Complete(Segment arc) {
  arc.shape = SegmentShape::kArc;
  const double mean = arc.radius + arc.radius_change / 2;
  const double along = AsVector(arc.travel).norm();
  arc.length = std::sqrt(mean * mean * arc.sweep * arc.sweep + along * along);
  return arc;
}

/// An arc in a plane around a centre with the sweep given.
std::optional<Segment> PlaneArc(const Coordinates& start, const Coordinates& end, ArcPlane plane,
                                double centre_first, double centre_second, double sweep,
                                bool counter_clockwise) {
  Segment arc;
  arc.start = start;
  arc.end = end;
  const double x = start[plane.first] - centre_first;
  const double y = start[plane.second] - centre_second;
  const double end_x = end[plane.first] - centre_first;
  const double end_y = end[plane.second] - centre_second;
  arc.radius = std::sqrt(x * x + y * y);
  arc.radius_change = std::sqrt(end_x * end_x + end_y * end_y) - arc.radius;
  arc.centre = start;
  arc.centre[plane.first] = centre_first;
  arc.centre[plane.second] = centre_second;
  const double turn = counter_clockwise ? 1 : -1;
  arc.toward_start[plane.first] = x / arc.radius;
  arc.toward_start[plane.second] = y / arc.radius;
  arc.sideways[plane.first] = -turn * (y / arc.radius);
  arc.sideways[plane.second] = turn * (x / arc.radius);
  arc.travel[plane.normal] = end[plane.normal] - start[plane.normal];
  arc.sweep = sweep;
  return Complete(arc);
}

}  // namespace

Coordinates Segment::PointAt(double path) const {
  if (path >= length) return end;
  const double part = path / length;
  if (shape == SegmentShape::kLine) {
    return AsCoordinates(AsVector(start) + part * AsVector(travel));
  }
  const auto [sine, cosine] = SineAndCosine(sweep * part);
  const double r = radius + radius_change * part;
  return AsCoordinates(AsVector(centre) + (r * cosine) * AsVector(toward_start) +
                       (r * sine) * AsVector(sideways) + part * AsVector(travel));
}

Coordinates Segment::TangentAt(double path) const {
  if (shape == SegmentShape::kLine) return AsCoordinates(AsVector(travel) / length);
  const double part = path / length;
  const auto [sine, cosine] = SineAndCosine(sweep * part);
  const double turning = (radius + radius_change * part) * sweep / length;
  const double growing = radius_change / length;
  return AsCoordinates((growing * cosine - turning * sine) * AsVector(toward_start) +
                       (growing * sine + turning * cosine) * AsVector(sideways) +
                       AsVector(travel) / length);
}

Coordinates Segment::CurvatureAt(double path) const {
  if (shape == SegmentShape::kLine) return {};
  const double part = path / length;
  const auto [sine, cosine] = SineAndCosine(sweep * part);
  const double rate = sweep / length;
  const double inward = -(radius + radius_change * part) * rate * rate;
  const double aside = 2 * (radius_change / length) * rate;
  return AsCoordinates((inward * cosine - aside * sine) * AsVector(toward_start) +
                       (inward * sine + aside * cosine) * AsVector(sideways));
}

std::optional<Segment> MakeLine(const Coordinates& start, const Coordinates& end) {
  Segment line;
  line.start = start;
  line.end = end;
  line.travel = AsCoordinates(AsVector(end) - AsVector(start));
  line.length = AsVector(line.travel).norm();
  if (!(line.length > 0)) return std::nullopt;
  return line;
}

std::optional<Segment> MakeArcWithRadius(const Coordinates& start, const Coordinates& end,
                                         ArcPlane plane, double radius, bool counter_clockwise) {
  const double x = end[plane.first] - start[plane.first];
  const double y = end[plane.second] - start[plane.second];
  const double chord = std::sqrt(x * x + y * y);
  const double size = std::fabs(radius);
  if (!(chord > 0) || !(size > 0) || chord / 2 - size > kArcTolerance) return std::nullopt;
  const double height = std::sqrt(std::fmax(0.0, size * size - chord * chord / 4));
  // Half of what a radius > 0 sweeps.
  const double half_sweep = height > 0 ? AngleOf(chord / 2, height) : kPi / 2;
  const double sweep = radius > 0 ? 2 * half_sweep : 2 * kPi - 2 * half_sweep;
  // The centre of a counter-clockwise arc of at most 180 degrees is to the left of the chord.
  const double left = counter_clockwise == (radius > 0) ? height : -height;
  return PlaneArc(start, end, plane, start[plane.first] + x / 2 - left * (y / chord),
                  start[plane.second] + y / 2 + left * (x / chord), sweep, counter_clockwise);
}

std::optional<Segment> MakeArcAroundCentre(const Coordinates& start, const Coordinates& end,
                                           ArcPlane plane, double first, double second,
                                           bool counter_clockwise) {
  const double radius = std::sqrt(first * first + second * second);
  const double x = end[plane.first] - (start[plane.first] + first);
  const double y = end[plane.second] - (start[plane.second] + second);
  const double end_radius = std::sqrt(x * x + y * y);
  // Written so that the check fails for a NaN.
  if (!(radius > 0) || !(std::fabs(end_radius - radius) <= kArcTolerance)) return std::nullopt;
  double sweep = 2 * kPi;
  if (end[plane.first] != start[plane.first] || end[plane.second] != start[plane.second]) {
    // The angle between (-first, -second) and (x, y).
    const double turn = counter_clockwise ? 1 : -1;
    sweep = AngleOf(turn * (second * x - first * y), -first * x - second * y);
    if (sweep <= 0) sweep += 2 * kPi;
  }
  return PlaneArc(start, end, plane, start[plane.first] + first, start[plane.second] + second,
                  sweep, counter_clockwise);
}

std::optional<Segment> MakeArcThroughPoint(const Coordinates& start, const Coordinates& end,
                                           const std::array<double, 3>& between) {
  const Vector3d from = AsVector(start).head<3>();
  const Vector3d b = Eigen::Map<const Vector3d>(between.data()) - from;
  const Vector3d c = AsVector(end).head<3>() - from;
  const Vector3d normal = b.cross(c);
  const double area = normal.squaredNorm();
  // There is no circle through three points on a line.
  if (!(area > 1e-12 * b.squaredNorm() * c.squaredNorm())) return std::nullopt;
  // The circumcentre relative to the start.
  const Vector3d to_centre =
      (b.squaredNorm() * c.cross(normal) + c.squaredNorm() * normal.cross(b)) / (2 * area);
  Segment arc;
  arc.start = start;
  arc.end = end;
  arc.radius = to_centre.norm();
  const Vector3d u = -to_centre / arc.radius;
  const Vector3d w = (normal / std::sqrt(area)).cross(u);
  const Vector3d last = c - to_centre;
  arc.sweep = AngleOf(last.dot(w), last.dot(u));
  if (arc.sweep <= 0) arc.sweep += 2 * kPi;
  arc.centre = start;
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<size_t>(i);
    arc.centre[axis] += to_centre[i];
    arc.toward_start[axis] = u[i];
    arc.sideways[axis] = w[i];
  }
  arc.travel[3] = end[3] - start[3];
  return Complete(arc);
}

}  // namespace oncard::motion
