// The operations of hosts on threads, and their codes: bind, run, stop, pause, step, breakpoints,
// periodic starts.
#include "vm/machine.h"

#include <functional>
#include <limits>

#include "tests/vm/program_builder.h"

namespace oncard::vm {
namespace {

// Counts in local slot 0 forever: lines 10 and 20.
Function Counter() { return MakeFunction({Add(Local(0), Local(0), ImmediateInt(1)), Goto(-1)}); }
// Three statements on lines 10, 20 and 30.
Function Three() {
  return MakeFunction({Set(Local(0), ImmediateInt(1)), Set(Local(0), ImmediateInt(2)),
                       Return(kAlways, ImmediateInt(7))});
}

class ThreadTest : public MachineTest {
 protected:
  ThreadRun RunOf(int thread) const { return machine_.thread(thread).run; }
};

// --- Arguments -----------------------------------------------------------------------------------

TEST_F(ThreadTest, EveryCallRefusesThreadsOutOfRange) {
  Load({Counter()});
  const std::function<int16_t(int)> calls[] = {
      [&](int thread) { return machine_.Bind(thread, 1, 0); },
      [&](int thread) { return machine_.Run(thread); },
      [&](int thread) { return machine_.StopThread(thread); },
      [&](int thread) { return machine_.Pause(thread); },
      [&](int thread) { return machine_.Step(thread); },
      [&](int thread) { return machine_.RunToBreakpoint(thread, 10); },
      [&](int thread) { return machine_.RunPeriodic(thread, 4, 4); },
  };
  for (const auto& call : calls) {
    EXPECT_EQ(call(-1), kBadParameter);
    EXPECT_EQ(call(32), kBadParameter);
  }
  EXPECT_FALSE(machine_.ExecuteOne(-1));
  EXPECT_FALSE(machine_.ExecuteOne(32));
}

TEST_F(ThreadTest, EveryCallButBindRefusesAnUnboundThread) {
  Load({Counter()});
  EXPECT_EQ(machine_.Run(0), kRefused);
  EXPECT_EQ(machine_.StopThread(0), kRefused);
  EXPECT_EQ(machine_.Pause(0), kRefused);
  EXPECT_EQ(machine_.Step(0), kRefused);
  EXPECT_EQ(machine_.RunToBreakpoint(0, 10), kRefused);
  EXPECT_EQ(machine_.RunPeriodic(0, 4, 4), kRefused);
  EXPECT_FALSE(machine_.ExecuteOne(0));
}

// --- Bind ----------------------------------------------------------------------------------------

TEST_F(ThreadTest, BindChecksFunctionAndPage) {
  EXPECT_EQ(machine_.Bind(0, 1, 0), kBadParameter) << "nothing is loaded";
  Load({Counter(), Three()});
  const struct {
    int function;
    int page;
    int16_t code;
  } kCases[] = {{0, 0, kBadParameter},
                {-1, 0, kBadParameter},
                {3, 0, kBadParameter},
                {1, -1, kBadParameter},
                {1, 32, kBadParameter},
                {1, 31, kOk},
                {2, 0, kOk}};
  for (const auto& c : kCases) {
    EXPECT_EQ(machine_.Bind(31, c.function, c.page), c.code) << c.function << ' ' << c.page;
  }
  EXPECT_EQ(RunOf(31), ThreadRun::kStopped);
  EXPECT_EQ(machine_.thread(31).function, 1);
  EXPECT_EQ(machine_.thread(31).page, 0);
}

TEST_F(ThreadTest, BindRefusesARunningOrPausedThread) {
  LoadAndStart(Counter().instructions);
  EXPECT_EQ(machine_.Bind(0, 1, 0), kRefused);
  machine_.Pause(0);
  EXPECT_EQ(machine_.Bind(0, 1, 0), kRefused);
  machine_.StopThread(0);
  EXPECT_EQ(machine_.Bind(0, 1, 5), kOk);
}

TEST_F(ThreadTest, APageBelongsToOneBoundThread) {
  Load({Counter()});
  ASSERT_EQ(machine_.Bind(0, 1, 3), kOk);
  EXPECT_EQ(machine_.Bind(1, 1, 3), kRefused) << "a stopped thread keeps its page";
  EXPECT_EQ(machine_.Bind(0, 1, 3), kOk) << "its own page";
  EXPECT_EQ(machine_.Bind(0, 1, 4), kOk);
  EXPECT_EQ(machine_.Bind(1, 1, 3), kOk) << "free again";
}

TEST_F(ThreadTest, OneFunctionRunsOnManyThreads) {
  Load({Counter()});
  for (int thread = 0; thread < kThreadCount; ++thread) Start(thread);
  EXPECT_EQ(machine_.Execute(2 * kThreadCount), 2 * kThreadCount);
  for (int page = 0; page < kPageCount; ++page) EXPECT_EQ(LocalInt(page, 0), 1);
}

// --- Run and stop --------------------------------------------------------------------------------

TEST_F(ThreadTest, RunStartsAtTheTopAndKeepsThePage) {
  LoadAndStart({Add(Local(0), Local(0), ImmediateInt(1)), Return(kAlways, Local(0))});
  EXPECT_EQ(machine_.Run(0), kRefused) << "already running";
  EXPECT_EQ(machine_.Execute(10), 2);
  EXPECT_EQ(machine_.last_stop(), Stop::kIdle);
  EXPECT_EQ(machine_.thread(0).result, 1);
  EXPECT_EQ(machine_.Run(0), kOk);
  EXPECT_EQ(machine_.thread(0).result, 0) << "cleared by the start";
  EXPECT_EQ(machine_.thread(0).executed, 0);
  machine_.Execute(10);
  EXPECT_EQ(machine_.thread(0).result, 2) << "the page was not cleared";
}

TEST_F(ThreadTest, StoppedThreadStartsFromTheTop) {
  LoadAndStart(Three().instructions);
  machine_.Execute(1);
  EXPECT_EQ(machine_.StopThread(0), kOk);
  EXPECT_EQ(RunOf(0), ThreadRun::kStopped);
  EXPECT_EQ(machine_.Line(0), 20) << "where it was stopped";
  EXPECT_EQ(machine_.Execute(5), 0);
  EXPECT_EQ(machine_.StopThread(0), kOk) << "stopping twice does no harm";
  machine_.Run(0);
  EXPECT_EQ(machine_.Line(0), 10);
  EXPECT_EQ(machine_.Execute(5), 3);
}

TEST_F(ThreadTest, StopEndsADelay) {
  LoadAndStart({Command(kDelay, {ImmediateInt(1000)}), Set(Local(0), ImmediateInt(1))});
  machine_.Execute(5);
  machine_.StopThread(0);
  EXPECT_EQ(machine_.thread(0).wake_cycle, 0);
  machine_.Run(0);
  EXPECT_EQ(machine_.Execute(5), 1) << "the delay anew";
}

TEST_F(ThreadTest, PausedThreadResumesWhereItWas) {
  LoadAndStart(Three().instructions);
  machine_.Execute(1);
  EXPECT_EQ(machine_.Pause(0), kOk);
  EXPECT_EQ(machine_.Pause(0), kRefused) << "not running";
  EXPECT_EQ(RunOf(0), ThreadRun::kPaused);
  EXPECT_EQ(machine_.Execute(5), 0);
  EXPECT_EQ(machine_.Line(0), 20);
  EXPECT_EQ(machine_.Run(0), kOk);
  EXPECT_EQ(machine_.Execute(5), 2);
  EXPECT_EQ(machine_.Pause(0), kRefused) << "finished";
}

// --- Step ----------------------------------------------------------------------------------------

TEST_F(ThreadTest, StepExecutesOneStatementAndPauses) {
  Load({Three()});
  machine_.Bind(0, 1, 0);
  EXPECT_EQ(machine_.Step(0), kOk) << "of a stopped thread";
  EXPECT_EQ(RunOf(0), ThreadRun::kPaused);
  EXPECT_EQ(machine_.Line(0), 20);
  EXPECT_EQ(LocalInt(0, 0), 1);
  EXPECT_EQ(machine_.Step(0), kOk) << "of a paused thread";
  EXPECT_EQ(machine_.Line(0), 30);
  EXPECT_EQ(machine_.Step(0), kOk);
  EXPECT_EQ(RunOf(0), ThreadRun::kStopped) << "it has finished";
  EXPECT_EQ(machine_.thread(0).result, 7);
  EXPECT_EQ(machine_.state().executed, 3);
}

TEST_F(ThreadTest, StepRefusesARunningOrDelayedThread) {
  LoadAndStart({Command(kDelay, {ImmediateInt(4)}), Set(Local(0), ImmediateInt(1)), Goto(-1)});
  EXPECT_EQ(machine_.Step(0), kRefused) << "running";
  machine_.Pause(0);
  EXPECT_EQ(machine_.Step(0), kOk);
  EXPECT_EQ(machine_.Step(0), kRefused) << "delayed";
  EXPECT_EQ(RunOf(0), ThreadRun::kPaused);
  machine_.BeginCycle(4);
  EXPECT_EQ(machine_.Step(0), kOk);
  EXPECT_EQ(LocalInt(0, 0), 1);
}

// --- Breakpoints ---------------------------------------------------------------------------------

TEST_F(ThreadTest, RunToBreakpointPausesBeforeTheLine) {
  Load({Three()});
  machine_.Bind(0, 1, 0);
  EXPECT_EQ(machine_.RunToBreakpoint(0, 25), kBadParameter) << "no statement there";
  EXPECT_EQ(machine_.RunToBreakpoint(0, 0), kBadParameter);
  EXPECT_EQ(RunOf(0), ThreadRun::kStopped);
  EXPECT_EQ(machine_.RunToBreakpoint(0, 30), kOk);
  EXPECT_EQ(machine_.RunToBreakpoint(0, 30), kRefused) << "running";
  EXPECT_EQ(machine_.Execute(100), 2);
  EXPECT_EQ(RunOf(0), ThreadRun::kPaused);
  EXPECT_EQ(machine_.Line(0), 30);
  EXPECT_EQ(machine_.thread(0).breakpoint_line, 0) << "used up";
  machine_.Run(0);
  EXPECT_EQ(machine_.Execute(100), 1);
}

TEST_F(ThreadTest, BreakpointOnTheFirstLinePausesAtOnce) {
  Load({Three()});
  machine_.Bind(0, 1, 0);
  EXPECT_EQ(machine_.RunToBreakpoint(0, 10), kOk);
  EXPECT_EQ(RunOf(0), ThreadRun::kPaused);
  EXPECT_EQ(machine_.Execute(100), 0);
}

TEST_F(ThreadTest, PausedAtTheLineItGoesOnToTheNextTime) {
  Load({Counter()});
  machine_.Bind(0, 1, 0);
  machine_.RunToBreakpoint(0, 20);
  EXPECT_EQ(machine_.Execute(100), 1);
  EXPECT_EQ(machine_.RunToBreakpoint(0, 20), kOk);
  EXPECT_EQ(machine_.Execute(100), 2);
  EXPECT_EQ(LocalInt(0, 0), 2);
}

TEST_F(ThreadTest, RunForgetsTheBreakpoint) {
  Load({Counter()});
  machine_.Bind(0, 1, 0);
  machine_.RunToBreakpoint(0, 20);
  machine_.Pause(0);
  machine_.Run(0);
  EXPECT_EQ(machine_.Execute(10), 10);
}

TEST_F(ThreadTest, OtherThreadsRunOnWhenOneReachesItsBreakpoint) {
  Load({Counter()});
  Start(5);
  machine_.Bind(2, 1, 2);
  machine_.RunToBreakpoint(2, 20);
  EXPECT_EQ(machine_.Execute(100), 100);
  EXPECT_EQ(machine_.thread(2).executed, 1);
  EXPECT_EQ(machine_.thread(5).executed, 99);
}

// --- Periodic starts -----------------------------------------------------------------------------

TEST_F(ThreadTest, RunPeriodicStartsAnewEveryPeriod) {
  Load({MakeFunction({Add(Local(0), Local(0), ImmediateInt(1))})});
  machine_.Bind(0, 1, 0);
  EXPECT_EQ(machine_.RunPeriodic(0, 0, 4), kBadParameter);
  machine_.BeginCycle(10);
  EXPECT_EQ(machine_.RunPeriodic(0, 4, 2), kOk);
  EXPECT_EQ(machine_.thread(0).priority, 2);
  for (int cycle = 10; cycle < 22; ++cycle) {
    machine_.BeginCycle(cycle);
    machine_.Execute(25);
    EXPECT_EQ(LocalInt(0, 0), (cycle - 10) / 4 + 1) << cycle;
  }
  EXPECT_EQ(machine_.thread(0).overruns, 0);
  EXPECT_EQ(machine_.thread(0).executed_max, 1);
  EXPECT_FALSE(machine_.Quiet()) << "it starts again";
}

TEST_F(ThreadTest, PeriodicThreadIsActiveBetweenItsStarts) {
  Load({MakeFunction({Set(Local(0), ImmediateInt(1))})});
  machine_.Bind(0, 1, 0);
  machine_.RunPeriodic(0, 4, 4);
  machine_.Execute(5);
  EXPECT_EQ(machine_.Bind(0, 1, 0), kRefused);
  EXPECT_EQ(machine_.Run(0), kRefused);
  EXPECT_EQ(machine_.RunPeriodic(0, 4, 4), kRefused);
  EXPECT_EQ(machine_.StopThread(0), kOk);
  machine_.BeginCycle(4);
  EXPECT_EQ(machine_.Execute(5), 0) << "stopping ends the periodic starts";
  EXPECT_TRUE(machine_.Quiet());
}

TEST_F(ThreadTest, AnOverrunIsCountedAndNotQueued) {
  Load({MakeFunction({Command(kDelay, {ImmediateInt(9)}), Add(Local(0), Local(0), kAlways)})});
  machine_.Bind(0, 1, 0);
  machine_.RunPeriodic(0, 4, 4);
  for (int cycle = 0; cycle < 12; ++cycle) {
    machine_.BeginCycle(cycle);
    machine_.Execute(25);
  }
  EXPECT_EQ(machine_.thread(0).overruns, 2) << "at cycles 4 and 8";
  EXPECT_EQ(LocalInt(0, 0), 1);
}

TEST_F(ThreadTest, StartsThatTheClockJumpedOverAreOverruns) {
  Load({MakeFunction({Add(Local(0), Local(0), kAlways)})});
  machine_.Bind(0, 1, 0);
  machine_.RunPeriodic(0, 10, 4);
  machine_.Execute(5);
  machine_.BeginCycle(35);
  machine_.Execute(5);
  EXPECT_EQ(LocalInt(0, 0), 2);
  EXPECT_EQ(machine_.thread(0).overruns, 2) << "those of cycles 20 and 30";
  machine_.BeginCycle(36);
  EXPECT_EQ(machine_.Execute(5), 0);
  machine_.BeginCycle(40);
  EXPECT_EQ(machine_.Execute(5), 1);
}

// --- Ends ----------------------------------------------------------------------------------------

TEST_F(ThreadTest, FallingOffTheEndReturnsZeroAndTakesNoStatement) {
  LoadAndStart({Set(Local(0), ImmediateInt(5))});
  EXPECT_EQ(machine_.Execute(1), 1);
  EXPECT_EQ(RunOf(0), ThreadRun::kStopped);
  EXPECT_EQ(machine_.thread(0).result, 0);
  EXPECT_EQ(machine_.Line(0), 10) << "the last statement";
}

TEST_F(ThreadTest, EmptyFunctionIsFinishedWhenItStarts) {
  Load({MakeFunction({})});
  machine_.Bind(0, 1, 0);
  EXPECT_EQ(machine_.Run(0), kOk);
  EXPECT_EQ(RunOf(0), ThreadRun::kStopped);
  EXPECT_EQ(machine_.Step(0), kOk);
  EXPECT_EQ(machine_.Execute(5), 0);
  EXPECT_EQ(machine_.Line(0), 0);
  EXPECT_TRUE(machine_.Quiet());
}

TEST_F(ThreadTest, ReturnGivesTheValueInTheFunctionsType) {
  Load({MakeFunction({Return(kAlways, Raw(0x18000))}, DataType::kDouble)});
  Start(0);
  machine_.Execute(1);
  EXPECT_EQ(machine_.thread(0).result_type, DataType::kDouble);
  EXPECT_EQ(machine_.thread(0).result, 0x18000);
}

TEST_F(ThreadTest, ReturnOfAnIntIgnoresWhatADoubleLeftInTheSlot) {
  LoadAndStart({Return(kAlways, Local(0))});
  machine_.WriteRaw({false, 0, 0}, (int64_t{3} << 32) | 17);
  machine_.Execute(1);
  EXPECT_EQ(machine_.thread(0).result, 17);
}

TEST_F(ThreadTest, ConditionalReturnGoesOnWhenTheConditionIsZero) {
  LoadAndStart({Return(Local(0), ImmediateInt(3)), Set(Local(0), ImmediateInt(-1)), Goto(-2)});
  EXPECT_EQ(machine_.Execute(10), 4);
  EXPECT_EQ(machine_.thread(0).result, 3);
}

// --- The machine ---------------------------------------------------------------------------------

TEST_F(ThreadTest, LoadUnbindsThreadsAndClearsVariables) {
  LoadAndStart(Counter().instructions);
  SetGlobalInt(3, 9);
  machine_.BeginCycle(5);
  machine_.Execute(5);
  Load({Three()});
  EXPECT_EQ(RunOf(0), ThreadRun::kUnbound);
  EXPECT_EQ(LocalInt(0, 0), 0);
  EXPECT_EQ(GlobalInt(3), 0);
  EXPECT_EQ(machine_.state().executed, 0);
  EXPECT_EQ(machine_.state().cycle, 5) << "time goes on";
}

TEST_F(ThreadTest, RunnableThreadsAreThoseThatCouldExecuteNow) {
  Load({Counter(), MakeFunction({Command(kDelay, {ImmediateInt(2)}), Goto(-1)})});
  Start(0);
  Start(3);
  Start(31, 2);
  EXPECT_EQ(machine_.RunnableThreads(), 0x80000009u);
  machine_.Pause(3);
  EXPECT_TRUE(machine_.ExecuteOne(31));
  EXPECT_FALSE(machine_.ExecuteOne(31));
  EXPECT_EQ(machine_.RunnableThreads(), 0x00000001u);
  machine_.BeginCycle(2);
  EXPECT_EQ(machine_.RunnableThreads(), 0x80000001u);
}

TEST_F(ThreadTest, ExecuteWithoutAProgramOrABudgetDoesNothing) {
  EXPECT_EQ(machine_.Execute(10), 0);
  EXPECT_EQ(machine_.last_stop(), Stop::kIdle);
  LoadAndStart(Counter().instructions);
  EXPECT_EQ(machine_.Execute(0), 0);
  EXPECT_EQ(machine_.last_stop(), Stop::kBudget);
}

TEST_F(ThreadTest, ClockNeverGoesBack) {
  machine_.BeginCycle(7);
  machine_.BeginCycle(3);
  EXPECT_EQ(machine_.state().cycle, 7);
}

// --- Variables -----------------------------------------------------------------------------------

TEST_F(ThreadTest, HostValuesAreTruncatedTowardZeroAndRangeChecked) {
  Load({Counter()});
  const SlotAddress integer{true, 0, 1, DataType::kInt};
  const SlotAddress fixed{false, 31, 1023, DataType::kDouble};
  EXPECT_TRUE(machine_.Write(integer, -2.9));
  EXPECT_EQ(machine_.ReadRaw(integer), -2);
  EXPECT_TRUE(machine_.Write(integer, 2147483647.9));
  EXPECT_EQ(machine_.Read(integer), 2147483647.0);
  EXPECT_FALSE(machine_.Write(integer, 2147483648.0));
  EXPECT_FALSE(machine_.Write(integer, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(machine_.Read(integer), 2147483647.0) << "nothing stored";
  EXPECT_TRUE(machine_.Write(fixed, -0.25));
  EXPECT_EQ(machine_.ReadRaw(fixed), -16384);
  EXPECT_EQ(machine_.Read(fixed), -0.25);
  EXPECT_FALSE(machine_.Write(fixed, 3e9));
}

}  // namespace
}  // namespace oncard::vm
