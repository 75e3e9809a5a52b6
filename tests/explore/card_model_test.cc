// A card as a transition system: time, fairness, ends, restoring states.
#include "explore/models/card_model.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "explore/engines/card_graph.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

/// Takes one of the possible choices with `choose`, until the end.
template <typename Choose>
CardModel::State RunToEnd(CardModel* model, Choose choose, std::string* order = nullptr) {
  CardModel::State state = model->Start();
  while (!state.ended) {
    const int thread = choose(state.choices);
    if (order != nullptr) *order += static_cast<char>('0' + thread);
    state = model->Step(state, thread);
  }
  return state;
}

int FirstChoice(uint32_t choices) { return std::countr_zero(choices); }

constexpr const char* kTwoThreads =
    "int a, b;\n"
    "int t0() { a = 1; a = 2; a = 3; a = 4; return a; }\n"
    "int t1() { b = 1; b = 2; b = 3; b = 4; return b; }\n";

TEST(CardModel, EveryThreadGetsAStatementInEveryCycle) {
  // 4 statements per cycle.
  CardModel model = CardOf(kTwoThreads, "rate = 16\n");
  std::string order;
  RunToEnd(&model, FirstChoice, &order);
  EXPECT_EQ(order,
            "0001"
            "0011"
            "11");
  order.clear();
  RunToEnd(
      &model, [](uint32_t choices) { return 31 - std::countl_zero(choices); }, &order);
  EXPECT_EQ(order,
            "1110"
            "1100"
            "00");
}

TEST(CardModel, ACycleBeginsWhenItsStatementsAreUsedUp) {
  CardModel model = CardOf(kTwoThreads, "rate = 16\n");
  RunToEnd(&model, FirstChoice);
  EXPECT_EQ(model.controller().cycle(), 3);
  CardModel fast = CardOf(kTwoThreads, "rate = 100\n");
  RunToEnd(&fast, FirstChoice);
  EXPECT_EQ(fast.controller().cycle(), 1);
}

TEST(CardModel, AWaitingThreadTakesNoStatements) {
  CardModel model = CardOf(
      "int go;\nint t0() { GT_WaitForVarEq(&go, 1); return 0; }\n"
      "int t1() { GT_Delay(5); go = 1; return 0; }\n",
      {});
  std::string order;
  const CardModel::State end = RunToEnd(&model, FirstChoice, &order);
  EXPECT_EQ(order,
            "011"
            "01");
  EXPECT_TRUE(end.finished);
  EXPECT_FALSE(end.fault);
  EXPECT_GE(model.controller().NowMs(), 5);
}

// 4 statements per cycle, and the boundary after them can come between `go = 1` and `go = 0` or
// not: states that differ in nothing but the reaction then come from the same body. The filter
// takes three cycles.
TEST(CardModel, TheWorldReactsToWhatTheScheduleMakesOfAProgram) {
  constexpr const char* kPulse =
      "int go, b;\n"
      "int t0() { go = 1; go = 0; return 0; }\n"
      "int t1() { b = 1; b = 2; b = 3; b = 4; return 0; }\n";
  const std::string keys =
      "rate = 16\nuntil_ms = 3\n[[world.react]]\nwhen = \"go == 1\"\nindex = 1\nvalue = 1\n";
  const auto verdict = [&](const std::string& requirement) {
    const Findings findings = FindingsOf(kPulse, requirement + keys, {});
    return findings.exploration.verdict;
  };
  EXPECT_EQ(verdict("final = [\"gpi[1] == 0\"]\n"), Verdict::kFailed);
  EXPECT_EQ(verdict("final = [\"gpi[1] == 1\"]\n"), Verdict::kFailed);
  EXPECT_EQ(verdict("never = [\"gpi[1] == 1 && clock < 1\"]\n"), Verdict::kProved);
}

// The reaction is pending when the threads are in the same states again and again.
TEST(CardModel, WhatIsPendingDistinguishesStates) {
  constexpr const char* kPolls =
      "int n;\n"
      "int t0() {\n  int seen;\nL:\n  GT_GetDi(4, &seen);\n  n = seen & 1;\n  if (n) goto E;\n"
      "  goto L;\nE:\n  return 0;\n}\n";
  const std::string react =
      "[[world.react]]\nwhen = \"thread0.statements >= 1\"\nafter_ms = 5\nindex = 1\nvalue = 1\n";
  EXPECT_EQ(FindingsOf(kPolls, "final = [\"n == 1\"]\n" + react, {}).exploration.verdict,
            Verdict::kProved);
  CardModel model = CardOf(kPolls, react);
  const CardModel::State end = RunToEnd(&model, FirstChoice);
  EXPECT_TRUE(end.finished);
  // It starts at 0.25 ms; the program sees it with the third sample, in the cycle up to 6 ms.
  EXPECT_EQ(model.controller().NowMs(), 6);
}

