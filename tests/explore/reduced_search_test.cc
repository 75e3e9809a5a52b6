// The search that leaves out states beside the graph of all states: the same verdict, and the same
// ends, for random programs and for those in which a rule matters.
#include "explore/engines/reduced_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "explore/engines/card_graph.h"
#include "explore/engines/walk.h"
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

class ReducedSearchOfRandomMachines : public testing::TestWithParam<uint64_t> {};

TEST_P(ReducedSearchOfRandomMachines, HasTheVerdictAndEndsOfAllStates) {
  constexpr uint64_t kPrograms = 125;
  const uint64_t tried = RandomCases(kPrograms);
  uint64_t reduced = 0;
  for (uint64_t i = 1; i <= tried && !HasFailure(); ++i) {
    const RandomMachine machine(GetParam() * kPrograms + i);
    reduced += ExpectSame(machine.source(), machine.keys()) ? 1 : 0;
  }
  // A quarter of them asks for races.
  EXPECT_GE(reduced, tried / 3);
}

INSTANTIATE_TEST_SUITE_P(Batches, ReducedSearchOfRandomMachines,
                         testing::Range(uint64_t{0}, uint64_t{8}));

struct Machine {
  const char* name;
  const char* source;
  const char* keys;
};

class ReducedSearchOfMachines : public testing::TestWithParam<Machine> {};

TEST_P(ReducedSearchOfMachines, HasTheVerdictAndEndsOfAllStates) {
  EXPECT_TRUE(ExpectSame(GetParam().source, GetParam().keys));
}

INSTANTIATE_TEST_SUITE_P(
    All, ReducedSearchOfMachines,
    testing::Values(
        // The order matters only if both are in one cycle, which the budget decides.
        Machine{"Budget",
                "int a, b, n;\nint t0() { a = 1; a = 2; a = 3; n = 1; return 0; }\n"
                "int t1() { b = 1; b = 2; n = 2; b = 3; return 0; }\n"
                "int t2() { int k; GT_Delay(1); k = n; return k; }\n",
                "rate = 12\n"},
        // Together they have one statement more than there is room for in a cycle.
        Machine{"OneTooMany",
                "int a, b, k;\nint t0() { a = 1; return 0; }\n"
                "int t1() { int c; b = 1; GT_GetClock(&c, &k); }\n",
                "rate = 12\n"},
        // The value that a refused command leaves in its output.
        Machine{"Refused",
                "int g, axis;\nint t0() { axis = 99; axis = 1; return 0; }\n"
                "int t1() { int s; int c; s = 5; GT_GetSts(axis, &s, 1, &c); return s; }\n",
                "rate = 16\n"},
        // A thread that waits begins to run within a cycle.
        Machine{"Waits",
                "int go, n;\nint t0() { n = n + 1; go = 1; n = n * 2; return n; }\n"
                "int t1() { GT_WaitForVarEq(&go, 1); n = n + 5; go = 2; return n; }\n"
                "int t2() { GT_Delay(1); n = n * 3; return 0; }\n",
                "rate = 12\n"},
        Machine{"Deadlock",
                "int go;\nint t0() { GT_WaitForVarEq(&go, 1); return 0; }\n"
                "int t1() { go = 1; go = 2; return 0; }\n",
                "rate = 12\n"},
        // A requirement sees a state between two statements that no thread notices.
        Machine{"Visible",
                "int a, b;\nint t0() { a = 1; a = 0; return 0; }\n"
                "int t1() { b = 1; b = 0; return 0; }\n",
                "rate = 100\nnever = [\"a == 1 && b == 1\"]\n"},
        Machine{"Assert",
                "int a;\nint t0() { int n; n = 1; a = 1; a = 0; return n; }\n"
                "int t1() { int n;\nn = 1;\n//@ assert: a == 0\nn = 2;\nreturn n; }\n",
                "rate = 100\n"},
        // A local that only an assert reads.
        Machine{"AssertOfLocal",
                "int t0() { int n; n = 1;\n//@ assert: n == 1\nn = 2;\nreturn 0; }\n"
                "int t1() { return 0; }\n",
                "rate = 100\n"},
        // Two axes one of which follows the other.
        Machine{"Gear",
                "int t0() { GT_AxisOn(1); GT_PrfTrap(1); GT_SetVel(1, 5); GT_SetPos(1, 20);"
                " GT_Update(1); return 0; }\n"
                "int t1() { GT_AxisOn(2); GT_PrfGear(2, 0); GT_SetGearMaster(2, 1, 2, 0);"
                " GT_SetGearRatio(2, 1, 1, 0); GT_GearStart(2); GT_Delay(3); return 0; }\n",
                "rate = 12\nuntil_ms = 4\nnever = [\"axis2.prfPos > 12\"]\n"},
        // An axis that has stopped starts again from where it is.
        Machine{
            "TwoMoves",
            "int t0() { GT_AxisOn(1); GT_PrfTrap(1); GT_SetVel(1, 5); GT_SetPos(1, 4);"
            " GT_Update(1); GT_Delay(3); GT_SetPos(1, 8); GT_Update(1); GT_Delay(1);"
            " GT_Stop(1, 0); GT_Delay(2); return 0; }\n"
            "int g; int t1() { int n; n = 3;\nL: g = n; n = n - 1; if (n) goto L; return 0; }\n",
            "rate = 12\nuntil_ms = 7\nfinal = [\"axis1.prfPos > 4\"]\n"}),
    [](const auto& each) { return each.param.name; });

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
