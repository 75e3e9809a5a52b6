// Statements that block their thread or change its page.
#include <gtest/gtest.h>

#include "tests/vm/program_builder.h"

namespace oncard::vm {
namespace {

using BlockingTest = MachineTest;

Instruction CountUp() { return Add(Local(0), Local(0), ImmediateInt(1)); }

// --- Delays --------------------------------------------------------------------------------------

TEST_F(BlockingTest, DelayEndsWhenThatManyCyclesHaveBegun) {
  LoadAndStart({Command(kDelay, {ImmediateInt(3)}), CountUp(), Goto(-2)});
  machine_.BeginCycle(10);
  EXPECT_EQ(machine_.Execute(25), 1) << "a blocked thread uses no budget";
  EXPECT_EQ(machine_.last_stop(), Stop::kIdle);
  EXPECT_EQ(machine_.thread(0).run, ThreadRun::kRunning);
  for (const int64_t cycle : {11, 12}) {
    machine_.BeginCycle(cycle);
    EXPECT_EQ(machine_.Execute(25), 0) << cycle;
  }
  machine_.BeginCycle(13);
  EXPECT_EQ(machine_.Execute(25), 3);
}

TEST_F(BlockingTest, IdleCyclesEndBeforeTheCycleInWhichAThreadCanRun) {
  EXPECT_EQ(machine_.IdleCycles(), INT64_MAX) << "no program";
  LoadAndStart({Command(kDelay, {ImmediateInt(3)}), CountUp(), Goto(-2)});
  machine_.BeginCycle(10);
  EXPECT_EQ(machine_.IdleCycles(), 0) << "about to run";
  machine_.Execute(25);
  EXPECT_EQ(machine_.IdleCycles(), 2) << "11 and 12";
  machine_.BeginCycle(12);
  EXPECT_EQ(machine_.IdleCycles(), 0);
  machine_.Pause(0);
  EXPECT_EQ(machine_.IdleCycles(), INT64_MAX) << "paused";
}

TEST_F(BlockingTest, DelayOfNothingDoesNotBlockAndLeavesNoTrace) {
  LoadAndStart({Command(kDelay, {ImmediateInt(0)}), CountUp(), Goto(-1)});
  machine_.BeginCycle(5);
  EXPECT_EQ(machine_.Execute(25), 25);
  EXPECT_EQ(machine_.thread(0).wake_cycle, 0);
}

TEST_F(BlockingTest, OthersUseTheBudgetOfADelayedThread) {
  Load({MakeFunction({Command(kDelay, {ImmediateInt(1)}), Goto(-1)}),
        MakeFunction({CountUp(), Goto(-1)})});
  Start(0, 1);
  Start(1, 2);
  EXPECT_EQ(machine_.Execute(25), 25);
  EXPECT_EQ(machine_.thread(0).executed, 1);
  EXPECT_EQ(machine_.thread(1).executed, 24);
}

TEST_F(BlockingTest, FunctionThatEndsInADelayFinishesWhenItIsOver) {
  LoadAndStart({CountUp(), Command(kDelay, {ImmediateInt(2)})});
  EXPECT_EQ(machine_.Execute(25), 2);
  EXPECT_EQ(machine_.thread(0).run, ThreadRun::kRunning);
  machine_.BeginCycle(1);
  machine_.Execute(25);
  EXPECT_EQ(machine_.thread(0).run, ThreadRun::kRunning);
  machine_.BeginCycle(2);
  EXPECT_EQ(machine_.Execute(25), 0) << "nothing is left to execute";
  EXPECT_EQ(machine_.thread(0).run, ThreadRun::kStopped);
  EXPECT_EQ(machine_.Line(0), 20);
}

TEST_F(BlockingTest, DelayGoesOnWhileTheThreadIsPaused) {
  LoadAndStart({Command(kDelay, {ImmediateInt(2)}), CountUp()});
  machine_.Execute(25);
  machine_.Pause(0);
  machine_.BeginCycle(2);
  EXPECT_EQ(machine_.Execute(25), 0);
  machine_.Run(0);
  EXPECT_EQ(machine_.Execute(25), 1);
}

TEST_F(BlockingTest, ASleepingThreadIsAtItsDelay) {
  LoadAndStart({CountUp(), Command(kDelay, {ImmediateInt(2)}), CountUp(), Goto(-3)});
  machine_.Execute(25);
  EXPECT_EQ(machine_.Line(0), 20);
  machine_.Pause(0);
  EXPECT_EQ(machine_.Line(0), 20);
  machine_.Run(0);
  machine_.BeginCycle(2);
  EXPECT_EQ(machine_.Line(0), 30) << "it is over";
}

TEST_F(BlockingTest, AWaitingThreadIsAtItsWait) {
  LoadAndStart({CountUp(), Command(kWaitFor, {Global(0), ImmediateInt(3)})});
  machine_.Execute(25);
  EXPECT_EQ(machine_.Line(0), 20);
}

// --- Waiting for a value -------------------------------------------------------------------------

TEST_F(BlockingTest, WaitEndsWhenTheVariableHasTheValue) {
  LoadAndStart({Command(kWaitFor, {Global(0), ImmediateInt(3)}), CountUp()});
  EXPECT_EQ(machine_.Execute(25), 1);
  SetGlobalInt(0, 2);
  EXPECT_EQ(machine_.Execute(25), 0);
  SetGlobalInt(0, 3);
  EXPECT_EQ(machine_.Execute(25), 1);
  EXPECT_EQ(LocalInt(0, 0), 1);
}

TEST_F(BlockingTest, WaitLooksAtTheValueOfTheMomentOnly) {
  LoadAndStart({Command(kWaitFor, {Global(0), ImmediateInt(3)}), CountUp()});
  machine_.Execute(1);
  SetGlobalInt(0, 3);
  SetGlobalInt(0, 4);
  EXPECT_EQ(machine_.Execute(25), 0);
}

TEST_F(BlockingTest, WaitThatHoldsAtOnceIsForgotten) {
  Policy policy;
  policy.quantum = 10;
  machine_.SetPolicy(policy);
  LoadAndStart({Command(kWaitFor, {Global(0), ImmediateInt(0)}), Set(Global(0), ImmediateInt(1)),
                CountUp(), Goto(-1)});
  EXPECT_EQ(machine_.Execute(2), 2);
  EXPECT_EQ(machine_.Execute(10), 10) << "the value has changed since";
}

TEST_F(BlockingTest, ThreadWakesAnotherOne) {
  Load({MakeFunction({Command(kWaitFor, {Global(0), ImmediateInt(1)}), CountUp()}),
        MakeFunction({CountUp(), CountUp(), Set(Global(0), ImmediateInt(1)), CountUp()})});
  Start(0, 1);
  Start(1, 2);
  EXPECT_EQ(machine_.Execute(100), 6);
  EXPECT_EQ(LocalInt(0, 0), 1);
  EXPECT_EQ(LocalInt(1, 0), 3);
}

TEST_F(BlockingTest, StepRefusesAWaitingThread) {
  Load({MakeFunction({Command(kWaitFor, {Global(0), ImmediateInt(1)}), CountUp()})});
  machine_.Bind(0, 1, 0);
  EXPECT_EQ(machine_.Step(0), kOk);
  EXPECT_EQ(machine_.Step(0), kRefused);
  SetGlobalInt(0, 1);
  EXPECT_EQ(machine_.Step(0), kOk);
}

// --- Pages ---------------------------------------------------------------------------------------

TEST_F(BlockingTest, NextStatementUsesTheNewPage) {
  LoadAndStart({CountUp(), Command(kUsePage, {ImmediateInt(7)}), CountUp(), CountUp()});
  EXPECT_EQ(machine_.Execute(25), 4);
  EXPECT_EQ(LocalInt(0, 0), 1);
  EXPECT_EQ(LocalInt(7, 0), 2);
  EXPECT_EQ(machine_.thread(0).page, 7);
  EXPECT_EQ(machine_.thread(0).error, kOk);
}

TEST_F(BlockingTest, PageIsRefusedOutOfRangeOrWhenAnotherBoundThreadHasIt) {
  const struct {
    int32_t page;
    int16_t code;
  } kCases[] = {{-1, kBadParameter}, {32, kBadParameter}, {4, kRefused}, {0, kOk}, {31, kOk}};
  for (const auto& c : kCases) {
    LoadAndStart({Command(kUsePage, {ImmediateInt(c.page)})});
    machine_.Bind(9, 1, 4);
    machine_.Execute(1);
    EXPECT_EQ(machine_.thread(0).error, c.code) << c.page;
    EXPECT_EQ(machine_.thread(0).page, c.code == kOk ? c.page : 0);
  }
}

TEST_F(BlockingTest, WaitRemembersThePageOfItsVariable) {
  LoadAndStart({Command(kWaitFor, {Local(1), ImmediateInt(1)}), CountUp()});
  machine_.Execute(25);
  SetLocalInt(0, 1, 1);
  EXPECT_EQ(machine_.Execute(25), 1);
}

}  // namespace
}  // namespace oncard::vm