TEST(CardModel, NamesReactionsThatNoRunStarts) {
  CardModel model = CardOf("int a;\nint t0() { a = 1; return 0; }\n",
                           "until_ms = 1\n[[world.react]]\nwhen = \"a == 2\"\nvalue = 1\n");
  RunToEnd(&model, FirstChoice);
  ASSERT_EQ(model.Untested().size(), 1u);
  EXPECT_EQ(model.Untested()[0].en,
            "no run starts the [[world.react]] of 'a == 2': it held at no boundary of profile "
            "cycles");
}

TEST(CardModel, SaysHowARunEnds) {
  const auto fault = [](const char* program, const char* keys) {
    CardModel model = CardOf(program, keys);
    return RunToEnd(&model, FirstChoice).fault.kind;
  };
  EXPECT_EQ(fault("int go;\nint t0() { GT_WaitForVarEq(&go, 1); return 0; }\n", ""),
            Fault::Kind::kDeadlock);
  EXPECT_EQ(fault("int t0() { L: goto L; }\n", "limit_ms = 2\n"), Fault::Kind::kTimeLimit);
  EXPECT_EQ(fault("int t0() { L: goto L; }\n", "until_ms = 2\n"), Fault::Kind::kNone);
  EXPECT_EQ(fault("int z;\nint t0() { z = 1 / z; return 0; }\n", ""), Fault::Kind::kThread);
  EXPECT_EQ(
      fault("int z;\nint t0() { z = 1 / z; return 0; }\n", "expect = [\"thread0.error == 99\"]\n"),
      Fault::Kind::kRequirement);
  EXPECT_EQ(fault("int a;\nint t0() { a = 7; a = 0; return 0; }\n", "never = [\"a == 7\"]\n"),
            Fault::Kind::kRequirement);
  EXPECT_EQ(fault("int a;\nint t0() { a = 7; a = 0; return 0; }\n", "expect = [\"a == 0\"]\n"),
            Fault::Kind::kNone);
}

TEST(CardModel, MotionGoesOnUntilTheLastInstantThatIsAskedFor) {
  constexpr const char* kJog =
      "int t0() { GT_AxisOn(1); GT_PrfJog(1); GT_SetVel(1, 10); GT_Update(1); return 0; }\n";
  CardModel model = CardOf(kJog, "expect = [\"axis1.prfVel == 10 @ 50ms\"]\n");
  EXPECT_FALSE(RunToEnd(&model, FirstChoice).fault);
  EXPECT_EQ(model.controller().NowMs(), 50);
  // While an axis moves, an invariant is checked in every cycle.
  CardModel watched =
      CardOf(kJog, "expect = [\"axis1.moving == 1 @ 50ms\"]\nalways = [\"axis1.prfPos < 100\"]\n");
  EXPECT_EQ(RunToEnd(&watched, FirstChoice).fault.kind, Fault::Kind::kRequirement);
  EXPECT_LT(watched.controller().NowMs(), 50);
}

TEST(CardModel, AStateThatIsPutBackGoesOnAsItDid) {
  CardModel model = CardOf(
      "int a;\nint t0() { GT_AxisOn(1); GT_PrfJog(1); GT_SetVel(1, 10); GT_Update(1); a = a + 1;"
      " return a; }\nint t1() { a = a + 2; GT_Delay(3); a = a * 2; return a; }\n",
      "rate = 8\n");
  std::vector<CardModel::State> states = {model.Start()};
  std::mt19937_64 random(7);
  while (!states.back().ended) {
    const uint32_t choices = states.back().choices;
    int thread = static_cast<int>(random() % 2);
    if ((choices >> thread & 1) == 0) thread = 1 - thread;
    states.push_back(model.Step(states.back(), thread));
  }
  for (size_t i = states.size() - 1; i-- > 0;) {
    bool found = false;
    for (int thread = 0; thread < 2; ++thread) {
      if ((states[i].choices >> thread & 1) == 0) continue;
      const CardModel::State next = model.Step(states[i], thread);
      found = found || model.KeyOf(next) == model.KeyOf(states[i + 1]);
    }
    EXPECT_TRUE(found) << i;
  }
}

