// Which thread executes next under each policy, and how policies are named.
#include "vm/scheduler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/vm/program_builder.h"

namespace oncard::vm {
namespace {

using testing::HasSubstr;

using Segments = std::vector<ScheduleSegment>;

class SchedulerTest : public MachineTest {
 protected:
  // Starts one endless thread for each number, under a policy.
  void StartEndless(const std::vector<int>& threads, const std::string& policy) {
    machine_.SetPolicy(ParsePolicy(policy).value());
    Load({MakeFunction({Goto(0)})});
    for (const int thread : threads) Start(thread);
  }

  // The segments of the next `statements` statements.
  Segments Trace(int64_t statements) {
    Recording recording;
    machine_.Record(&recording);
    machine_.Execute(statements);
    machine_.Record(nullptr);
    return ScheduleOf(recording).segments;
  }
};

// --- Round robin ---------------------------------------------------------------------------------

TEST_F(SchedulerTest, RoundRobinGoesInThreadOrder) {
  StartEndless({31, 3, 10}, "rr");
  EXPECT_EQ(Trace(7), (Segments{{3, 1}, {10, 1}, {31, 1}, {3, 1}, {10, 1}, {31, 1}, {3, 1}}));
  EXPECT_EQ(Trace(2), (Segments{{10, 1}, {31, 1}})) << "goes on where it was";
}

TEST_F(SchedulerTest, RoundRobinWithAQuantumLetsAThreadExecuteSeveral) {
  StartEndless({0, 1}, "rr:3");
  EXPECT_EQ(Trace(8), (Segments{{0, 3}, {1, 3}, {0, 2}}));
  EXPECT_EQ(Trace(4), (Segments{{0, 1}, {1, 3}})) << "the turn goes on after a split";
}

TEST_F(SchedulerTest, TurnEndsWithItsThread) {
  machine_.SetPolicy(ParsePolicy("rr:5").value());
  Load({MakeFunction({Goto(1), Goto(1), Return(kAlways, ImmediateInt(0))}),
        MakeFunction({Goto(0)})});
  Start(0, 1);
  Start(1, 2);
  EXPECT_EQ(Trace(13), (Segments{{0, 3}, {1, 10}}));
}

TEST_F(SchedulerTest, ThreadThatIsPausedInItsTurnLosesIt) {
  StartEndless({0, 1, 2}, "rr:4");
  EXPECT_EQ(Trace(2), (Segments{{0, 2}}));
  machine_.Pause(0);
  EXPECT_EQ(Trace(5), (Segments{{1, 4}, {2, 1}}));
  machine_.Run(0);
  EXPECT_EQ(Trace(5), (Segments{{2, 3}, {0, 2}}));
}

TEST_F(SchedulerTest, NewThreadJoinsTheRoundInItsPlace) {
  StartEndless({0, 5}, "rr");
  EXPECT_EQ(Trace(1), (Segments{{0, 1}}));
  Start(3);
  EXPECT_EQ(Trace(4), (Segments{{3, 1}, {5, 1}, {0, 1}, {3, 1}}));
}

// Doubling and incrementing do not commute, so the value shows the order.
TEST_F(SchedulerTest, StatementsAlternateWithoutRecordingToo) {
  Load({MakeFunction({Binary(BinaryOperator::kMultiply, DataType::kInt, Global(0), ImmediateInt(2),
                             Global(0)),
                      Goto(-1)}),
        MakeFunction({Add(Global(0), Global(0), ImmediateInt(1)), Goto(-1)})});
  SetGlobalInt(0, 1);
  Start(0, 1);
  Start(1, 2);
  machine_.Execute(24);  // six times: double, add, goto, goto
  EXPECT_EQ(GlobalInt(0), 127) << "1 -> 3 -> 7 -> 15 -> 31 -> 63 -> 127";
}

// t = g; t = t + 1; g = t: both threads read before either writes.
TEST_F(SchedulerTest, SeparateStatementsLoseUpdates) {
  const struct {
    const char* policy;
    int32_t total;
  } kCases[] = {{"rr", 1}, {"rr:2", 1}, {"rr:3", 2}, {"priority", 1}};
  for (const auto& c : kCases) {
    machine_.SetPolicy(ParsePolicy(c.policy).value());
    Load({MakeFunction({Set(Local(0), Global(0)), Add(Local(0), Local(0), ImmediateInt(1)),
                        Set(Global(0), Local(0))})});
    Start(0);
    Start(1);
    EXPECT_EQ(machine_.Execute(100), 6);
    EXPECT_EQ(GlobalInt(0), c.total) << c.policy;
  }
}

TEST_F(SchedulerTest, OneStatementIsAtomic) {
  Load({MakeFunction({Add(Global(0), Global(0), ImmediateInt(1)), Goto(-1)})});
  for (int thread = 0; thread < kThreadCount; ++thread) Start(thread);
  machine_.Execute(2 * kThreadCount * 100);
  EXPECT_EQ(GlobalInt(0), kThreadCount * 100);
}

// --- Priority ------------------------------------------------------------------------------------

TEST_F(SchedulerTest, SmallestPriorityNumberRunsFirstAndEqualsTakeTurns) {
  machine_.SetPolicy(ParsePolicy("priority").value());
  Load({MakeFunction({Set(Local(0), Local(0)), Set(Local(0), Local(0))})});
  const int16_t priorities[] = {5, 2, 9, 2};
  for (int thread = 0; thread < 4; ++thread) {
    machine_.Bind(thread, 1, thread);
    machine_.RunPeriodic(thread, 1000, priorities[thread]);
  }
  EXPECT_EQ(Trace(100), (Segments{{1, 1}, {3, 1}, {1, 1}, {3, 1}, {0, 2}, {2, 2}}));
}

// --- Random policies -----------------------------------------------------------------------------

TEST_F(SchedulerTest, TheNextThreadIsKnownBeforeItExecutes) {
  for (const char* policy : {"rr", "rr:3", "priority", "random:5", "pct:5:3"}) {
    StartEndless({1, 4, 9}, policy);
    for (int i = 0; i < 50; ++i) {
      const int next = machine_.NextThread();
      const int64_t before = machine_.thread(next).executed;
      machine_.Execute(1);
      EXPECT_EQ(machine_.thread(next).executed, before + 1) << policy;
    }
  }
  for (const int thread : {1, 4, 9}) machine_.StopThread(thread);
  EXPECT_EQ(machine_.NextThread(), -1);
}

TEST_F(SchedulerTest, RandomPoliciesDependOnTheSeedOnly) {
  for (const std::string policy : {"random:", "pct:"}) {
    const std::string tail = policy == "pct:" ? ":8:60" : "";
    std::vector<Segments> traces;
    for (const char* seed : {"1", "1", "2"}) {
      StartEndless({0, 1, 2, 3}, policy + seed + tail);
      traces.push_back(Trace(60));
    }
    EXPECT_EQ(traces[0], traces[1]) << policy;
    EXPECT_NE(traces[0], traces[2]) << policy;
  }
}

TEST_F(SchedulerTest, RandomDoesNotDependOnHowTheBudgetIsSplit) {
  StartEndless({0, 7, 9}, "random:42");
  machine_.Execute(90);
  const uint64_t whole = machine_.Hash();
  StartEndless({0, 7, 9}, "random:42");
  for (int i = 0; i < 30; ++i) machine_.Execute(3);
  EXPECT_EQ(machine_.Hash(), whole);
}

TEST_F(SchedulerTest, RandomChoosesEveryRunnableThreadAboutEquallyOften) {
  std::vector<int> all;
  for (int thread = 0; thread < kThreadCount; ++thread) all.push_back(thread);
  StartEndless(all, "random:7");
  machine_.Execute(32000);
  for (const int thread : all) {
    EXPECT_GT(machine_.thread(thread).executed, 800);  // 1000 expected, standard deviation 31
    EXPECT_LT(machine_.thread(thread).executed, 1200);
  }
}

TEST_F(SchedulerTest, PctSwitchesAtMostAsOftenAsItsDepthAllows) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    StartEndless({0, 1, 2}, fmt::format("pct:{}:3:100", seed));
    const Segments trace = Trace(100);
    // Endless threads switch at the two change points only.
    EXPECT_LE(trace.size(), 3u) << seed;
  }
}

