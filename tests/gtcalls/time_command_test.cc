// Clocks, delays, data pages, waiting for a variable.
#include <gtest/gtest.h>

#include <initializer_list>

#include "gtcalls/gts/catalogue.h"
#include "tests/gtcalls/command_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

using vm::DataType;
using vm::ImmediateInt;
using vm::Storage;

constexpr vm::Variable kResult{Storage::kLocal, 0};
constexpr vm::Variable kFlag{Storage::kGlobal, 0};

vm::Instruction CallOf(std::string_view name, std::vector<vm::Operand> operands) {
  return {.opcode = vm::Opcode::kCommand,
          .op = GtsCatalogue().Find(name)->number,
          .operands = std::move(operands)};
}

/// int f(int r): the given commands, then `r = 1`.
vm::Object ProgramOf(std::vector<vm::Instruction> commands) {
  commands.push_back({.opcode = vm::Opcode::kUnary,
                      .op = static_cast<uint16_t>(vm::UnaryOperator::kCopy),
                      .operands = {ImmediateInt(1), kResult}});
  vm::Object object;
  object.globals = {{"flag", 0, DataType::kInt, 0}};
  vm::Function function;
  function.name = "f";
  function.file = "test.c";
  function.lines.assign(commands.size(), 1);
  function.instructions = std::move(commands);
  function.variables = {{"r", 0, DataType::kInt, 0}};
  object.functions = {function};
  return object;
}

bool Done(const CommandTestCard& card, uint8_t page = 0) {
  return card.machine.ReadRaw({.global = false, .page = page, .id = 0}) == 1;
}

/// Cycles until the thread has executed its commands, without the cycle of the commands.
int CyclesUntilDone(CommandTestCard& card) {
  card.Cycle();
  int cycles = 0;
  while (!Done(card) && cycles < 100000) {
    card.Cycle();
    ++cycles;
  }
  return cycles;
}

TEST(Clock, ReadsMillisecondsAndProfileCyclesSinceReset) {
  for (const int64_t cycle_us : {250, 1000}) {
    CommandTestCard card({.cycle_us = cycle_us});
    card.Cycles(10);
    card.motion.Reset();
    card.Cycles(7);
    std::vector<double> clock(1);
    std::vector<double> loop(1);
    EXPECT_EQ(card.Call("GT_GetClock", {&clock, &loop}), 0);
    EXPECT_EQ(clock[0], cycle_us == 250 ? 1 : 7);  // 1.75 ms, 7 ms
    EXPECT_EQ(loop[0], 7);
    EXPECT_EQ(card.Call("GT_GetClockHighPrecision", {&clock}), 0);
    EXPECT_EQ(clock[0], cycle_us == 250 ? 14 : 56);
  }
}

TEST(Clock, LoopMayBeNull) {
  CommandTestCard card;
  std::vector<double> clock(1);
  EXPECT_EQ(card.Call("GT_GetClock", {&clock, nullptr}), 0);
}

TEST(Clock, WrapsAt32Bits) {
  CommandTestCard card;
  ChangeState(card.motion).clock_cycle = (int64_t{1} << 32) * 4 + 40;  // 2^32 ms and 10 ms
  std::vector<double> clock(1);
  std::vector<double> loop(1);
  EXPECT_EQ(card.Call("GT_GetClock", {&clock, &loop}), 0);
  EXPECT_EQ(clock[0], 10);
  EXPECT_EQ(loop[0], 40);
}

TEST(Delay, LastsItsMillisecondsRoundedUpToCycles) {
  struct {
    int64_t cycle_us;
    int32_t ms;
    int cycles;
  } const cases[] = {{250, 0, 0},  {250, 1, 4},  {250, 100, 400}, {1000, 1, 1}, {1000, 7, 7},
                     {4000, 1, 1}, {4000, 4, 1}, {4000, 5, 2},    {375, 1, 3}};
  for (const auto& c : cases) {
    CommandTestCard card({.cycle_us = c.cycle_us});
    card.Load(ProgramOf({CallOf("GT_Delay", {ImmediateInt(c.ms)})}));
    ASSERT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
    ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
    EXPECT_EQ(CyclesUntilDone(card), c.cycles) << c.ms << " ms at " << c.cycle_us << " us";
  }
}

