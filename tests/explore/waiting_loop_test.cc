// Loops in which threads wait (explore/engines/waiting_loop.h).
#include "explore/engines/waiting_loop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "explore/reports/report.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Whether thread 0 waits after this many statements, in a program in which it has `body`.
bool WaitsAfter(int statements, const std::string& body) {
  Model model =
      ProblemOf("int x, a[2];\nint t0() {\n  int r, c;\n" + body + "  return 0;\n}\n").model;
  for (int i = 0; i < statements; ++i) model.Step(0);
  const StateKey before = model.key();
  const bool waits = WaitsInLoop(&model, 0);
  EXPECT_EQ(model.key(), before);
  EXPECT_EQ(model.depth(), statements);
  return waits;
}

TEST(WaitingLoopTest, OnePassMustChangeNothing) {
  const std::string look = "W:\n  r = x;\n  c = r == 0;\n  if (c) goto W;\n";
  EXPECT_FALSE(WaitsAfter(0, look));  // the first pass sets c
  EXPECT_TRUE(WaitsAfter(3, look));
  EXPECT_FALSE(WaitsAfter(3, "W:\n  r = x;\n  c = c + 1;\n  if (c) goto W;\n"));
  EXPECT_FALSE(WaitsAfter(2, "W:\n  x = 0;\n  c = 1;\n  if (c) goto W;\n"));
  // Two looks in one pass are not recognised.
  EXPECT_FALSE(WaitsAfter(4, "W:\n  r = x;\n  r = a[1];\n  c = r == 0;\n  if (c) goto W;\n"));
}

TEST(WaitingLoopTest, AllThreadsThatRunMustWait) {
  Model model = ProblemOf(MutualWait()).model;
  EXPECT_THAT(EndlessWait(model), IsEmpty());
  for (const int thread : {0, 0, 0, 1, 1, 1}) model.Step(thread);
  EXPECT_THAT(EndlessWait(model), ElementsAre(0, 0, 0, 1, 1, 1));
}

TEST(WaitingLoopTest, ALivelockIsFoundInTraces) {
  const Findings findings = FindingsOf(MutualWait(), {.engine = EngineKind::kDpor});
  EXPECT_EQ(findings.exploration.verdict, Verdict::kFailed);
  const Failure& failure = *findings.exploration.failure;
  EXPECT_TRUE(failure.livelock);
  EXPECT_EQ(failure.cycle.size(), 6u);
  EXPECT_THAT(TextReport(findings, Language::kEnglish), HasSubstr("for ever"));
  const Findings allowed =
      FindingsOf("//@ livelock: any\n" + MutualWait(), {.engine = EngineKind::kDpor});
  EXPECT_EQ(allowed.exploration.verdict, Verdict::kProved);
}

}  // namespace
}  // namespace oncard::explore