TEST_F(SchedulerTest, PctStartsWithEveryThreadForSomeSeed) {
  std::set<int> first;
  for (uint64_t seed = 0; seed < 100; ++seed) {
    StartEndless({0, 1, 2, 3}, fmt::format("pct:{}:1", seed));
    const Segments trace = Trace(10);
    ASSERT_EQ(trace.size(), 1u) << "depth 1 never switches";
    first.insert(trace[0].thread);
  }
  EXPECT_EQ(first.size(), 4u);
}

// --- Names ---------------------------------------------------------------------------------------

TEST(PolicyNameTest, IsReadAndWritten) {
  const struct {
    const char* text;
    const char* canonical;
  } kCases[] = {{"rr", "rr"},
                {"rr:1", "rr"},
                {"rr:1000000000", "rr:1000000000"},
                {"priority", "priority"},
                {"random:0", "random:0"},
                {"random:18446744073709551615", "random:18446744073709551615"},
                {"pct:5:1", "pct:5:1:1000"},
                {"pct:5:64:1000000000000", "pct:5:64:1000000000000"}};
  for (const auto& c : kCases) {
    const auto policy = ParsePolicy(c.text);
    ASSERT_TRUE(policy.ok()) << c.text;
    EXPECT_EQ(FormatPolicy(policy.value()), c.canonical);
  }
  Policy replay;
  replay.kind = PolicyKind::kReplay;
  EXPECT_EQ(FormatPolicy(replay), "replay");
}

TEST(PolicyNameTest, AnythingElseIsRefusedWithTheListOfPolicies) {
  for (const char* text : {"",
                           "rr:",
                           "rr:0",
                           "rr:-1",
                           "rr:1000000001",
                           "rr:1:2",
                           "rr:x",
                           "RR",
                           " rr",
                           "priority:1",
                           "random",
                           "random:",
                           "random:-1",
                           "random:18446744073709551616",
                           "random:1:2",
                           "pct",
                           "pct:1",
                           "pct:1:0",
                           "pct:1:65",
                           "pct:1:2:0",
                           "pct:1:2:1000000000001",
                           "pct:1:2:3:4",
                           "replay",
                           "replay:file",
                           "fifo"}) {
    const auto policy = ParsePolicy(text);
    ASSERT_FALSE(policy.ok()) << text;
    EXPECT_EQ(policy.error().message.en,
              fmt::format("'{}' is not a schedule policy; write rr, rr:N, priority, random:SEED, "
                          "pct:SEED:DEPTH or pct:SEED:DEPTH:STEPS (N up to 1000000000, DEPTH up "
                          "to 64)",
                          text));
    EXPECT_THAT(policy.error().message.zh, HasSubstr("调度策略"));
  }
}

}  // namespace
}  // namespace oncard::vm
