// Download by words: GT_ClearPlc, GT_LoadPlc, GT_LoadPlcCommand.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

/// The records of the manual's example 10-1, as the vendor's compiler writes them: the sum of
/// begin..end. Locals: begin 0, end 1, i 2, cc 3; the sum is global 0.
const std::vector<std::vector<double>> kSumRecords = {
    {5, 0x5041, 1, 0, 1, 2, 3, 0x0A, 1, 1},
    {6, 0x5040, 0x0B, 2, 1, 1, 3, 4, 0x16, 1, 1, 1},
    {3, 0x5080, 3, 4, 2, 1, 1},
    {6, 0x5040, 1, 0, 2, 1, 0, 4, 0x16, 3, 1, 3},
    {8, 0x5040, 1, 2, 1, 0, 0, 1, 2, 3, 0x12, 1, 1},
    {3, 0x5080, 1, -4, 1, 0},
    {3, 0x5081, 1, 0, 2, 2, 3},
};

/// int f() { return 1; }
const std::vector<double> kReturnOne = {5, 0x5081, 1, 1, 0, 0, 1, 0};

int16_t LoadWords(CommandTestCard& card, double id, std::vector<double> words) {
  return card.Call("GT_LoadPlcCommand", {id, static_cast<double>(words.size()), &words});
}

void LoadSum(CommandTestCard& card, double id) {
  ASSERT_EQ(card.Call("GT_LoadPlc", {id, 1}), 0);
  for (const std::vector<double>& record : kSumRecords) ASSERT_EQ(LoadWords(card, id, record), 0);
}

TEST(PlcWords, TheManualsExampleRunsFromItsWords) {
  CommandTestCard card;
  LoadSum(card, 1);
  ASSERT_EQ(card.Call("GT_Bind", {0, 1, 5}), 0);
  std::vector<double> info = {0, 1};
  std::vector<double> range = {1, 10};
  ASSERT_EQ(card.Call("GT_SetVarValue", {5, &info, &range, 2}), 0);
  ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
  card.Cycles(10);
  std::vector<double> status(4);
  ASSERT_EQ(card.Call("GT_GetThreadSts", {0, &status}), 0);
  EXPECT_EQ(status[0], 0);
  EXPECT_EQ(status[2], 55);
}

TEST(PlcWords, RecordsMayBeCutAnywhere) {
  CommandTestCard card;
  std::vector<double> all;
  for (const auto& record : kSumRecords) all.insert(all.end(), record.begin(), record.end());
  ASSERT_EQ(card.Call("GT_LoadPlc", {1, 1}), 0);
  for (size_t first = 0; first < all.size(); first += 7) {
    const size_t last = std::min(all.size(), first + 7);
    ASSERT_EQ(LoadWords(card, 1,
                        {all.begin() + static_cast<std::ptrdiff_t>(first),
                         all.begin() + static_cast<std::ptrdiff_t>(last)}),
              0);
  }
  EXPECT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
}

TEST(PlcWords, NothingChangesBeforeBind) {
  CommandTestCard card;
  card.LoadTestProgram();
  const vm::Image* image = card.machine.image();
  LoadSum(card, 1);
  EXPECT_EQ(card.machine.image(), image);
  ASSERT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
  EXPECT_NE(card.machine.image(), image);
}

TEST(PlcWords, BindOfAFunctionThatWasNotReceivedLeavesTheProgram) {
  CommandTestCard card;
  card.LoadTestProgram();
  const vm::Image* image = card.machine.image();
  LoadSum(card, 1);
  EXPECT_EQ(card.Call("GT_Bind", {0, kIntFunction, 0}), 0);
  EXPECT_EQ(card.machine.image(), image);
}

TEST(PlcWords, BindingAgainDoesNotLoadAgain) {
  CommandTestCard card;
  LoadSum(card, 1);
  ASSERT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
  const vm::Image* image = card.machine.image();
  ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
  EXPECT_EQ(card.Call("GT_Bind", {1, 1, 1}), 0);
  EXPECT_EQ(card.machine.image(), image);
}

TEST(PlcWords, SeveralFunctionsBecomeOneProgram) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_LoadPlc", {2, 1}), 0);
  ASSERT_EQ(LoadWords(card, 2, kReturnOne), 0);
  LoadSum(card, 1);
  ASSERT_EQ(card.Call("GT_Bind", {0, 2, 0}), 0);
  ASSERT_EQ(card.Call("GT_Bind", {1, 1, 1}), 0);
  ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
  card.Cycle();
  std::vector<double> status(4);
  ASSERT_EQ(card.Call("GT_GetThreadSts", {0, &status}), 0);
  EXPECT_EQ(status[2], 1);
}

TEST(PlcWords, AGapInTheIdsIsRefused) {
  CommandTestCard card;
  LoadSum(card, 2);
  const uint64_t before = card.Hash();
  EXPECT_EQ(card.Call("GT_Bind", {0, 2, 0}), 7);
  EXPECT_EQ(card.reason.en, "function 1 is missing; ids must follow each other from 1");
  EXPECT_EQ(card.Hash(), before);
}

