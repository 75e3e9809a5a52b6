#include "motion/paths/path_limits.h"

#include <cmath>

namespace oncard::motion {
namespace {

/// A turn that is only a rounding error of unit vectors.
constexpr double kNoTurn = 1e-12;

}  // namespace

void MeasureLength(uint32_t axes, Segment* segment) {
  const double along = LengthIn(axes, segment->travel);
  double around = 0;
  if (segment->shape == SegmentShape::kArc) {
    bool counts = false;
    for (size_t i = 0; i < kCrdDimensionMax; ++i) {
      const bool in_circle = segment->toward_start[i] != 0 || segment->sideways[i] != 0;
      counts = counts || (in_circle && (axes >> i & 1) != 0);
    }
    const double mean = segment->radius + segment->radius_change / 2;
    if (counts) around = mean * segment->sweep;
  }
  const double length = std::sqrt(around * around + along * along);
  if (length > 0) segment->length = length;
}

double CornerSpeed(uint32_t axes, const Coordinates& before, const Coordinates& after,
                   double acceleration, double time) {
  const double turn = LengthIn(axes, Between(before, after));
  if (turn < kNoTurn) return kUnlimited;
  return acceleration * time / turn;
}

double RadiusThrough(uint32_t axes, const Coordinates& a, const Coordinates& b,
                     const Coordinates& c) {
  Coordinates before = Between(a, b);
  Coordinates after = Between(b, c);
  const double first = LengthIn(axes, before);
  const double second = LengthIn(axes, after);
  if (!(first > 0) || !(second > 0)) return kUnlimited;
  for (size_t i = 0; i < before.size(); ++i) {
    before[i] /= first;
    after[i] /= second;
  }
  // 2 sin(angle / 2), from which the sine of the angle follows without cancellation.
  const double turn = LengthIn(axes, Between(before, after));
  if (turn < kNoTurn || turn >= kCurveTurnMax) return kUnlimited;
  const double sine = turn * std::sqrt(1 - turn * turn / 4);
  return LengthIn(axes, Between(a, c)) / (2 * sine);
}

}  // namespace oncard::motion