TEST(DelayHighPrecision, LastsItsProfileCycles) {
  for (const int32_t cycles : {0, 1, 2, 33}) {
    CommandTestCard card;
    card.Load(ProgramOf({CallOf("GT_DelayHighPrecision", {ImmediateInt(cycles)})}));
    ASSERT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
    ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
    EXPECT_EQ(CyclesUntilDone(card), cycles);
  }
}

TEST(Delay, NegativeTimeInAProgramIsRefusedWithItsCode) {
  CommandTestCard card;
  card.Load(ProgramOf({CallOf("GT_Delay", {ImmediateInt(-1)})}));
  ASSERT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
  ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
  EXPECT_EQ(CyclesUntilDone(card), 0);
  EXPECT_EQ(card.machine.thread(0).error, 7);
}

TEST(ThreadCommand, FromTheHostIsRefused) {
  CommandTestCard card;
  std::vector<double> cell(1);
  EXPECT_EQ(card.Call("GT_Delay", {1}), 1);
  EXPECT_EQ(card.Call("GT_DelayHighPrecision", {1}), 1);
  EXPECT_EQ(card.Call("GT_SetDataPage", {1}), 1);
  EXPECT_EQ(card.Call("GT_WaitForVarEq", {&cell, 1}), 1);
}

TEST(SetDataPage, SwitchesTheThreadFromTheNextStatementOn) {
  CommandTestCard card;
  card.Load(ProgramOf({CallOf("GT_SetDataPage", {ImmediateInt(31)})}));
  ASSERT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
  ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
  card.Cycle();
  EXPECT_FALSE(Done(card, 0));
  EXPECT_TRUE(Done(card, 31));
}

TEST(SetDataPage, RefusesAPageThatDoesNotExistOrIsTaken) {
  struct {
    int32_t page;
    int code;
  } const cases[] = {{-1, 7}, {32, 7}, {5, 1}};
  for (const auto& c : cases) {
    CommandTestCard card;
    card.Load(ProgramOf({CallOf("GT_SetDataPage", {ImmediateInt(c.page)})}));
    ASSERT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
    ASSERT_EQ(card.Call("GT_Bind", {1, 1, 5}), 0);
    ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
    card.Cycle();
    EXPECT_EQ(card.machine.thread(0).error, c.code) << c.page;
    EXPECT_TRUE(Done(card, 0)) << c.page;
  }
}

TEST(WaitForVarEq, BlocksUntilTheVariableHasTheValue) {
  CommandTestCard card;
  card.Load(ProgramOf({CallOf("GT_WaitForVarEq", {kFlag, ImmediateInt(3)})}));
  ASSERT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
  ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
  card.Cycles(5);
  EXPECT_FALSE(Done(card));
  std::vector<double> info = {0, 1};
  std::vector<double> value = {2};
  ASSERT_EQ(card.Call("GT_SetVarValue", {-1, &info, &value, 1}), 0);
  card.Cycles(5);
  EXPECT_FALSE(Done(card));
  value[0] = 3;
  ASSERT_EQ(card.Call("GT_SetVarValue", {-1, &info, &value, 1}), 0);
  card.Cycle();
  EXPECT_TRUE(Done(card));
}

TEST(WaitForVarEq, DoesNotBlockWhenTheValueIsThere) {
  CommandTestCard card;
  card.Load(ProgramOf({CallOf("GT_WaitForVarEq", {kFlag, ImmediateInt(0)})}));
  ASSERT_EQ(card.Call("GT_Bind", {0, 1, 0}), 0);
  ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
  card.Cycle();
  EXPECT_TRUE(Done(card));
}

}  // namespace
}  // namespace oncard::gtcalls::gts
