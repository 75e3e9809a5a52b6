// Binding of PLC blocks by command: ranges, variables, threads.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

constexpr double kIntType = 1;

int16_t Bind(CommandTestCard& card, const char* name, double thread, double variable,
             std::vector<double> prm) {
  std::vector<double> info = {variable, kIntType};
  return card.Call(name, {thread, &info, &prm});
}

/// A block with valid members for the global ints 0, 2, 3 and 4 or the locals 0, 2 to 5.
struct Valid {
  const char* name;
  std::vector<double> prm;
};
const Valid kValid[] = {
    {"GT_BindDi", {4, 16, 0}},     {"GT_BindDo", {12, 16, 0}},
    {"GT_BindTimer", {0, 100, 2}}, {"GT_BindCounter", {0, 0, 0, 5, 0, 0, 1, 1, 2, -1}},
    {"GT_BindFlank", {0, 2}},      {"GT_BindSrff", {2, 3}},
};

TEST(PlcBind, EveryBlockBindsToGlobalsAndToAThread) {
  for (const Valid& block : kValid) {
    CommandTestCard card;
    card.LoadTestProgram();
    ASSERT_EQ(card.Call("GT_Bind", {31, kLoopFunction, 0}), 0);
    EXPECT_EQ(Bind(card, block.name, -1, 0, block.prm), 0) << block.name;
    EXPECT_EQ(Bind(card, block.name, 31, 0, block.prm), 0) << block.name;
    EXPECT_EQ(card.state().plc.blocks.size(), block.name == kValid[1].name ? 1u : 2u) << block.name;
  }
}

TEST(PlcBind, RefusesAnUnboundThreadAndANumberOutOfRange) {
  for (const Valid& block : kValid) {
    CommandTestCard card;
    card.LoadTestProgram();
    EXPECT_EQ(Bind(card, block.name, 0, 0, block.prm), 1) << block.name;
    EXPECT_EQ(Bind(card, block.name, 32, 0, block.prm), 7) << block.name;
    EXPECT_EQ(Bind(card, block.name, -2, 0, block.prm), 7) << block.name;
    EXPECT_TRUE(card.state().plc.blocks.empty());
  }
}

TEST(PlcBind, RefusesGlobalsWithoutAProgram) {
  for (const Valid& block : kValid) {
    CommandTestCard card;
    EXPECT_EQ(Bind(card, block.name, -1, 0, block.prm), 1) << block.name;
  }
}

TEST(PlcBind, RefusesWhatIsNoIntVariable) {
  for (const Valid& block : kValid) {
    CommandTestCard card;
    card.LoadTestProgram();
    for (const double id : {-1.0, 1.0, 5.0, 1023.0, 1024.0, 32767.0}) {
      EXPECT_EQ(Bind(card, block.name, -1, id, block.prm), 7) << block.name << " " << id;
    }
    EXPECT_EQ(Bind(card, block.name, -1, 4, block.prm), 0) << block.name;
  }
}

TEST(PlcBind, MembersAreCheckedAtBothEnds) {
  struct {
    const char* name;
    size_t member;
    double value;
    int code;
  } const cases[] = {
      {"GT_BindDi", 0, -1, 7},
      {"GT_BindDi", 0, 7, 7},
      {"GT_BindDi", 1, 0, 7},
      {"GT_BindDi", 1, 1, 0},
      {"GT_BindDi", 1, 17, 7},
      {"GT_BindDi", 2, 1, 0},
      {"GT_BindDo", 0, 9, 7},
      {"GT_BindDo", 0, 13, 7},
      {"GT_BindDo", 1, 0, 7},
      {"GT_BindDo", 1, 17, 7},
      {"GT_BindDo", 0, 10, 7},
      {"GT_BindTimer", 0, -1, 7},
      {"GT_BindTimer", 0, 2, 0},
      {"GT_BindTimer", 0, 3, 7},
      {"GT_BindTimer", 1, -1, 7},
      {"GT_BindTimer", 1, 0, 0},
      {"GT_BindTimer", 1, 2147483647, 0},
      {"GT_BindTimer", 2, 1, 7},
      {"GT_BindTimer", 2, -1, 7},
      {"GT_BindCounter", 0, -1, 7},
      {"GT_BindCounter", 0, 3, 7},
      {"GT_BindCounter", 1, 3, 7},
      {"GT_BindCounter", 2, 2147483648.0, 7},
      {"GT_BindCounter", 4, 1, 7},
      {"GT_BindCounter", 4, -1, 0},
      {"GT_BindCounter", 5, -1, 7},
      {"GT_BindCounter", 6, -1, 0},
      {"GT_BindCounter", 6, -2, 7},
      {"GT_BindCounter", 6, 2, 7},
      {"GT_BindCounter", 7, 0, 7},
      {"GT_BindCounter", 7, 4294967295.0, 0},
      {"GT_BindCounter", 8, 1, 7},
      {"GT_BindCounter", 9, 1, 7},
      {"GT_BindCounter", 9, 3, 0},
      {"GT_BindFlank", 0, -1, 7},
      {"GT_BindFlank", 0, 2, 0},
      {"GT_BindFlank", 0, 3, 7},
      {"GT_BindFlank", 1, 1, 7},
      {"GT_BindSrff", 0, 1, 7},
      {"GT_BindSrff", 1, 5, 7},
  };
  for (const auto& c : cases) {
    CommandTestCard card;
    card.LoadTestProgram();
    std::vector<double> prm;
    for (const Valid& block : kValid) {
      if (std::string_view(block.name) == c.name) prm = block.prm;
    }
    prm[c.member] = c.value;
    const uint64_t before = card.Hash();
    EXPECT_EQ(Bind(card, c.name, -1, 0, prm), c.code)
        << c.name << "[" << c.member << "] " << c.value;
    if (c.code != 0) {
      EXPECT_EQ(card.Hash(), before);
    }
  }
}

