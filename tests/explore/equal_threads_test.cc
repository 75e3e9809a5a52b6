// Threads that can be exchanged, and what a search of their states leaves out
// (explore/models/equal_threads.h).
#include "explore/models/equal_threads.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "explore/engines/state_search.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

std::vector<std::vector<int>> GroupsOf(const std::string& source) {
  return EqualThreads(ProblemOf(source).model).groups();
}

TEST(EqualThreadsTest, HaveTheSameStatements) {
  const std::string x = "{\n  int a, b;\n  a = x;\n  b = a + 1;\n  x = b;\n  return b;\n}\n";
  const std::string other_constant =
      "{\n  int a, b;\n  a = x;\n  b = a + 2;\n  x = b;\n  return b;\n}\n";
  const std::string other_global =
      "{\n  int a, b;\n  a = y;\n  b = a + 1;\n  x = b;\n  return b;\n}\n";
  const std::string other_local =
      "{\n  int a, b;\n  a = x;\n  b = a + 1;\n  x = b;\n  return a;\n}\n";
  const std::string globals = "int x, y;\n";
  EXPECT_THAT(GroupsOf(globals + "int t0() " + x + "int t1() " + x),
              ElementsAre(ElementsAre(0, 1)));
  for (const std::string& other : {other_constant, other_global, other_local}) {
    EXPECT_THAT(GroupsOf(globals + "int t0() " + x + "int t1() " + other), IsEmpty());
    EXPECT_THAT(GroupsOf(globals + "int t0() " + other + "int t1() " + x + "int t2() " + other +
                         "int t3() " + x + "int t4() " + x),
                ElementsAre(ElementsAre(0, 2), ElementsAre(1, 3, 4)));
  }
}

// An assert belongs to the statements of one thread.
TEST(EqualThreadsTest, MeetNoCheck) {
  const std::string other = "int t1() {\n  x = 1;\n  return 0;\n}\n";
  const std::string t0 = "int x;\nint t0() {\n";
  EXPECT_THAT(GroupsOf(t0 + "  x = 1;\n  return 0;\n}\n" + other), ElementsAre(ElementsAre(0, 1)));
  EXPECT_THAT(GroupsOf(t0 + "  //@ assert: x < 2\n  x = 1;\n  return 0;\n}\n" + other), IsEmpty());
}

TEST(EqualThreadsTest, EndsAreThoseOfAllExchanges) {
  const std::string reader = "{\n  return x;\n}\n";
  const std::string writer = "{\n  x = x + 1;\n  return x;\n}\n";
  Model model = ProblemOf("int x;\nint t0() " + writer + "int t1() " + reader + "int t2() " +
                          writer + "int t3() " + reader + "int t4() " + reader)
                    .model;
  // Thread 3 returns 0, thread 0 then 1, threads 1 and 4 as well, thread 2 returns 2.
  for (const int thread : {3, 0, 0, 1, 4, 2, 2}) model.Step(thread);
  ASSERT_EQ(model.runnable(), 0u);
  Model scratch = model;
  std::vector<End> ends;
  ForEachExchange(
      EqualThreads(ProblemOf("int x;\nint t0() " + writer + "int t1() " + reader + "int t2() " +
                             writer + "int t3() " + reader + "int t4() " + reader)
                       .model),
      model, &scratch, [&](const Model& end) { ends.push_back(EndOf(end)); });
  EXPECT_THAT(ends, UnorderedElementsAre(End{2, 1, 0, 2, 1, 1}, End{2, 1, 1, 2, 0, 1},
                                         End{2, 1, 1, 2, 1, 0}, End{2, 2, 0, 1, 1, 1},
                                         End{2, 2, 1, 1, 0, 1}, End{2, 2, 1, 1, 1, 0}));
}

