// Axes that follow a path by a map: where a point puts them, and the point at which they are,
// compared with exact fractions.
#include "motion/paths/coordinate_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include "motion/common/state_hash.h"
#include "tests/motion/planned_path.h"

namespace oncard::motion {
namespace {

CoordinateMap MapOf(std::initializer_list<MapRow> rows) {
  CoordinateMap map;
  std::copy(rows.begin(), rows.end(), map.rows.begin());
  return map;
}

TEST(CoordinateMap, PutsAxesWhereTheirRowsSay) {
  const CoordinateMap map = MapOf({{{2000}, 5}, {{1, -2, 3, 0.5}, -7}, {}, {{0, 0, 0, 1}}});
  EXPECT_EQ(map.PositionOf(0, {10, 1, 1, 1}), 20005);
  EXPECT_EQ(map.PositionOf(1, {10, 20, 30, 40}), 10 - 40 + 90 + 20 - 7);
  EXPECT_EQ(map.Along(1, {10, 20, 30, 40}), 10 - 40 + 90 + 20);
  EXPECT_TRUE(map.Has(0));
  EXPECT_FALSE(map.Has(2));
  EXPECT_TRUE(map.Has(3));
}

TEST(CoordinateMap, FindsThePointWhereTheAxesAre) {
  const CoordinateMap map = MapOf({{{2000}, 5}, {{0, 500}}, {{0, 0, -10}, 100}, {{0, 0, 0, 1}}});
  EXPECT_EQ(map.PointOf({20005, 250, 0, -3}, {}), (Coordinates{10, 0.5, 10, -3}));
}

struct PointCase {
  const char* name;
  CoordinateMap map;
  MappedPositions axes;
  Coordinates present;
  Coordinates expected;
};

const PointCase kPointCases[] = {
    {"without a map the path stays", {}, {1, 2, 3, 4}, {5, 6, 7, 8}, {5, 6, 7, 8}},
    {"a coordinate without an equation stays",
     MapOf({{{1}}, {{0, 1}}}),
     {1, 2, 3, 4},
     {5, 6, 7, 8},
     {1, 2, 7, 8}},
    {"where there is a choice, the coordinate of a higher number stays",
     MapOf({{{0, 1, 1}}}),
     {9, 0, 0, 0},
     {1, 2, 3, 4},
     {1, 6, 3, 4}},
    {"of two rows that contradict each other the first counts",
     MapOf({{{1}}, {{1}, 100}, {{0, 1}}}),
     {30, 0, 40, 0},
     {},
     {30, 40, 0, 0}},
    {"a row that depends on two others is ignored",
     MapOf({{{1, 1}}, {{1, -1}}, {{3, 1}}, {{0, 0, 1}}}),
     {10, 4, -1, 2},
     {},
     {7, 3, 2, 0}},
    {"coefficients may be tiny or huge",
     MapOf({{{1e-200}}, {{0, 1e200}}}),
     {2e-200, 3e200, 0, 0},
     {},
     {2, 3, 0, 0}}};

TEST(CoordinateMap, IgnoresDependentRowsAndKeepsOpenCoordinates) {
  for (const PointCase& c : kPointCases) {
    SCOPED_TRACE(c.name);
    const Coordinates point = c.map.PointOf(c.axes, c.present);
    for (size_t i = 0; i < point.size(); ++i) EXPECT_NEAR(point[i], c.expected[i], 1e-12) << i;
  }
}

// Otherwise a second move to the same point would have a length, that of a rounding error.
TEST(CoordinateMap, FindsExactlyThePointThatPutsTheAxesThere) {
  RandomNumbers random(1);
  for (int run = 0; run < 1000; ++run) {
    CoordinateMap map;
    Coordinates point;
    for (double& value : point) value = random.Between(-100, 100);
    MappedPositions axes{};
    for (size_t axis = 0; axis < axes.size(); ++axis) {
      for (double& value : map.rows[axis].coefficients) value = random.Between(-1, 1);
      map.rows[axis].offset = random.Between(-10, 10);
      axes[axis] = map.PositionOf(axis, point);
    }
    ASSERT_EQ(map.PointOf(axes, point), point);
  }
}

TEST(CoordinateMap, LimitsTurnsByTheAxisThatJumpsMost) {
  CoordinateMap map = MapOf({{{2}}, {{0, -3}}, {}, {{1, 1}}});
  map.jumps = {10, 6, 0.001, 100};
  // 2 * 1, 3 * 0.5 and 1.5 per unit of speed.
  EXPECT_EQ(map.SpeedAtTurn({1, 0.5}), 4);
  EXPECT_EQ(map.SpeedAtTurn({0, 0, 1, 1}), kUnlimited);
  EXPECT_EQ(CoordinateMap{}.SpeedAtTurn({1, 1, 1, 1}), kUnlimited);
}

TEST(CoordinateMap, JoinsTheHashWithAllItHolds) {
  const auto hash = [](const CoordinateMap& map) { return StateHash().Add(map).value(); };
  CoordinateMap jump;
  jump.jumps[3] = 1;
  CoordinateMap alone;
  alone.stops_together = false;
  CoordinateMap held;
  held.held = true;
  const uint64_t hashes[] = {
      hash({}),  hash(MapOf({{{0, 0, 0, 1}}})), hash(MapOf({{{}, 1}})), hash(jump), hash(alone),
      hash(held)};
  for (size_t i = 1; i < std::size(hashes); ++i) {
    for (size_t k = 0; k < i; ++k) EXPECT_NE(hashes[i], hashes[k]) << i << k;
  }
}

// --- Exact fractions -----------------------------------------------------------------------------

__extension__ using Wide = __int128;

/// A fraction in lowest terms, with a positive denominator.
struct Fraction {
  Wide numerator = 0;
  Wide denominator = 1;

