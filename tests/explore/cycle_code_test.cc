// What a thread can still execute in a cycle (explore/models/cycle_code.h): looked up by source
// line.
#include "explore/models/cycle_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

/// The thread t0 of a program; its declarations are the first three lines.
class CycleCodeTest : public testing::Test {
 protected:
  static constexpr int kDeclarations = 3;

  CycleCodeTest()
      : card_(CardOf("int g;\nint t0() {\n  int n;\n"
                     "  n = g;\n"          // 1
                     "  if (n) goto W;\n"  // 2
                     "  n = 3;\n"          // 3
                     "  GT_Delay(2);\n"    // 4
                     "  g = 1;\n"          // 5
                     "  g = 2;\n"          // 6
                     "  return 0;\n"       // 7
                     "W:\n"                // 8
                     "  n = g == 0;\n"     // 9
                     "  if (n) goto W;\n"  // 10
                     "  GT_Delay(n);\n"    // 11
                     "  g = 3;\n"          // 12
                     "}\n",
                     "limit_ms = 10\n")),
        function_(card_.image()->object.functions.front()),
        code_(function_, card_.controller().family().catalogue) {}

  size_t At(int line) const {
    const auto found = std::ranges::find(function_.lines, line + kDeclarations);
    return static_cast<size_t>(found - function_.lines.begin());
  }
  std::vector<int> LinesFrom(int line) const {
    std::vector<int> lines;
    for (const size_t position : code_.ReachedFrom(At(line))) {
      lines.push_back(function_.lines[position] - kDeclarations);
    }
    return lines;
  }

  CardModel card_;
  const vm::Function& function_;
  CycleCode code_;
};

TEST_F(CycleCodeTest, ADelayEndsAThreadsPartOfTheCycle) {
  EXPECT_EQ(code_.MostFrom(At(3)), 2);
  EXPECT_EQ(LinesFrom(3), std::vector<int>({3, 4}));
}

TEST_F(CycleCodeTest, SoDoesItsEnd) {
  EXPECT_EQ(code_.MostFrom(At(5)), 3);
  EXPECT_EQ(code_.MostFrom(function_.instructions.size()), 0);
  EXPECT_EQ(LinesFrom(6), std::vector<int>({6, 7}));
}

TEST_F(CycleCodeTest, ALoopWithoutADelayHasNoLimit) {
  EXPECT_EQ(code_.MostFrom(At(9)), CycleCode::kUnlimited);
  EXPECT_EQ(code_.MostFrom(At(1)), CycleCode::kUnlimited);
}

TEST_F(CycleCodeTest, ADelayOfAComputedTimeMayBeNone) {
  EXPECT_EQ(LinesFrom(11), std::vector<int>({11, 12}));
  EXPECT_EQ(code_.MostFrom(At(11)), 2);
}

TEST_F(CycleCodeTest, BothWaysOfAConditionAreReached) {
  EXPECT_EQ(LinesFrom(1), std::vector<int>({1, 2, 3, 4, 9, 10, 11, 12}));
}

}  // namespace
}  // namespace oncard::explore
