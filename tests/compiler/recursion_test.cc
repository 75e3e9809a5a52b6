// Functions that call themselves: how deep they may go, what they keep, and what is refused. That
// they compute what C computes is tested by tests/lang/structured/recursion.c and
// tests/differential.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "compiler/lowering/lowering.h"
#include "runtime/sim/controller.h"
#include "tests/compiler/memory_files.h"

namespace oncard::compiler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr int64_t kCycleLimit = 4000;

Lowering Lowered(const std::string& program, bool optimize = true) {
  return LowerText("p.c", program, {}, {.optimize = optimize}, NoFiles());
}

// `sum(n)` needs n + 1 frames.
std::string Sum(int depth, int argument) {
  return fmt::format(
      "int v;\n"
      "//@ depth: {}\n"
      "int sum(int n) {{\n"
      "  if (n == 0) return 0;\n"
      "  return n +\n"
      "         sum(n - 1);\n"
      "}}\n"
      "void t0() {{ v = sum({}); }}\n",
      depth, argument);
}

// What the first thread function does: "ends", or its fault and the line of that.
std::string Outcome(const Lowering& lowering) {
  if (!lowering.object) return "not lowered: " + lowering.diagnostics.at(0).message.en;
  runtime::Controller controller;
  if (!controller.Load(*lowering.object).ok()) return "not loaded";
  vm::Machine& machine = controller.machine();
  if (machine.Bind(0, 1, 0) != 0 || machine.Run(0) != 0) return "not started";
  if (controller.RunUntilQuiet(kCycleLimit) != runtime::RunEnd::kQuiet) return "runs for ever";
  const vm::ThreadState& thread = machine.thread(0);
  if (thread.run != vm::ThreadRun::kFaulted) return "ends";
  return fmt::format("fault {} in line {}", thread.error,
                     lowering.object->functions[0].lines.at(thread.pc));
}

TEST(Recursion, MayBeAsDeepAsItsComment) {
  for (const bool optimize : {true, false}) {
    EXPECT_EQ(Outcome(Lowered(Sum(4, 3), optimize)), "ends");
    EXPECT_EQ(Outcome(Lowered(Sum(4, 4), optimize)), "fault 101 in line 6");
    EXPECT_EQ(Outcome(Lowered(Sum(4, 100), optimize)), "fault 101 in line 6");
    EXPECT_EQ(Outcome(Lowered(Sum(1, 0), optimize)), "ends");
    EXPECT_EQ(Outcome(Lowered(Sum(1, 1), optimize)), "fault 101 in line 6");
  }
}

TEST(Recursion, FaultsAlsoWhereNothingIsKept) {
  const std::string program =
      "int v;\n"
      "//@ depth: 9\n"
      "void down() {\n"
      "  down();\n"
      "  v++;\n"
      "}\n"
      "void t0() { down(); }\n";
  EXPECT_EQ(Outcome(Lowered(program)), "fault 101 in line 4");
  EXPECT_EQ(Outcome(Lowered(program, false)), "fault 101 in line 4");
}

// The calls of a circle wait for each other.
TEST(Recursion, CountsTheFramesOfACircleTogether) {
  const auto circle = [](int argument) {
    return fmt::format(
        "int v;\n"
        "int odd(int n);\n"
        "//@ depth: 5\n"
        "int even(int n) {{ if (n == 0) return 1; return !odd(n - 1) * 1; }}\n"
        "int odd(int n) {{ if (n == 0) return 1; return !even(n - 1) * 1; }}\n"
        "void t0() {{ v = even({}); }}\n",
        argument);
  };
  EXPECT_EQ(Outcome(Lowered(circle(4))), "ends");
  EXPECT_EQ(Outcome(Lowered(circle(5))), "fault 101 in line 4");
}

// A second call from elsewhere begins with the first frame.
TEST(Recursion, BeginsAnewWithEachCallFromElsewhere) {
  std::string program = Sum(4, 3);
  program.replace(program.rfind("v = sum(3);"), 11,
                  "for (int i = 0; i < 9; i++) v += sum(sum(2));");
  EXPECT_EQ(Outcome(Lowered(program)), "ends");
}

TEST(Recursion, CostsTheSlotsOfTheCallsThatWait) {
  const Lowering lowering = Lowered(Sum(100, 3));
  ASSERT_EQ(lowering.costs.size(), 1u);
  ASSERT_EQ(lowering.costs[0].frames.size(), 1u);
  const FramesCost& frames = lowering.costs[0].frames[0];
  EXPECT_EQ(frames.name, "sum");
  EXPECT_EQ(frames.count, 99);
  EXPECT_EQ(frames.slots, 2);  // n and the way back
  const Lowering shorter = Lowered(Sum(99, 3));
  EXPECT_EQ(lowering.costs[0].page_slots, shorter.costs.at(0).page_slots + 2);
}

