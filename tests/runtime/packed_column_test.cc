#include "runtime/observe/packed_column.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "base/random.h"

namespace oncard::runtime {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

PackedColumn Packed(const std::vector<double>& values) {
  PackedColumn column;
  for (const double value : values) column.Append(value);
  return column;
}

// Bits, because NaN is not equal to itself and -0 equals 0.
std::vector<uint64_t> BitsOf(const std::vector<double>& values) {
  std::vector<uint64_t> bits;
  for (const double value : values) bits.push_back(std::bit_cast<uint64_t>(value));
  return bits;
}

std::vector<double> Read(const PackedColumn& column, size_t count) {
  PackedColumn::Reader reader(column);
  std::vector<double> values;
  for (size_t i = 0; i < count; ++i) values.push_back(reader.Next());
  return values;
}

std::vector<double> Sequence(size_t count, const std::function<double(double)>& value) {
  std::vector<double> values;
  for (size_t i = 0; i < count; ++i) values.push_back(value(static_cast<double>(i)));
  return values;
}

struct ColumnCase {
  std::string name;
  std::vector<double> values;
  double bytes_per_value;  ///< at most
};

std::vector<ColumnCase> ColumnCases() {
  return {
      {"zeros", Sequence(1000, [](double) { return 0.0; }), 0.01},
      {"a constant", Sequence(1000, [](double) { return 0.1; }), 0.02},
      {"steps", Sequence(1000, [](double i) { return std::floor(i / 100); }), 0.1},
      {"an exact ramp", Sequence(1000, [](double i) { return 7 + 0.25 * i; }), 0.03},
      {"a rounded ramp", Sequence(1000, [](double i) { return 0.1 * i; }), 3},
      {"an exact parabola", Sequence(1000, [](double i) { return i * i / 8; }), 0.03},
      {"a rounded parabola", Sequence(1000, [](double i) { return 0.01 * i * i; }), 3},
      {"a sine", Sequence(1000, [](double i) { return std::sin(i / 100); }), 9},
      {"down through zero", Sequence(1000, [](double i) { return 500 - i; }), 0.03},
      {"run lengths around a byte more", Sequence(1000, [](double i) { return i < 17 ? 1 : 2; }),
       0.03},
      {"both zeros", {0, -0.0, 0, 0, -0.0, -0.0}, 9},
      {"nothing that can be computed with",
       {kNan, -kNan, kNan, kNan, kInfinity, kInfinity, -kInfinity, 1, kNan, 1, kInfinity, 2},
       9},
      {"other NaNs",
       {std::bit_cast<double>(0x7FF8'0000'0000'0001), std::bit_cast<double>(0xFFF8'1234'0000'0000),
        1},
       9},
      {"the bounds",
       {std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(),
        std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min(),
        std::numeric_limits<double>::min()},
       9},
  };
}

TEST(PackedColumn, GivesBackEveryBit) {
  for (const ColumnCase& c : ColumnCases()) {
    const PackedColumn column = Packed(c.values);
    ASSERT_EQ(column.size(), c.values.size());
    EXPECT_EQ(BitsOf(Read(column, c.values.size())), BitsOf(c.values)) << c.name;
  }
}

TEST(PackedColumn, TakesFewBytesForWhatIsPredictable) {
  for (const ColumnCase& c : ColumnCases()) {
    // The memory of a vector that grows is up to twice its size.
    const double most = 2 * c.bytes_per_value * static_cast<double>(c.values.size());
    EXPECT_LE(static_cast<double>(Packed(c.values).bytes()), most) << c.name;
  }
}

TEST(PackedColumn, GivesBackRandomBits) {
  uint64_t random = 1;
  std::vector<double> values;
  for (int i = 0; i < 10'000; ++i) {
    // Also some that equal the last one and some of which only the middle is random.
    const uint64_t mask = i % 3 == 0 ? ~uint64_t{0} : uint64_t{0xFFFF} << (i % 48);
    const auto bits = std::bit_cast<uint64_t>(i == 0 ? 0.0 : values.back());
    values.push_back(std::bit_cast<double>(i % 7 == 0 ? bits : bits ^ (NextRandom(random) & mask)));
  }
  EXPECT_EQ(BitsOf(Read(Packed(values), values.size())), BitsOf(values));
}

TEST(PackedColumn, GivesBackRunsOfAnyLength) {
  for (const size_t length : {1u, 2u, 15u, 16u, 17u, 143u, 144u, 145u, 20'000u}) {
    PackedColumn column = Packed({1, 2, 3, 5});
    column.Repeat(length);
    column.Append(8);
    std::vector<double> expected = {1, 2, 3, 5};
    expected.insert(expected.end(), length, 5);
    expected.push_back(8);
    EXPECT_EQ(column.size(), expected.size());
    EXPECT_EQ(Read(column, expected.size()), expected) << length;
  }
}

TEST(PackedColumn, RepeatsWhatWasAppended) {
  PackedColumn repeated = Packed({0.1, 0.2});
  repeated.Repeat(0);
  repeated.Repeat(1);
  repeated.Repeat(4);
  EXPECT_EQ(Read(repeated, 7), (std::vector<double>{0.1, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2}));
}

TEST(PackedColumn, GoesOnWithItsLastValueAfterItsEnd) {
  EXPECT_EQ(Read(Packed({1, 2, 3}), 6), (std::vector<double>{1, 2, 3, 3, 3, 3}));
  EXPECT_EQ(Read(Packed({0.1, 0.7}), 3), (std::vector<double>{0.1, 0.7, 0.7}));
}

}  // namespace
}  // namespace oncard::runtime