// Bodies are shared between states; a run that is never revisited does not have them.
TEST(CardModel, StatesThatAreVisitedInAnyOrderAreThoseOfRuns) {
  const std::string source =
      "int a;\nint t0() { GT_AxisOn(1); GT_PrfJog(1); GT_SetVel(1, 10); GT_Update(1); GT_Delay(2);"
      " GT_Stop(1, 0); a = a + 1; return a; }\n"
      "int t1() { GT_Delay(3); a = a + 2; GT_SetDo(12, a); GT_Delay(1); a = a * 2; return a; }\n";
  const std::string keys = "rate = 3\n";
  struct Walk {
    std::vector<int> order;
    CardModel::State state;
  };
  CardModel model = CardOf(source, keys);
  std::vector<Walk> walks(8, Walk{{}, model.Start()});
  std::mt19937_64 random(11);
  const auto open = [](const Walk& walk) { return !walk.state.ended; };
  while (std::ranges::any_of(walks, open)) {
    Walk& walk = walks[random() % walks.size()];
    if (!open(walk)) continue;
    int thread = static_cast<int>(random() % 2);
    if ((walk.state.choices >> thread & 1) == 0) thread = 1 - thread;
    walk.state = model.Step(walk.state, thread);
    walk.order.push_back(thread);
  }
  for (const Walk& walk : walks) {
    CardModel straight = CardOf(source, keys);
    CardModel::State state = straight.Begin();
    for (const int thread : walk.order) straight.Advance(&state, thread);
    EXPECT_EQ(straight.KeyOf(straight.Whole(state)), model.KeyOf(walk.state));
  }
}

// A card that executes everything within one cycle has the same ends as the program alone, unless a
// thread waits for another one.
TEST(CardGraph, HasTheEndsOfTheProgramAlone) {
  for (const auto& source : {Increments(2, 2), Increments(3, 1)}) {
    CardModel model = CardOf(source, "rate = 1000\n");
    const CardGraph card = BuildCardGraph(&model, {});
    const auto program = Explore(ProblemOf(source), {.engine = EngineKind::kStateful});
    EXPECT_TRUE(card.graph.complete);
    EXPECT_EQ(card.final_globals, program.value().states->final_globals);
    EXPECT_EQ(card.final_full, program.value().states->final_full);
  }
}

// Thread 0 executes 5 or 6 statements, and is in the same state after them.
constexpr const char* kTwoCounts =
    "int g;\n"
    "int t0() {\n  int seen;\n  seen = g;\n  if (seen) goto E;\n  seen = 1;\nE:\n  seen = 0;\n"
    "  GT_Delay(1);\n%s  return 0;\n}\n"
    "int t1() { g = 1; return 0; }\n";

std::string TwoCounts(const std::string& assert) {
  std::string source = kTwoCounts;
  return source.replace(source.find("%s"), 2, assert);
}

Verdict StatefulVerdict(const std::string& source, const std::string& keys) {
  return FindingsOf(source, keys, {.engine = EngineKind::kStateful}).exploration.verdict;
}

TEST(ExploreCard, CountsOfStatementsThatAreNamedDistinguishStates) {
  for (const char* count : {"5", "6"}) {
    const std::string of_thread = std::string("thread0.statements != ") + count;
    EXPECT_EQ(StatefulVerdict(TwoCounts(""), "final = [\"" + of_thread + "\"]\n"),
              Verdict::kFailed);
    EXPECT_EQ(StatefulVerdict(TwoCounts(""), "expect = [\"" + of_thread + "\"]\n"),
              Verdict::kFailed);
    EXPECT_EQ(StatefulVerdict(TwoCounts(""), "leads = [\"clock >= 1 -> " + of_thread + "\"]\n"),
              Verdict::kFailed);
  }
  EXPECT_EQ(StatefulVerdict(TwoCounts(""), "final = [\"thread0.statements != 7\"]\n"),
            Verdict::kProved);
  // With the two statements of thread 1.
  for (const char* count : {"7", "8"}) {
    EXPECT_EQ(
        StatefulVerdict(TwoCounts(""), std::string("final = [\"statements != ") + count + "\"]\n"),
        Verdict::kFailed);
  }
  // Before the statement that returns.
  for (const char* count : {"4", "5"}) {
    EXPECT_EQ(StatefulVerdict(
                  TwoCounts(std::string("//@ assert: thread0.statements != ") + count + "\n"), ""),
              Verdict::kFailed);
  }
}

TEST(ExploreCard, CountsOfStatementsThatStartReactionsDistinguishStates) {
  for (const char* count : {"5", "6"}) {
    EXPECT_EQ(
        StatefulVerdict(TwoCounts(""), std::string("expect = [\"gpi[1] == 0 "
                                                   "@ 8ms\"]\n[[world.react]]\nwhen = "
                                                   "\"thread0.statements == ") +
                                           count + "\"\nafter_ms = 1\nindex = 1\nvalue = 1\n"),
        Verdict::kFailed);
  }
}

