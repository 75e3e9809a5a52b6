// The data of a search file is checked with the program before it is used
// (explore/search/search_check.h).
#include "explore/search/search_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

using testing::HasSubstr;

/// An interrupted search with frames, plans and races, for two threads with three statements and a
/// return each, one of which accesses nothing shared.
class SearchCheck : public ::testing::Test {
 protected:
  SearchCheck() : problem_(ProblemOf(Increments(2, 2))) {
    file_.problem = HashOf(problem_);
    file_.held = {1};
    SearchTraces(problem_, {.executions = 4}, &file_.traces);
    frames_ = &file_.traces.units.front().frames;
  }
  /// Empty if the file is valid.
  std::string Error() const {
    const auto checked = CheckSearch(problem_, file_);
    return checked.ok() ? "" : checked.error().message.en;
  }
  TraceUnit& unit() { return file_.traces.units.front(); }

  Problem problem_;
  SearchFile file_;
  std::vector<SavedFrame>* frames_ = nullptr;
};

TEST_F(SearchCheck, WhatASearchHasWrittenIsGood) {
  ASSERT_GT(frames_->size(), 3u);
  EXPECT_EQ(Error(), "");
  for (int64_t executions = 1; executions < 15; ++executions) {
    file_.traces = {};
    SearchTraces(problem_, {.executions = executions}, &file_.traces);
    EXPECT_EQ(Error(), "") << executions;
  }
  file_.traces = TracesOfPart(problem_, {2, 3});
  EXPECT_EQ(Error(), "");
}

TEST_F(SearchCheck, ResultsThatTheProgramCannotHave) {
  // The program has one global and two threads.
  file_.traces.ends = {};
  file_.traces.ends.Add({1, 2});
  EXPECT_EQ(Error(), "results[0]: 2 values, the program has 3; explore again");
}

TEST_F(SearchCheck, AThreadThatThereIsNot) {
  for (const int thread : {2, 31}) {
    frames_->front().plans.front().thread = static_cast<uint8_t>(thread);
    EXPECT_EQ(Error(), "units[0].frames[0].plans: thread " + std::to_string(thread) +
                           " of the search cannot execute a step there; explore again");
  }
  unit() = {{0, 1, 7}, {}};
  EXPECT_EQ(
      Error(),
      "units[0].prefix[2]: thread 7 of the search cannot execute a step there; explore again");
  unit() = {{0}, {1, 2}};
  EXPECT_EQ(Error(),
            "units[0].sleep: thread 2 of the search cannot execute a step there; explore again");
  unit() = {{}, {}, {{.sleep = {9}, .plans = {{0, 0}}}}};
  EXPECT_THAT(Error(), HasSubstr("units[0].frames[0].sleep: thread 9"));
}

TEST_F(SearchCheck, AThreadThatHasEnded) {
  // Four steps that access x; then the thread runs to its end.
  unit() = {{0, 0, 0, 0}, {}};
  EXPECT_EQ(Error(), "");
  unit() = {{0, 0, 0, 0, 0}, {}};
  EXPECT_THAT(Error(), HasSubstr("prefix[4]: thread 0"));
  unit() = {{0, 0, 0, 0}, {0}};
  EXPECT_THAT(Error(), HasSubstr("sleep: thread 0"));
}

TEST_F(SearchCheck, PlansThatAreNoTrees) {
  const auto with_plans = [&](std::vector<PlannedStep> plans) {
    unit() = {{}, {}, {{.sleep = {}, .plans = std::move(plans)}}};
    return Error();
  };
  EXPECT_EQ(with_plans({{0, 1}, {1, 0}, {1, 0}}), "");
  EXPECT_THAT(with_plans({}), HasSubstr("not a list of plans"));
  EXPECT_THAT(with_plans({{0, 1}}), HasSubstr("not a list of plans"));
  EXPECT_THAT(with_plans({{0, 4'000'000'000}, {1, 0}}), HasSubstr("not a list of plans"));
  EXPECT_THAT(with_plans({{0, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 0}}), HasSubstr("thread 0"));
}

TEST_F(SearchCheck, RacesWithWhatIsNotEarlier) {
  for (size_t i = 0; i < frames_->size(); ++i) {
    const SavedFrame kept = (*frames_)[i];
    (*frames_)[i].races = {static_cast<uint32_t>(i)};
    EXPECT_THAT(Error(), HasSubstr(".races: " + std::to_string(i) + " is not an earlier step"));
    (*frames_)[i].races = {UINT32_MAX};
    EXPECT_THAT(Error(), HasSubstr(".races: 4294967295"));
    (*frames_)[i] = kept;
  }
}

/// Earlier steps that are listed as races but do not race are ignored; the counts do not change.
TEST_F(SearchCheck, RacesThatAreNoneAreForgotten) {
  TraceSearch whole;
  SearchTraces(problem_, {}, &whole);
  for (size_t i = 0; i < frames_->size(); ++i) {
    for (uint32_t earlier = 0; earlier < i; ++earlier) {
      if (std::ranges::find((*frames_)[i].races, earlier) == (*frames_)[i].races.end()) {
        (*frames_)[i].races.push_back(earlier);
      }
    }
  }
  EXPECT_EQ(Error(), "");
  SearchTraces(problem_, {}, &file_.traces);
  EXPECT_TRUE(file_.traces.complete());
  EXPECT_EQ(file_.traces.full, whole.full);
}

TEST_F(SearchCheck, RunsThatDoNotFail) {
  ASSERT_GT(file_.traces.bad, 0);
  const std::vector<uint8_t> failing = file_.traces.failing;
  file_.traces.failing.back() = 5;
  EXPECT_THAT(Error(), HasSubstr("thread 5"));
  // One thread after the other: no addition is lost.
  file_.traces.failing = std::vector<uint8_t>(7, 0);
  file_.traces.failing.insert(file_.traces.failing.end(), 7, 1);
  EXPECT_EQ(Error(), "failing: this run does not fail; explore again");
  file_.traces.failing.clear();
  EXPECT_NE(Error(), "");
  file_.traces.failing = failing;
  file_.traces.bad = 0;
  EXPECT_NE(Error(), "");
}

TEST_F(SearchCheck, RunsThatAreLongerThanTheSearchFollows) {
  unit() = {{0, 0, 0, 0}, {}};
  EXPECT_TRUE(CheckSearch(problem_, file_, 100).ok());
  const auto checked = CheckSearch(problem_, file_, 4);
  ASSERT_FALSE(checked.ok());
  EXPECT_THAT(checked.error().message.en, HasSubstr("longer than 4 statements"));
}

}  // namespace
}  // namespace oncard::explore
