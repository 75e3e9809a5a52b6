// Remembered steps do what the model does (explore/models/thread_states.h, step_model.h).
#include "explore/models/thread_states.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "explore/models/number_table.h"
#include "explore/models/step_model.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

constexpr int64_t kStatements = 1000;

TEST(NumberTableTest, FindsWhatWasAdded) {
  NumberTable table;
  std::map<std::pair<uint32_t, int64_t>, uint32_t> expected;
  std::mt19937_64 random(1);
  for (int i = 0; i < 20'000; ++i) {
    const auto first = static_cast<uint32_t>(random() % 300);
    const auto value = static_cast<int64_t>(random() % 100) - 50;
    const auto known = expected.find({first, value});
    EXPECT_EQ(table.Find(first, value),
              known == expected.end() ? NumberTable::kNone : known->second);
    if (known != expected.end()) continue;
    table.Add(first, value, static_cast<uint32_t>(i));
    expected[{first, value}] = static_cast<uint32_t>(i);
  }
  EXPECT_EQ(table.size(), expected.size());
}

TEST(TupleTableTest, NumbersDifferentTuples) {
  TupleTable table(3000);
  std::map<std::vector<int64_t>, uint32_t> expected;
  uint32_t next = 0;
  std::mt19937_64 random(1);
  for (const size_t width : {size_t{3}, size_t{2}, size_t{4}}) {
    expected.clear();  // those of another size are forgotten
    for (int i = 0; i < 4000 && next < 3000; ++i) {
      std::vector<int64_t> tuple(width);
      for (int64_t& value : tuple) value = static_cast<int64_t>(random() % 10) - 5;
      const auto [known, added] = expected.try_emplace(tuple, next);
      if (added) ++next;
      ASSERT_EQ(table.NumberOf(tuple), known->second);
    }
  }
  EXPECT_EQ(next, 3000u);
  EXPECT_EQ(table.NumberOf({100, 0, 0, 0}), TupleTable::kNone);
  EXPECT_EQ(table.NumberOf(expected.begin()->first), expected.begin()->second);
}

/// A program in both forms, on the same path.
class Pair {
 public:
  explicit Pair(const Problem& problem)
      : model_(problem.model), steps_(problem.model, kStatements) {
    EXPECT_TRUE(steps_.Begin());
    for (int thread = 0; thread < model_.thread_count(); ++thread) {
      model_.StepPrivate(thread, kStatements);
    }
    ExpectEqual();
  }

  uint32_t runnable() const { return model_.runnable(); }
  size_t depth() const { return depths_.size(); }

  void Step(int thread) {
    depths_.push_back(model_.depth());
    ASSERT_TRUE(steps_.Step(thread));
    model_.Step(thread);
    model_.StepPrivate(thread, kStatements);
    ExpectEqual();
  }
  void Undo() {
    while (model_.depth() > depths_.back()) model_.Undo();
    depths_.pop_back();
    steps_.Undo();
    ExpectEqual();
  }

 private:
  void ExpectEqual() {
    ASSERT_EQ(steps_.runnable(), model_.runnable());
    ASSERT_EQ(steps_.statements(), model_.depth());
    ASSERT_EQ(steps_.depth(), depths_.size());
    Model same = steps_.AsModel();
    same.TrackKey(true);
    ASSERT_EQ(same.key(), model_.key());
    ASSERT_EQ(same.runnable(), model_.runnable());
    const std::vector<uint8_t> threads = steps_.StatementThreads();
    ASSERT_EQ(static_cast<int64_t>(threads.size()), model_.depth());
    for (size_t i = 0; i < threads.size(); ++i) {
      ASSERT_EQ(threads[i], model_.StepThread(static_cast<int64_t>(i)));
    }
    const uint32_t number = steps_.StateNumber();
    ASSERT_EQ(numbers_.try_emplace(number, model_.key()).first->second, model_.key());
    ExpectEqualAccesses();
  }
  void ExpectEqualAccesses() {
    for (int a = 0; a < model_.thread_count(); ++a) {
      for (int b = 0; b < model_.thread_count(); ++b) {
        if (!model_.Running(a) || !model_.Running(b)) continue;
        const bool depends =
            (steps_.Dependent(steps_.NextAccess(a)) >> steps_.NextAccess(b) & 1) != 0;
        ASSERT_EQ(depends, model_.NextAccess(a).DependsOn(model_.NextAccess(b)));
      }
    }
  }

