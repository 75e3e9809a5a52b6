// The number of traces, estimated (explore/engines/estimate.h).
#include "explore/engines/estimate.h"

#include <gtest/gtest.h>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

TEST(EstimateTest, IsNearTheNumberOfTraces) {
  struct Case {
    int threads;
    int times;
    double traces;
  };
  for (const Case& c : {Case{2, 1, 4}, Case{2, 2, 34}, Case{3, 1, 36}, Case{3, 2, 7134}}) {
    Problem problem = ProblemOf(Increments(c.threads, c.times));
    const TraceEstimate estimate = EstimateTraces(&problem.model, 4000, 1, 1000);
    EXPECT_NEAR(estimate.traces, c.traces, 3 * estimate.error) << c.traces;
    EXPECT_LT(estimate.error, 0.2 * c.traces);
    EXPECT_EQ(problem.model.depth(), 0);
  }
}

TEST(EstimateTest, OfIndependentThreadsItIsExact) {
  Problem problem = ProblemOf("int x, y;\nint t0() {\n x = 1;\n}\nint t1() {\n y = 1;\n}\n");
  const TraceEstimate estimate = EstimateTraces(&problem.model, 20000, 1, 1000);
  EXPECT_NEAR(estimate.traces, 1, 3 * estimate.error);
}

TEST(EstimateTest, WhatDoesNotEndHasNone) {
  Problem problem = ProblemOf(MutualWait());
  EXPECT_EQ(EstimateTraces(&problem.model, 10, 1, 1000).traces, 0);
}

}  // namespace
}  // namespace oncard::explore