TEST(Recursion, SaysWhichDepthFits) {
  const Lowering lowering = Lowered(Sum(1000, 3));
  ASSERT_EQ(lowering.diagnostics.size(), 1u);
  const Diagnostic& diagnostic = lowering.diagnostics[0];
  EXPECT_EQ(diagnostic.info->slug, "lowered-too-large");
  ASSERT_EQ(diagnostic.notes.size(), 1u);
  const Message& note = diagnostic.notes[0].message;
  EXPECT_THAT(note.en, HasSubstr("each call of 'sum' that waits takes 2 slots"));
  EXPECT_THAT(note.zh, HasSubstr("'sum' 每次等待中的调用占用 2 个存储单元"));
  const size_t begin = note.en.find("depth: ") + 7;
  const int depth = std::stoi(note.en.substr(begin));
  EXPECT_EQ(Outcome(Lowered(Sum(depth, 400))), "ends");
  EXPECT_FALSE(Lowered(Sum(depth + 1, 400)).object.has_value());
}

TEST(Recursion, IsRefusedWithoutADepth) {
  std::string program = Sum(4, 3);
  program.replace(program.find("//@ depth: 4"), 12, "");
  program.replace(program.find("sum(3)"), 6, "sum(v)");
  const Lowering lowering = Lowered(program);
  ASSERT_EQ(lowering.diagnostics.size(), 1u);
  EXPECT_EQ(lowering.diagnostics[0].message.en,
            "'sum' calls itself (sum -> sum); write '//@ depth: N' above it, with N calls at the "
            "same time at most, or use a loop");
  EXPECT_EQ(lowering.diagnostics[0].message.zh,
            "'sum' 直接或间接调用自身（sum -> sum）；请在其上方写 '//@ depth: N'，N "
            "为同时进行的调用的最大"
            "数目，或改用循环");
}

// --- Without a comment ---------------------------------------------------------------------------

// How many calls wait at the same time, at most; -1: that is not known, so that a comment is
// missing.
int WaitingIn(const std::string& functions, const std::string& start) {
  const Lowering lowering = Lowered("int v, w;\nenum { FIVE = 5 };\n" + functions +
                                    "\nvoid t0() { v = " + start + "; }\n");
  if (!lowering.object) {
    EXPECT_EQ(lowering.diagnostics.at(0).info->slug, "recursion");
    return -1;
  }
  return lowering.costs.at(0).frames.at(0).count;
}

TEST(Recursion, NeedsNoCommentWhereArgumentsCountDown) {
  EXPECT_EQ(WaitingIn("int f(int n) { return n <= 1 ? 1 : n * f(n - 1); }", "f(7)"), 6);
  EXPECT_EQ(WaitingIn("int f(int n) { return n <= 1 ? 1 : n * f(n - 1); }", "f(3) + f(FIVE)"), 4);
  EXPECT_EQ(WaitingIn("int f(int n) { if (n < 2) return n; return f(n - 1) + f(n - 2); }", "f(10)"),
            9);
  EXPECT_EQ(WaitingIn("int f(int n, int a, int b) { if (n == 0) return 0;\n"
                      "return f(n - 1, a, 6 - a - b) + 1 + f(n - 1, 6 - a - b, b); }",
                      "f(4, 1, 3)"),
            4);
  EXPECT_EQ(WaitingIn("int f(int n) { int s = 0; while (n > 3 && !w) { w = s; s += f(n / 2); }\n"
                      "return s; }",
                      "f(40)"),
            4);  // 40, 20, 10, 5, 2
  EXPECT_EQ(
      WaitingIn("int f(int n) { if (n) { return 1 + f(n - FIVE); } else { return w; } }", "f(15)"),
      3);
  EXPECT_EQ(WaitingIn("int odd(int n);\nint even(int n) { return n ? !odd(n - 1) : 1; }\n"
                      "int odd(int n) { return n ? !even(n - 1) : 1; }",
                      "even(4)"),
            4);
}

// The way to a call can lead through others, also through those of another group.
TEST(Recursion, NeedsNoCommentBehindOtherCalls) {
  const std::string factorial = "int f(int n) { return n <= 1 ? 1 : n * f(n - 1); }\n";
  EXPECT_EQ(WaitingIn(factorial + "int g(int n, int m) { return f(n + m); }", "g(1, 2) + g(2, 3)"),
            4);
  EXPECT_EQ(
      WaitingIn(factorial + "int g(int n) { return n > 3 ? f(n) : f(n) + g(n + 1); }", "g(1)"), 3);
  EXPECT_EQ(WaitingIn(factorial + "static int unused() { return f(w); }", "f(3)"), 2);
  EXPECT_EQ(WaitingIn(factorial + "int g(int n) { return f(n); }", "g(w)"), -1);
}

