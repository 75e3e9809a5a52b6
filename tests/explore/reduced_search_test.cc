// The search that leaves out states beside the graph of all states: the same verdict, and the same
// ends, for random programs and for those in which a rule matters.
#include "explore/engines/reduced_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "card_machines.h"
#include "explore/engines/card_graph.h"
#include "explore/engines/walk.h"
#include "explore/models/card_steps.h"
#include "explore_programs.h"
#include "random_machine.h"
#include "tests/base/random_cases.h"

namespace oncard::explore {
namespace {

/// False if states of the program cannot be left out.
bool ExpectSame(const std::string& source, const std::string& keys) {
  SCOPED_TRACE(keys + source);
  CardModel model = CardOf(source, keys);
  const auto reduced = SearchReduced(&model, {.states = 300'000});
  if (!reduced) return false;
  CardModel other = CardOf(source, keys);
  const CardGraph graph =
      BuildCardGraph(&other, {.states = 300'000, .states_after_bad = reduced->fails ? 0u : ~0u});
  EXPECT_EQ(reduced->fails, graph.bad_states > 0);
  if (reduced->fails) {
    CardWalk walk(&model, false);
    for (const uint8_t thread : reduced->failing) walk.Step(thread);
    EXPECT_TRUE(static_cast<bool>(walk.fault()));
    return true;
  }
  if (!graph.graph.complete) return reduced->complete;
  EXPECT_TRUE(reduced->complete);
  EXPECT_EQ(reduced->final_globals, graph.final_globals);
  EXPECT_EQ(reduced->final_full, graph.final_full);
  EXPECT_EQ(reduced->ends.ends(), graph.ends.ends());
  EXPECT_EQ(model.horizon().axes, other.horizon().axes);
  EXPECT_EQ(model.horizon().threads, other.horizon().threads);
  return true;
}

std::string At(const char* ms) {
  return std::string("[[world.input]]\nindex = 1\nvalue = 1\nat_ms = ") + ms + "\n";
}

std::vector<std::string> TextsOf(const std::vector<Message>& messages) {
  std::vector<std::string> texts;
  for (const Message& message : messages) texts.push_back(message.en);
  return texts;
}

template <typename Found>
std::vector<std::pair<int, int64_t>> CountsOf(const std::vector<Found>& all) {
  std::vector<std::pair<int, int64_t>> counts;
  for (const Found& found : all) counts.emplace_back(found.place.line, found.count);
  std::ranges::sort(counts);
  return counts;
}

/// What cases with other events know of the steps leaves out work, and nothing else. Returns false
/// if states of the program cannot be left out.
bool ExpectSameWithKnownSteps(const std::string& source, const std::string& keys) {
  const auto known = std::make_shared<KnownSteps>();
  for (const char* at_ms : {"0.5", "1", "1.75", "40"}) {
    const std::string chosen = keys + At(at_ms);
    SCOPED_TRACE(chosen + source);
    CardModel model = CardOf(source, chosen);
    const auto alone = SearchReduced(&model, {.states = 20'000});
    if (!alone) return false;
    CardModel other = CardOf(source, chosen);
    const auto shared = SearchReduced(&other, {.states = 20'000, .known_steps = known});
    EXPECT_TRUE(shared.has_value());
    if (!shared) return true;
    EXPECT_EQ(shared->counts.states, alone->counts.states);
    EXPECT_EQ(shared->counts.transitions, alone->counts.transitions);
    EXPECT_EQ(shared->counts.starts, alone->counts.starts);
    EXPECT_EQ(shared->complete, alone->complete);
    EXPECT_EQ(shared->failing, alone->failing);
    EXPECT_EQ(shared->final_full, alone->final_full);
    EXPECT_EQ(shared->ends.ends(), alone->ends.ends());
    EXPECT_EQ(other.HeldSoFar(), model.HeldSoFar());
    EXPECT_EQ(TextsOf(other.UntestedRequirements()), TextsOf(model.UntestedRequirements()));
    EXPECT_EQ(other.horizon().axes, model.horizon().axes);
    EXPECT_EQ(CountsOf(other.refused()), CountsOf(model.refused()));
    EXPECT_EQ(CountsOf(other.found()), CountsOf(model.found()));
  }
  return true;
}

class ReducedSearchOfRandomMachines : public testing::TestWithParam<uint64_t> {};

TEST_P(ReducedSearchOfRandomMachines, HasTheVerdictAndEndsOfAllStates) {
  constexpr uint64_t kPrograms = 125;
  const uint64_t programs = RandomCases(kPrograms);
  uint64_t reduced = 0;
  for (uint64_t i = 1; i <= programs && !HasFailure(); ++i) {
    const RandomMachine machine(GetParam() * programs + i);
    reduced += ExpectSame(machine.source(), machine.keys()) ? 1 : 0;
  }
  // A quarter of them asks for races.
  EXPECT_GE(reduced, LeastOfCases(kPrograms / 2));
}

TEST_P(ReducedSearchOfRandomMachines, IsTheSameWithWhatOtherCasesKnow) {
  constexpr uint64_t kPrograms = 25;
  const uint64_t programs = RandomCases(kPrograms);
  uint64_t reduced = 0;
  for (uint64_t i = 1; i <= programs && !HasFailure(); ++i) {
    const RandomMachine machine(GetParam() * programs + i);
    reduced += ExpectSameWithKnownSteps(machine.source(), machine.keys()) ? 1 : 0;
  }
  EXPECT_GE(reduced, LeastOfCases(kPrograms / 2));
}

INSTANTIATE_TEST_SUITE_P(Batches, ReducedSearchOfRandomMachines,
                         testing::Range(uint64_t{0}, uint64_t{8}));

class ReducedSearchOfMachines : public testing::TestWithParam<CardMachine> {};

TEST_P(ReducedSearchOfMachines, HasTheVerdictAndEndsOfAllStates) {
  EXPECT_TRUE(ExpectSame(GetParam().source, GetParam().keys));
}

TEST_P(ReducedSearchOfMachines, IsTheSameWithWhatOtherCasesKnow) {
  EXPECT_TRUE(ExpectSameWithKnownSteps(GetParam().source, GetParam().keys));
}

INSTANTIATE_TEST_SUITE_P(All, ReducedSearchOfMachines, testing::ValuesIn(CardMachines()),
                         [](const auto& machine) { return machine.param.name; });

TEST(ReducedSearch, LeavesOutMostStatesOfThreadsThatDoNotMeet) {
  CardModel model = CardOf(
      "int a, b;\nint t0() { a = 1; a = 2; a = 3; return 0; }\n"
      "int t1() { b = 1; b = 2; b = 3; return 0; }\n",
      "rate = 100\n");
  const auto reduced = SearchReduced(&model, {});
  ASSERT_TRUE(reduced);
  EXPECT_EQ(reduced->counts.transitions, 8) << "one order";
  EXPECT_EQ(reduced->counts.starts, 1);
}

TEST(ReducedSearch, SaysWhereItsLimitWasReached) {
  CardModel model = CardOf(Increments(3, 6), "rate = 12\n");
  const auto reduced = SearchReduced(&model, {.states = 100});
  ASSERT_TRUE(reduced);
  EXPECT_FALSE(reduced->complete);
  EXPECT_TRUE(reduced->open);
}

TEST(ReducedSearch, IsNotPossibleWhereAThreadChangesItsPage) {
  CardModel model = CardOf("int t0() { int n; n = 1; GT_SetDataPage(7); return n; }\n", "");
  EXPECT_FALSE(SearchReduced(&model, {}));
}

}  // namespace
}  // namespace oncard::explore
