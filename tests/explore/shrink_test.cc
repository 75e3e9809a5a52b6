// Failing schedules with fewer preemptions (explore/engines/shrink.h).
#include "explore/engines/shrink.h"

#include <gtest/gtest.h>

#include "explore/search/explorer.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

TEST(ShrinkTest, PreemptionsAreChangesOfThreadsThatCouldGoOn) {
  Problem problem = ProblemOf(Increments(2, 1));
  EXPECT_EQ(CountPreemptions(&problem.model, {0, 0, 0, 0, 1, 1, 1, 1}), 0);
  EXPECT_EQ(CountPreemptions(&problem.model, {0, 1, 1, 1, 1, 0, 0, 0}), 1);
  EXPECT_EQ(CountPreemptions(&problem.model, {0, 1, 0, 1, 0, 1, 0, 1}), 6);
  EXPECT_EQ(problem.model.depth(), 0);
}

TEST(ShrinkTest, ALostUpdateNeedsOnePreemption) {
  Problem problem = ProblemOf(Increments(3, 2));
  std::vector<uint8_t> steps;
  for (int i = 0; i < 7; ++i) {
    for (uint8_t thread = 0; thread < 3; ++thread) steps.push_back(thread);
  }
  const Failure shrunk = Shrink(problem, steps);
  EXPECT_EQ(shrunk.preemptions, 1);
  EXPECT_EQ(CountPreemptions(&problem.model, shrunk.steps), 1);
  for (const uint8_t thread : shrunk.steps) problem.model.Step(thread);
  EXPECT_TRUE(FindFault(problem, problem.model));
}

// Thread 1 is not involved, and thread 2's statements before its write are not needed.
TEST(ShrinkTest, WhatHasNothingToDoWithTheFaultGoes) {
  const Problem problem = ProblemOf(
      "int x, y;\n//@ never: x == 1\nint t0() {\n int r;\n r = y;\n x = 1;\n}\n"
      "int t1() {\n y = 1;\n y = 2;\n y = 3;\n}\n");
  const Failure shrunk = Shrink(problem, {1, 0, 1, 0});
  EXPECT_EQ(shrunk.steps, (std::vector<uint8_t>{0, 0}));
  EXPECT_EQ(shrunk.preemptions, 0);
}

TEST(ShrinkTest, ACardsScheduleToo) {
  CardModel card = CardOf(
      "int x;\nint t0() {\n int t;\n GT_Delay(1);\n t = x;\n x = t + 1;\n}\n"
      "int t1() {\n int t;\n GT_Delay(1);\n t = x;\n x = t + 1;\n}\n"
      "int y;\nint t2() {\n y = 1;\n y = 2;\n y = 3;\n}\n",
      "expect = [\"x == 2\"]\ncycle_us = 1000\nrate = 10\n");
  const Exploration found = ExploreCard(&card, {.engine = EngineKind::kRandom, .runs = 200});
  ASSERT_EQ(found.verdict, Verdict::kFailed);
  EXPECT_LE(found.failure->preemptions, 2);
  EXPECT_EQ(found.failure->fault.kind, Fault::Kind::kRequirement);
}

}  // namespace
}  // namespace oncard::explore
