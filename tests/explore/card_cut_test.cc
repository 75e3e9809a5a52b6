// Groups of schedules of a card (explore/engines/card_cut.h), beside the search of all.
#include "explore/engines/card_cut.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <span>

#include "explore/engines/walk.h"
#include "explore/search/case_counts.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

/// Two threads that set their own variable and read the other's, five statements a cycle for both;
/// their results are what they have read last.
std::string Pollers(int times) {
  std::string source = "int a, b;\n";
  const auto add = [&](const char* name, const char* own, const char* other) {
    source += fmt::format(
        "int {}() {{\n  int n, r, s;\n  n = 0;\nlbl_next:\n  n = n + 1;\n  {} = n;\n  s = {};\n",
        name, own, other);
    source += fmt::format(
        "  r = n < {};\n  if (r) goto lbl_next;\n  GT_Delay(1);\n  return s;\n}}\n", times);
  };
  add("t0", "a", "b");
  add("t1", "b", "a");
  return source;
}
constexpr const char* kSlow = "rate = 20\n";

TEST(CardCut, ItsStartsAreDifferentAndTheirWaysLeadThere) {
  CardModel model = CardOf(Pollers(3), kSlow);
  const CardCut cut = CutCard(&model, 10, {});
  ASSERT_GE(cut.starts.size(), 10u);
  ASSERT_EQ(cut.ways.size(), cut.starts.size());
  std::set<StateKey> keys;
  for (size_t i = 0; i < cut.starts.size(); ++i) {
    keys.insert(model.KeyOf(cut.starts[i]));
    CardModel::State state = model.Start();
    for (const uint8_t thread : cut.ways[i]) state = model.Step(state, thread);
    EXPECT_EQ(model.KeyOf(state), model.KeyOf(cut.starts[i]));
  }
  EXPECT_EQ(keys.size(), cut.starts.size());
  EXPECT_TRUE(cut.counts.complete);
}

TEST(CardCut, NothingIsLeftWhereAllRunsHaveEnded) {
  CardModel model = CardOf(Pollers(1), kSlow);
  const CardCut cut = CutCard(&model, 1000, {});
  EXPECT_TRUE(cut.starts.empty());
  CardModel whole = CardOf(Pollers(1), kSlow);
  const Exploration all = ExploreCard(&whole, {.engine = EngineKind::kStateful});
  EXPECT_EQ(cut.counts.states, all.states->states);
  EXPECT_EQ(cut.counts.transitions, all.states->transitions);
  EXPECT_EQ(cut.counts.final_full, all.states->final_full);
  EXPECT_EQ(cut.ends.ends(), all.ends);
}

TEST(CardCut, ALimitTakesItBackToTheStartOfACycle) {
  CardModel model = CardOf(Pollers(3), kSlow);
  const CardCut all = CutCard(&model, 1000, {});
  StateLimits limits;
  limits.states = 60;
  const CardCut cut = CutCard(&model, 1000, limits);
  EXPECT_LE(cut.counts.states, 60);
  EXPECT_LT(cut.starts.size(), all.starts.size() + 1000);
  ASSERT_FALSE(cut.starts.empty());
  const int64_t cycle = CardModel::CycleOf(cut.starts.front());
  for (const CardModel::State& start : cut.starts) {
    EXPECT_EQ(start.served, 0u);
    EXPECT_EQ(CardModel::CycleOf(start), cycle);
  }
  EXPECT_TRUE(cut.counts.complete);
}

Exploration AllGroups(const std::string& source, const std::string& keys, int groups) {
  std::optional<Exploration> all;
  for (int group = 0; group < groups; ++group) {
    CardModel model = CardOf(source, keys);
    Exploration one = ExploreCard(
        &model, {.engine = EngineKind::kStateful, .all = true, .group = group, .groups = groups});
    if (all) {
      AddCase(std::move(one), &*all);
    } else {
      all = std::move(one);
    }
  }
  return *std::move(all);
}

TEST(CardCut, GroupsShowTheEndsOfTheWhole) {
  for (int times = 1; times <= 4; ++times) {
    CardModel model = CardOf(Pollers(times), kSlow);
    const Exploration whole = ExploreCard(&model, {.engine = EngineKind::kStateful});
    ASSERT_EQ(whole.verdict, Verdict::kProved);
    for (const int groups : {2, 3, 7}) {
      const Exploration all = AllGroups(Pollers(times), kSlow, groups);
      EXPECT_EQ(all.verdict, Verdict::kProved);
      EXPECT_EQ(all.ends, whole.ends);
      EXPECT_TRUE(all.states->in_groups);
      EXPECT_GE(all.states->states, whole.states->states);
      EXPECT_GE(all.states->final_full, whole.states->final_full);
    }
  }
}

TEST(CardCut, AFailureIsInOneOfTheGroups) {
  // Every end of the whole is forbidden in turn.
  CardModel model = CardOf(Pollers(3), kSlow);
  const Exploration whole = ExploreCard(&model, {.engine = EngineKind::kStateful});
  ASSERT_GT(whole.ends.size(), 1u);
  for (const End& end : whole.ends) {
    const auto results = std::span(end).last(2);
    const std::string keys =
        fmt::format("{}final = [\"!(thread0.result == {} && thread1.result == {})\"]\n", kSlow,
                    results[0], results[1]);
    const Exploration all = AllGroups(Pollers(3), keys, 4);
    ASSERT_EQ(all.verdict, Verdict::kFailed) << keys;
    CardModel again = CardOf(Pollers(3), keys);
    CardWalk walk(&again, false);
    for (const uint8_t thread : all.failure->steps) walk.Step(thread);
    EXPECT_TRUE(walk.fault());
  }
}

TEST(CardCut, AFailureBeforeTheGroupsIsOneOfEach) {
  for (int group = 0; group < 3; ++group) {
    CardModel model = CardOf(Pollers(3), std::string(kSlow) + "never = [\"a == 1\"]\n");
    const Exploration one =
        ExploreCard(&model, {.engine = EngineKind::kStateful, .group = group, .groups = 3});
    EXPECT_EQ(one.verdict, Verdict::kFailed);
    ASSERT_TRUE(one.failure);
    EXPECT_TRUE(one.failure->fault);
  }
}

}  // namespace
}  // namespace oncard::explore