  Model model_;
  StepModel steps_;
  std::vector<int64_t> depths_;
  std::map<uint32_t, StateKey> numbers_;
};

void ExpectSameOnRandomPaths(const std::string& source, uint64_t seed) {
  std::mt19937_64 random(seed);
  Pair pair(ProblemOf(source));
  for (int i = 0; i < 200 && !testing::Test::HasFatalFailure(); ++i) {
    const int thread = static_cast<int>(random() % 3);
    if ((pair.runnable() >> thread & 1) != 0 && random() % 3 != 0) {
      pair.Step(thread);
    } else if (pair.depth() > 0) {
      pair.Undo();
    }
  }
}

TEST(StepModelTest, StepsAndUndoesAsTheModel) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    ExpectSameOnRandomPaths(RandomThreads(seed), seed);
  }
}

TEST(StepModelTest, StatementsThatFailDoNotWrite) {
  const std::string source =
      "int x, y, a[2];\n"
      "int t0() {\n  x = 1 / y;\n  return 0;\n}\n"
      "int t1() {\n  int k;\n  y = y + 1;\n  k = y + y;\n  a[k] = x;\n  return 0;\n}\n"
      "int t2() {\n  x = x - 1;\n  y = 5 / x;\n  x = 0;\n  return 0;\n}\n";
  for (uint64_t seed = 0; seed < 50; ++seed) ExpectSameOnRandomPaths(source, seed);
}

TEST(StepModelTest, DoublesAndLocalArrays) {
  const std::string source =
      "double d;\nint n;\n"
      "int t0() {\n  int l[3], k;\n  k = n;\n  l[k] = 4;\n  d = d + 0.5;\n  l[1] = l[k] + n;\n"
      "  return l[1];\n}\n"
      "double t1() {\n  double e;\n  e = d;\n  e = e * 1.5;\n  d = e;\n  n = 2;\n  return e;\n}\n";
  for (uint64_t seed = 0; seed < 50; ++seed) ExpectSameOnRandomPaths(source, seed);
}

TEST(StepModelTest, ARunThatIsTooLongIsGivenUp) {
  const Problem problem =
      ProblemOf("int x;\nint t0() {\nL:\n  x = x + 1;\n  goto L;\n  return 0;\n}\n");
  StepModel steps(problem.model, 10);
  ASSERT_TRUE(steps.Begin());
  int taken = 0;
  while (steps.Step(0)) ++taken;
  EXPECT_EQ(taken, 4);
  EXPECT_EQ(steps.statements(), 8);
  EXPECT_EQ(steps.AsModel().Global(0), 4);
  StepModel endless(
      ProblemOf("int x;\nint t0() {\nL:\n  goto L;\n  x = 1;\n  return 0;\n}\n").model, 10);
  EXPECT_FALSE(endless.Begin());
}

TEST(ThreadStatesTest, TooManyStatesAreGivenUp) {
  const Problem problem =
      ProblemOf("int x;\nint t0() {\nL:\n  x = x + 1;\n  goto L;\n  return 0;\n}\n");
  ThreadStates states(problem.model, kStatements, 5);
  const auto begun = states.Begin(0);
  ASSERT_TRUE(begun);
  std::vector<int64_t> globals = states.globals();
  for (int64_t i = 0; i < 5; ++i) {
    globals[0] = i;
    const ThreadStates::Step* step = states.StepOf(begun->next, globals);
    ASSERT_NE(step, nullptr);
    EXPECT_EQ(step->value, i + 1);
    EXPECT_EQ(step->next, begun->next);
    EXPECT_EQ(step->statements, 2u);
  }
  globals[0] = 7;
  EXPECT_EQ(states.StepOf(begun->next, globals), nullptr);
  globals[0] = 3;
  EXPECT_NE(states.StepOf(begun->next, globals), nullptr);
}

TEST(ModelTest, KnowsWhetherAccessesAreLocal) {
  EXPECT_TRUE(ProblemOf("int a[2], x;\nint t0() {\n  int k;\n  a[k] = a[1];\n  x = a[k];\n"
                        "  return x;\n}\n")
                  .model.AccessesAreLocal());
  EXPECT_FALSE(ProblemOf("int a[2], i;\nint t0() {\n  a[i] = 1;\n  return 0;\n}\n")
                   .model.AccessesAreLocal());
}

}  // namespace
}  // namespace oncard::explore
