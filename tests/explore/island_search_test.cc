// Proofs by islands beside the search of all states.
#include "explore/engines/island_search.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "explore/engines/card_graph.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"
#include "random_machine.h"
#include "tests/base/random_cases.h"

namespace oncard::explore {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Threads that each move an axis of their own to a position and wait there for the end of the
/// motion. What they set in the end is given by its `{0}`, the thread.
std::string Moves(int axes, const std::string& in_the_end = "done{0} = 1") {
  std::string source = "int done;\n";
  for (int i = 0; i < axes; ++i) {
    source += fmt::format(
        "int done{0};\n"
        "int t{0}() {{\n  TTrapPrm trap;\n  int status;\n  int time;\n  GT_AxisOn({1});\n  "
        "GT_PrfTrap({1});\n"
        "  GT_GetTrapPrm({1}, &trap);\n  trap.acc = 1;\n  trap.dec = 1;\n"
        "  GT_SetTrapPrm({1}, &trap);\n  GT_SetVel({1}, 10);\n  GT_SetPos({1}, 100);\n"
        "  GT_Update({2});\nL:\n  GT_GetSts({1}, &status, 1, &time);\n  status = status & 1024;\n"
        "  if (status) goto L;\n",
        i, i + 1, 1 << i);
    source += "  " + fmt::format(fmt::runtime(in_the_end), i) + ";\n  return 0;\n}\n";
  }
  return source;
}

std::optional<IslandProof> ProofOf(CardModel* model, uint32_t states = 1'000'000) {
  auto islands = Islands::Of(*model);
  if (!islands) return std::nullopt;
  auto proof = ProveByIslands(model, *std::move(islands), {.states = states}).proof;
  if (proof) proof->IncludeIn(model);
  return proof;
}

TEST(IslandSearch, TheStatesOfIslandsAreASum) {
  CardModel two = CardOf(Moves(2), "final = [\"done0 == 1 && done1 == 1\"]\n");
  CardModel four = CardOf(Moves(4), "final = [\"done0 == 1 && done3 == 1\"]\n");
  const auto proof_of_two = ProofOf(&two);
  const auto proof_of_four = ProofOf(&four);
  ASSERT_TRUE(proof_of_two && proof_of_four);
  EXPECT_THAT(proof_of_four->counts.threads,
              ElementsAre(ElementsAre(0), ElementsAre(1), ElementsAre(2), ElementsAre(3)));
  EXPECT_EQ(proof_of_four->counts.states, 2 * proof_of_two->counts.states);
}

// Thread 0 adds 1 or 3, as it sees the input or asks too early; thread 1 adds 10.
TEST(IslandSearch, EverySumIsChecked) {
  constexpr const char* kSource =
      "int sum;\n"
      "int t0() {\n  int n;\n  GT_Delay(1);\n  sum = sum + 1;\n  GT_GetDi(4, &n);\n  n = n & 1;\n"
      "  if (n) goto E;\n  sum = sum + 2;\nE:\n  return 0;\n}\n"
      "int t1() { GT_AxisOn(2); sum = sum + 10; return 0; }\n";
  const auto proves = [&](const std::string& final) {
    CardModel model = CardOf(kSource, "final = [\"" + final +
                                          "\"]\n[globals]\nsum = 5\n[[world.input]]\n"
                                          "at_ms = 0.75\ntype = \"gpi\"\nindex = 1\nvalue = 1\n");
    const auto proof = ProofOf(&model);
    if (proof) {
      EXPECT_THAT(proof->counts.sums, ElementsAre("sum"));
    }
    return proof.has_value();
  };
  EXPECT_TRUE(proves("sum == 16 || sum == 18"));
  EXPECT_TRUE(proves("sum > 15 && sum < 19 && sum != 17"));
  EXPECT_FALSE(proves("sum == 16"));
  EXPECT_FALSE(proves("sum == 18"));
}

TEST(IslandSearch, ALimitIsNoProof) {
  CardModel model = CardOf(Moves(2), "final = [\"done0 == 1\"]\n");
  EXPECT_FALSE(ProofOf(&model, 100));
}

// The axis still moves when its thread ends. The other thread decides how long the run lasts.
TEST(IslandSearch, WhatLastsIsCheckedUntilTheOthersEnd) {
  constexpr const char* kSource =
      "int g;\n"
      "int t0() { GT_AxisOn(1); GT_PrfJog(1); GT_SetVel(1, 10); GT_Update(1); return 0; }\n"
      "int t1() { GT_Delay(9); g = 1; return 0; }\n";
  const auto proves = [&](const std::string& keys) {
    CardModel model = CardOf(kSource, keys);
    return ProofOf(&model).has_value();
  };
  EXPECT_TRUE(proves("never = [\"axis1.prfPos > 1000\"]\n"));
  EXPECT_FALSE(proves("never = [\"axis1.prfPos > 30\"]\n"));
  EXPECT_FALSE(proves("final = [\"axis1.prfPos < 30\"]\n"));
  EXPECT_FALSE(proves("final = [\"clock < 9\"]\n"));
  EXPECT_TRUE(proves("final = [\"clock < 11\"]\n"));
  EXPECT_FALSE(
      proves("within = [{ after = \"axis1.prfPos > 0\", then = \"thread0.run == 5\", ms = 3 }]\n"));
  // An expectation of the other thread makes the run last.
  EXPECT_FALSE(proves("never = [\"axis1.prfPos > 1000\"]\nexpect = [\"g == 1 @ 200ms\"]\n"));
}

TEST(IslandSearch, WhatGoesOnAtTheEndIsNoProof) {
  const std::string source = Moves(2);
  const Findings findings = FindingsOf(
      source, "until_ms = 5\nnever = [\"axis1.prfPos > 200 || axis2.prfPos > 200\"]\n", {});
  EXPECT_EQ(findings.exploration.verdict, Verdict::kPassed);
  ASSERT_TRUE(findings.exploration.islands);
  EXPECT_THAT(findings.exploration.why.en, HasSubstr("threads 0, 1 still run"));
}

TEST(IslandSearch, AutoProvesByIslandsWhatHasManyStates) {
  const std::string keys = "final = [\"done0 == 1 && done2 == 1\"]\n";
  const Findings findings = FindingsOf(Moves(3), keys, {});
  EXPECT_EQ(findings.exploration.verdict, Verdict::kProved);
  ASSERT_TRUE(findings.exploration.islands);
  const std::string text = TextReport(findings, Language::kEnglish, {});
  EXPECT_THAT(text, HasSubstr("by islands: threads {0}, {1}, {2}, each with any timing of the "
                              "others\n"));
  EXPECT_THAT(text, HasSubstr("\nislands: "));
  EXPECT_TRUE(findings.untested.empty());
  const Findings whole = FindingsOf(Moves(3), keys, {.state_limit = 20'000, .islands = false});
  EXPECT_EQ(whole.exploration.verdict, Verdict::kIncomplete);
}

// Thread 4 has to read each of the values that thread 3 sets: too many preemptions for a first
// look, and too many states of all threads together.
TEST(IslandSearch, AutoFindsWhatFailsInAnIsland) {
  std::string sets;
  std::string reads;
  for (int value = 1; value <= 8; ++value) {
    sets += fmt::format("  x = {};\n", value);
    reads += fmt::format("  n = x == {};\n  hits = hits + n;\n", value);
  }
  const std::string source = Moves(3) + "int x;\nint hits;\nint t3() {\n" + sets +
                             "  x = 0;\n  return 0;\n}\nint t4() {\n  int n;\n" + reads +
                             "  return 0;\n}\n";
  const std::string keys = "final = [\"hits < 8\", \"done2 == 1\"]\n";
  ExploreOptions options = {.state_limit = 300'000};
  const Findings found = FindingsOf(source, keys, options);
  EXPECT_EQ(found.exploration.verdict, Verdict::kFailed);
  ASSERT_TRUE(found.exploration.failure);
  EXPECT_EQ(found.exploration.failure->fault.requirement, 0);
  options.islands = false;
  EXPECT_EQ(FindingsOf(source, keys, options).exploration.verdict, Verdict::kIncomplete);
}

TEST(IslandSearch, AutoSumsWhatManyThreadsCount) {
  const Findings findings =
      FindingsOf(Moves(3, "done = done + 1"), "final = [\"done == 3\"]\n", {});
  EXPECT_EQ(findings.exploration.verdict, Verdict::kProved);
  ASSERT_TRUE(findings.exploration.islands);
  EXPECT_THAT(TextReport(findings, Language::kEnglish, {}),
              HasSubstr("at the end done: the sum of what they add, in every combination\n"));
}

TEST(IslandSearch, SmallProgramsAreSearchedAsAWhole) {
  const Findings findings = FindingsOf(
      "int a;\nint b;\nint t0() { GT_Delay(1); a = 1; return 0; }\n"
      "int t1() { b = 1; return 0; }\n",
      "final = [\"a == 1\"]\n", {});
  EXPECT_EQ(findings.exploration.verdict, Verdict::kProved);
  EXPECT_FALSE(findings.exploration.islands);
  EXPECT_TRUE(findings.exploration.states->complete);
}

// --- Beside the search of all states -------------------------------------------------------------

struct Tally {
  int proofs = 0;
  int failures = 0;
};

/// Searches a machine as a whole, too, unless it has too many states.
void CheckProof(const RandomMachine& card, Tally* tally) {
  CardModel whole = CardOf(card.source(), card.keys());
  const CardGraph graph = BuildCardGraph(&whole, {.states = 60'000, .states_after_bad = 0});
  const bool fails = graph.bad_states > 0;
  if (!fails && !graph.graph.complete) return;
  CardModel model = CardOf(card.source(), card.keys());
  const bool proved = ProofOf(&model).has_value();
  ASSERT_FALSE(proved && fails);
  // What goes on at the end is noted if it really does.
  if (proved) {
    EXPECT_EQ(whole.horizon().axes & ~model.horizon().axes, 0u);
    EXPECT_EQ(whole.horizon().threads & ~model.horizon().threads, 0u);
  }
  tally->proofs += proved ? 1 : 0;
  tally->failures += fails ? 1 : 0;
}

TEST(IslandSearch, ProvesNothingThatFails) {
  const auto programs = RandomCases(uint64_t{60});
  Tally tally;
  for (uint64_t seed = 1; seed <= programs; ++seed) {
    const RandomMachine card(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}{}", seed, card.keys(), card.source()));
    CheckProof(card, &tally);
  }
  // Both are many enough to tell.
  EXPECT_GE(tally.proofs, static_cast<int>(programs / 20));
  EXPECT_GE(tally.failures, static_cast<int>(programs / 5));
}

// The same with a counter that all threads add to.
TEST(IslandSearch, ProvesNoSumThatFails) {
  const auto programs = RandomCases(uint64_t{120});
  Tally tally;
  for (uint64_t seed = 1; seed <= programs; ++seed) {
    const RandomMachine card = RandomMachine::ThatCounts(seed);
    const auto islands = Islands::Of(CardOf(card.source(), card.keys()));
    if (!islands || islands->summed().empty()) continue;
    SCOPED_TRACE(fmt::format("seed {}\n{}{}", seed, card.keys(), card.source()));
    CheckProof(card, &tally);
  }
  EXPECT_GE(tally.proofs, static_cast<int>(programs / 20));
  EXPECT_GE(tally.failures, static_cast<int>(programs / 20));
}

// The replay is a schedule of the program, in which something fails, executed here once more.
TEST(IslandSearch, AFailureOfAnIslandIsReplayedInTheProgram) {
  const auto programs = RandomCases(uint64_t{200});
  int replayed = 0;
  for (uint64_t seed = 1; seed <= programs; ++seed) {
    const RandomMachine card(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}{}", seed, card.keys(), card.source()));
    CardModel model = CardOf(card.source(), card.keys());
    const auto islands = Islands::Of(model);
    if (!islands) continue;
    const IslandResult result = ProveByIslands(&model, *islands, {.states = 20'000});
    if (result.failing.empty()) continue;
    EXPECT_FALSE(result.proof);
    CardModel again = CardOf(card.source(), card.keys());
    CardModel::State state = again.Start();
    for (const uint8_t thread : result.failing) {
      ASSERT_FALSE(state.fault);
      ASSERT_NE(state.choices >> thread & 1, 0u);
      state = again.Step(state, thread);
    }
    EXPECT_TRUE(state.fault);
    ++replayed;
  }
  EXPECT_GE(replayed, static_cast<int>(programs / 10));
}

TEST(IslandSearch, RowsAndWholeStatesProveTheSame) {
  const auto programs = RandomCases(uint64_t{60});
  int proofs = 0;
  for (uint64_t seed = 1; seed <= programs; ++seed) {
    const RandomMachine card(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}{}", seed, card.keys(), card.source()));
    CardModel model = CardOf(card.source(), card.keys());
    const auto islands = Islands::Of(model);
    if (!islands) continue;
    const auto rows = ProveByIslands(&model, *islands, {.states = 20'000}).proof;
    const auto whole =
        ProveByIslands(&model, *islands, {.states = 20'000, .whole_states = true}).proof;
    ASSERT_EQ(rows.has_value(), whole.has_value());
    if (!rows) continue;
    ++proofs;
    EXPECT_EQ(rows->counts.threads, whole->counts.threads);
    EXPECT_EQ(rows->counts.states, whole->counts.states);
    EXPECT_EQ(rows->counts.transitions, whole->counts.transitions);
  }
  EXPECT_GE(proofs, static_cast<int>(programs / 12));
}

}  // namespace
}  // namespace oncard::explore
