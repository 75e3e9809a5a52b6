// Searches by rows (models/card_rows.h, card_steps.h) beside those of whole states: the graphs are
// equal, state by state, and so is what is noted on the way.
#include "explore/models/card_steps.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "card_machines.h"
#include "explore/engines/card_graph.h"
#include "explore_programs.h"
#include "random_machine.h"
#include "tests/base/random_cases.h"

namespace oncard::explore {
namespace {

struct Searched {
  CardGraph graph;
  std::set<std::string> notes;  ///< findings of the supervisor, refused commands, what is untested
  Horizon horizon;
};

Searched Search(const std::string& source, const std::string& keys, const StateLimits& limits) {
  CardModel model = CardOf(source, keys);
  CardGraph graph = BuildCardGraph(&model, limits);
  Searched searched = {std::move(graph), {}, model.horizon()};
  for (const runtime::CardFinding& found : model.found()) {
    searched.notes.insert(runtime::DescribeFindingPlace(found, {}).en);
  }
  for (const runtime::RefusedCommand& refused : model.refused()) {
    searched.notes.insert(runtime::DescribeRefusedPlace(refused, {}).en);
  }
  for (const Message& untested : model.Untested()) searched.notes.insert(untested.en);
  return searched;
}

/// True if the search was one by rows.
bool ExpectSame(const std::string& source, const std::string& keys, uint32_t states) {
  SCOPED_TRACE(keys + source);
  const Searched rows = Search(source, keys, {.states = states});
  const Searched whole = Search(source, keys, {.states = states, .whole_states = true});
  const StateGraph& graph = rows.graph.graph;
  EXPECT_EQ(graph.complete, whole.graph.graph.complete);
  EXPECT_EQ(graph.transitions, whole.graph.graph.transitions);
  EXPECT_TRUE(std::ranges::equal(graph.flags, whole.graph.graph.flags));
  EXPECT_TRUE(std::ranges::equal(graph.successors, whole.graph.graph.successors));
  EXPECT_EQ(rows.graph.bad_states, whole.graph.bad_states);
  EXPECT_EQ(rows.graph.final_globals, whole.graph.final_globals);
  EXPECT_EQ(rows.graph.final_full, whole.graph.final_full);
  EXPECT_EQ(rows.graph.ends.ends(), whole.graph.ends.ends());
  EXPECT_EQ(rows.graph.open.has_value(), whole.graph.open.has_value());
  EXPECT_THAT(rows.notes, testing::ElementsAreArray(whole.notes));
  EXPECT_EQ(rows.horizon.axes, whole.horizon.axes);
  EXPECT_EQ(rows.horizon.threads, whole.horizon.threads);
  EXPECT_FALSE(whole.graph.by_rows);
  return rows.graph.by_rows;
}

// In batches, so that they can run at once.
class CardStepsOfRandomMachines : public testing::TestWithParam<uint64_t> {};

TEST_P(CardStepsOfRandomMachines, HaveTheGraphsOfWholeStates) {
  constexpr uint64_t kPrograms = 125;
  const uint64_t programs = RandomCases(kPrograms);
  uint64_t by_rows = 0;
  for (uint64_t i = 1; i <= programs && !HasFailure(); ++i) {
    const RandomMachine machine(GetParam() * programs + i);
    by_rows += ExpectSame(machine.source(), machine.keys(), 400) ? 1 : 0;
  }
  // A quarter of them asks for races.
  EXPECT_GE(by_rows, LeastOfCases(kPrograms / 2));
}

INSTANTIATE_TEST_SUITE_P(Batches, CardStepsOfRandomMachines,
                         testing::Range(uint64_t{0}, uint64_t{8}));

class CardStepsOfMachines : public testing::TestWithParam<CardMachine> {};

TEST_P(CardStepsOfMachines, HaveTheGraphsOfWholeStates) {
  EXPECT_TRUE(ExpectSame(GetParam().source, GetParam().keys, 20'000));
}

INSTANTIATE_TEST_SUITE_P(All, CardStepsOfMachines, testing::ValuesIn(CardMachines()),
                         [](const auto& machine) { return machine.param.name; });

// The page that a thread leaves belongs to none: more has changed than the command declares.
TEST(CardSteps, AreGivenUpWhereAStatementChangesWhatItDoesNotDeclare) {
  EXPECT_FALSE(
      ExpectSame("int n;\nint t0() { int k; k = 7; GT_SetDataPage(9); n = k; return k; }\n"
                 "int t1() { int k; k = n; n = k + 1; return k; }\n",
                 "rate = 12\n", 20'000));
}

}  // namespace
}  // namespace oncard::explore