TEST(PlcBind, CounterStartsWithinItsBounds) {
  CommandTestCard card;
  card.LoadTestProgram();
  EXPECT_EQ(Bind(card, "GT_BindCounter", -1, 0, {0, 0, 4, 5, 1, 3, 1, 1, 2, -1}), 7);
  EXPECT_EQ(Bind(card, "GT_BindCounter", -1, 0, {0, 0, 0, 5, 1, 3, 1, 1, 2, -1}), 7);
  EXPECT_EQ(Bind(card, "GT_BindCounter", -1, 0, {0, 0, 3, 5, 1, 3, 1, 1, 2, -1}), 0);
}

TEST(PlcBind, TheReasonNamesTheMember) {
  CommandTestCard card;
  card.LoadTestProgram();
  EXPECT_EQ(Bind(card, "GT_BindTimer", -1, 0, {3, 100, 2}), 7);
  EXPECT_EQ(card.reason.en, "TBindTimer.timerType is 3; the range is [0, 2]");
}

TEST(PlcBind, AnInputThatIsOnAlreadyMakesNoEdge) {
  CommandTestCard card;
  card.LoadTestProgram();
  card.machine.WriteRaw({.global = true, .id = 2}, 1);
  ASSERT_EQ(Bind(card, "GT_BindFlank", -1, 0, {2, 2}), 0);
  card.Cycle();
  EXPECT_EQ(card.machine.ReadRaw({.global = true, .id = 0}), 0);
}

TEST(PlcBind, DiToTimerToDoWorksThroughTheCommands) {
  // Input 1 on -> variable ga[0] -> on-delay of 1 ms -> g -> output 16.
  CommandTestCard card;
  card.LoadTestProgram();
  ASSERT_EQ(Bind(card, "GT_BindDi", -1, 2, {4, 1, 0}), 0);
  ASSERT_EQ(Bind(card, "GT_BindTimer", -1, 0, {0, 1, 2}), 0);
  ASSERT_EQ(Bind(card, "GT_BindDo", -1, 0, {12, 16, 0}), 0);
  card.motion.digital_io().SetPin(motion::DiType::kGpi, 0, true);
  card.Cycles(3 + 3);  // it passes the filter in cycle 3, the timer 4 cycles later
  EXPECT_EQ(card.motion.state().io.Register(motion::DoType::kGpo), 0u);
  card.Cycle();
  EXPECT_EQ(card.motion.state().io.Register(motion::DoType::kGpo), 0x8000u);
}

TEST(UnbindVar, RemovesTheBlocksOfItsThread) {
  CommandTestCard card;
  card.LoadTestProgram();
  ASSERT_EQ(card.Call("GT_Bind", {0, kLoopFunction, 0}), 0);
  ASSERT_EQ(Bind(card, "GT_BindFlank", -1, 0, {0, 2}), 0);
  ASSERT_EQ(Bind(card, "GT_BindFlank", 0, 0, {0, 2}), 0);
  EXPECT_EQ(card.Call("GT_UnbindVar", {0}), 0);
  ASSERT_EQ(card.state().plc.blocks.size(), 1u);
  EXPECT_EQ(card.Call("GT_UnbindVar", {-1}), 0);
  EXPECT_TRUE(card.state().plc.blocks.empty());
  EXPECT_EQ(card.Call("GT_UnbindVar", {-2}), 7);
  EXPECT_EQ(card.Call("GT_UnbindVar", {32}), 7);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
