// Searches as files (explore/search_file.h); what the command does with them is tested by
// tests/tools/explore_search_test.cc.
#include "explore/search_file.h"

#include <gtest/gtest.h>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

SearchFile Interrupted(const Problem& problem, int64_t executions) {
  SearchFile file;
  file.input = "inc.c";
  file.problem = HashOf(problem);
  file.held = {1};
  SearchTraces(problem, {.executions = executions}, &file.traces);
  return file;
}

TEST(SearchFileTest, TheTextHoldsEverything) {
  const Problem problem = ProblemOf(Increments(3, 2));
  const SearchFile file = Interrupted(problem, 500);
  ASSERT_FALSE(file.traces.units.front().frames.empty());
  const auto read = ParseSearchFile(FormatSearchFile(file));
  ASSERT_TRUE(read.ok()) << read.error().message.en;
  EXPECT_EQ(read.value().input, "inc.c");
  EXPECT_EQ(read.value().problem, file.problem);
  EXPECT_EQ(read.value().traces.units, file.traces.units);
  EXPECT_EQ(read.value().traces.executions, 500);
  EXPECT_EQ(read.value().traces.bad, file.traces.bad);
  EXPECT_EQ(read.value().traces.globals, file.traces.globals);
  EXPECT_EQ(read.value().traces.full, file.traces.full);
  EXPECT_EQ(read.value().traces.failing, file.traces.failing);
  EXPECT_EQ(FormatSearchFile(read.value()), FormatSearchFile(file));
}

TEST(SearchFileTest, SaysWhetherItIsDone) {
  const Problem problem = ProblemOf(Increments(2, 1));
  const SearchFile interrupted = Interrupted(problem, 2);
  EXPECT_FALSE(interrupted.done());
  EXPECT_EQ(Conclude(problem, interrupted).verdict, Verdict::kFailed);
  const SearchFile whole = Interrupted(problem, 1000);
  EXPECT_TRUE(whole.done() && whole.whole());
}

TEST(SearchFileTest, OtherProblemsHaveOtherHashes) {
  const std::string source = Increments(2, 1);
  const uint64_t hash = HashOf(ProblemOf(source));
  EXPECT_EQ(HashOf(ProblemOf(source)), hash);
  EXPECT_NE(HashOf(ProblemOf(source + "//@ never: x == 7\n")), hash);
  EXPECT_NE(HashOf(ProblemOf(source + "//@ init: x=1\n")), hash);
  EXPECT_NE(HashOf(ProblemOf(source + "//@ races: none\n")), hash);
}

TEST(SearchFileTest, PartsAreNumberedFromOne) {
  EXPECT_EQ(ParsePart("3/8").value(), (SearchPart{3, 8}));
  for (const char* bad : {"", "3", "0/8", "9/8", "3/", "/8", "3/8x", "-1/8", "1/100001"}) {
    EXPECT_FALSE(ParsePart(bad).ok()) << bad;
  }
}

TEST(SearchFileTest, RandomRunsThatAreNotDoneAreNotMerged) {
  SearchFile first;
  first.engine = EngineKind::kRandom;
  first.parts = 2;
  first.held = {1};
  SearchFile second = first;
  second.held = {2};
  second.runs_cut = 3;
  SearchFile file = first;
  EXPECT_FALSE(MergeInto(&file, second).ok());
  second.runs_cut = 0;
  EXPECT_TRUE(MergeInto(&file, second).ok());
  EXPECT_TRUE(file.whole());
}

TEST(SearchFileTest, RunsAreSharedOut) {
  EXPECT_EQ(RunsOfPart(10, {1, 3}), (std::pair<int64_t, int64_t>{0, 4}));
  EXPECT_EQ(RunsOfPart(10, {2, 3}), (std::pair<int64_t, int64_t>{4, 3}));
  EXPECT_EQ(RunsOfPart(10, {3, 3}), (std::pair<int64_t, int64_t>{7, 3}));
  EXPECT_EQ(RunsOfPart(1, {2, 2}), (std::pair<int64_t, int64_t>{1, 0}));
}

}  // namespace
}  // namespace oncard::explore
