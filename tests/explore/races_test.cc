// Data races (explore/models/races.h), and how the engines report them.
#include "explore/models/races.h"

#include <gtest/gtest.h>

#include "explore/engines/walk.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

/// Thread 0 passes `x` to thread 1 with `flag`.
std::string HandOver(const std::string& comments) {
  return "int x, flag;\n" + comments +
         "int t0() {\n  x = 1;\n  flag = 1;\n}\n"
         "int t1() {\n  int f, r, c;\n  f = flag;\n  c = f == 0;\n  if (c) goto E;\n  r = x;\nE:\n "
         " return r;\n}\n";
}

Exploration RunOn(const std::string& source, EngineKind engine) {
  auto result = Explore(ProblemOf(source), {.engine = engine});
  EXPECT_TRUE(result.ok());
  return std::move(result).value();
}

constexpr EngineKind kEngines[] = {EngineKind::kAuto, EngineKind::kDpor, EngineKind::kStateful,
                                   EngineKind::kBounded, EngineKind::kRandom};

TEST(RacesTest, AFlagOrdersOnlyWhenItSynchronises) {
  for (const EngineKind engine : kEngines) {
    const Exploration without = RunOn(HandOver("//@ races: none\n"), engine);
    ASSERT_EQ(without.verdict, Verdict::kFailed) << EngineName(engine);
    EXPECT_EQ(without.failure->fault.kind, Fault::Kind::kRace);
    const Exploration with = RunOn(HandOver("//@ races: none\n//@ sync: flag\n"), engine);
    EXPECT_NE(with.verdict, Verdict::kFailed) << EngineName(engine);
  }
}

TEST(RacesTest, WithoutTheWishNoneIsLookedFor) {
  const Exploration exploration = RunOn(HandOver(""), EngineKind::kStateful);
  EXPECT_EQ(exploration.verdict, Verdict::kProved);
  EXPECT_TRUE(exploration.races.empty());
}

TEST(RacesTest, ReadsDoNotRace) {
  EXPECT_EQ(RunOn("int x;\n//@ races: none\nint t0() {\n int r;\n r = x;\n return r;\n}\n"
                  "int t1() {\n int r;\n r = x;\n return r;\n}\n",
                  EngineKind::kStateful)
                .verdict,
            Verdict::kProved);
}

TEST(RacesTest, ARaceIsShownWithBothStatements) {
  const Exploration exploration = RunOn(
      "int x;\n//@ races: none\nint t0() {\n x = 1;\n return 0;\n}\nint t1() {\n int r;\n r = x;\n"
      " return r;\n}\n",
      EngineKind::kStateful);
  ASSERT_EQ(exploration.races.size(), 1u);
  const Race& race = exploration.races[0].race;
  EXPECT_EQ(race.first, (RacingStatement{0, 0, true}));
  EXPECT_EQ(race.second, (RacingStatement{1, 0, false}));
  EXPECT_FALSE(exploration.races[0].benign);
  EXPECT_EQ(exploration.failure->steps, (std::vector<uint8_t>{0, 1}));
}

// Both threads write the same value; a third one makes the order of two writes visible.
TEST(RacesTest, ABenignRaceChangesNoEnd) {
  const std::string same =
      "int x;\n//@ races: benign\nint t0() {\n x = 1;\n}\nint t1() {\n x = 1;\n}\n";
  const Exploration benign = RunOn(same, EngineKind::kStateful);
  EXPECT_EQ(benign.verdict, Verdict::kProved);
  ASSERT_EQ(benign.races.size(), 1u);
  EXPECT_TRUE(benign.races[0].benign);
  const Exploration harmful = RunOn(same + "int t2() {\n x = 2;\n}\n", EngineKind::kStateful);
  EXPECT_EQ(harmful.verdict, Verdict::kFailed);
  EXPECT_EQ(harmful.races.size(), 3u);
  EXPECT_EQ(std::ranges::count(harmful.races, true, &FoundRace::benign), 1);
}

TEST(RacesTest, WhetherARaceIsBenignNeedsAllStates) {
  EXPECT_FALSE(
      Explore(ProblemOf(HandOver("//@ races: benign\n")), {.engine = EngineKind::kDpor}).ok());
}

// The clocks are part of a walk's state: two paths to the same values may be different states.
TEST(RacesTest, WaysThatOrderDifferentlyAreDifferentStates) {
  Problem problem = ProblemOf(
      "int x, f;\nint t0() {\n x = 1;\n f = 1;\n}\nint t1() {\n int r;\n f = 1;\n r = f;\n r = "
      "x;\n}\n");
  problem.races = RaceRule::kNone;
  problem.sync = {false, true};
  const auto key_after = [&](std::initializer_list<int> threads) {
    ProgramWalk walk(problem);
    for (const int thread : threads) walk.Step(thread);
    return walk.Key();
  };
  // Thread 1 reads f before or after thread 0 writes the same value.
  EXPECT_FALSE(key_after({0, 1, 1, 0}) == key_after({0, 0, 1, 1}));
}

// The clocks order distant statements: thread 1 reads x long after thread 0 has written it.
TEST(RacesTest, ClocksSeeRacesFarApart) {
  const Problem problem = ProblemOf(HandOver(""));
  const auto race_of = [&](const SyncCells& sync) {
    Model model = problem.model;
    RaceDetector detector(model, sync);
    Race found;
    for (const int thread : {0, 0, 1, 1, 1, 1}) {
      const Race race = detector.BeforeStep(model, thread);
      if (!found) found = race;
      model.Step(thread);
    }
    return found;
  };
  EXPECT_EQ(race_of({}).cell, 1u);
  EXPECT_FALSE(race_of({false, true}));
  EXPECT_EQ(race_of({true, false}).cell, 1u);
}

}  // namespace
}  // namespace oncard::explore