TEST(Recursion, NeedsACommentWhereItsDepthIsNotSeen) {
  const std::string factorial = "int f(int n) { return n <= 1 ? 1 : n * f(n - 1); }";
  EXPECT_EQ(WaitingIn(factorial, "f(w)"), -1);
  EXPECT_EQ(WaitingIn(factorial, "f(2) + f(w)"), -1);
  // Too many calls.
  EXPECT_EQ(WaitingIn(factorial, "f(2000)"), -1);
  EXPECT_EQ(WaitingIn("int f(int n) { if (n == 0) return 0; return 1 + f(n - 2); }", "f(5)"), -1);
  // No call is the last one.
  EXPECT_EQ(WaitingIn("int f(int n) { return 1 + f(n - 1); }", "f(5)"), -1);
  EXPECT_EQ(WaitingIn("int f(int n) { if (w == 0) return 0; return 1 + f(n); }", "f(5)"), -1);
  EXPECT_EQ(WaitingIn("int f(int m, int n) { if (m == 0) return n + 1;\n"
                      "if (n == 0) return 2 * f(m - 1, 1); return f(m - 1, f(m, n - 1)); }",
                      "f(2, 3)"),
            -1);
  // A parameter that changes, or is hidden by another variable.
  EXPECT_EQ(WaitingIn("int f(int n) { n--; if (n < 0) return 0; return 1 + f(n); }", "f(5)"), -1);
  EXPECT_EQ(WaitingIn("int f(int n) { if (n == 0) return 0; { int n = w; return 1 + f(n - 1); } }",
                      "f(5)"),
            -1);
  // A jump to where no way seems to lead.
  EXPECT_EQ(
      WaitingIn("int f(int n) { if (n > 0) goto L; return 0; L: return 1 + f(n - 1); }", "f(5)"),
      -1);
}

// The text is for the card, whose tools know no depth.
// What is kept for a call that nothing comes back from.
TEST(Recursion, KeepsNothingThatIsNeverRead) {
  const Lowering lowering = Lowered(
      "struct pair { int x, y; };\nint g, a[8];\n"
      "static int first(int n, int x, int y, int *v, struct pair p, int *s) {\n"
      "  int z = x + n, t = y;\n  if (n <= 0) return v[1] & z;\n"
      "  if (z && second(n - 1, t, x, a, p, s) > 3) t++;\n}\n"
      "static int second(int n, int x, char y, int *v, struct pair p, int *s) {\n"
      "  int z;\n  struct pair own = p;\n  z = x * x - first(n - 1, x, own.x, v, p, &g);\n}\n"
      "int t0() {\n  int x = 5, m[8] = {1, 7, 2}, w = 1;\n  struct pair p = {4, 9};\n"
      "  x = x - second(1, x, 2, m, p, &w);\n}\n");
  ASSERT_TRUE(lowering.text.has_value());
  EXPECT_THAT(lowering.diagnostics, testing::IsEmpty());
}

TEST(Recursion, LeavesItsCommentOut) {
  const Lowering lowering = Lowered(Sum(4, 3));
  ASSERT_TRUE(lowering.text.has_value());
  EXPECT_EQ(lowering.text->find("//@"), std::string::npos);
}

// A call that is the last thing a function does keeps nothing: a thousand fit without a depth.
TEST(Recursion, IsALoopAtTheEndOfAFunction) {
  const std::string program =
      "int v;\n"
      "int up(int n) {\n"
      "  if (n == 1000) return n;\n"
      "  return up(n + 1);\n"
      "}\n"
      "void t0() { v = up(0); }\n";
  const Lowering lowering = Lowered(program);
  EXPECT_EQ(Outcome(lowering), "ends");
  EXPECT_TRUE(lowering.costs.at(0).frames.empty());
  EXPECT_EQ(Outcome(Lowered(program, false)), "ends");
}

TEST(Recursion, IsNoLoopWhereSomethingIsLeftToDo) {
  const auto slugs = [](const std::string& program) {
    std::vector<std::string_view> found;
    for (const Diagnostic& each : Lowered(program).diagnostics) found.push_back(each.info->slug);
    return found;
  };
  // The assert must hold each time that a call ends.
  EXPECT_THAT(slugs("int v;\n"
                    "void up(int n) {\n"
                    "  if (n < 3) up(n + 1);\n"
                    "  //@ assert: n < 9\n"
                    "  return;\n"
                    "}\n"
                    "void t0() { up(v); }\n"),
              ElementsAre("recursion"));
  // The references stand for other variables in each call.
  EXPECT_THAT(slugs("int v, w;\n"
                    "void to(int n, int *a, int *b) {\n"
                    "  *a += n;\n"
                    "  if (n > 0) to(n - 1, b, a);\n"
                    "}\n"
                    "void t0() { to(v, &v, &w); }\n"),
              ElementsAre("recursion"));
}

// An array has the name of the variable that it keeps.
TEST(Recursion, NamesWhatItKeeps) {
  const Lowering lowering = Lowered(Sum(4, 3));
  ASSERT_TRUE(lowering.text.has_value());
  EXPECT_THAT(*lowering.text, HasSubstr("  sum_back[sum_depth] = sum_call;\n"
                                        "  sum_n_kept[sum_depth] = sum_n;\n"
                                        "  sum_depth = sum_depth + 1;\n"
                                        "  sum_n = tmp1;\n"));
  EXPECT_THAT(*lowering.text, HasSubstr("  sum_depth = sum_depth - 1;\n"
                                        "  sum_call = sum_back[sum_depth];\n"
                                        "  sum_n = sum_n_kept[sum_depth];\n"));
}

}  // namespace
}  // namespace oncard::compiler
