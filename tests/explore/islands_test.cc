// Which threads of a program are islands, and what each is to fulfil.
#include "explore/models/islands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::ElementsAre;

/// Three threads with an axis each; the functions get these statements first.
std::string ThreeAxes(const std::string& more_of_t0 = {}) {
  return "int a;\nint b;\nint c;\n"
         "int t0() { int n; " +
         more_of_t0 +
         " GT_AxisOn(1); a = 1; return 0; }\n"
         "int t1() { GT_AxisOn(2); b = 1; return 0; }\n"
         "int t2() { GT_AxisOn(3); c = 1; return 0; }\n";
}

/// The threads of the islands as bits; none if there are no islands.
std::vector<uint32_t> IslandsOf(const std::string& source, const std::string& keys) {
  const CardModel model = CardOf(source, keys);
  std::vector<uint32_t> threads;
  if (const auto islands = Islands::Of(model)) {
    for (const Island& island : islands->all()) threads.push_back(island.threads);
  }
  return threads;
}

TEST(Islands, ThreadsWithTheirOwnThingsAreApart) {
  EXPECT_THAT(IslandsOf(ThreeAxes(), {}), ElementsAre(1, 2, 4));
}

TEST(Islands, ThreadsThatShareSomethingAreOne) {
  EXPECT_THAT(IslandsOf(ThreeAxes("c = 2;"), {}), ElementsAre(5, 2));
  EXPECT_THAT(IslandsOf(ThreeAxes("GT_Stop(4, 0);"), {}), ElementsAre(5, 2));
  // A thread that reads all axes.
  EXPECT_THAT(IslandsOf(ThreeAxes("GT_GearStart(1);"), {}), ElementsAre());
  // The chain b - c - a.
  EXPECT_THAT(IslandsOf("int a;\nint b;\nint t0() { a = 1; return 0; }\n"
                        "int t1() { b = 1; return 0; }\nint t2() { GT_AxisOn(1); return 0; }\n"
                        "int t3() { b = a; return 0; }\n",
                        {}),
              ElementsAre(11, 4));
}

// A requirement is checked in the island that sets what it names.
TEST(Islands, ARequirementJoinsWhatItNames) {
  EXPECT_THAT(IslandsOf(ThreeAxes(), "never = [\"a == 1 && axis3.prfPos > 5\"]\n"),
              ElementsAre(5, 2));
  EXPECT_THAT(IslandsOf(ThreeAxes(), "final = [\"ret0 == b\"]\n"), ElementsAre(3, 4));
  EXPECT_THAT(
      IslandsOf(ThreeAxes(), "within = [{ after = \"a == 1\", then = \"c == 1\", ms = 5 }]\n"),
      ElementsAre(5, 2));
  EXPECT_THAT(IslandsOf(ThreeAxes(), "final = [\"clock < 5\", \"statements > 0\"]\n"),
              ElementsAre());
}

TEST(Islands, PartsOfAConjunctionAreCheckedApart) {
  EXPECT_THAT(IslandsOf(ThreeAxes(), "final = [\"a == 1 && (b == 1 || c == 1)\"]\n"),
              ElementsAre(1, 6));
  EXPECT_THAT(IslandsOf(ThreeAxes(), "expect = [\"a == 1 && b == 1 @ 2ms\"]\n"),
              ElementsAre(1, 2, 4));
  EXPECT_THAT(IslandsOf(ThreeAxes(), "never = [\"a == 2 || b == 2\"]\n"), ElementsAre(1, 2, 4));
  EXPECT_THAT(IslandsOf(ThreeAxes(), "always = [\"a <= 1 && b <= 1 || c == 1\"]\n"), ElementsAre());
}

// Here threads can begin to run in the middle of a cycle, or fewer statements than threads can.
TEST(Islands, NoneWhereOthersDoMoreThanTakeStatements) {
  EXPECT_THAT(IslandsOf(ThreeAxes("GT_WaitForVarEq(&a, 0);"), {}), ElementsAre());
  EXPECT_THAT(IslandsOf(ThreeAxes(), "rate = 11\n"), ElementsAre());
  EXPECT_THAT(IslandsOf(ThreeAxes(), "rate = 12\n"), ElementsAre(1, 2, 4));
  EXPECT_THAT(IslandsOf(ThreeAxes(), "[[world.react]]\nwhen = \"a == 1\"\nvalue = 1\n"),
              ElementsAre());
  EXPECT_THAT(
      IslandsOf(ThreeAxes(), "[[world.switch]]\naxis = 1\ntype = \"home\"\nindex = 2\nfrom = 5\n"),
      ElementsAre());
}

