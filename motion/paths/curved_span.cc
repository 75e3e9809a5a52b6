#include "motion/paths/curved_span.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/common/trigonometry.h"
#include "motion/paths/path_limits.h"

namespace oncard::motion {
namespace {

/// Shares of the limits that are used, so that they are also kept between the points of a cell at
/// which they are required.
constexpr double kAccelerationShare = 0.9995;
constexpr double kVelocityShare = 0.999;
/// A component of the tangent or its change that is only a rounding error.
constexpr double kNothing = 1e-12;

/// u = at_zero + slope x.
struct Bound {
  double at_zero = 0;
  double slope = 0;

  double At(double x) const { return at_zero + slope * x; }
};

/// What the axes allow at a point of the arc.
struct CurvePoint {
  Coordinates tangent;
  Coordinates change;
  double top = 0;  ///< the largest square of the speed

  CurvePoint(const CurvedSpan& span, double path)
      : tangent(span.segment.TangentAt(path)),
        change(span.segment.CurvatureAt(path)),
        top(span.top) {
    for (size_t i = 0; i < tangent.size(); ++i) {
      if (span.axis_velocity[i] == kUnlimited || std::fabs(tangent[i]) < kNothing) continue;
      const double speed = kVelocityShare * span.axis_velocity[i] / tangent[i];
      top = std::min(top, speed * speed);
    }
  }
};

/// A cell as rows of a linear program in u, for every x.
class Cell {
 public:
  Cell(const CurvedSpan& span, double path, double step)
      : begin_(span, path), end_(span, path + step), twice_(2 * step), start_top_(begin_.top) {
    const CurvePoint middle(span, path + step / 2);
    hard_upper_[0] = {span.acceleration, 0};
    hard_lower_[0] = {-span.acceleration, 0};
    hard_ = 1;
    for (size_t i = 0; i < kCrdDimensionMax; ++i) {
      if (span.axis_acceleration[i] == kUnlimited) continue;
      const double limit = kAccelerationShare * span.axis_acceleration[i];
      Require(begin_.tangent[i], begin_.change[i], limit);
      Require(middle.tangent[i] + step * middle.change[i], middle.change[i], limit);
      Require(end_.tangent[i] + twice_ * end_.change[i], end_.change[i], limit);
    }
    middle_ = {middle.top / step, -1 / step};
  }

  /// The largest x at the cell's begin from which an x of at most `end` can be reached.
  double Reach(double end) const {
    end = std::min(end, end_.top);
    double x = start_top_;
    // Upper minus lower bound is a concave function of x; Newton's method finds its root from
    // above in finitely many steps.
    for (int i = 0; i < kNewtonMax; ++i) {
      const Bound upper = LeastUpper(x, end);
      const Bound lower = GreatestLower(x);
      if (upper.At(x) >= lower.At(x)) return x;
      const double root = (upper.at_zero - lower.at_zero) / (lower.slope - upper.slope);
      if (!(root < x)) return x;
      x = std::max(root, 0.0);
    }
    return x;
  }

  /// The largest x at the cell's end, at most `end` if the axes allow that.
  double Advance(double x, double end) const {
    const double most = LeastUpper(x, std::min(end, end_.top)).At(x);
    double low = -x / twice_;
    double high = kUnlimited;
    for (size_t i = 0; i < hard_; ++i) {
      low = std::max(low, hard_lower_[i].At(x));
      high = std::min(high, hard_upper_[i].At(x));
    }
    const double u = std::max(std::min(most, high), low);
    return std::max(x + twice_ * u, 0.0);
  }

 private:
  static constexpr size_t kRowMax = 1 + 3 * kCrdDimensionMax;
  static constexpr int kNewtonMax = 64;

  /// |p u + q x| <= limit.
  void Require(double p, double q, double limit) {
    if (std::fabs(p) < kNothing) {
      if (std::fabs(q) > kNothing) start_top_ = std::min(start_top_, limit / std::fabs(q));
      return;
    }
    const double size = std::fabs(limit / p);
    hard_upper_[hard_] = {size, -q / p};
    hard_lower_[hard_++] = {-size, -q / p};
  }

