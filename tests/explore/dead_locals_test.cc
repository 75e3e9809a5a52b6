// Locals that can no longer be read (explore/models/dead_locals.h), in states of one thread.
#include "explore/models/dead_locals.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

using Values = std::vector<int64_t>;

/// Of each state of the thread t0 what is left of its locals, after each statement.
std::vector<Values> LocalsOf(const std::string& body, const std::string& keys, bool* grown) {
  CardModel card = CardOf("int g;\nint t0() {\n  int a, b, sts, clock;\n" + body + "}\n", keys);
  CardSteps rows(&card);
  DeadLocals locals(card, &rows);
  std::vector<Values> all;
  CardRows::Row row = rows.Start();
  for (locals.Begin(); rows.ChoicesOf(row) != 0;) {
    locals.LookAt(row, 0);
    row = rows.Step(row, 0);
    CardRows::Row forgotten = row;
    locals.Forget(0, &forgotten);
    all.push_back(rows.ThreadOf(forgotten, 0).page);
  }
  *grown = locals.grown();
  return all;
}

std::vector<Values> LocalsOf(const std::string& body, const std::string& keys = "") {
  bool grown = false;
  std::vector<Values> all = LocalsOf(body, keys, &grown);
  EXPECT_FALSE(grown);
  return all;
}

TEST(DeadLocals, AreThoseThatAreNotReadAnyMore) {
  EXPECT_EQ(LocalsOf("  a = 5;\n  b = a + 1;\n  g = b;\n  return 0;\n"),
            std::vector<Values>({{5}, {0, 6}, {}, {}}));
}

TEST(DeadLocals, AreThoseThatAreWrittenBeforeTheyAreRead) {
  EXPECT_EQ(LocalsOf("  a = 5;\n  g = 1;\n  a = 6;\n  g = a;\n  return 0;\n"),
            std::vector<Values>({{}, {}, {6}, {}, {}}));
}

TEST(DeadLocals, AReturnedValueIsReadBefore) {
  EXPECT_EQ(LocalsOf("  a = 5;\n  return a;\n"), std::vector<Values>({{5}, {}}));
}

TEST(DeadLocals, AreOutputsBeforeTheirCommand) {
  EXPECT_EQ(LocalsOf("  sts = 7;\n  GT_AxisOn(1);\n  GT_GetSts(1, &sts, 1, &clock);\n  g = 1;\n"
                     "  return sts;\n"),
            std::vector<Values>({{}, {}, {0, 0, 0x200}, {0, 0, 0x200}, {}}));
}

TEST(DeadLocals, ARefusedCommandLeavesItsOutputs) {
  // There is no axis 99, so that what is returned is 7. It is seen when the command is looked at.
  bool grown = false;
  LocalsOf("  a = 99;\n  sts = 7;\n  GT_GetSts(a, &sts, 1, &clock);\n  return sts;\n", "", &grown);
  EXPECT_TRUE(grown);
}

TEST(DeadLocals, WhatARequirementNamesCounts) {
  EXPECT_EQ(LocalsOf("  a = 5;\n  b = 6;\n  return 0;\n", "always = [\"page0.a < 9\"]\n"),
            std::vector<Values>({{5}, {5}, {5}}));
}

TEST(DeadLocals, ElementsOfArraysAreNotWrittenForSure) {
  EXPECT_EQ(LocalsOf("  int l[2];\n  a = 1;\n  l[0] = 8;\n  l[a] = 9;\n  g = l[0];\n  return 0;\n"),
            std::vector<Values>({{1}, {1, 0, 0, 0, 8}, {0, 0, 0, 0, 8}, {}, {}}));
}

}  // namespace
}  // namespace oncard::explore
