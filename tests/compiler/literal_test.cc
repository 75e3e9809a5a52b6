#include "compiler/literal.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

namespace oncard::compiler {
namespace {

using vm::DoubleFormat;

struct FixedCase {
  const char* text;
  int64_t raw;
};

class FixedLiteralTest : public testing::TestWithParam<FixedCase> {};

TEST_P(FixedLiteralTest, RoundsToTheNearestMultiple) {
  const Literal literal = ParseFixed(GetParam().text);
  ASSERT_TRUE(FixedValue(literal, DoubleFormat::k32_16).has_value());
  EXPECT_EQ(*FixedValue(literal, DoubleFormat::k32_16), GetParam().raw);
}

// Raw values are the numbers times 65536, calculated by hand.
INSTANTIATE_TEST_SUITE_P(
    Values, FixedLiteralTest,
    testing::Values(FixedCase{"0.0", 0}, FixedCase{"1.0", 65536}, FixedCase{"12.5", 819200},
                    FixedCase{".5", 32768}, FixedCase{"3.", 196608}, FixedCase{"1e2", 6553600},
                    FixedCase{"25e-2", 16384}, FixedCase{"0.0000152587890625", 1},
                    // Half a step is rounded away from zero, slightly less is rounded down.
                    FixedCase{"0.00000762939453125", 1}, FixedCase{"0.00000762939453124999999", 0},
                    FixedCase{"0.000022888183593750", 2},
                    FixedCase{"0.00002288818359374999999999999999", 1},
                    // 0.1 * 65536 = 6553.6
                    FixedCase{"0.1", 6554}, FixedCase{"1e-1", 6554},
                    FixedCase{"2147483647.99998", 140737488355327},
                    FixedCase{"000000000000000000000000001.5", 98304},
                    FixedCase{"0.000000000000000000000000000001e30", 65536},
                    FixedCase{"1e-999999999999", 0}));

TEST(FixedLiteral, IsExactWhereADoubleIsNot) {
  // A double's 53 bits cannot distinguish this number from the half step above it.
  const Literal literal = ParseFixed("1073741823.00000762939453124999999999999");
  EXPECT_EQ(*FixedValue(literal, DoubleFormat::k32_16), int64_t{1073741823} * 65536);
}

TEST(FixedLiteral, HasTheRangeOfItsFormat) {
  Literal literal = ParseFixed("2147483648.0");
  EXPECT_FALSE(FixedValue(literal, DoubleFormat::k32_16).has_value());
  literal.negative = true;
  EXPECT_EQ(*FixedValue(literal, DoubleFormat::k32_16), int64_t{-2147483648} * 65536);
  literal = ParseFixed("32768.0");
  EXPECT_FALSE(FixedValue(literal, DoubleFormat::k16_16).has_value());
  literal.negative = true;
  EXPECT_EQ(*FixedValue(literal, DoubleFormat::k16_16), int64_t{-32768} * 65536);
  EXPECT_FALSE(FixedValue(ParseFixed("1e999999999"), DoubleFormat::k32_16).has_value());
  EXPECT_FALSE(FixedValue(ParseFixed(std::string(1000, '9') + ".0"), DoubleFormat::k32_16));
  // Rounding up may exceed the range.
  EXPECT_FALSE(FixedValue(ParseFixed("2147483647.999999"), DoubleFormat::k32_16));
}

TEST(IntegerLiteral, HasTheRangeOfInt) {
  EXPECT_EQ(IntValue(ParseInteger("2147483647")), 2147483647);
  EXPECT_FALSE(IntValue(ParseInteger("2147483648")).has_value());
  Literal literal = ParseInteger("2147483648");
  literal.negative = true;
  EXPECT_EQ(IntValue(literal), INT32_MIN);
  literal.magnitude += 1;
  EXPECT_FALSE(IntValue(literal).has_value());
  EXPECT_FALSE(IntValue(ParseInteger(std::string(100, '9'))).has_value());
  EXPECT_FALSE(IntValue(ParseInteger("18446744073709551617")).has_value());
}

TEST(IntegerLiteral, WrapsHexadecimalsOf32Bits) {
  EXPECT_EQ(IntValue(ParseInteger("0x7FFFFFFF")), INT32_MAX);
  EXPECT_EQ(IntValue(ParseInteger("0x80000000")), INT32_MIN);
  EXPECT_EQ(IntValue(ParseInteger("0Xffffffff")), -1);
  EXPECT_FALSE(IntValue(ParseInteger("0x100000000")).has_value());
  Literal literal = ParseInteger("0x80000000");
  literal.negative = true;
  EXPECT_EQ(IntValue(literal), INT32_MIN);
}

TEST(IntegerLiteral, IsTheSameNumberAsADouble) {
  EXPECT_EQ(*FixedValue(ParseInteger("5"), DoubleFormat::k16_16), 5 * 65536);
  EXPECT_FALSE(FixedValue(ParseInteger("40000"), DoubleFormat::k16_16).has_value());
  EXPECT_EQ(*FixedValue(ParseInteger("40000"), DoubleFormat::k32_16), int64_t{40000} * 65536);
}

struct IntegerCase {
  const char* text;
  uint64_t magnitude;
  bool as_bits = false;
  bool is_unsigned = false;
};

class IntegerOfCTest : public testing::TestWithParam<IntegerCase> {};

TEST_P(IntegerOfCTest, HasTheValueAndTypeOfC) {
  const std::optional<Literal> literal = ParseIntegerOfC(GetParam().text);
  ASSERT_TRUE(literal.has_value());
  EXPECT_EQ(literal->magnitude, GetParam().magnitude);
  EXPECT_EQ(literal->as_bits, GetParam().as_bits);
  EXPECT_EQ(literal->is_unsigned, GetParam().is_unsigned);
}

// With C's rules for an int and a long of 32 bits.
INSTANTIATE_TEST_SUITE_P(
    Values, IntegerOfCTest,
    testing::Values(IntegerCase{"0", 0}, IntegerCase{"12", 12}, IntegerCase{"12L", 12},
                    IntegerCase{"12u", 12, false, true}, IntegerCase{"12Ul", 12, false, true},
                    IntegerCase{"12lU", 12, false, true}, IntegerCase{"017", 15, true},
                    IntegerCase{"00", 0, true}, IntegerCase{"037777777777", 4294967295, true, true},
                    IntegerCase{"0b101", 5, true}, IntegerCase{"0B0L", 0, true},
                    IntegerCase{"0x7FFFFFFF", 2147483647, true},
                    IntegerCase{"0x80000000", 2147483648, true, true},
                    IntegerCase{"0xAu", 10, true, true}, IntegerCase{"2147483648", 2147483648},
                    IntegerCase{"99999999999999999999999", kHuge},
                    IntegerCase{"0x40000000000000001", kHuge, true, true},
                    IntegerCase{"0xFFFFFFFFFFFFFFFF", kHuge, true, true}));

TEST(IntegerOfC, OfLongLongIsInvalid) {
  for (const char* text : {"1ll", "1ull", "1LLU", "0x1uLL"}) {
    const std::optional<Literal> literal = ParseIntegerOfC(text);
    ASSERT_TRUE(literal.has_value()) << text;
    EXPECT_TRUE(literal->invalid) << text;
  }
  EXPECT_FALSE(ParseIntegerOfC("1ul")->invalid);
}

struct BitsCase {
  const char* text;
  std::optional<uint64_t> bits;
};

TEST(IntegerOfC, HasAllBitsOfThePreprocessor) {
  for (const BitsCase& row : {BitsCase{"0xFFFFFFFFFFFFFFFF", 18446744073709551615u},
                              BitsCase{"18446744073709551615u", 18446744073709551615u},
                              BitsCase{"9223372036854775807LL", 9223372036854775807u},
                              BitsCase{"18446744073709551616", std::nullopt},
                              BitsCase{"0x10000000000000000", std::nullopt},
                              BitsCase{"0x40000000000000001", std::nullopt}}) {
    const std::optional<IntegerOfC> integer = ReadIntegerOfC(row.text);
    ASSERT_TRUE(integer.has_value()) << row.text;
    EXPECT_EQ(integer->bits, row.bits) << row.text;
  }
}

TEST(IntegerOfC, RefusesOtherTexts) {
  for (const char* text : {"", "u", "09", "0b2", "0b", "0x", "0xG", "1lL", "1uu", "1lul", "1lll",
                           "1f", "1.0", "12a", "-1", "1ulu", "1llul", "1'000"}) {
    EXPECT_FALSE(ParseIntegerOfC(text).has_value()) << text;
  }
}

TEST(Character, HasTheValueOfC) {
  const std::pair<const char*, int> values[] = {
      {"'a'", 97},     {"'0'", 48},   {"' '", 32},     {"'\"'", 34},      {"'\\''", 39},
      {"'\\n'", 10},   {"'\\0'", 0},  {"'\\12'", 10},  {"'\\177'", 127},  {"'\\377'", -1},
      {"'\\x41'", 65}, {"'\\x7'", 7}, {"'\\xff'", -1}, {"'\\x80'", -128}, {"'\\?'", 63}};
  for (const auto& [text, value] : values) EXPECT_EQ(CharacterValue(text), value) << text;
  for (const char* text : {"''", "'ab'", "'\\q'", "'\\x'", "'\\x100'", "'\\400'", "'\\0000'",
                           "'\\8'", "'\xC3\xA9'", "a"}) {
    EXPECT_EQ(CharacterValue(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace oncard::compiler
