// Structured C with the commands that compile: what they say is about the source, not about the
// lowered program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/files.h"
#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

// Line 5 is one statement of C and several of the card.
const std::string kStructuredSum =
    "int sum;\n"                           // 1
    "int f(int n) {\n"                     // 2
    "  int i;\n"                           // 3
    "  for (i = 1; i <= n; i++)\n"         // 4
    "    sum += i * i > 4 ? i * 2 : i;\n"  // 5
    "  return sum;\n"                      // 6
    "}\n";
const std::string kMarked = "//@ structured\n";

class StructuredTest : public testing::Test {
 protected:
  ProcessResult Run(const std::vector<std::string>& arguments) {
    return RunOncard(arguments, folder_.path());
  }
  ScratchFolder folder_;
};

TEST_F(StructuredTest, IsRefusedUnlessItIsAskedFor) {
  folder_.Write("f.c", kStructuredSum);
  EXPECT_EQ(Run({"check", "f.c"}).exit_code, 1);
  EXPECT_EQ(Run({"check", "--structured", "f.c"}).exit_code, 0);
  folder_.Write("f.c", kMarked + kStructuredSum);
  EXPECT_EQ(Run({"check", "f.c"}).exit_code, 0);
}

TEST_F(StructuredTest, RunsAsCDoes) {
  folder_.Write("f.c", kStructuredSum);
  const ProcessResult result = Run({"run", "--structured", "f.c", "--thread=0=f:n=4",
                                    "--expect=sum == 17", "--expect=thread0.result == 17"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST_F(StructuredTest, IsAKeyOfAScenario) {
  folder_.Write("f.c", kStructuredSum);
  const std::string scenario =
      "program = \"f.c\"\nexpect = [\"sum == 17\"]\n[[thread]]\nfunction = \"f\"\ninit.n = 4\n";
  folder_.Write("plain.toml", scenario);
  folder_.Write("keyed.toml", "structured = true\n" + scenario);
  EXPECT_EQ(Run({"test", "keyed.toml"}).exit_code, 0);
  EXPECT_EQ(Run({"test", "plain.toml"}).exit_code, 1);
  EXPECT_EQ(Run({"test", "--structured", "plain.toml"}).exit_code, 0);
}

TEST_F(StructuredTest, NamesLinesOfTheSource) {
  folder_.Write("f.c", kStructuredSum);
  EXPECT_EQ(Run({"build", "--structured", "f.c"}).exit_code, 0);
  EXPECT_THAT(Run({"dump", "f.bin"}).out,
              AllOf(HasSubstr("'f' of f.c"), ContainsRegex("line 4 +i := 1 "),
                    ContainsRegex("line 5 +sum := sum"), ContainsRegex("line 6 +return sum")));
  const ProcessResult stopped =
      Run({"run", "--structured", "f.c", "--thread=0=f:n=4", "--expect=sum == 1", "--steps"});
  EXPECT_THAT(stopped.out, AllOf(HasSubstr("     4  for (i = 1; i <= n; i++)   i: 0 -> 1\n"),
                                 HasSubstr("     5  sum += i * i > 4 ? i * 2 : i;   [i = 1]"),
                                 HasSubstr("     6  return sum;   [sum = 17]\n")));
}

TEST_F(StructuredTest, SaysWhichDepthIsTooSmall) {
  folder_.Write("f.c",
                "//@ structured\n//@ depth: 3\nint sum(int n) {\n  if (n == 0) return 0;\n"
                "  return n + sum(n - 1);\n}\nint total;\nvoid t0(int n) { total = sum(n); }\n");
  EXPECT_EQ(Run({"run", "f.c", "--thread=0=t0:n=2", "--expect=total == 3"}).exit_code, 0);
  const ProcessResult deep = Run({"run", "f.c", "--thread=0=t0:n=3"});
  EXPECT_THAT(deep.out,
              HasSubstr("fault at f.c:5: calls of 'sum' are nested more than 3 deep: write a "
                        "larger number after '//@ depth:'"));
  EXPECT_THAT(Run({"--lang=zh", "run", "f.c", "--thread=0=t0:n=3"}).out,
              HasSubstr("'sum' 的嵌套调用超过 3 层"));
  folder_.Write("f.toml", "program = \"f.c\"\n[[thread]]\nfunction = \"t0\"\ninit.n = 3\n");
  EXPECT_THAT(Run({"explore", "f.toml"}).out,
              HasSubstr("in line 5 calls of 'sum' are nested more than 3 deep"));
}

TEST_F(StructuredTest, FaultsAtItsLine) {
  folder_.Write("f.c",
                "int a;\nint f() {\n  int i;\n\n  while (a >= 0)\n    a += 10 / (3 - a);\n}\n");
  const ProcessResult result = Run({"run", "--structured", "f.c", "--thread=0=f"});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_THAT(result.out + result.err, HasSubstr("f.c:6"));
}

TEST_F(StructuredTest, ReportsErrorsInTheSource) {
  folder_.Write("f.c", kMarked + "int f() {\n  return 1 + missing;\n}\n");
  const ProcessResult result = Run({"check", "f.c"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("f.c:3:14: error"));
}

TEST_F(StructuredTest, HasTheVerdictOfItsLoweredProgram) {
  const std::string threads =
      "int n, grid[2][2];\n"
      "int t0() { static int runs; runs++; for (int i = 0; i < 2; i++) n += 1; grid[1][0] = n; }\n"
      "int t1() { n++; }\n";
  struct Case {
    const char* requirement;
    int exit_code;
  };
  const Case cases[] = {{"//@ final: n == 2\n", 1},
                        {"  //@ always: n <= 3\r\n", 0},
                        {"//@ final: n == 7\n//@init: n=4 \n", 0},
                        {"//@ final: grid[2] == 5\n", 1},
                        {"//@ never: page0.i == 2\n", 1},
                        {"//@ never: t0_runs == 1\n", 1},
                        {"//@ races: none\n", 1}};
  for (const Case& test : cases) {
    folder_.Write("t.c", kMarked + threads + test.requirement);
    ASSERT_EQ(Run({"lower", "t.c", "-o", "card.c"}).exit_code, 0);
    const ProcessResult structured = Run({"explore", "t.c"});
    const ProcessResult card = Run({"explore", "card.c"});
    EXPECT_EQ(structured.exit_code, test.exit_code) << test.requirement << structured.err;
    EXPECT_EQ(card.exit_code, test.exit_code) << test.requirement << card.err;
    const auto asked = [](const ProcessResult& result) {
      return result.out.substr(0, result.out.find("\nprogram"));
    };
    EXPECT_EQ(asked(card), asked(structured)) << test.requirement;
  }
}

TEST_F(StructuredTest, ShowsCounterexamplesInTheSource) {
  folder_.Write(
      "t.c",
      "//@ final: n == 2\nint n, m;\nint t0() { n = abs(n) + 1; m = 1; }\nint t1() {\n  n++;\n}\n");
  const ProcessResult result = Run({"explore", "--structured", "t.c"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(
      result.out,
      AllOf(HasSubstr("FAILED"), HasSubstr("     3  n = abs(n) + 1;   "), HasSubstr(" 5  n++;"),
            HasSubstr("steps 1 and 3 belong to one statement of line 3, 'n = abs(n) + "
                      "1;': other threads can run ")));
}

TEST_F(StructuredTest, TwoStatementsOfALineAreNotOne) {
  folder_.Write("t.c",
                "//@ structured\n//@ final: n == 2\nint n;\n"
                "void t0() { int v; v = n * 1; n = v + 1; }\nvoid t1() { n++; }\n");
  const ProcessResult result = Run({"explore", "t.c"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, AllOf(HasSubstr("     4  n = v + 1;   "), HasSubstr("     5  n++;   "),
                                Not(HasSubstr("belong to one statement"))));
}

// The value of n waits in a temporary while f runs, elsewhere in the thread function.
TEST_F(StructuredTest, ShowsThatAStatementWithACallByAJumpIsNotAtomic) {
  folder_.Write("t.c",
                "//@ structured\n//@ final: n != 1\nint n, a, b;\nint f(int x) {\n"
                "  if (x > 3) x -= a;\n  if (x < b) x += a;\n  return x * x + b;\n}\n"
                "void t0() {\n  a = f(a);\n  b = f(b);\n  n = n * 2 + 1 - f(a);\n}\n"
                "void t1() {\n  n++;\n}\n");
  const ProcessResult lowered = Run({"lower", "--annotate", "--cost", "t.c"});
  EXPECT_THAT(lowered.err, HasSubstr("t0: 3 calls of f are jumps"));
  EXPECT_THAT(lowered.out, HasSubstr("  // called by a jump: 'f'\n"
                                     "  // not atomic: 'n' is read in one statement and written"));
  const ProcessResult explored = Run({"explore", "t.c"});
  EXPECT_EQ(explored.exit_code, 1);
  EXPECT_THAT(explored.out,
              HasSubstr("belong to one statement of line 12, 'n = n * 2 + 1 - f(a);'"));
}

TEST_F(StructuredTest, IsNotCorrectedByFixIts) {
  folder_.Write("f.c", kMarked + kStructuredSum);
  const ProcessResult result = Run({"check", "--fix", "f.c"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("use 'oncard lower'"));
  EXPECT_EQ(ReadFile(folder_.path() + "/f.c").value(), kMarked + kStructuredSum);
}

}  // namespace
}  // namespace oncard::tools
