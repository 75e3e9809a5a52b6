// The model executes statements like the machine (explore/models/model.h), and can undo them.
#include "explore/models/model.h"

#include <gtest/gtest.h>

#include "explore_programs.h"
#include "vm/fixed_point.h"

namespace oncard::explore {
namespace {

constexpr char kMixed[] =
    "int g[4];\n"
    "double d;\n"
    "int t0() {\n"
    "  int i;\n"
    "  double e;\n"
    "  i = 3;\n"
    "  g[i] = 7;\n"
    "  e = 1.5;\n"
    "  d = e * e;\n"
    "  i = i / 2;\n"
    "  return i;\n"
    "}\n"
    "int t1() {\n"
    "  int i;\n"
    "  i = g[3];\n"
    "  i = 1 / i;\n"
    "  return i;\n"
    "}\n";

TEST(ModelTest, StatementsDoWhatTheMachineDoes) {
  Problem problem = ProblemOf(kMixed);
  Model& model = problem.model;
  const auto value = [&](const vm::Symbol* symbol, bool global, int index = 0) {
    const int64_t raw =
        model.Read({global, 0, static_cast<uint16_t>(symbol->id + index), symbol->type});
    return symbol->type == vm::DataType::kDouble ? vm::DoubleFromFixed(raw)
                                                 : static_cast<double>(raw);
  };
  while (model.Running(0)) model.Step(0);
  const vm::Image& image = model.image();
  EXPECT_EQ(value(vm::FindGlobal(image, "g"), true, 3), 7);
  EXPECT_EQ(value(vm::FindGlobal(image, "d"), true), 2.25);
  EXPECT_EQ(value(vm::FindLocal(image, 0, "e"), false), 1.5);
  EXPECT_EQ(value(vm::FindLocal(image, 0, "i"), false), 1);
  EXPECT_EQ(model.End(0), ThreadEnd::kFinished);
  EXPECT_EQ(model.ReturnValue(0), 1);
  EXPECT_EQ(model.runnable(), 2u);
}

TEST(ModelTest, AFaultEndsTheThread) {
  Problem problem = ProblemOf(kMixed);
  problem.model.Step(1);
  problem.model.Step(1);
  EXPECT_EQ(problem.model.End(1), ThreadEnd::kDivisionByZero);
  EXPECT_EQ(problem.model.runnable(), 1u);
}

TEST(ModelTest, AccessesAreSharedCellsOnly) {
  Problem problem = ProblemOf(kMixed);
  Model& model = problem.model;
  EXPECT_TRUE(model.NextAccess(0).empty());  // i = 3
  model.Step(0);
  EXPECT_EQ(model.NextAccess(0).write, 3u);  // g[i]
  EXPECT_EQ(model.NextAccess(1).read_count, 1u);
  EXPECT_EQ(model.NextAccess(1).reads[0], 3u);
  EXPECT_TRUE(model.NextAccess(0).DependsOn(model.NextAccess(1)));
}

TEST(ModelTest, ReadsDoNotDependOnReads) {
  Problem problem = ProblemOf(Increments(2, 1));
  EXPECT_FALSE(problem.model.NextAccess(0).DependsOn(problem.model.NextAccess(1)));
}

TEST(ModelTest, UndoGoesBackToTheSameState) {
  Problem problem = ProblemOf(kMixed);
  Model& model = problem.model;
  std::vector<StateKey> keys = {model.key()};
  for (const int thread : {0, 1, 0, 0, 1, 0, 0, 0}) {
    if (!model.Running(thread)) continue;
    model.Step(thread);
    keys.push_back(model.key());
  }
  while (model.depth() > 0) {
    EXPECT_EQ(model.key(), keys.back());
    keys.pop_back();
    model.Undo();
  }
  EXPECT_EQ(model.key(), keys.back());
  EXPECT_EQ(model.runnable(), 3u);
}

TEST(ModelTest, DifferentOrdersOfIndependentStepsMeetInOneState) {
  Problem problem = ProblemOf(
      "int x, y;\nint t0() {\n x = 1;\n return 0;\n}\n"
      "int t1() {\n y = 1;\n return 0;\n}\n");
  Model& model = problem.model;
  model.Step(0);
  model.Step(1);
  const StateKey first = model.key();
  model.Undo();
  model.Undo();
  model.Step(1);
  model.Step(0);
  EXPECT_EQ(model.key(), first);
}

}  // namespace
}  // namespace oncard::explore
