// Schedules with few preemptions (explore/engines/bounded_search.h).
#include "explore/engines/bounded_search.h"

#include <gtest/gtest.h>

#include "explore/search/explorer.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

TEST(BoundedSearchTest, WithoutPreemptionsNoUpdateIsLost) {
  const Problem problem = ProblemOf(Increments(3, 2));
  const BoundedCounts none = SearchBounded(problem, {.preemptions = 0});
  EXPECT_TRUE(none.complete);
  EXPECT_FALSE(none.bad);
  EXPECT_EQ(none.preemptions, 0);
  EXPECT_EQ(none.different_ends, 1);
  const BoundedCounts one = SearchBounded(problem, {.preemptions = 1});
  EXPECT_TRUE(one.bad);
  EXPECT_EQ(one.preemptions, 1);
}

// Compared with the fewest preemptions in the graph of all states.
TEST(BoundedSearchTest, FindsTheFewestPreemptions) {
  for (const std::string& source : {Increments(2, 2), Peterson(true)}) {
    const auto bounded = Explore(ProblemOf(source), {.engine = EngineKind::kBounded});
    const auto stateful = Explore(ProblemOf(source), {.engine = EngineKind::kStateful});
    ASSERT_TRUE(bounded.value().failure && stateful.value().failure);
    EXPECT_EQ(bounded.value().failure->preemptions, stateful.value().failure->preemptions);
  }
}

TEST(BoundedSearchTest, PassedIsNoProof) {
  const auto bounded = Explore(ProblemOf(Peterson(false)), {.engine = EngineKind::kBounded});
  EXPECT_EQ(bounded.value().verdict, Verdict::kPassed);
  EXPECT_EQ(bounded.value().bounded->preemptions, 2);
}

TEST(BoundedSearchTest, ALimitIsIncomplete) {
  const auto bounded =
      Explore(ProblemOf(Peterson(false)), {.engine = EngineKind::kBounded, .state_limit = 10});
  EXPECT_EQ(bounded.value().verdict, Verdict::kIncomplete);
}

TEST(BoundedSearchTest, ACardIsSearchedToo) {
  CardModel card = CardOf(
      "int x;\nint t0() {\n int t;\n GT_Delay(1);\n t = x;\n x = t + 1;\n}\n"
      "int t1() {\n int t;\n GT_Delay(1);\n t = x;\n x = t + 1;\n}\n",
      "expect = [\"x == 2\"]\ncycle_us = 1000\nrate = 10\n");
  const Exploration exploration = ExploreCard(&card, {.engine = EngineKind::kBounded});
  ASSERT_EQ(exploration.verdict, Verdict::kFailed);
  EXPECT_EQ(exploration.failure->preemptions, 1);
}

}  // namespace
}  // namespace oncard::explore
