// Threads: binding, running, stopping, pausing, stepping, and reading their state.
#include <gtest/gtest.h>

#include <functional>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

/// A thread brought into one of its states: thread 0, page 0.
enum class State { kUnbound, kStopped, kRunning, kPaused, kPeriodic, kFaulted };

void Bring(CommandTestCard& card, State state) {
  card.LoadTestProgram();
  if (state == State::kUnbound) return;
  const double function = state == State::kFaulted ? kFaultFunction : kLoopFunction;
  ASSERT_EQ(card.Call("GT_Bind", {0, function, 0}), 0);
  if (state == State::kStopped) return;
  if (state == State::kPeriodic) {
    ASSERT_EQ(card.Call("GT_Bind", {0, kIntFunction, 0}), 0);
    ASSERT_EQ(card.Call("GT_RunThreadPeriod", {0, 10, 4}), 0);
    card.Cycle();
    return;
  }
  ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
  card.Cycle();
  if (state == State::kPaused) {
    ASSERT_EQ(card.Call("GT_PauseThread", {0}), 0);
  }
}

std::vector<double> Status(CommandTestCard& card, double thread) {
  std::vector<double> cells(4);
  EXPECT_EQ(card.Call("GT_GetThreadSts", {thread, &cells}), 0);
  return cells;
}

TEST(ThreadCommand, CodeOfEveryCommandInEveryState) {
  struct {
    const char* name;
    std::vector<Argument> arguments;
    // unbound, stopped, running, paused, periodic, faulted
    int codes[6];
  } const rows[] = {
      {"GT_Bind", {0, kLoopFunction, 0}, {0, 0, 1, 1, 1, 0}},
      {"GT_RunThread", {0}, {1, 0, 1, 0, 1, 0}},
      {"GT_StopThread", {0}, {1, 0, 0, 0, 0, 0}},
      {"GT_PauseThread", {0}, {1, 1, 0, 1, 1, 1}},
      {"GT_StepThread", {0}, {1, 0, 1, 0, 1, 0}},
      {"GT_RunThreadToBreakpoint", {0, 10}, {1, 0, 1, 0, 7, 7}},
      {"GT_RunThreadPeriod", {0, 1, 4}, {1, 0, 1, 1, 1, 0}},
  };
  for (const auto& row : rows) {
    for (int state = 0; state < 6; ++state) {
      CommandTestCard card;
      Bring(card, static_cast<State>(state));
      const uint64_t before = card.Hash();
      EXPECT_EQ(card.Call(row.name, row.arguments), row.codes[state])
          << row.name << " in state " << state;
      if (row.codes[state] != 0) {
        EXPECT_EQ(card.Hash(), before) << row.name << state;
      }
    }
  }
}

TEST(ThreadCommand, ThreadNumberIsCheckedAtBothEnds) {
  for (const char* name : {"GT_RunThread", "GT_StopThread", "GT_PauseThread", "GT_StepThread"}) {
    CommandTestCard card;
    card.LoadTestProgram();
    EXPECT_EQ(card.Call(name, {-1}), 7) << name;
    EXPECT_EQ(card.Call(name, {32}), 7) << name;
    EXPECT_EQ(card.Call(name, {31}), 1) << name;
  }
}

TEST(Bind, RefusesWhatIsOutOfRangeOrUnknown) {
  struct {
    double thread, function, page;
    int code;
  } const cases[] = {
      {0, 1, 0, 0}, {31, 4, 31, 0}, {-1, 1, 0, 7}, {32, 1, 0, 7}, {0, 0, 0, 7},
      {0, 5, 0, 7}, {0, -1, 0, 7},  {0, 1, -1, 7}, {0, 1, 32, 7},
  };
  for (const auto& c : cases) {
    CommandTestCard card;
    card.LoadTestProgram();
    EXPECT_EQ(card.Call("GT_Bind", {c.thread, c.function, c.page}), c.code)
        << c.thread << " " << c.function << " " << c.page;
  }
}