  double value() const { return static_cast<double>(numerator) / static_cast<double>(denominator); }
  bool zero() const { return numerator == 0; }
};

Fraction Reduced(Wide numerator, Wide denominator) {
  Wide a = numerator < 0 ? -numerator : numerator;
  Wide b = denominator < 0 ? -denominator : denominator;
  while (b != 0) {
    const Wide rest = a % b;
    a = b;
    b = rest;
  }
  const Wide divisor = denominator < 0 ? -a : a;
  return {numerator / divisor, denominator / divisor};
}

Fraction operator*(const Fraction& a, const Fraction& b) {
  return Reduced(a.numerator * b.numerator, a.denominator * b.denominator);
}
Fraction operator/(const Fraction& a, const Fraction& b) {
  return Reduced(a.numerator * b.denominator, a.denominator * b.numerator);
}
Fraction operator-(const Fraction& a, const Fraction& b) {
  return Reduced(a.numerator * b.denominator - b.numerator * a.denominator,
                 a.denominator * b.denominator);
}

/// The coefficients of x, y, z, a, and the value.
using Equation = std::array<Fraction, kCrdDimensionMax + 1>;

/// Equations in reduced row echelon form, to which one after the other is added.
class ExactSolution {
 public:
  void Add(Equation added) {
    for (const auto& [pivot, equation] : solved_) Eliminate(pivot, equation, &added);
    size_t pivot = 0;
    while (pivot < kCrdDimensionMax && added[pivot].zero()) ++pivot;
    if (pivot == kCrdDimensionMax) return;
    const Fraction divisor = added[pivot];
    for (Fraction& value : added) value = value / divisor;
    for (auto& [other, equation] : solved_) Eliminate(pivot, added, &equation);
    solved_.push_back({pivot, added});
  }

