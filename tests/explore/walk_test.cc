// Runs, and properties that depend on their path (explore/engines/walk.h).
#include "explore/engines/walk.h"

#include <gtest/gtest.h>

#include "explore/search/explorer.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

/// `seen` is 1 for some time, unless the other thread interferes.
std::string Glimpse(bool always) {
  return std::string("int gate, seen;\n//@ eventually: seen == 1\n") +
         "int t0() {\n  gate = 1;\n}\n" + "int t1() {\n  int g;\n  g = gate;\n" +
         (always ? "" : "  if (g) goto E;\n") + "  seen = 1;\n  seen = 0;\nE:\n  return 0;\n}\n";
}

TEST(WalkTest, ARunMustHaveAStateInWhichItHolds) {
  for (const EngineKind engine :
       {EngineKind::kAuto, EngineKind::kStateful, EngineKind::kBounded, EngineKind::kRandom}) {
    const auto failed = Explore(ProblemOf(Glimpse(false)), {.engine = engine});
    ASSERT_EQ(failed.value().verdict, Verdict::kFailed) << EngineName(engine);
    EXPECT_EQ(failed.value().failure->fault.kind, Fault::Kind::kRequirement);
    const auto holds = Explore(ProblemOf(Glimpse(true)), {.engine = engine});
    EXPECT_NE(holds.value().verdict, Verdict::kFailed) << EngineName(engine);
  }
  EXPECT_EQ(Explore(ProblemOf(Glimpse(true)), {}).value().verdict, Verdict::kProved);
}

TEST(WalkTest, TracesDoNotTell) {
  EXPECT_FALSE(Explore(ProblemOf(Glimpse(true)), {.engine = EngineKind::kDpor}).ok());
}

TEST(WalkTest, UndoForgetsWhatHasHeld) {
  const Problem problem = ProblemOf(Glimpse(true));
  ProgramWalk walk(problem);
  const StateKey start = walk.Key();
  for (const int thread : {0, 1, 1, 1, 1}) walk.Step(thread);
  EXPECT_TRUE(walk.ended());
  EXPECT_FALSE(walk.fault());
  walk.Restart();
  EXPECT_EQ(walk.Key(), start);
  EXPECT_FALSE(walk.ended());
}

TEST(WalkTest, ACardMustReachItToo) {
  const std::string keys =
      "eventually = [\"axis1.moving == 1\"]\nlimit_ms = 50\ncycle_us = 1000\nrate = 10\n";
  const std::string moves =
      "int t0() {\n GT_AxisOn(1);\n GT_PrfTrap(1);\n GT_SetPos(1, 100);\n GT_SetVel(1, 10);\n"
      " GT_Update(1);\n GT_Delay(40);\n}\n";
  CardModel moving = CardOf(moves, keys);
  EXPECT_EQ(ExploreCard(&moving, {}).verdict, Verdict::kProved);
  CardModel resting = CardOf("int t0() {\n GT_Delay(10);\n}\n", keys);
  EXPECT_EQ(ExploreCard(&resting, {}).verdict, Verdict::kFailed);
}

}  // namespace
}  // namespace oncard::explore