// --- Sums ----------------------------------------------------------------------------------------

/// Two threads that count in `done`, with more statements of the second one.
std::string TwoCount(const std::string& more = {}) {
  return "int done;\nint a;\nint b;\n"
         "int t0() { GT_AxisOn(1); done = done + 1; b = b + 1; return 0; }\n"
         "int t1() { int n; GT_AxisOn(2); done = done + 1; " +
         more + " return 0; }\n";
}

TEST(Islands, WhatIsOnlyAddedToJoinsNobody) {
  EXPECT_THAT(IslandsOf(TwoCount(), {}), ElementsAre(1, 2));
  EXPECT_THAT(IslandsOf(TwoCount(), "final = [\"done == 2\", \"done < 3 && a == 0\"]\n"),
              ElementsAre(1, 2));
  EXPECT_THAT(IslandsOf(TwoCount("n = done;"), {}), ElementsAre());
}

// What is asked before the end, or of it and of something else, is asked of all that add to it.
TEST(Islands, WhatIsOnlyAddedToJoinsWhereItIsAskedForOtherwise) {
  EXPECT_THAT(IslandsOf(TwoCount(), "never = [\"done == 3\"]\n"), ElementsAre());
  EXPECT_THAT(IslandsOf(TwoCount(), "expect = [\"done == 0 @ 0ms\"]\n"), ElementsAre());
  EXPECT_THAT(IslandsOf(TwoCount("b = b - 1;"), "final = [\"done == b + 2\"]\n"),
              ElementsAre(1, 2));
  EXPECT_THAT(IslandsOf(TwoCount("a = 1;"), "final = [\"done == a + 1\"]\n"), ElementsAre());
  EXPECT_THAT(IslandsOf(TwoCount(), "final = [\"!(done > 1) || done == 2\"]\n"), ElementsAre());
  EXPECT_THAT(IslandsOf(TwoCount(), "races = \"none\"\n"), ElementsAre());
}

TEST(Islands, AnIslandHasItsThreadsAndRequirements) {
  const CardModel model = CardOf(
      ThreeAxes(), "expect = [\"b == 1 && a == 1 @ 2ms\"]\nnever = [\"c == 2\", \"b == 2\"]\n");
  const auto islands = Islands::Of(model);
  ASSERT_TRUE(islands);
  const auto card = islands->Build(1, model);
  ASSERT_TRUE(card);
  EXPECT_EQ(card->model.thread_count(), 1);
  EXPECT_EQ(card->model.setup(0).thread, 1);
  std::vector<std::string> titles;
  for (const Requirement& requirement : card->model.Requirements()) {
    titles.push_back(requirement.Title());
  }
  EXPECT_THAT(titles, ElementsAre("final: b == 1 @ 2ms", "never: b == 2"));
  EXPECT_THAT(card->origins, ElementsAre(0, 2));
}

TEST(Islands, OthersMayTakeTheCycleOnceEachThreadWasServed) {
  const CardModel whole = CardOf(ThreeAxes("c = 2; c = 3;"), "rate = 16\n");
  auto card = Islands::Of(whole)->Build(0, whole);
  CardModel& island = card->model;
  ASSERT_EQ(island.thread_count(), 2);
  CardModel::State state = island.Start();
  EXPECT_FALSE(island.MayEndCycle(state));
  state = island.Step(state, 0);
  EXPECT_FALSE(island.MayEndCycle(state));
  state = island.Step(state, 1);
  EXPECT_TRUE(island.MayEndCycle(state));
  EXPECT_EQ(CardModel::CycleOf(island.EndCycle(state)), CardModel::CycleOf(state) + 1);
}

}  // namespace
}  // namespace oncard::explore
