// What each operator yields, one value of each worked out by hand, and the values at the edges. The
// interpreter executes the same rows (image_test.cc).
#include "vm/arithmetic.h"
#include "tests/vm/raw_doubles.h"

#include <gtest/gtest.h>

#include <vector>

namespace oncard::vm {
namespace {

constexpr int64_t kIntMin = INT32_MIN;
constexpr int64_t kIntMax = INT32_MAX;

struct BinaryCase {
  BinaryOperator op;
  int64_t a;
  int64_t b;
  std::optional<int64_t> value;
};

TEST(ArithmeticTest, IntsWrapAndDivideTowardZero) {
  using enum BinaryOperator;
  for (const BinaryCase& c : std::vector<BinaryCase>{
           {kAdd, 7, -9, -2},
           {kAdd, kIntMax, 1, kIntMin},
           {kSubtract, kIntMin, 1, kIntMax},
           {kMultiply, -7, 6, -42},
           {kMultiply, 65536, 65536, 0},
           {kDivide, -7, 2, -3},
           {kDivide, -7, 3, -2},
           {kDivide, kIntMin, -1, kIntMin},
           {kDivide, 1, 0, std::nullopt},
           {kRemainder, -7, 4, -3},
           {kRemainder, 7, -5, 2},
           {kRemainder, kIntMin, -1, 0},
           {kRemainder, 1, 0, std::nullopt},
           {kLogicalAnd, 2, 4, 1},
           {kLogicalAnd, 2, 0, 0},
           {kLogicalOr, 0, 4, 1},
           {kLogicalOr, 0, 0, 0},
           {kEqual, 3, 3, 1},
           {kNotEqual, 3, 3, 0},
           {kLess, -1, 0, 1},
           {kGreater, -1, 0, 0},
           {kLessEqual, 3, 3, 1},
           {kGreaterEqual, 2, 3, 0},
           {kAnd, 12, 10, 8},
           {kOr, 12, 10, 14},
           {kXor, 12, 10, 6},
           {kShiftLeft, 3, 33, 6},
           {kShiftLeft, 1, 31, kIntMin},
           {kShiftRight, -7, 1, -4},
           {kShiftRight, 8, 34, 2},
       }) {
    EXPECT_EQ(EvaluateBinary(c.op, DataType::kInt, c.a, c.b, kWide), c.value)
        << c.a << ' ' << FindBinaryOperator(static_cast<uint16_t>(c.op))->spelling << ' ' << c.b;
  }
}

// A slot that held a double has bits above those of an int.
TEST(ArithmeticTest, AnIntIsTheLowHalfOfItsSlot) {
  constexpr int64_t kThree = 5 * (int64_t{1} << 32) + 3;
  EXPECT_EQ(EvaluateBinary(BinaryOperator::kAdd, DataType::kInt, kThree, kThree, kWide), 6);
  EXPECT_EQ(EvaluateUnary(UnaryOperator::kInvert, DataType::kInt, kThree, kWide), -4);
}

TEST(ArithmeticTest, DoublesAreFixedPointNumbers) {
  using enum BinaryOperator;
  for (const BinaryCase& c : std::vector<BinaryCase>{
           {kAdd, kOne, kOne / 2, 98304},
           {kSubtract, kOne, 3 * kOne, -131072},
           {kMultiply, -kOne / 2, 3, -1},  // -1.5 units of 2^-16
           {kDivide, kOne, 3 * kOne, 21845},
           {kDivide, kOne, 0, std::nullopt},
           {kLess, kOne / 2, kOne, 1},
           {kGreaterEqual, kOne / 2, kOne, 0},
       }) {
    EXPECT_EQ(EvaluateBinary(c.op, DataType::kDouble, c.a, c.b, kWide), c.value)
        << static_cast<int>(c.op);
  }
}

TEST(ArithmeticTest, DoublesWrapToTheirWidth) {
  constexpr int64_t kLargest = (int64_t{1} << 31) - 1;
  EXPECT_EQ(EvaluateBinary(BinaryOperator::kAdd, DataType::kDouble, kLargest, 1,
                           WrapShift(DoubleFormat::k16_16)),
            -kLargest - 1);
}

TEST(ArithmeticTest, UnaryOperators) {
  struct Case {
    UnaryOperator op;
    DataType type;
    int64_t source;
    int64_t value;
  };
  using enum UnaryOperator;
  for (const Case& c : {
           Case{kCopy, DataType::kInt, -5, -5},
           Case{kCopy, DataType::kDouble, int64_t{1} << 40, int64_t{1} << 40},
           Case{kNot, DataType::kInt, 0, 1},
           Case{kNot, DataType::kInt, 7, 0},
           Case{kInvert, DataType::kInt, 0, -1},
           Case{kAbs, DataType::kInt, -5, 5},
           Case{kAbs, DataType::kInt, kIntMin, kIntMin},
           Case{kFabs, DataType::kDouble, -kOne, kOne},
           Case{kToInt, DataType::kDouble, -3 * kOne / 2, -1},
           Case{kToDouble, DataType::kInt, -3, -196608},
       }) {
    EXPECT_EQ(EvaluateUnary(c.op, c.type, c.source, kWide), c.value)
        << FindUnaryOperator(static_cast<uint16_t>(c.op))->spelling << ' ' << c.source;
  }
}

TEST(ArithmeticTest, OnlyDivisionsStopAtZero) {
  for (const OperatorInfo& info : BinaryOperators()) {
    EXPECT_EQ(Divides(static_cast<BinaryOperator>(info.number)),
              info.spelling == "/" || info.spelling == "%")
        << info.spelling;
  }
}

}  // namespace
}  // namespace oncard::vm
