// Failing schedules with fewer preemptions (explore/shrink.h).
#include "explore/shrink.h"

#include <gtest/gtest.h>

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
  const std::vector<uint8_t> shrunk = Shrink(problem, steps);
  EXPECT_EQ(CountPreemptions(&problem.model, shrunk), 1);
  for (const uint8_t thread : shrunk) problem.model.Step(thread);
  EXPECT_TRUE(FindFault(problem, problem.model));
}

}  // namespace
}  // namespace oncard::explore
