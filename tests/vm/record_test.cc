#include "vm/record.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "tests/vm/object_samples.h"
#include "vm/limits.h"

namespace oncard::vm {
namespace {

using Words = std::vector<uint16_t>;

struct RecordSample {
  std::string name;
  Instruction instruction;
  Words words;
};

// The expected words are derived by hand from the layout in docs/object-format.md.
std::vector<RecordSample> RecordSamples() {
  const Element local_by_local{Storage::kLocal, 4, 3, Local(9)};
  const Element global_by_local{Storage::kGlobal, 4, 3, Local(9)};
  const Element local_by_global{Storage::kLocal, 4, 3, Global(9)};
  const Element global_by_global{Storage::kGlobal, 4, 3, Global(9)};
  const DataType kInt = DataType::kInt;
  const DataType kDouble = DataType::kDouble;
  return {
      {"copy_of_a_variable",
       Unary(UnaryOperator::kCopy, kInt, Global(1023), Local(2)),
       {5, 0x5041, 1, 1023, 1, 2, 3, 0x000A, 3, 1}},
      {"copy_of_minus_one",
       Unary(UnaryOperator::kCopy, kInt, ImmediateInt(-1), Local(2)),
       {7, 0x5041, 1, 0xFFFF, 0xFFFF, 0, 1, 2, 2, 0x0008, 1}},
      {"copy_of_the_largest_int",
       Unary(UnaryOperator::kCopy, kInt, ImmediateInt(std::numeric_limits<int32_t>::max()),
             Local(2)),
       {7, 0x5041, 1, 0xFFFF, 0x7FFF, 0, 1, 2, 2, 0x0008, 1}},
      {"double_literal_minus_one_and_a_half",
       Unary(UnaryOperator::kCopy, kDouble, Raw(-0x18000), Global(2)),
       {7, 0x5041, 1, 0xFFFE, 0xFFFF, 0x8000, 2, 2, 2, 0x0008, 3}},
      {"smallest_double",
       Unary(UnaryOperator::kCopy, kDouble, Raw(-0x800000000000), Global(2)),
       {7, 0x5041, 1, 0x0000, 0x8000, 0x0000, 2, 2, 2, 0x0008, 3}},
      {"binary_of_two_literals",
       Binary(BinaryOperator::kShiftRight, kInt, ImmediateInt(0x10002), ImmediateInt(3), Local(0)),
       {10, 0x5040, 0x12, 2, 1, 0, 3, 0, 0, 1, 0, 2, 0x0010, 1}},
      {"element_of_local_array_by_local",
       Unary(UnaryOperator::kCopy, kInt, local_by_local, Local(2)),
       {5, 0x5041, 1, 4, 1, 2, 5, 0x000A, 0x11, 3, 9, 1}},
      {"element_of_global_array_by_local",
       Unary(UnaryOperator::kCopy, kInt, Local(2), global_by_local),
       {5, 0x5041, 1, 2, 1, 4, 5, 0x000A, 1, 0x13, 3, 9}},
      {"element_of_local_array_by_global",
       Unary(UnaryOperator::kCopy, kInt, local_by_global, Local(2)),
       {5, 0x5041, 1, 4, 1, 2, 5, 0x000A, 0x31, 3, 9, 1}},
      {"elements_everywhere",
       Binary(BinaryOperator::kAdd, kInt, global_by_global, local_by_local, global_by_local),
       {6, 0x5040, 1, 4, 4, 1, 4, 10, 0x0016, 0x33, 3, 9, 0x11, 3, 9, 0x13, 3, 9}},
      {"conditional_jump_back", Jump(Local(7), -1), {3, 0x5080, 7, 0xFFFF, 2, 0x0001, 1}},
      {"farthest_jump", Jump(ImmediateInt(1), 32767), {3, 0x5080, 1, 0x7FFF, 1, 0}},
      {"return_of_nothing",
       Return(ImmediateInt(1), ImmediateInt(0)),
       {5, 0x5081, 1, 0, 0, 0, 1, 0}},
      {"conditional_return_of_a_variable",
       Return(Global(1), Local(2)),
       {3, 0x5081, 1, 2, 3, 0x0003, 3, 1}},
      {"command_without_arguments", Command(0xFFFF, {}), {2, 0x5090, 0xFFFF, 1, 0}},
      {"command_with_every_kind_of_argument",
       Command(12, {ImmediateInt(1), Local(3), global_by_local}),
       {7, 0x5090, 12, 1, 0, 0, 3, 4, 5, 0x000C, 1, 0x13, 3, 9}},
      {"command_with_fifteen_variables",
       Command(kFifteen, std::vector<Operand>(15, Local(0))),
       {17, 0x5090, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        16, 0xFFFE, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}},
  };
}

class RecordTest : public testing::TestWithParam<RecordSample> {};

TEST_P(RecordTest, EncodesToTheWords) {
  EXPECT_EQ(EncodeRecord(GetParam().instruction), GetParam().words);
}

TEST_P(RecordTest, DecodesFromTheWords) {
  Words words = GetParam().words;
  const size_t count = words.size();
  words.push_back(0xABCD);  // the next record
  const Result<DecodedRecord> record = DecodeRecord(words);
  ASSERT_TRUE(record.ok()) << record.error().message.en;
  EXPECT_EQ(record.value().word_count, count);
  EXPECT_EQ(record.value().instruction, GetParam().instruction);
}

TEST_P(RecordTest, IsRefusedWhenCutOffAnywhere) {
  const Words& words = GetParam().words;
  for (size_t count = 0; count < words.size(); ++count) {
    const Result<DecodedRecord> record = DecodeRecord(std::span(words).first(count));
    ASSERT_FALSE(record.ok());
    EXPECT_EQ(record.error().code, 2008);
    EXPECT_EQ(record.error().message.en, "the record is truncated");
  }
}

INSTANTIATE_TEST_SUITE_P(RecordSamples, RecordTest, testing::ValuesIn(RecordSamples()),
                         [](const auto& row) { return row.param.name; });

struct BadRecord {
  std::string name;
  Words words;
  std::string message;
};

class BadRecordTest : public testing::TestWithParam<BadRecord> {};

TEST_P(BadRecordTest, IsRefusedWithTheReason) {
  const Result<DecodedRecord> record = DecodeRecord(GetParam().words);
  ASSERT_FALSE(record.ok());
  EXPECT_EQ(record.error().code, 2008);
  EXPECT_EQ(record.error().message.en, GetParam().message);
  EXPECT_FALSE(record.error().message.zh.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Rules, BadRecordTest,
    testing::ValuesIn(std::vector<BadRecord>{
        {"no_words", {0, 1, 0}, "the record is empty"},
        {"no_link_mask", {3, 0x5080, 1, 4, 0}, "the record has no link mask"},
        {"length_beyond_the_file", {0xFFFF, 0x5080}, "the record is truncated"},
        {"links_beyond_the_file", {3, 0x5080, 1, 4, 0xFFFF, 0}, "the record is truncated"},
        {"unknown_opcode", {3, 0x5082, 1, 4, 1, 0}, "opcode 0x5082 is not known"},
        {"operand_missing", {2, 0x5080, 1, 1, 0}, "the record ends within operand 1"},
        {"literal_cut_off", {4, 0x5081, 1, 5, 0, 1, 0}, "the record ends within operand 1"},
        {"word_too_many", {4, 0x5080, 1, 4, 0, 1, 0}, "1 words are left over"},
        {"link_missing", {3, 0x5080, 1, 4, 1, 1}, "the links end at operand 0"},
        {"element_link_missing",
         {5, 0x5041, 1, 0, 1, 2, 3, 0x000A, 0x11, 1},
         "the links end at operand 1"},
        {"link_too_many", {3, 0x5080, 1, 4, 2, 0, 1}, "1 link words are left over"},
        {"mask_beyond_the_operands",
         {3, 0x5080, 1, 4, 1, 0x0004},
         "link mask 0x0004 marks operands that do not exist; there are 2"},
        {"operator_flagged",
         {5, 0x5041, 1, 0, 1, 2, 4, 0x000B, 1, 1, 1},
         "operand 0 is marked as a variable, but can only be a number"},
        {"type_flagged",
         {5, 0x5041, 1, 0, 1, 2, 4, 0x000E, 1, 1, 1},
         "operand 2 is marked as a variable, but can only be a number"},
        {"displacement_flagged",
         {3, 0x5080, 1, 4, 2, 0x0002, 1},
         "operand 1 is marked as a variable, but can only be a number"},
        {"target_not_flagged",
         {5, 0x5041, 1, 0, 1, 2, 2, 0x0002, 1},
         "operand 3 is not a variable"},
        {"type_zero",
         {5, 0x5041, 1, 0, 0, 2, 3, 0x000A, 1, 1},
         "data type 0 is not known; 1 (int) or 2 (double) is expected"},
        {"type_three",
         {5, 0x5041, 1, 0, 3, 2, 3, 0x000A, 1, 1},
         "data type 3 is not known; 1 (int) or 2 (double) is expected"},
        {"storage_class_two",
         {3, 0x5080, 1, 4, 2, 1, 2},
         "storage class 0x2 of operand 0 is not known"},
        {"storage_class_with_a_bad_index",
         {3, 0x5080, 1, 4, 2, 1, 0x21},
         "storage class 0x21 of operand 0 is not known"},
        {"storage_class_with_a_high_byte",
         {3, 0x5080, 1, 4, 2, 1, 0x101},
         "storage class 0x101 of operand 0 is not known"},
        {"sixteen_arguments",
         {18, 0x5090, 8,      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
          0,  16,     0xFFFE, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1},
         "a command has more than 15 arguments"},
    }),
    [](const auto& row) { return row.param.name; });

TEST(RecordLengthTest, LongestRecordIsFifteenElements) {
  const Element element{Storage::kGlobal, 0, 1, Global(1)};
  const Words words = EncodeRecord(Command(1, std::vector<Operand>(kCommandArgumentMax, element)));
  EXPECT_EQ(words.size(), 1u + 17u + 1u + 1u + 45u);
  EXPECT_TRUE(DecodeRecord(words).ok());
}

}  // namespace
}  // namespace oncard::vm
