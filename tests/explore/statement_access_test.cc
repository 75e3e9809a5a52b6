// The accesses of statements (runtime/observe/statement_access.h).
#include "runtime/observe/statement_access.h"

#include <gtest/gtest.h>

#include <functional>

#include "explore/reports/trail.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"
#include "tests/motion/change_state.h"

namespace oncard::explore {
namespace {

using runtime::StatementAccess;
using runtime::Touched;

/// The accesses of the statements of t0, one after the other; `!` marks writes.
std::vector<std::string> AccessesOf(const std::string& source) {
  CardModel model = CardOf(source, "rate = 1000\n");
  CardModel::State state = model.Start();
  std::vector<std::string> accesses;
  while (!state.ended) {
    model.Load(state);
    std::string text;
    for (const Touched& touched : NextAccess(model.controller(), 0)) {
      if (!text.empty()) text += ' ';
      text += NameOf(touched, model.image()->object) + (touched.write ? "!" : "");
    }
    accesses.push_back(text);
    state = model.Step(state, 0);
  }
  return accesses;
}

TEST(StatementAccessTest, Variables) {
  EXPECT_EQ(
      AccessesOf("int g, a[4], k;\nint t0() {\n int l;\n l = 2;\n g = l;\n k = 3;\n a[k] = g;\n"
                 " a[1] = a[k];\n if (g) goto E;\nE:\n return g;\n}\n"),
      (std::vector<std::string>{"", "g!", "k!", "g k a[3]!", "k a[3] a[1]!", "g", "g"}));
}

TEST(StatementAccessTest, CommandsTouchWhatTheCatalogueSays) {
  EXPECT_EQ(
      AccessesOf("int n, s;\nint t0() {\n int c;\n n = 3;\n GT_AxisOn(n);\n GT_SetVel(2, 5);\n"
                 " GT_GetSts(1, &s, 1, &c);\n GT_Update(5);\n GT_Delay(1);\n}\n"),
      (std::vector<std::string>{"n!", "n axis 3! do!", "axis 2!", "s! axis 1", "axis 1! axis 3!",
                                ""}));
}

// A coordinate system can have any axes.
TEST(StatementAccessTest, ABitOfAMaskBehindTheAxesMayTouchAnyAxis) {
  const auto accesses = AccessesOf(
      "int t0() {\n GT_SynchAxisPos(2);\n GT_SynchAxisPos(4098);\n GT_Stop(256, 0);\n}\n");
  EXPECT_EQ(accesses,
            (std::vector<std::string>{"axis 2! encoder crd", "axis! encoder crd", "axis! crd!"}));
}

// The variable's value is not the number of another one.
TEST(StatementAccessTest, AWaitReadsItsVariable) {
  EXPECT_EQ(AccessesOf("int a, b, go;\nint t0() {\n go = 1;\n GT_WaitForVarEq(&go, 1);\n}\n"),
            (std::vector<std::string>{"go!", "go"}));
}

TEST(StatementAccessTest, AnElementSelectsAnAxisToo) {
  EXPECT_EQ(
      AccessesOf("int a[3];\nint t0() {\n int k;\n k = 1;\n a[1] = 4;\n GT_SetVel(a[k], 5);\n}\n"),
      (std::vector<std::string>{"", "a[1]!", "a[1] axis 4!"}));
}

/// The accesses of GT_SetVel(2, 5) on a card that `change` has changed.
Touched AccessOfAxis2(const std::function<void(motion::MotionCore*)>& change) {
  runtime::Controller card;
  const CardModel model = CardOf("int t0() {\n GT_SetVel(2, 5);\n}\n", "rate = 1000\n");
  EXPECT_TRUE(card.Load(model.image()->object).ok());
  EXPECT_EQ(card.machine().Bind(0, 1, 0), vm::kOk);
  EXPECT_EQ(card.machine().Run(0), vm::kOk);
  change(&card.motion());
  const StatementAccess access = NextAccess(card, 0);
  EXPECT_EQ(access.size(), 1u);
  return access.empty() ? Touched{} : access.front();
}

// The slave uses the profile of its master.
TEST(StatementAccessTest, InAGantryACommandOfOneAxisMayReachTheOther) {
  EXPECT_EQ(AccessOfAxis2([](auto* motion) { motion->EnableGantry(0, 1, 0, 0); }),
            (Touched{gtcalls::Resource::kAxis, Touched::kAll, true}));
}

TEST(StatementAccessTest, SoItMayWhereAConfigurationMapsAxesOtherwise) {
  const std::vector<std::function<void(motion::MotionCore*)>> changes = {
      [](auto* motion) { ChangeState(*motion).axes[3].profile_map = 0b10; },
      [](auto* motion) { ChangeState(*motion).axes[3].encoder_map = 0b11; },
      [](auto* motion) { ChangeState(*motion).controls[3].axis = 1; },
      [](auto* motion) { ChangeState(*motion).controls[3].encoder = 1; },
      [](auto* motion) { ChangeState(*motion).steps[3].axis = 1; },
  };
  for (const auto& change : changes) {
    EXPECT_EQ(AccessOfAxis2(change), (Touched{gtcalls::Resource::kAxis, Touched::kAll, true}));
  }
  EXPECT_EQ(AccessOfAxis2([](auto*) {}), (Touched{gtcalls::Resource::kAxis, 2, true}));
}

TEST(StatementAccessTest, DependenceIsACommonThingThatOneWrites) {
  using gtcalls::Resource;
  const StatementAccess reads = {{Resource::kAxis, 1, false}};
  const StatementAccess writes = {{Resource::kAxis, 1, true}};
  const StatementAccess other = {{Resource::kAxis, 2, true}};
  const StatementAccess all = {{Resource::kAxis, Touched::kAll, true}};
  EXPECT_EQ(FindDependence(reads, reads), nullptr);
  EXPECT_NE(FindDependence(reads, writes), nullptr);
  EXPECT_EQ(FindDependence(writes, other), nullptr);
  ASSERT_NE(FindDependence(all, other), nullptr);
  EXPECT_EQ(FindDependence(all, other)->number, 2u);
}

// The emergency stop comes between the check and the start.
TEST(StatementAccessTest, ThePairOfACardsFailureIsNamed) {
  CardModel model = CardOf(
      "int stopped;\n"
      "int t0() {\n int halt;\n GT_AxisOn(1);\n GT_PrfJog(1);\n GT_SetVel(1, 50);\n halt = "
      "stopped;\n"
      " if (halt) goto E;\n GT_Update(1);\nE:\n return 0;\n}\n"
      "int t1() {\n stopped = 1;\n GT_Stop(1, 1);\n return 0;\n}\n",
      "expect = [\"axis1.moving == 0 @ 20ms\"]\ncycle_us = 1000\nrate = 100\n");
  const Exploration exploration = ExploreCard(&model, {});
  ASSERT_TRUE(exploration.failure);
  const Trail trail = Follow(&model, *exploration.failure);
  ASSERT_TRUE(trail.pair);
  EXPECT_EQ(trail.pair->what, "axis 1");
}

TEST(StatementAccessTest, PrioritiesOfStatementsKnowTheCard) {
  CardModel model = CardOf(
      "int x;\nint t0() {\n int t;\n GT_AxisOn(1);\n t = x;\n x = t + 1;\n}\n"
      "int t1() {\n int t;\n GT_AxisOn(2);\n t = x;\n x = t + 1;\n}\n",
      "expect = [\"x == 2\"]\nrate = 100\n");
  const Exploration found = ExploreCard(&model, {.engine = EngineKind::kPos, .runs = 500});
  EXPECT_EQ(found.verdict, Verdict::kFailed);
}

}  // namespace
}  // namespace oncard::explore
