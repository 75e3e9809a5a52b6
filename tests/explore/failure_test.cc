// The report of a failure besides its steps: the wrong values (explore/reports/trail.h), the cause
// (explore/reports/culprit.h), both orders of a data race (explore/reports/race_orders.h).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "explore/reports/culprit.h"
#include "explore/reports/race_orders.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Told {
  std::string actual;
  std::string culprit;
};

Told Tell(const std::string& source) {
  const Problem problem = ProblemOf(source);
  const auto exploration = Explore(problem, {.engine = EngineKind::kStateful});
  if (!exploration.ok() || !exploration.value().failure) return {"no failure", ""};
  const Failure& failure = *exploration.value().failure;
  const Trail trail = Follow(problem, failure);
  const auto culprit = FindCulprit(SubjectOf(problem), failure, trail);
  return {trail.actual.en, culprit ? culprit->sentence.en : ""};
}

TEST(FailureTest, ALostUpdateIsAWriteOverWhatWasNotSeen) {
  const Told told = Tell(Increments(2, 1));
  EXPECT_EQ(told.actual, "x is 1, expected 2");
  EXPECT_EQ(told.culprit,
            "thread 0 wrote x = 1 over thread 1's 1 at step 7, because it had read x = 0 at step "
            "1, before thread 1 wrote it at step 4");
}

TEST(FailureTest, ADecisionOnWhatNoLongerHolds) {
  const Told told = Tell(
      "int stop, moves;\n"
      "//@ final: moves == 0\n"
      "int t0() {\n  int halt;\n  halt = stop;\n  if (halt) goto E;\n  moves = 1;\nE:\n"
      "  return 0;\n}\n"
      "int t1() {\n  stop = 1;\n  moves = 0;\n  return 0;\n}\n");
  EXPECT_EQ(told.actual, "moves is 1, expected 0");
  EXPECT_THAT(told.culprit, StartsWith("thread 0 continued to step "));
  EXPECT_THAT(told.culprit,
              HasSubstr("because it had read stop = 0 at step 1; thread 1 had set it to 1"));
}

/// The cause that is told of a given schedule; `fatal`: the statement after which every end is bad.
std::string CauseOf(const std::string& source, const std::vector<uint8_t>& steps,
                    int64_t fatal = -1, const std::vector<std::string>& sync = {}) {
  const Problem problem = ProblemOf(source);
  Failure failure;
  failure.steps = steps;
  failure.last_escape = fatal;
  failure.fault.kind = Fault::Kind::kRequirement;
  const Trail trail = Follow(problem, failure);
  Subject subject = SubjectOf(problem);
  subject.sync = sync;
  const auto culprit = FindCulprit(subject, failure, trail);
  return culprit ? culprit->sentence.en : "";
}

/// Threads that add 1 to a variable, each in three statements; x is 2 if none is lost.
constexpr const char* kAddToX =
    "int t0() {\n  int t;\n  t = x;\n  t = t + 1;\n  x = t;\n}\n"
    "int t1() {\n  int t;\n  t = x;\n  t = t + 1;\n  x = t;\n}\n";
constexpr const char* kLostX =
    "thread 0 wrote x = 1 over thread 1's 1 at step 6, because it had read x = 0 at step 1, before "
    "thread 1 wrote it at step 4";

TEST(FailureTest, AVariableThatDoesNotReachTheRequirementIsNoCause) {
  const std::string lamps =
      "int t2() {\n  int l;\n  l = lamp;\n  lamp = l + 1;\n}\n"
      "int t3() {\n  int l;\n  l = lamp;\n  lamp = l + 1;\n}\n";
  EXPECT_EQ(CauseOf("int x, lamp;\n//@ final: x == 2\n" + (kAddToX + lamps),
                    {0, 1, 1, 1, 0, 0, 2, 3, 3, 2}),
            kLostX);
}

