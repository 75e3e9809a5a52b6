// The fastest motion along a path, computed independently of the planner: on a fine grid, a pass
// backward and a pass forward over the square of the speed. Directions and their changes are
// differences of points; the limits of the axes are found by bisection.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "motion/paths/path_planner.h"

namespace oncard::motion {

struct ReferencePath {
  PathLimits limits;
  std::vector<PathSlot> slots;  ///< segments only, as they were commanded
  double grid = 0.001;

  /// The shortest time from rest to rest.
  double ShortestTime() const;
  /// The largest square of the speed along a segment: as commanded, and on its curve.
  double TopOf(size_t slot) const;

 private:
  struct Point {
    Coordinates tangent{};
    Coordinates bend{};
    double step = 0;  ///< to the next point
    double top = 0;   ///< the largest square of the speed
    double acceleration = 0;
  };

  static double Distance(const Coordinates& a, const Coordinates& b) {
    double square = 0;
    for (size_t i = 0; i < a.size(); ++i) square += (b[i] - a[i]) * (b[i] - a[i]);
    return std::sqrt(square);
  }
  double RadiusAt(size_t corner) const;
  double CornerTop(size_t corner, const Coordinates& before, const Coordinates& after) const;
  void Extend(double square, const Point& point, double* low, double* high) const;
  std::vector<Point> Points() const;
};

/// The radius of the circle through three successive points, from its sides and its area.
inline double ReferencePath::RadiusAt(size_t corner) const {
  const Segment& first = slots[corner - 1].segment;
  const Segment& second = slots[corner].segment;
  if (first.shape != SegmentShape::kLine || second.shape != SegmentShape::kLine) return kUnlimited;
  if (slots[corner - 1].ends_at_rest) return kUnlimited;
  const double a = Distance(first.start, first.end);
  const double b = Distance(second.start, second.end);
  const double c = Distance(first.start, second.end);
  const double cosine = (a * a + b * b - c * c) / (2 * a * b);  // of the angle inside
  if (cosine > -std::cos(M_PI / 6)) return kUnlimited;          // a corner
  const double area = a * b / 2 * std::sqrt(std::max(1 - cosine * cosine, 0.0));
  return area > 1e-12 ? a * b * c / (4 * area) : kUnlimited;
}

inline double ReferencePath::TopOf(size_t slot) const {
  double top = slots[slot].velocity * slots[slot].velocity;
  if (!limits.geometric) return top;
  const auto curve = [&](double radius, double acceleration) {
    if (radius < kUnlimited) top = std::min(top, limits.radius_ratio * acceleration * radius);
  };
  if (slots[slot].segment.shape == SegmentShape::kArc) {
    // On a helix the radius of curvature of its path.
    const Segment& arc = slots[slot].segment;
    curve(arc.length * arc.length / (arc.radius * arc.sweep * arc.sweep), slots[slot].acceleration);
    return top;
  }
  for (const size_t corner : {slot, slot + 1}) {
    if (corner == 0 || corner == slots.size()) continue;
    curve(RadiusAt(corner), slots[slot].acceleration);
  }
  return top;
}

inline double ReferencePath::CornerTop(size_t corner, const Coordinates& before,
                                       const Coordinates& after) const {
  if (slots[corner - 1].ends_at_rest) return 0;
  double top = std::min(TopOf(corner - 1), TopOf(corner));
  const auto limit = [&](double change, double allowed) {
    // Differences of points are exact to about 1e-7.
    if (change > 1e-6 && allowed < kUnlimited) {
      top = std::min(top, allowed / change * (allowed / change));
    }
  };
  if (limits.geometric) {
    limit(Distance(before, after), limits.corner_time * std::min(slots[corner - 1].acceleration,
                                                                 slots[corner].acceleration));
  }
  for (size_t i = 0; i < before.size(); ++i) {
    limit(std::fabs(after[i] - before[i]), limits.axes[i].jump);
  }
  return top;
}

inline std::vector<ReferencePath::Point> ReferencePath::Points() const {
  std::vector<Point> points;
  Coordinates before{};
  for (size_t s = 0; s < slots.size(); ++s) {
    const Segment& segment = slots[s].segment;
    const auto count = static_cast<size_t>(std::ceil(segment.length / grid));
    const double step = segment.length / static_cast<double>(count);
    const double h = segment.length * 1e-4;
    const bool line = segment.shape == SegmentShape::kLine;
    for (size_t i = 0; i < count; ++i) {
      const double at = std::clamp(step * static_cast<double>(i), h, segment.length - h);
      const Coordinates a = segment.PointAt(at - h);
      const Coordinates b = segment.PointAt(at);
      const Coordinates c = segment.PointAt(std::min(at + h, segment.length * (1 - 1e-12)));
      Point point;
      point.step = step;
      point.top = TopOf(s);
      point.acceleration = slots[s].acceleration;
      for (size_t k = 0; k < a.size(); ++k) {
        point.tangent[k] = (c[k] - a[k]) / (2 * h);
        point.bend[k] = line ? 0 : (c[k] - 2 * b[k] + a[k]) / (h * h);
      }
      if (i == 0) {
        point.top = s == 0 ? 0 : std::min(point.top, CornerTop(s, before, point.tangent));
      }
      for (size_t k = 0; k < a.size(); ++k) {
        const double share = std::fabs(point.tangent[k]);
        if (share < 1e-9 || limits.axes[k].velocity == kUnlimited) continue;
        const double speed = limits.axes[k].velocity / share;
        point.top = std::min(point.top, speed * speed);
      }
      points.push_back(point);
      before = point.tangent;
    }
  }
  return points;
}

/// The accelerations that the limits allow at a speed.
inline void ReferencePath::Extend(double square, const Point& point, double* low,
                                  double* high) const {
  *low = -point.acceleration;
  *high = point.acceleration;
  for (size_t k = 0; k < point.tangent.size(); ++k) {
    const double t = point.tangent[k];
    if (limits.axes[k].acceleration == kUnlimited || std::fabs(t) < 1e-9) continue;
    const double middle = -square * point.bend[k] / t;
    const double half = limits.axes[k].acceleration / std::fabs(t);
    *low = std::max(*low, middle - half);
    *high = std::min(*high, middle + half);
  }
}

inline double ReferencePath::ShortestTime() const {
  std::vector<Point> points = Points();
  std::vector<double> square(points.size() + 1, 0.0);
  for (size_t i = points.size(); i-- > 0;) {
    const Point& point = points[i];
    const auto reaches = [&](double x) {
      double low = 0;
      double high = 0;
      Extend(x, point, &low, &high);
      return low <= high && x + 2 * point.step * low <= square[i + 1];
    };
    double good = 0;
    double bad = point.top;
    if (reaches(bad)) {
      good = bad;
    } else {
      for (int k = 0; k < 40; ++k) {
        const double x = (good + bad) / 2;
        (reaches(x) ? good : bad) = x;
      }
    }
    square[i] = good;
  }
  double time = 0;
  double x = square[0];
  for (size_t i = 0; i < points.size(); ++i) {
    double low = 0;
    double high = 0;
    Extend(x, points[i], &low, &high);
    const double next = std::max(std::min(x + 2 * points[i].step * high, square[i + 1]), 0.0);
    const double speeds = std::sqrt(x) + std::sqrt(next);
    if (speeds > 0) time += 2 * points[i].step / speeds;
    x = next;
  }
  return time;
}

}  // namespace oncard::motion
