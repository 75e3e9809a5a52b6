// Searches by rows (models/card_rows.h, card_steps.h) beside those of whole states: the graphs are
// equal, state by state, and so is what is noted on the way.
#include "explore/models/card_steps.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

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
  const auto programs = RandomCases(uint64_t{125});
  uint64_t by_rows = 0;
  for (uint64_t i = 1; i <= programs && !HasFailure(); ++i) {
    const RandomMachine machine(GetParam() * programs + i);
    by_rows += ExpectSame(machine.source(), machine.keys(), 400) ? 1 : 0;
  }
  // A quarter of them asks for races.
  EXPECT_GE(by_rows, programs / 3);
}

INSTANTIATE_TEST_SUITE_P(Batches, CardStepsOfRandomMachines,
                         testing::Range(uint64_t{0}, uint64_t{8}));

struct Machine {
  const char* name;
  const char* source;
  const char* keys;
};

class CardStepsOfMachines : public testing::TestWithParam<Machine> {};

TEST_P(CardStepsOfMachines, HaveTheGraphsOfWholeStates) {
  EXPECT_TRUE(ExpectSame(GetParam().source, GetParam().keys, 20'000));
}

INSTANTIATE_TEST_SUITE_P(
    All, CardStepsOfMachines,
    testing::Values(
        // An axis follows another one.
        Machine{"Gear",
                "int t0() { GT_AxisOn(1); GT_PrfTrap(1); GT_SetVel(1, 5); GT_SetPos(1, 20);"
                " GT_Update(1); return 0; }\n"
                "int t1() { GT_AxisOn(2); GT_PrfGear(2, 0); GT_SetGearMaster(2, 1, 2, 0);"
                " GT_SetGearRatio(2, 1, 1, 0); GT_GearStart(2); GT_Delay(3); return 0; }\n",
                "rate = 12\nuntil_ms = 4\nnever = [\"axis2.prfPos > 12\"]\n"},
        // Threads that wait, one of them at the end of its function.
        Machine{"Waits",
                "int go, n;\n"
                "int t0() { n = n + 1; go = n; GT_Delay(1); }\n"
                "int t1() { GT_WaitForVarEq(&go, 1); n = n + 5; go = 2; return n; }\n"
                "int t2() { GT_Delay(2); n = n * 2; GT_WaitForVarEq(&go, 2); }\n",
                "rate = 12\n"},
        Machine{"Deadlock",
                "int go;\nint t0() { GT_WaitForVarEq(&go, 1); return 0; }\n"
                "int t1() { go = 1; go = 2; return 0; }\n",
                "rate = 12\n"},
        Machine{"Reaction",
                "int go, n;\nint t0() { go = 1; GT_SetDoBit(12, 1, 1); go = 0; return 0; }\n"
                "int t1() {\n  int seen;\nL:\n  GT_GetDi(4, &seen);\n  n = seen & 1;\n"
                "  if (n) goto E;\n  GT_Delay(1);\n  goto L;\nE:\n  return 0;\n}\n",
                "rate = 12\nlimit_ms = 6\nfinal = [\"n == 1\"]\n[[world.react]]\n"
                "when = \"gpo[1] == 1 && go == 1\"\nafter_ms = 1\nindex = 1\nvalue = 1\n"},
        Machine{"Arrays",
                "int a[4], i;\nint t0() { i = 1; a[i] = 3; i = 2; a[i] = a[1]; return i; }\n"
                "int t1() { int k; k = a[i]; a[k] = 7; i = a[1]; a[0] = k; return k; }\n",
                "rate = 12\n"},
        // The second thread takes the target of the first one, or changes its motion.
        Machine{"TwoThreads",
                "int t0() { GT_AxisOn(1); GT_PrfTrap(1); GT_SetVel(1, 5); GT_SetPos(1, 20);"
                " GT_Update(1); return 0; }\n"
                "int t1() { GT_SetPos(1, 9); GT_Update(2); GT_Update(1); GT_AxisOn(9);"
                " return 0; }\n",
                "rate = 12\nuntil_ms = 3\nwithin = [{ after = \"axis1.moving == 1\","
                " then = \"axis1.prfPos > 3\", ms = 1 }]\n"},
        Machine{"Assert",
                "int x;\nint t0() { x = 1; x = 0; return 0; }\n"
                "int t1() {\n  GT_Delay(1);\n  //@ assert: x == 0\n  x = 2;\n  return x;\n}\n",
                "rate = 12\neventually = [\"x == 2\"]\n"}),
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