TEST(Bind, WithoutAProgramNoFunctionExists) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_Bind", {0, 1, 0}), 7);
  EXPECT_EQ(card.reason.en, "no function has id 1; the program has 0 functions, numbered from 1");
}

TEST(Bind, APageBelongsToOneThread) {
  CommandTestCard card;
  card.LoadTestProgram();
  ASSERT_EQ(card.Call("GT_Bind", {0, kLoopFunction, 3}), 0);
  EXPECT_EQ(card.Call("GT_Bind", {1, kLoopFunction, 3}), 1);
  EXPECT_EQ(card.reason.en, "data page 3 belongs to another bound thread; choose another page");
  EXPECT_EQ(card.Call("GT_Bind", {0, kIntFunction, 3}), 0);
}

TEST(Bind, OneFunctionRunsOnManyThreads) {
  CommandTestCard card;
  card.LoadTestProgram();
  for (const double thread : {0.0, 1.0, 31.0}) {
    EXPECT_EQ(card.Call("GT_Bind", {thread, kLoopFunction, thread}), 0);
    EXPECT_EQ(card.Call("GT_RunThread", {thread}), 0);
  }
}

TEST(ThreadStatus, MapsRunToOneTwoAndZero) {
  const int expected[] = {0, 0, 1, 2, 0, 0};
  for (int state = 0; state < 6; ++state) {
    CommandTestCard card;
    Bring(card, static_cast<State>(state));
    EXPECT_EQ(Status(card, 0)[0], expected[state]) << state;
  }
}

TEST(ThreadStatus, OfAnUnboundThreadIsAllZero) {
  CommandTestCard card;
  card.LoadTestProgram();
  EXPECT_EQ(Status(card, 31), (std::vector<double>{0, 0, 0, 0}));
}

TEST(ThreadStatus, ResultIsAnIntOrAFixedPointNumber) {
  CommandTestCard card;
  card.LoadTestProgram();
  ASSERT_EQ(card.Call("GT_Bind", {0, kIntFunction, 0}), 0);
  ASSERT_EQ(card.Call("GT_Bind", {1, kDoubleFunction, 1}), 0);
  ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
  ASSERT_EQ(card.Call("GT_RunThread", {1}), 0);
  card.Cycle();
  EXPECT_EQ(Status(card, 0), (std::vector<double>{0, 0, 42, 21}));
  EXPECT_EQ(Status(card, 1), (std::vector<double>{0, 0, 2.5, 30}));
}

TEST(ThreadStatus, ErrorOfAFaultIsItsNumberAndLineItsPlace) {
  CommandTestCard card;
  Bring(card, State::kFaulted);
  EXPECT_EQ(Status(card, 0), (std::vector<double>{0, 100, 0, 40}));
}

TEST(PauseThread, HoldsTheThreadUntilItRunsAgain) {
  CommandTestCard card;
  Bring(card, State::kPaused);
  const int64_t executed = card.machine.thread(0).executed;
  card.Cycles(4);
  EXPECT_EQ(card.machine.thread(0).executed, executed);
  ASSERT_EQ(card.Call("GT_RunThread", {0}), 0);
  card.Cycle();
  EXPECT_EQ(card.machine.thread(0).executed, executed + 25);
}

TEST(StepThread, ExecutesOneStatementAndPauses) {
  CommandTestCard card;
  Bring(card, State::kStopped);
  ASSERT_EQ(card.Call("GT_StepThread", {0}), 0);
  EXPECT_EQ(Status(card, 0), (std::vector<double>{2, 0, 0, 11}));
  ASSERT_EQ(card.Call("GT_StepThread", {0}), 0);
  EXPECT_EQ(Status(card, 0), (std::vector<double>{2, 0, 0, 10}));
  EXPECT_EQ(card.machine.thread(0).executed, 2);
}

