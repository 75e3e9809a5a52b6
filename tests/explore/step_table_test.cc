// Runs as tables (explore/reports/step_table.h), with the curves of axes
// (explore/reports/axis_curve.h).
#include "explore/reports/step_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/compiler.h"
#include "compiler/display_text.h"
#include "explore/reports/axis_curve.h"
#include "explore_programs.h"
#include "runtime/scenario/run/scenario_run.h"
#include "tests/compiler/memory_files.h"

namespace oncard::explore {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

/// A program and some of its statements in an order.
class StepTableTest : public ::testing::Test {
 protected:
  StepView View(const std::string& source, std::vector<uint8_t> threads, Detail detail) {
    source_.text = source;
    const Problem problem = ProblemOf(source);
    Failure failure;
    failure.steps = std::move(threads);
    failure.fault.kind = Fault::Kind::kTimeLimit;
    trail_ = Follow(problem, failure);
    subject_ = SubjectOf(problem);
    StepView view = {subject_, trail_.steps, source_};
    view.detail = detail;
    return view;
  }

  ProgramText source_;
  Trail trail_;
  Subject subject_;
};

constexpr const char* kLoop =
    "int sum;\n"
    "int t0() {\n"
    "  int i;\n"
    "  int cc;\n"
    "  i = 0;\n"
    "L:\n"
    "  sum = sum + i;\n"
    "  i = i + 1;\n"
    "  cc = i < 50;\n"
    "  if (cc) goto L;\n"
    "  return 0;\n"
    "}\n";

TEST_F(StepTableTest, LoopsAreDrawnTogether) {
  const StepView view = View(kLoop, std::vector<uint8_t>(202, 0), Detail::kLoops);
  EXPECT_EQ(TextTable(view, 0, Language::kEnglish),
            "        thread 0 t0\n"
            "     1     5  i = 0;   i: 0 -> 0\n"
            "     2     7  sum = sum + i;   [sum = 0, i = 0]   sum: 0 -> 0\n"
            "     3     8  i = i + 1;   [i = 0]   i: 0 -> 1\n"
            "     4     9  cc = i < 50;   [i = 1]   cc: 0 -> 1\n"
            "     5    10  if (cc) goto L;   [cc = 1]\n"
            "   ...        lines 7–10 × 49 more   sum: 0 -> 1225, i: 1 -> 50, cc: 1 -> 0\n"
            "   202    11  return 0;\n");
  StepView full = view;
  full.detail = Detail::kFull;
  EXPECT_EQ(RowsOf(full, Language::kEnglish).rows.size(), 202u);
}

TEST_F(StepTableTest, ABriefOneLeavesOutWhatTouchesNothingShared) {
  const StepView view = View(kLoop, std::vector<uint8_t>(202, 0), Detail::kBrief);
  EXPECT_EQ(TextTable(view, 0, Language::kChinese),
            "        线程 0 t0\n"
            "     2     7  sum = sum + i;   [sum = 0]   sum: 0 -> 0\n"
            "   ...        第 7 行，再 × 49   sum: 0 -> 1225\n");
  EXPECT_EQ(RowsOf(view, Language::kEnglish).left_out, 152u);
}

TEST_F(StepTableTest, NamedStepsAreNeverHidden) {
  StepView view = View(kLoop, std::vector<uint8_t>(202, 0), Detail::kBrief);
  view.named = {2};               // private
  view.last_escape = 1 + 4 * 20;  // within the loop
  const std::string text = TextTable(view, 0, Language::kEnglish);
  EXPECT_THAT(text, HasSubstr("     3     8  i = i + 1;"));
  EXPECT_THAT(
      text, HasSubstr("    82     7  sum = sum + i;   [sum = 190]   sum: 190 -> 210   <- from here "
                      "on every continuation fails"));
}

TEST_F(StepTableTest, FitsTheTerminal) {
  const std::string source =
      "int first_variable, second_variable;\n"
      "int t0() {\n  first_variable = second_variable + 1;  // 第一个变量等于第二个变量加一\n"
      "  return 0;\n}\n"
      "int t1() {\n  second_variable = first_variable + 1;\n  return 0;\n}\n";
  const StepView view = View(source, {0, 1, 0, 1}, Detail::kFull);
  for (const int width : {40, 60, 80, 100, 200}) {
    const std::string text = TextTable(view, width, Language::kChinese);
    for (size_t begin = 0; begin < text.size();) {
      const size_t end = text.find('\n', begin);
      const std::string line = text.substr(begin, end - begin);
      EXPECT_LE(compiler::DisplayLine(line).ColumnOf(line.size()), width) << text;
      begin = end + 1;
    }
    std::string joined;  // without any loss
    for (const char c : text) {
      if (c != ' ' && c != '\n') joined += c;
    }
    for (const char* part : {"+1;", "加一", "first_variable:0->1"}) {
      if (width < 80) continue;
      EXPECT_THAT(joined, HasSubstr(part)) << part << '\n' << text;
    }
  }
  // 40 columns are not enough for two: the threads share one column.
  EXPECT_THAT(TextTable(view, 40, Language::kEnglish), HasSubstr("thread 1 t1"));
}

TEST(AxisCurveTest, DrawsWhereTheAxisIs) {
  const auto compilation = compiler::CompileText(
      "p.c",
      "int t0() {\n  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_SetVel(1, 50);\n  GT_Update(1);\n"
      "  GT_Delay(20);\n  return 0;\n}\n",
      {}, compiler::NoFiles());
  ASSERT_TRUE(compilation.object);
  const auto scenario = runtime::ParseScenario("program = \"p.c\"\n", "test.toml");
  runtime::RunOptions options;
  options.trace = true;
  const auto run = runtime::RunScenario(scenario.value(), *compilation.object, options);
  ASSERT_TRUE(run.ok());
  AxisCurve curve(&*run.value().trace);
  EXPECT_EQ(curve.BarAt(0), "   axis1.prfPos 0 |*                               |");
  const std::vector<double> tail = curve.TailAfter(0);
  ASSERT_EQ(tail.size(), 8u);
  EXPECT_EQ(tail.back(), run.value().end_ms);
  EXPECT_THAT(curve.BarAt(tail.back()), EndsWith("|                               *|"));
  EXPECT_THAT(curve.BarAt(0), EndsWith("|*                               |")) << "again";
  EXPECT_THAT(curve.Svg(), HasSubstr("<polyline"));
  EXPECT_THAT(curve.Svg(), HasSubstr("axis1.prfPos"));
}

TEST(AxisCurveTest, WithoutMotionThereIsNone) {
  AxisCurve curve(nullptr);
  EXPECT_EQ(curve.BarAt(0), "");
  EXPECT_EQ(curve.Svg(), "");
  EXPECT_TRUE(curve.TailAfter(0).empty());
}

}  // namespace
}  // namespace oncard::explore