TEST(PlcWords, DamagedWordsAreRefusedAndTheProgramStays) {
  struct {
    const char* what;
    std::vector<double> words;
  } const cases[] = {
      {"cut off", {5, 0x5041, 1, 0}},
      {"unknown opcode", {3, 0x1234, 1, 0, 1, 0}},
      {"unknown operator", {5, 0x5041, 99, 0, 1, 2, 3, 0x0A, 1, 1}},
      {"jump out of the function", {3, 0x5080, 1, 4, 1, 0}},
      {"slot past the page", {5, 0x5041, 1, 0, 1, 1024, 3, 0x0A, 1, 1}},
      {"length zero", {0, 1, 0}},
  };
  for (const auto& c : cases) {
    CommandTestCard card;
    card.LoadTestProgram();
    const vm::Image* image = card.machine.image();
    ASSERT_EQ(card.Call("GT_LoadPlc", {1, 1}), 0);
    ASSERT_EQ(LoadWords(card, 1, c.words), 0) << c.what;
    EXPECT_EQ(card.Call("GT_Bind", {0, 1, 0}), 7) << c.what;
    EXPECT_EQ(card.machine.image(), image) << c.what;
  }
}

TEST(PlcWords, TheProgramIsNotReplacedWhileAThreadRuns) {
  CommandTestCard card;
  card.LoadTestProgram();
  ASSERT_EQ(card.Call("GT_Bind", {3, kLoopFunction, 3}), 0);
  ASSERT_EQ(card.Call("GT_RunThread", {3}), 0);
  LoadSum(card, 1);
  EXPECT_EQ(card.Call("GT_Bind", {0, 1, 0}), 1);
  EXPECT_EQ(card.Call("GT_ClearPlc"), 1);
  ASSERT_EQ(card.Call("GT_StopThread", {3}), 0);
  EXPECT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
}

TEST(PlcWords, ANewProgramReleasesTheBlocks) {
  CommandTestCard card;
  card.LoadTestProgram();
  ASSERT_TRUE(card.state().plc.Bind({.variable = 0, .function = FlankBlock{}}));
  LoadSum(card, 1);
  ASSERT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
  EXPECT_TRUE(card.state().plc.blocks.empty());
}

TEST(PlcWords, VariablesAreReachedByIdAndType) {
  CommandTestCard card;
  LoadSum(card, 1);
  ASSERT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
  std::vector<double> value = {1.5};
  for (const auto& [id, type, code] :
       {std::tuple{0, 1, 0}, {1023, 2, 0}, {1024, 1, 7}, {-1, 1, 7}, {0, 0, 7}, {0, 3, 7}}) {
    std::vector<double> info = {double(id), double(type)};
    EXPECT_EQ(card.Call("GT_SetVarValue", {-1, &info, &value, 1}), code) << id << " " << type;
  }
}

TEST(LoadPlc, IdAndReturnTypeAreCheckedAtBothEnds) {
  struct {
    double id, type;
    int code;
  } const cases[] = {{0, 1, 7}, {1, 1, 0}, {32, 1, 0}, {33, 1, 7}, {-1, 1, 7},
                     {1, 0, 0}, {1, 2, 0}, {1, 3, 7},  {1, -1, 7}};
  for (const auto& c : cases) {
    CommandTestCard card;
    EXPECT_EQ(card.Call("GT_LoadPlc", {c.id, c.type}), c.code) << c.id << " " << c.type;
  }
}

TEST(LoadPlc, OpeningAFunctionAnewDropsItsWords) {
  CommandTestCard card;
  LoadSum(card, 1);
  ASSERT_EQ(card.Call("GT_LoadPlc", {1, 1}), 0);
  EXPECT_TRUE(card.state().plc.functions[0].words.empty());
}

TEST(LoadPlcCommand, TakesOneToTwentyFourWords) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_LoadPlc", {1, 1}), 0);
  EXPECT_EQ(LoadWords(card, 1, {}), 7);
  EXPECT_EQ(LoadWords(card, 1, std::vector<double>(1)), 0);
  EXPECT_EQ(LoadWords(card, 1, std::vector<double>(24)), 0);
  EXPECT_EQ(LoadWords(card, 1, std::vector<double>(25)), 7);
}

TEST(LoadPlcCommand, NeedsAnOpenFunction) {
  CommandTestCard card;
  EXPECT_EQ(LoadWords(card, 1, {1}), 1);
  EXPECT_EQ(card.reason.en, "function 1 is not open; call GT_LoadPlc first");
}

TEST(LoadPlcCommand, StopsAtTheEndOfTheMemory) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_LoadPlc", {1, 1}), 0);
  ASSERT_EQ(card.Call("GT_LoadPlc", {2, 1}), 0);
  for (int i = 0; i < 170; ++i) ASSERT_EQ(LoadWords(card, 1 + i % 2, std::vector<double>(24)), 0);
  EXPECT_EQ(LoadWords(card, 1, std::vector<double>(17)), 1);  // 4080 + 17 > 4096
  EXPECT_EQ(LoadWords(card, 1, std::vector<double>(16)), 0);
  EXPECT_EQ(LoadWords(card, 2, std::vector<double>(1)), 1);
}

TEST(ClearPlc, EmptiesTheProgramMemory) {
  CommandTestCard card;
  card.LoadTestProgram();
  LoadSum(card, 1);
  EXPECT_EQ(card.Call("GT_ClearPlc"), 0);
  EXPECT_EQ(card.machine.image(), nullptr);
  EXPECT_TRUE(card.state().plc.functions.empty());
  EXPECT_EQ(card.Call("GT_Bind", {0, 1, 0}), 7);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
