#include "motion/paths/segment.h"

#include <cmath>

#include "motion/common/state_hash.h"
#include "motion/common/trigonometry.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<Segment>);

/// Coordinates of which each is computed alike: `value(i)` is the ith.
template <typename Function>
Coordinates Each(Function value) {
  return {value(0), value(1), value(2), value(3)};
}

double LengthOf(const Coordinates& v) {
  return std::sqrt((v[0] * v[0] + v[1] * v[1]) + (v[2] * v[2] + v[3] * v[3]));
}

/// A vector in X, Y, Z.
struct Vector {
  double x = 0;
  double y = 0;
  double z = 0;
};

Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator*(double factor, const Vector& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}
Vector operator/(const Vector& v, double divisor) {
  return {v.x / divisor, v.y / divisor, v.z / divisor};
}
double Dot(const Vector& a, const Vector& b) { return a.x * b.x + (a.y * b.y + a.z * b.z); }
Vector Cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Completes an arc for which centre, unit vectors, radii, sweep and linear travel are set. Empty
/// if a double cannot tell its length from 0.
std::optional<Segment> Complete(Segment arc) {
  arc.shape = SegmentShape::kArc;
  const double mean = arc.radius + arc.radius_change / 2;
  const double along = LengthOf(arc.travel);
  arc.length = std::sqrt(mean * mean * arc.sweep * arc.sweep + along * along);
  if (!(arc.length > 0)) return std::nullopt;
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
    return Each([&](size_t i) { return start[i] + part * travel[i]; });
  }
  const auto [sine, cosine] = SineAndCosine(sweep * part);
  const double r = radius + radius_change * part;
  const double along_start = r * cosine;
  const double along_side = r * sine;
  return Each([&](size_t i) {
    return centre[i] + along_start * toward_start[i] + along_side * sideways[i] + part * travel[i];
  });
}

Coordinates Segment::TangentAt(double path) const {
  if (shape == SegmentShape::kLine) return Each([&](size_t i) { return travel[i] / length; });
  const double part = path / length;
  const auto [sine, cosine] = SineAndCosine(sweep * part);
  const double turning = (radius + radius_change * part) * sweep / length;
  const double growing = radius_change / length;
  const double along_start = growing * cosine - turning * sine;
  const double along_side = growing * sine + turning * cosine;
  return Each([&](size_t i) {
    return along_start * toward_start[i] + along_side * sideways[i] + travel[i] / length;
  });
}

Coordinates Segment::CurvatureAt(double path) const {
  if (shape == SegmentShape::kLine) return {};
  const double part = path / length;
  const auto [sine, cosine] = SineAndCosine(sweep * part);
  const double rate = sweep / length;
  const double inward = -(radius + radius_change * part) * rate * rate;
  const double aside = 2 * (radius_change / length) * rate;
  const double along_start = inward * cosine - aside * sine;
  const double along_side = inward * sine + aside * cosine;
  return Each([&](size_t i) { return along_start * toward_start[i] + along_side * sideways[i]; });
}

std::optional<Segment> MakeLine(const Coordinates& start, const Coordinates& end) {
  Segment line;
  line.start = start;
  line.end = end;
  line.travel = Between(start, end);
  line.length = LengthOf(line.travel);
  if (!(line.length > 0)) return std::nullopt;
  return line;
}

std::optional<Segment> MakeArcWithRadius(const Coordinates& start, const Coordinates& end,
                                         ArcPlane plane, double radius, bool counter_clockwise,
                                         double tolerance) {
  const double x = end[plane.first] - start[plane.first];
  const double y = end[plane.second] - start[plane.second];
  const double chord = std::sqrt(x * x + y * y);
  const double size = std::fabs(radius);
  if (!(chord > 0) || !(size > 0) || chord / 2 - size > tolerance) return std::nullopt;
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
                                           bool counter_clockwise, double tolerance) {
  const double radius = std::sqrt(first * first + second * second);
  const double x = end[plane.first] - (start[plane.first] + first);
  const double y = end[plane.second] - (start[plane.second] + second);
  const double end_radius = std::sqrt(x * x + y * y);
  // Written so that the check fails for a NaN.
  if (!(radius > 0) || !(std::fabs(end_radius - radius) <= tolerance)) return std::nullopt;
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

std::optional<Segment> MakeArcWithSweep(const Coordinates& start, ArcPlane plane, double first,
                                        double second, double sweep, bool counter_clockwise) {
  if (!(first * first + second * second > 0)) return std::nullopt;
  Coordinates end = start;
  if (sweep < 2 * kPi) {
    const SineCosine turn = SineAndCosine(counter_clockwise ? sweep : -sweep);
    end[plane.first] += first - (turn.cosine * first - turn.sine * second);
    end[plane.second] += second - (turn.sine * first + turn.cosine * second);
  }
  return PlaneArc(start, end, plane, start[plane.first] + first, start[plane.second] + second,
                  sweep, counter_clockwise);
}

std::optional<Segment> MakeArcThroughPoint(const Coordinates& start, const Coordinates& end,
                                           const std::array<double, 3>& between) {
  // Relative to the start.
  const Vector b = {between[0] - start[0], between[1] - start[1], between[2] - start[2]};
  const Vector c = {end[0] - start[0], end[1] - start[1], end[2] - start[2]};
  const Vector normal = Cross(b, c);
  const double area = Dot(normal, normal);
  // There is no circle through three points on a line.
  if (!(area > 1e-12 * Dot(b, b) * Dot(c, c))) return std::nullopt;
  const Vector to_centre =
      (Dot(b, b) * Cross(c, normal) + Dot(c, c) * Cross(normal, b)) / (2 * area);
  Segment arc;
  arc.start = start;
  arc.end = end;
  arc.radius = std::sqrt(Dot(to_centre, to_centre));
  const Vector u = to_centre / -arc.radius;
  const Vector w = Cross(normal / std::sqrt(area), u);
  const Vector last = c - to_centre;
  arc.sweep = AngleOf(Dot(last, w), Dot(last, u));
  if (arc.sweep <= 0) arc.sweep += 2 * kPi;
  arc.centre = {start[0] + to_centre.x, start[1] + to_centre.y, start[2] + to_centre.z, start[3]};
  arc.toward_start = {u.x, u.y, u.z};
  arc.sideways = {w.x, w.y, w.z};
  arc.travel[3] = end[3] - start[3];
  return Complete(arc);
}

}  // namespace oncard::motion