// Two threads that read x and write it back, increased. S: not begun; Hn: has read n - 1; E: ended.
// (S, S), (H1, S), (S, H1), (H1, H1) with x = 0; (E, S), (S, E), (E, H1), (H1, E), (E, H2), (H2,
// E), (E, E) with x = 1; (E, E) with x = 2. What an ended thread has written tells three ends
// apart.
TEST(EqualThreadsTest, StatesAreCountedOnce) {
  struct Case {
    bool dead_locals;
    bool symmetry;
    int64_t states;
  };
  for (const Case& c : {Case{false, false, 13}, Case{true, false, 12}, Case{true, true, 8}}) {
    Problem problem = ProblemOf(Increments(2, 1));
    problem.requirements.clear();
    const Exploration found = Explore(problem, {.engine = EngineKind::kStateful,
                                                .merge_private = true,
                                                .dead_locals = c.dead_locals,
                                                .symmetry = c.symmetry})
                                  .value();
    EXPECT_EQ(found.states->states, c.states);
    EXPECT_EQ(found.states->symmetric, c.symmetry);
    EXPECT_EQ(found.states->final_globals, 2);
    EXPECT_EQ(found.verdict, Verdict::kProved);
  }
}

// What tells threads apart, or needs to know who does what.
TEST(EqualThreadsTest, RequirementsCanTellThreadsApart) {
  const std::string thread = "{\n  int r;\n  r = x;\n  x = 1;\n  return r;\n}\n";
  struct Case {
    const char* requirement;
    bool symmetric;
  };
  for (const Case& c :
       {Case{"final: x == 1", true}, Case{"never: x == 2", true}, Case{"final: ret0 < 2", false},
        Case{"final: page1.r < 2", false}, Case{"eventually: x == 1", false},
        Case{"leads: x == 0 -> x == 1", false}}) {
    SCOPED_TRACE(c.requirement);
    const Problem problem = ProblemOf(std::string("int x;\n//@ ") + c.requirement + "\nint t0() " +
                                      thread + "int t1() " + thread);
    const Exploration found = Explore(problem, {.engine = EngineKind::kStateful}).value();
    EXPECT_EQ(found.verdict, Verdict::kProved);
    EXPECT_EQ(found.states->symmetric, c.symmetric);
  }
}

// Threads that wait can go round in circles, which single threads are needed to judge.
TEST(EqualThreadsTest, CirclesAreJudgedInAllStates) {
  const std::string thread =
      "{\n  int c;\nW:\n  c = lock;\n  lock = 1;\n  if (c) goto W;\n  n = n + 1;\n  lock = 0;\n"
      "  return 0;\n}\n";
  const std::string source =
      "int lock, n;\n//@ final: n < 3\nint t0() " + thread + "int t1() " + thread;
  const Exploration found =
      Explore(ProblemOf(source), {.engine = EngineKind::kStateful, .merge_private = true}).value();
  EXPECT_FALSE(found.states->symmetric);
  EXPECT_EQ(found.verdict,
            Explore(ProblemOf(source),
                    {.engine = EngineKind::kStateful, .merge_private = true, .symmetry = false})
                .value()
                .verdict);
  const Exploration lasting =
      Explore(ProblemOf("//@ livelock: any\n" + source), {.engine = EngineKind::kStateful}).value();
  EXPECT_TRUE(lasting.states->symmetric);
  EXPECT_EQ(lasting.verdict, Verdict::kProved);
}

// A failure to which only the search with equal threads comes before the limit is a run of the
// program.
TEST(EqualThreadsTest, FailuresAreRuns) {
  const Problem problem = ProblemOf("//@ never: x == 1 && done == 4\n" + [] {
    std::string source = "int x, done;\n";
    for (int thread = 0; thread < 4; ++thread) {
      source += "int t" + std::to_string(thread) +
                "() {\n  int t;\n  t = x;\n  t = t + 1;\n  x = t;\n  done = done + 1;\n"
                "  return 0;\n}\n";
    }
    return source;
  }());
  int only_with_equals = 0;
  for (uint32_t limit = 20; limit < 2000; limit += 20) {
    ExploreOptions options = {
        .engine = EngineKind::kStateful, .state_limit = limit, .merge_private = true};
    const Exploration found = Explore(problem, options).value();
    options.symmetry = false;
    const Exploration without = Explore(problem, options).value();
    if (!found.failure) {
      EXPECT_FALSE(without.failure);
      continue;
    }
    only_with_equals += without.failure ? 0 : 1;
    Model model = problem.model;
    for (const uint8_t thread : found.failure->steps) {
      ASSERT_TRUE(model.Running(thread));
      model.Step(thread);
    }
    EXPECT_EQ(FindFault(problem, model).kind, Fault::Kind::kRequirement);
  }
  EXPECT_GT(only_with_equals, 0);
}

}  // namespace
}  // namespace oncard::explore