TEST(RunThreadToBreakpoint, PausesBeforeTheLine) {
  CommandTestCard card;
  Bring(card, State::kStopped);
  ASSERT_EQ(card.Call("GT_RunThreadToBreakpoint", {0, 11}), 0);
  card.Cycle();
  EXPECT_EQ(Status(card, 0), (std::vector<double>{2, 0, 0, 11}));
  EXPECT_EQ(card.machine.thread(0).executed, 1);
}

TEST(RunThreadToBreakpoint, RefusesALineWithoutAStatement) {
  for (const double line : {-1.0, 0.0, 9.0, 12.0, 20.0}) {
    CommandTestCard card;
    Bring(card, State::kStopped);
    EXPECT_EQ(card.Call("GT_RunThreadToBreakpoint", {0, line}), 7) << line;
  }
}

TEST(RunThreadPeriod, StartsTheFunctionEveryPeriodRoundedUpToCycles) {
  // 1 ms is 3 cycles of 375 us.
  CommandTestCard card({.cycle_us = 375});
  card.LoadTestProgram();
  ASSERT_EQ(card.Call("GT_Bind", {0, kIntFunction, 0}), 0);
  ASSERT_EQ(card.Call("GT_RunThreadPeriod", {0, 1, 4}), 0);
  card.Cycles(7);  // starts now, at cycle 3 and at cycle 6
  EXPECT_EQ(card.machine.state().executed, 6);
}

TEST(RunThreadPeriod, PeriodIsCheckedAtBothEnds) {
  struct {
    double ms;
    int code;
  } const cases[] = {{0, 7}, {1, 0}, {32767, 0}, {32768, 7}, {-1, 7}};
  for (const auto& c : cases) {
    CommandTestCard card;
    Bring(card, State::kStopped);
    EXPECT_EQ(card.Call("GT_RunThreadPeriod", {0, c.ms, 4}), c.code) << c.ms;
  }
}

TEST(GetThreadTime, GivesPeriodAndExecutionTimesInMilliseconds) {
  CommandTestCard card;
  card.LoadTestProgram();
  ASSERT_EQ(card.Call("GT_Bind", {0, kIntFunction, 0}), 0);
  ASSERT_EQ(card.Call("GT_RunThreadPeriod", {0, 5, 4}), 0);
  card.Cycle();
  std::vector<double> period(1);
  std::vector<double> time(1);
  std::vector<double> time_max(1);
  ASSERT_EQ(card.Call("GT_GetThreadTime", {0, &period, &time, &time_max}), 0);
  EXPECT_EQ(period[0], 5);
  EXPECT_DOUBLE_EQ(time[0], 0.02);  // two statements of 10 us
  EXPECT_DOUBLE_EQ(time_max[0], 0.02);
}

TEST(GetThread, GivesTheWholeRecord) {
  CommandTestCard card;
  card.LoadTestProgram();
  ASSERT_EQ(card.Call("GT_Bind", {2, kIntFunction, 7}), 0);
  ASSERT_EQ(card.Call("GT_RunThreadPeriod", {2, 5, 3}), 0);
  card.Cycle();
  std::vector<double> record(18);
  ASSERT_EQ(card.Call("GT_GetThread", {2, &record}), 0);
  // link address size page delay priority ptr status error result[4] resultType breakpoint period
  // count function
  EXPECT_EQ(record, (std::vector<double>{1, 0, 2, 7, 0, 3, 1, 0, 0, 42, 0, 0, 0, 1, 0, 5, 0, 2}));
}

TEST(GetThread, OfAnUnboundThreadSaysSo) {
  CommandTestCard card;
  std::vector<double> record(18, 9);
  ASSERT_EQ(card.Call("GT_GetThread", {0, &record}), 0);
  EXPECT_EQ(record[0], 0);
  EXPECT_EQ(record[2], 0);
  EXPECT_EQ(record[17], 0);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
