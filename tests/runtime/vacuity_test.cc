// What was not put to the test (runtime/scenario/run/vacuity.h).
#include "runtime/scenario/run/vacuity.h"

#include <gtest/gtest.h>

namespace oncard::runtime {
namespace {

struct GuardCase {
  Scope scope;
  const char* text;
  const char* left;  ///< empty: it has no guard
  bool negated = false;
};

class GuardTest : public ::testing::TestWithParam<GuardCase> {};

TEST_P(GuardTest, IsTheLeftSideOfWhatOnlyMattersThere) {
  const GuardCase& c = GetParam();
  const auto guard = GuardOf({c.scope, c.text});
  ASSERT_EQ(guard.has_value(), *c.left != 0);
  if (!guard) return;
  EXPECT_EQ(guard->left, c.left);
  EXPECT_EQ(guard->negated, c.negated);
}

INSTANTIATE_TEST_SUITE_P(
    Requirements, GuardTest,
    ::testing::Values(
        GuardCase{Scope::kNever, "a == 1 && b > 2", "a == 1"},
        GuardCase{Scope::kNever, "a && b && c", "a && b"},
        GuardCase{Scope::kNever, "(a || b) && c", "(a || b)"},
        GuardCase{Scope::kNever, "a && b || c", ""}, GuardCase{Scope::kNever, "(a && b)", ""},
        GuardCase{Scope::kNever, "a", ""}, GuardCase{Scope::kAlways, "!a || b", "!a", true},
        GuardCase{Scope::kAlways, "!(a && b) || c", "!(a && b)", true},
        GuardCase{Scope::kFinal, "!a || b == 3", "!a", true},
        GuardCase{Scope::kAlways, "!a || b || c", ""}, GuardCase{Scope::kAlways, "a || b", ""},
        GuardCase{Scope::kAlways, "a && b", ""}, GuardCase{Scope::kEventually, "!a || b", ""}));

TEST(VacuityTest, SaysWhichSideWasEnough) {
  const Requirement never = {Scope::kNever, "a && b"};
  EXPECT_EQ(DescribeVacuous(never, *GuardOf(never)).en,
            "'never: a && b' was met by its left side alone: 'a' never held");
  const Requirement always = {Scope::kAlways, "!a || b"};
  EXPECT_EQ(DescribeVacuous(always, *GuardOf(always)).zh,
            "“always: !a || b”仅凭左侧即已满足：“!a”始终成立");
}

TEST(VacuityTest, EventsBehindTheEndAreNamedOnceForEachKind) {
  World world;
  world.inputs = {{.at_us = 1000}, {.at_us = 600'000}, {.at_us = 500'000}};
  world.voltages = {{.at_us = 30'000}};
  const auto late = DescribeLateEvents(world, 30'000, false);
  ASSERT_EQ(late.size(), 1u);
  EXPECT_EQ(late[0].en,
            "the run ended at 30 ms, before [[world.input]] at 500, 600 ms: 'until_ms' makes it "
            "last longer");
  EXPECT_EQ(DescribeLateEvents(world, 30'000, true)[0].zh,
            "没有运行持续到 500, 600 ms 的 [[world.input]]：最后的运行在 30 ms "
            "结束（可用“until_ms”使运行继续）");
  EXPECT_TRUE(DescribeLateEvents(world, 600'000, false).empty());
}

TEST(VacuityTest, ReactionsThatNothingStartedAreNamed) {
  World world;
  world.reactions = {{.when = "a"}, {.when = "b"}, {.when = "c"}};
  const auto idle = DescribeIdleReactions(world, 0b010, true);
  ASSERT_EQ(idle.size(), 2u);
  EXPECT_EQ(idle[0].en,
            "no run starts the [[world.react]] of 'a': it held at no boundary of profile cycles");
  EXPECT_EQ(idle[1].zh, "没有运行触发 [[world.react]]：“c”在任何规划周期边界上都未成立");
}

}  // namespace
}  // namespace oncard::runtime