  Bound LeastUpper(double x, double end) const {
    Bound least = {end / twice_, -1 / twice_};
    if (middle_.At(x) < least.At(x)) least = middle_;
    for (size_t i = 0; i < hard_; ++i) {
      if (hard_upper_[i].At(x) < least.At(x)) least = hard_upper_[i];
    }
    return least;
  }
  Bound GreatestLower(double x) const {
    Bound greatest = {0, -1 / twice_};
    for (size_t i = 0; i < hard_; ++i) {
      if (hard_lower_[i].At(x) > greatest.At(x)) greatest = hard_lower_[i];
    }
    return greatest;
  }

  CurvePoint begin_;
  CurvePoint end_;
  double twice_;                           ///< the cell's length, twice: x changes by twice_ * u
  double start_top_;                       ///< the largest x at its begin
  Bound middle_;                           ///< what the axes' velocities allow in its middle
  std::array<Bound, kRowMax> hard_upper_;  ///< accelerations
  std::array<Bound, kRowMax> hard_lower_;
  size_t hard_ = 0;
};

size_t CellsOf(const CurvedSpan& span, double begin) {
  const double turn = span.segment.sweep * (1 - begin / span.segment.length) / (2 * kPi);
  const double cells = std::ceil(turn * static_cast<double>(kCurveCellMax));
  return std::clamp(static_cast<size_t>(std::max(cells, 0.0)), kCurveCellMin, kCurveCellMax);
}

/// The squares of PlanCurve in `squares`, which has room for the nodes.
void PassBothWays(const CurvedSpan& span, double begin, double begin_square, double end_square,
                  size_t cells, double* squares) {
  const double step = (span.segment.length - begin) / static_cast<double>(cells);
  squares[cells] = std::min(end_square, CurvePoint(span, span.segment.length).top);
  for (size_t i = cells; i-- > 1;) {
    const Cell cell(span, begin + static_cast<double>(i) * step, step);
    squares[i] = cell.Reach(squares[i + 1]);
  }
  squares[0] = begin_square;
  for (size_t i = 0; i < cells; ++i) {
    const Cell cell(span, begin + static_cast<double>(i) * step, step);
    squares[i + 1] = cell.Advance(squares[i], squares[i + 1]);
  }
}

}  // namespace

bool IsHeldBack(const CurvedSpan& span) {
  const Segment& arc = span.segment;
  const double turning = arc.sweep / arc.length;
  const double radius = std::max(arc.radius, arc.radius + arc.radius_change);
  for (size_t i = 0; i < kCrdDimensionMax; ++i) {
    const double share =
        std::sqrt(arc.toward_start[i] * arc.toward_start[i] + arc.sideways[i] * arc.sideways[i]);
    const double tangent = share * radius * turning +
                           (std::fabs(arc.travel[i]) + std::fabs(arc.radius_change)) / arc.length;
    const double change = share * (radius * turning * turning +
                                   2 * std::fabs(arc.radius_change) / arc.length * turning);
    if (tangent * std::sqrt(span.top) > span.axis_velocity[i]) return true;
    if (tangent * span.acceleration + change * span.top > span.axis_acceleration[i]) return true;
  }
  return false;
}

double CurveReach(const CurvedSpan& span, double end_square) {
  const size_t cells = CellsOf(span, 0);
  const double step = span.segment.length / static_cast<double>(cells);
  double square = end_square;
  for (size_t i = cells; i-- > 0;) {
    square = Cell(span, static_cast<double>(i) * step, step).Reach(square);
  }
  return square;
}

void PlanCurve(const CurvedSpan& span, double begin, double begin_square, double end_square,
               std::vector<double>* squares) {
  const size_t cells = CellsOf(span, begin);
  squares->resize(cells + 1);
  PassBothWays(span, begin, begin_square, end_square, cells, squares->data());
}

double CurveEnd(const CurvedSpan& span, double begin_square, double end_square) {
  std::array<double, kCurveNodeMax> squares;
  const size_t cells = CellsOf(span, 0);
  PassBothWays(span, 0, begin_square, end_square, cells, squares.data());
  return squares[cells];
}

}  // namespace oncard::motion
