#include "motion/paths/coordinate_map.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<CoordinateMap> && kFieldsComplete<MapRow>);

using Eigen::Vector4d;
static_assert(Vector4d::SizeAtCompileTime == kCrdDimensionMax);

Eigen::Map<const Vector4d> VectorOf(const Coordinates& values) {
  return Eigen::Map<const Vector4d>(values.data());
}

/// A vector of which less than this part is not a sum of others is one: the rest is rounding.
constexpr double kDependent = 0x1p-30;

/// The solution of equations that are added one by one. Each moves it at a right angle to those
/// before, so that they stay true.
class Solution {
 public:
  /// Demands row * point = value, unless that depends on the equations before.
  void Add(Vector4d row, double value) {
    const double scale = row.cwiseAbs().maxCoeff();
    if (count_ == kCrdDimensionMax || scale == 0) return;
    // Squares of the numbers can be represented then.
    row /= scale;
    Vector4d across = row;
    // The second time removes what rounding has left.
    for (int time = 0; time < 2; ++time) {
      for (Eigen::Index i = 0; i < count_; ++i) across -= across.dot(axes_.col(i)) * axes_.col(i);
    }
    const double length = across.norm();
    if (length <= kDependent * row.norm()) return;
    across /= length;
    point_ += (value / scale - row.dot(point_)) / row.dot(across) * across;
    axes_.col(count_++) = across;
  }

  const Vector4d& point() const { return point_; }

 private:
  Eigen::Matrix4d axes_ = Eigen::Matrix4d::Zero();
  Eigen::Index count_ = 0;
  Vector4d point_ = Vector4d::Zero();
};

}  // namespace

bool CoordinateMap::Has(size_t axis) const {
  const Coordinates& row = rows[axis].coefficients;
  return std::any_of(row.begin(), row.end(), [](double coefficient) { return coefficient != 0; });
}

double CoordinateMap::PositionOf(size_t axis, const Coordinates& point) const {
  return Along(axis, point) + rows[axis].offset;
}

double CoordinateMap::Along(size_t axis, const Coordinates& direction) const {
  return VectorOf(rows[axis].coefficients).dot(VectorOf(direction));
}

double CoordinateMap::SpeedAtTurn(const Coordinates& turn) const {
  double speed = kUnlimited;
  for (size_t axis = 0; axis < rows.size(); ++axis) {
    const double change = std::fabs(Along(axis, turn));
    if (change * speed > jumps[axis]) speed = jumps[axis] / change;
  }
  return speed;
}

Coordinates CoordinateMap::PointOf(const MappedPositions& axes, const Coordinates& present) const {
  bool there = true;
  Solution solution;
  for (size_t axis = 0; axis < rows.size(); ++axis) {
    if (!Has(axis)) continue;
    there = there && PositionOf(axis, present) == axes[axis];
    solution.Add(VectorOf(rows[axis].coefficients), axes[axis] - rows[axis].offset);
  }
  if (there) return present;
  for (size_t i = kCrdDimensionMax; i-- > 0;) {
    solution.Add(Vector4d::Unit(static_cast<Eigen::Index>(i)), present[i]);
  }
  Coordinates point;
  Eigen::Map<Vector4d>(point.data()) = solution.point();
  return point;
}

}  // namespace oncard::motion