  Coordinates PointBeside(const std::array<int, kCrdDimensionMax>& present) const {
    std::array<Fraction, kCrdDimensionMax> point;
    for (size_t i = 0; i < point.size(); ++i) point[i] = {present[i], 1};
    for (const auto& [pivot, equation] : solved_) {
      Fraction value = equation[kCrdDimensionMax];
      for (size_t i = pivot + 1; i < point.size(); ++i) {
        value = value - equation[i] * Fraction{present[i], 1};
      }
      point[pivot] = value;
    }
    Coordinates result;
    for (size_t i = 0; i < result.size(); ++i) result[i] = point[i].value();
    return result;
  }

 private:
  struct Solved {
    size_t pivot;
    Equation equation;
  };

  static void Eliminate(size_t pivot, const Equation& by, Equation* from) {
    const Fraction factor = (*from)[pivot];
    for (size_t i = 0; i < from->size(); ++i) (*from)[i] = (*from)[i] - factor * by[i];
  }

  std::vector<Solved> solved_;
};

/// A map of whole numbers.
struct WholeMap {
  std::array<std::array<int, kCrdDimensionMax>, kMappedAxisMax> rows{};
  std::array<int, kMappedAxisMax> offsets{};
};

enum class MapKind { kAny, kPartial, kContradictory, kSkew };

WholeMap RandomMap(MapKind kind, RandomNumbers& random) {
  const auto whole = [&](int most) { return static_cast<int>(random.Between(-most, most + 1)); };
  WholeMap map;
  for (size_t axis = 0; axis < map.rows.size(); ++axis) {
    if (kind == MapKind::kPartial && random.Between(0, 1) < 0.5) continue;
    for (int& value : map.rows[axis]) value = random.Between(0, 1) < 0.3 ? 0 : whole(9);
    map.offsets[axis] = whole(1000);
  }
  const auto last = static_cast<size_t>(random.Between(1, 4));
  for (size_t i = 0; i < kCrdDimensionMax; ++i) {
    int& value = map.rows[last][i];
    const int before = map.rows[last - 1][i];
    // A combination of rows before, and a row that is nearly parallel to the one before.
    if (kind == MapKind::kContradictory) value = 3 * before - 2 * map.rows[0][i];
    if (kind == MapKind::kSkew) value = 1000 * before + (i == last ? 1 : 0);
  }
  return map;
}

TEST(CoordinateMap, AgreesWithExactFractions) {
  constexpr MapKind kKinds[] = {MapKind::kAny, MapKind::kPartial, MapKind::kContradictory,
                                MapKind::kSkew};
  RandomNumbers random(7);
  for (int run = 0; run < 10'000; ++run) {
    SCOPED_TRACE(run);
    const WholeMap whole = RandomMap(kKinds[run % 4], random);
    CoordinateMap map;
    ExactSolution exact;
    MappedPositions axes;
    std::array<int, kCrdDimensionMax> present{};
    Coordinates kept;
    for (size_t i = 0; i < kCrdDimensionMax; ++i) {
      present[i] = static_cast<int>(random.Between(-50, 50));
      kept[i] = present[i];
    }
    for (size_t axis = 0; axis < axes.size(); ++axis) {
      const int position = static_cast<int>(random.Between(-100'000, 100'000));
      axes[axis] = position;
      Equation equation;
      for (size_t i = 0; i < kCrdDimensionMax; ++i) {
        equation[i] = {whole.rows[axis][i], 1};
        map.rows[axis].coefficients[i] = whole.rows[axis][i];
      }
      equation[kCrdDimensionMax] = {position - whole.offsets[axis], 1};
      map.rows[axis].offset = whole.offsets[axis];
      exact.Add(equation);
    }
    const Coordinates expected = exact.PointBeside(present);
    const Coordinates point = map.PointOf(axes, kept);
    double size = 1;
    for (const double value : expected) size = std::max(size, std::fabs(value));
    for (size_t i = 0; i < point.size(); ++i) ASSERT_NEAR(point[i], expected[i], 1e-9 * size) << i;
  }
}

}  // namespace
}  // namespace oncard::motion