TEST(FailureTest, AWriteThatChangesNothingIsNoCause) {
  const std::string again =
      "int t2() {\n  int l;\n  l = x;\n  x = l;\n}\n"
      "int t3() {\n  int l;\n  l = x;\n  x = l;\n}\n";
  EXPECT_EQ(
      CauseOf("int x;\n//@ final: x == 2\n" + (kAddToX + again), {0, 1, 1, 1, 0, 0, 2, 3, 3, 2}),
      kLostX);
}

TEST(FailureTest, AVariableThatSynchronisesIsTheLastToBeBlamed) {
  const char* source =
      "int x, y, f;\n//@ final: y == 1 && f == 2\n"
      "int t0() {\n  int a;\n  int b;\n  a = x;\n  b = f;\n  b = b + 1;\n  f = b;\n  y = a;\n}\n"
      "int t1() {\n  int c;\n  x = 1;\n  c = f;\n  c = c + 1;\n  f = c;\n}\n";
  const std::vector<uint8_t> steps = {0, 0, 1, 1, 1, 1, 0, 0, 0};
  EXPECT_THAT(CauseOf(source, steps), StartsWith("thread 0 wrote f = 1 over thread 1's 1"));
  EXPECT_THAT(CauseOf(source, steps, -1, {"f"}), StartsWith("thread 0 used x = 0 at step 9"));
}

TEST(FailureTest, TheCauseIsThatOfTheRacingPair) {
  const std::string others =
      "int t2() {\n  int l;\n  l = z;\n  z = l + 1;\n}\n"
      "int t3() {\n  int l;\n  l = z;\n  z = l + 1;\n}\n";
  const std::string source =
      "int x, y, z;\n//@ final: y == 1 && z < 9\n"
      "int t0() {\n  int a;\n  a = x;\n  y = a;\n}\nint t1() {\n  x = 1;\n}\n" +
      others;
  EXPECT_THAT(CauseOf(source, {0, 1, 2, 3, 3, 2, 0}, 0),
              StartsWith("thread 0 used x = 0 at step 7, which it had read at step 1; thread 1"));
}

TEST(FailureTest, AReadBeforeTheWrite) {
  const Told told = Tell(
      "int ready, got;\n"
      "//@ final: got == 1\n"
      "int t0() {\n  got = ready;\n  return 0;\n}\n"
      "int t1() {\n  ready = 1;\n  return 0;\n}\n");
  EXPECT_EQ(told.actual, "got is 0, expected 1");
  EXPECT_THAT(told.culprit,
              HasSubstr("thread 0 read ready = 0 at step 1, before thread 1 wrote ready = 1"));
}

TEST(FailureTest, TheStateOfAThreadIsTheWorkOfItsStatements) {
  const Findings findings = FindingsOf(
      "int x;\nint t0() {\n  GT_AxisOn(1);\n  x = 1;\n}\n"
      "int t1() {\n  int h;\n  h = x;\n  if (h) goto E;\n  h = 2;\nE:\n  return h;\n}\n",
      "expect = [\"thread1.run == 1\"]\n", {});
  const Trail& trail = findings.trail;
  bool commanded = false;
  size_t last = trail.steps.size();
  for (size_t i = 0; i < trail.steps.size(); ++i) {
    const TrailStep& step = trail.steps[i];
    commanded = commanded || step.log.command;
    EXPECT_FALSE(step.log.command && trail.matters[i]);
    EXPECT_TRUE(!step.log.decides || trail.matters[i]);
    if (step.thread == 1) last = i;
  }
  EXPECT_TRUE(commanded);
  ASSERT_LT(last, trail.steps.size());
  EXPECT_TRUE(trail.matters[last]);
}

struct ActualCase {
  const char* requirement;
  const char* actual;
};

class ActualValue : public ::testing::TestWithParam<ActualCase> {};

TEST_P(ActualValue, StandsBesideTheExpectedOne) {
  const Told told = Tell(std::string("int x, y;\ndouble d;\n//@ ") + GetParam().requirement +
                         "\nint t0() {\n  x = 3;\n  y = 4;\n  d = 2.5;\n  return 7;\n}\n");
  EXPECT_EQ(told.actual, GetParam().actual);
}

