// What can still matter to a thread (explore/models/thread_future.h): looked up by source line.
#include "explore/models/thread_future.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

/// The thread t0 of a program; lines are counted from 1, its declarations are the first three.
class ThreadFutureTest : public testing::Test {
 protected:
  static constexpr int kDeclarations = 3;

  /// `body`: the statements of t0, one per line, after the globals g[4], h and its locals.
  ThreadFuture Of(std::string_view body) {
    model_ = ProblemOf("int g[4], h, i[100];\nint t0() {\n  int a, b, k, l[3];\n" +
                       std::string(body) + "}\n")
                 .model;
    return {*model_, 0};
  }
  /// The position of the first statement of a line of the body, counted from 1.
  int At(int line) const {
    const auto& lines = model_->image().object.functions.front().lines;
    return static_cast<int>(std::ranges::find(lines, line + kDeclarations) - lines.begin());
  }

  std::optional<Model> model_;
};

using Locals = std::vector<uint32_t>;
// Slots of the locals.
constexpr uint32_t kA = 0;
constexpr uint32_t kB = 1;
constexpr uint32_t kK = 2;
constexpr uint32_t kL = 3;
// Bits of the globals.
constexpr uint64_t kG = 1;
constexpr uint64_t kH = 1 << 4;

TEST_F(ThreadFutureTest, ALocalMattersUntilItIsReadForTheLastTime) {
  const ThreadFuture future =
      Of("  a = h;\n"
         "  a = a + b;\n"
         "  h = a;\n"
         "  a = h;\n"
         "  return a;\n");
  EXPECT_EQ(future.Locals(At(1)), Locals({kB}));
  EXPECT_EQ(future.Locals(At(2)), Locals({kA, kB}));
  EXPECT_EQ(future.Locals(At(3)), Locals({kA}));
  EXPECT_EQ(future.Locals(At(4)), Locals());
  EXPECT_EQ(future.Locals(At(5)), Locals({kA}));
}

TEST_F(ThreadFutureTest, AccessesAreThoseOfThisAndLaterStatements) {
  const ThreadFuture future =
      Of("  h = 1;\n"
         "  a = g[0];\n"
         "  g[0] = h;\n"
         "  return a;\n");
  EXPECT_EQ(future.Accesses(At(1)).writes, kG | kH);
  EXPECT_EQ(future.Accesses(At(2)).writes, kG);
  EXPECT_EQ(future.Accesses(At(2)).reads, kG | kH);
  EXPECT_EQ(future.Accesses(At(3)).reads, kH);
  EXPECT_EQ(future.Accesses(At(4)).reads, 0u);
  EXPECT_EQ(future.Accesses(At(4)).writes, 0u);
}

TEST_F(ThreadFutureTest, JumpsLeadBothWays) {
  const ThreadFuture future =
      Of("L:\n"
         "  h = b;\n"
         "  b = 1;\n"
         "  if (a) goto L;\n"
         "  if (k) goto E;\n"
         "  g[0] = 1;\n"
         "E:\n"
         "  return k;\n");
  EXPECT_EQ(future.Locals(At(2)), Locals({kA, kB, kK}));
  EXPECT_EQ(future.Locals(At(3)), Locals({kA, kK}));
  EXPECT_EQ(future.Locals(At(4)), Locals({kA, kB, kK}));
  EXPECT_EQ(future.Locals(At(5)), Locals({kK}));
  EXPECT_EQ(future.Accesses(At(4)).writes, kG | kH);
  EXPECT_EQ(future.Accesses(At(5)).writes, kG);
  EXPECT_EQ(future.Accesses(At(8)).writes, 0u);
}

// Which element is accessed is not known before; to write one leaves the others.
TEST_F(ThreadFutureTest, ElementsWithVariableIndices) {
  const ThreadFuture future =
      Of("  g[k] = a;\n"
         "  l[k] = 1;\n"
         "  a = l[b];\n"
         "  a = g[k];\n"
         "  return 0;\n");
  EXPECT_EQ(future.Accesses(At(1)).writes, 15 * kG);
  EXPECT_EQ(future.Accesses(At(4)).writes, 0u);
  EXPECT_EQ(future.Accesses(At(4)).reads, 15 * kG);
  EXPECT_EQ(future.Locals(At(1)), Locals({kA, kB, kK, kL, kL + 1, kL + 2}));
  EXPECT_EQ(future.Locals(At(2)), Locals({kB, kK, kL, kL + 1, kL + 2}));
  EXPECT_EQ(future.Locals(At(4)), Locals({kK}));
}

// Globals whose numbers differ by 64 are taken for one.
TEST_F(ThreadFutureTest, ThereCanBeManyGlobals) {
  const ThreadFuture future = Of("  i[59] = 1;\n  i[k] = 1;\n  return 0;\n");
  EXPECT_EQ(future.Accesses(At(1)).writes, ~uint64_t{0});
  AccessSet access;
  access.Read(4);
  EXPECT_EQ(BitsOf(access).reads, kH);
  access.write = 5 + 59;
  EXPECT_EQ(BitsOf(access).writes, kG);
}

TEST_F(ThreadFutureTest, DependenceIsAWriteOfWhatTheOtherAccesses) {
  const AccessBits reads = {.reads = kG};
  const AccessBits writes = {.writes = kG};
  const AccessBits other = {.reads = kH, .writes = kH};
  EXPECT_FALSE(reads.MayDependOn(reads));
  EXPECT_TRUE(reads.MayDependOn(writes));
  EXPECT_TRUE(writes.MayDependOn(reads));
  EXPECT_TRUE(writes.MayDependOn(writes));
  EXPECT_FALSE(other.MayDependOn(writes));
  EXPECT_FALSE(other.MayDependOn(reads));
}

// More locals than are looked at one by one: all of them matter.
TEST_F(ThreadFutureTest, AThreadCanBeTooLarge) {
  std::string source = "int h;\nint t0() {\n  int a, l[1000];\n";
  for (int i = 0; i < 5000; ++i) source += "  a = 1;\n";
  const Problem problem = ProblemOf(source + "  h = a;\n  return 0;\n}\n");
  const ThreadFuture future(problem.model, 0);
  EXPECT_EQ(future.Locals(0).size(), 1001u);
  EXPECT_EQ(future.Accesses(0).writes, 1u);
}

}  // namespace
}  // namespace oncard::explore
