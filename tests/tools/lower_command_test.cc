// The command lower. What it translates is tested by tests/lang/structured and tests/differential.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kLoops =
    "int g, h;\nvoid t0(int x) {\n  while (x > 0) g += x--;\n  h = h * g + 1;\n}\n";
constexpr const char* kUndeclared = "int g;\nvoid t0() {\n  g = later + 1;\n}\n";

TEST(Lower, PrintsAProgramThatTheCheckAccepts) {
  const ScratchFolder scratch;
  const ProcessResult lowered = RunOncard({"lower", scratch.Write("p.c", kLoops)});
  EXPECT_EQ(lowered.exit_code, 0);
  EXPECT_EQ(lowered.err, "");
  EXPECT_THAT(lowered.out, HasSubstr("lbl_while_3_end:"));
  const ProcessResult check = RunOncard({"check", scratch.Write("lowered.c", lowered.out)});
  EXPECT_EQ(check.exit_code, 0);
  EXPECT_EQ(check.err, "");
}

TEST(Lower, WritesAFileOnRequest) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", kLoops);
  const ProcessResult result = RunOncard({"lower", source, "-o", scratch.path() + "/out.c"});
  EXPECT_EQ(result.out + result.err, "");
  EXPECT_EQ(scratch.Read("out.c"), RunOncard({"lower", source}).out);
}

TEST(Lower, WritesNothingWhenTheProgramIsWrong) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", kUndeclared);
  const ProcessResult result = RunOncard({"lower", source, "-o", scratch.path() + "/out.c"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("p.c:3:7: error MP027"));
  EXPECT_FALSE(scratch.Has("out.c"));
}

TEST(Lower, DoesNotOverwriteItsSource) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", kLoops);
  EXPECT_EQ(RunOncard({"lower", source, "-o", source}).exit_code, 2);
  EXPECT_EQ(scratch.Read("p.c"), kLoops);
}

TEST(Lower, AnnotatesWhatIsNotAtomic) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", kLoops);
  const std::string remark = "not atomic: 'h' is read in one statement and written in a later";
  EXPECT_THAT(RunOncard({"lower", "--annotate", source}).out, HasSubstr(remark));
  EXPECT_THAT(RunOncard({"lower", source}).out, Not(HasSubstr("not atomic")));
}

TEST(Lower, ShowsTheCostOfEachFunction) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", kLoops);
  const ProcessResult result = RunOncard({"lower", "--cost", source});
  EXPECT_THAT(result.err, HasSubstr("t0"));
  EXPECT_THAT(result.err, HasSubstr("global slots: 2"));
}

// A Chinese character takes two columns of a terminal, so the heads end where the numbers do.
TEST(Lower, AlignsTheHeadsOfTheCostInChinese) {
  const ScratchFolder scratch;
  const ProcessResult result =
      RunOncard({"lower", "--cost", "--lang", "zh", scratch.Write("p.c", "void t0() {}\n")});
  EXPECT_EQ(result.err,
            "函数                                    语句    标号     临时变量  页存储单元\n"
            "t0                                         0       0            0           0\n"
            "全局存储单元：0\n");
}

TEST(Lower, SaysWhichCallsAreJumps) {
  const ScratchFolder scratch;
  const std::string source =
      scratch.Write("p.c",
                    "int g, h;\nint f(int x) {\n  if (x > 9) x -= g;\n  if (x < h) x += g;\n  "
                    "return x * x + h;\n}\n"
                    "void t0() {\n  g = f(h);\n  h = f(g);\n  g += f(h);\n}\n");
  const ProcessResult result = RunOncard({"lower", "--cost", "--annotate", source});
  EXPECT_THAT(result.err, HasSubstr("t0: 3 calls of f are jumps\n"));
  EXPECT_THAT(result.out, HasSubstr("  // 9: h = f(g);\n  // called by a jump: 'f'\n"));
  const ProcessResult inlined = RunOncard({"lower", "--cost", "--no-optimize", source});
  EXPECT_THAT(inlined.err, Not(HasSubstr("jumps")));
}

TEST(Lower, SaysWhichVariablesShareSlots) {
  const ScratchFolder scratch;
  const std::string source =
      scratch.Write("p.c",
                    "int g;\nvoid t0() {\n  { int a[600]; a[g] = 1; g = a[0]; }\n"
                    "  { int b[600]; b[g] = 2; g = b[1]; }\n}\n");
  const ProcessResult result = RunOncard({"lower", "--cost", source});
  EXPECT_THAT(result.err,
              HasSubstr("t0: the slots of a are those of b, too; their lives do not overlap\n"));
  EXPECT_THAT(result.out, HasSubstr("  // a is b, too: their lives do not overlap\n"));
}

TEST(Lower, SaysWhichTablesAreInThePage) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c",
                                           "const int table[1000] = {7};\nint list[100];\n"
                                           "void t0() { list[0] = table[list[1]]; }\n");
  const ProcessResult result = RunOncard({"lower", "--cost", source});
  EXPECT_THAT(result.err, HasSubstr("t0: the constants of table are in its page\n"));
}

// The rows are tested by tests/compiler/two_columns_test.cc.
TEST(Lower, ShowsCBesideTheLoweredProgram) {
  const std::string sample = std::string(ONCARD_SOURCE_DIR) + "/samples/02_loops/structured.c";
  ExpectGolden("lower_diff.txt", RunOncard({"lower", "--diff", "--width=90", sample}).out);
  // A pipe has no width.
  const ScratchFolder scratch;
  const std::string wide = RunOncard({"lower", "--diff", sample}).out;
  EXPECT_EQ(wide, RunOncard({"lower", "--diff", "--width=120", sample}).out);
  RunOncard({"lower", "--diff", sample, "-o", scratch.path() + "/rows.txt"});
  EXPECT_EQ(scratch.Read("rows.txt"), wide);
  EXPECT_THAT(RunOncard({"lower", "--diff", "--color=always", sample}).out,
              HasSubstr("\x1b[2m 5\x1b[0m  int test_first(void)"));
}

TEST(Lower, RefusesAWidthThatIsOfNoUse) {
  const ScratchFolder scratch;
  const std::string source = scratch.Write("p.c", kLoops);
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--diff", "--width=39"},
                                                {"--diff", "--width=1001"},
                                                {"--width=80"}}) {
    std::vector<std::string> arguments = {"lower", source};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    const ProcessResult result = RunOncard(arguments);
    EXPECT_EQ(result.exit_code, 2) << wrong.back();
    EXPECT_THAT(result.err, HasSubstr("--width")) << wrong.back();
    EXPECT_EQ(result.out, "");
  }
}

TEST(Lower, IsExplained) {
  for (const char* language : {"--lang=en", "--lang=zh"}) {
    const ProcessResult page = RunOncard({language, "explain", "structured"});
    EXPECT_EQ(page.exit_code, 0);
    EXPECT_THAT(page.out, HasSubstr("oncard lower FILE.c -o OUT.c"));
  }
}

TEST(Lower, ExitsWithThreeWhenTheFileCannotBeRead) {
  EXPECT_EQ(RunOncard({"lower", "/nonexistent/p.c"}).exit_code, 3);
}

}  // namespace
}  // namespace oncard::tools