INSTANTIATE_TEST_SUITE_P(
    FailureTest, ActualValue,
    ::testing::Values(ActualCase{"final: x == 10", "x is 3, expected 10"},
                      ActualCase{"final: x != 3", "x is 3, expected != 3"},
                      ActualCase{"final: x <= 2", "x is 3, expected <= 2"},
                      ActualCase{"final: d > 3", "d is 2.5, expected > 3"},
                      ActualCase{"final: x == y", "x is 3, y is 4"},
                      ActualCase{"final: ret0 == 1", "thread0.result is 7, expected 1"},
                      ActualCase{"final: x == 3 && y + x == 8", "x is 3, y is 4"},
                      ActualCase{"never: x == 3", "x is 3"}));

TEST(FailureTest, AFaultSaysWhatLedToIt) {
  EXPECT_EQ(
      Tell("int x, a[3];\nint t0() {\n  int i;\n  i = 5;\n  a[i] = 1;\n  return 0;\n}\n").actual,
      "in line 5 the index is 5, the array has 3 elements");
  EXPECT_EQ(Tell("int x;\nint t0() {\n  int i;\n  i = 1 / x;\n  return i;\n}\n").actual,
            "division by zero in line 4");
}

TEST(FailureTest, ADataRaceShowsBothOrders) {
  const Problem problem = ProblemOf(
      "int x, y;\n//@ races: none\n"
      "int t0() {\n  x = 1;\n  return 0;\n}\n"
      "int t1() {\n  x = 2;\n  y = x;\n  return 0;\n}\n");
  const auto exploration = Explore(problem, {.engine = EngineKind::kStateful});
  ASSERT_TRUE(exploration.ok() && exploration.value().failure);
  const auto orders = BothOrders(problem, *exploration.value().failure);
  ASSERT_EQ(orders.size(), 2u);
  EXPECT_EQ(orders[0].first + orders[1].first, 1);
  const RaceOrder& zero_first = orders[0].first == 0 ? orders[0] : orders[1];
  const RaceOrder& one_first = orders[0].first == 0 ? orders[1] : orders[0];
  EXPECT_EQ(zero_first.after, "x = 2");
  EXPECT_EQ(one_first.after, "x = 1");
  EXPECT_EQ(zero_first.end.substr(0, 5), "x = 2");
  EXPECT_EQ(one_first.end.substr(0, 5), "x = 1");
}

TEST(FailureTest, WhatARacingStatementReadIsToldOfBothOrders) {
  const Problem problem = ProblemOf(
      "int y;\n//@ races: none\n"
      "int t0() {\n  y = 200;\n  return 0;\n}\n"
      "int t1() {\n  int got;\n  got = y;\n  return got;\n}\n");
  const auto exploration = Explore(problem, {.engine = EngineKind::kStateful});
  ASSERT_TRUE(exploration.ok() && exploration.value().failure);
  const auto orders = BothOrders(problem, *exploration.value().failure);
  ASSERT_EQ(orders.size(), 2u);
  const RaceOrder& write_first = orders[0].first == 0 ? orders[0] : orders[1];
  const RaceOrder& read_first = orders[0].first == 0 ? orders[1] : orders[0];
  EXPECT_EQ(write_first.after, "[y = 200] y = 200");
  EXPECT_EQ(write_first.end, "thread1.result = 200");
  EXPECT_EQ(read_first.after, "[y = 0] y = 200");
  EXPECT_EQ(read_first.end, "thread1.result = 0");
}

TEST(FailureTest, WhatIsNoDataRaceHasNoOrders) {
  const Problem problem = ProblemOf(Increments(2, 1));
  Failure failure;
  failure.steps = {0, 1};
  EXPECT_TRUE(BothOrders(problem, failure).empty());
}

}  // namespace
}  // namespace oncard::explore