TEST(CardGraph, ALimitEndsTheSearch) {
  CardModel model = CardOf(Increments(3, 2), {});
  EXPECT_FALSE(BuildCardGraph(&model, {.states = 100}).graph.complete);
}

TEST(ExploreCard, TellsAProofFromABound) {
  CardModel proved = CardOf(kTwoThreads, "expect = [\"a == 4\"]\n");
  EXPECT_EQ(ExploreCard(&proved, {}).verdict, Verdict::kProved);
  CardModel passed = CardOf("int t0() { L: goto L; }\n", "until_ms = 2\n");
  EXPECT_EQ(ExploreCard(&passed, {}).verdict, Verdict::kPassed);
  CardModel failed = CardOf(Increments(2, 1), "expect = [\"x == 2\"]\n");
  const Exploration exploration = ExploreCard(&failed, {});
  EXPECT_EQ(exploration.verdict, Verdict::kFailed);
  EXPECT_EQ(exploration.failure->preemptions, 1);
  EXPECT_TRUE(exploration.failure->fewest_preemptions);
  CardModel large = CardOf(Increments(3, 2), {});
  EXPECT_EQ(ExploreCard(&large, {.state_limit = 50}).verdict, Verdict::kIncomplete);
}

TEST(ExploreCard, AutoTriesRandomSchedulesWhereThereAreTooManyStates) {
  CardModel large = CardOf(Increments(3, 2), {});
  EXPECT_EQ(ExploreCard(&large, {.state_limit = 50}).why.en,
            "the limit of 50 states was reached; none of 1000 random schedules of the engine pos "
            "fails");
  EXPECT_EQ(ExploreCard(&large, {.engine = EngineKind::kStateful, .state_limit = 50}).why.en,
            "the limit of 50 states was reached");
}

// Thread 1 sees all four values only if the threads take turns six times: too often for the
// schedules of few preemptions and of few changes of priority that `auto` tries first.
TEST(ExploreCard, AutoFailsWithARandomScheduleThatDoesSo) {
  constexpr const char* kAlternates =
      "int a, n;\n"
      "int t0() { a = 1; a = 2; a = 3; a = 4; return 0; }\n"
      "int t1() {\n  int s, e;\n  s = a; e = s == 1; n = n + e;\n  s = a; e = s == 2; n = n + e;\n"
      "  s = a; e = s == 3; n = n + e;\n  s = a; e = s == 4; n = n + e;\n  return 0;\n}\n";
  const std::string keys = "rate = 4000\nuntil_ms = 1\nnever = [\"n == 4\"]\n";
  const ExploreOptions few = {.state_limit = 50};
  const Exploration found = FindingsOf(kAlternates, keys, few).exploration;
  EXPECT_EQ(found.verdict, Verdict::kFailed);
  EXPECT_EQ(found.engine, EngineKind::kPos);
  EXPECT_EQ(found.why.en, "");
  ASSERT_TRUE(found.failure);
  EXPECT_EQ(found.failure->preemptions, 6);
  EXPECT_FALSE(found.failure->fewest_preemptions);
  CardModel model = CardOf(kAlternates, keys);
  CardModel::State state = model.Start();
  for (const uint8_t thread : found.failure->steps) {
    ASSERT_FALSE(state.fault);
    state = model.Step(state, thread);
  }
  EXPECT_TRUE(state.fault);
}

// --- Findings of the supervisor ------------------------------------------------------------------

constexpr const char* kJog =
    "int t0() { GT_AxisOn(1); GT_PrfJog(1); GT_SetVel(1, 10); GT_Update(1); return 0; }\n";

TEST(CardFindings, SayAtTheEndThatAnAxisStillMoves) {
  const Findings findings = FindingsOf(kJog, "until_ms = 30\n", {});
  ASSERT_EQ(findings.card.size(), 1u);
  EXPECT_EQ(findings.card[0].warning, runtime::CardWarning::kWorkLeft);
}

TEST(CardFindings, SayNothingOfTheEndOfARunThatAFailureCuts) {
  const Findings findings =
      FindingsOf(kJog, "until_ms = 30\nalways = [\"axis1.prfPos < 20\"]\n", {});
  EXPECT_EQ(findings.exploration.verdict, Verdict::kFailed);
  EXPECT_TRUE(findings.card.empty());
}

}  // namespace
}  // namespace oncard::explore
