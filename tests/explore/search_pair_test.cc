// Two searches one after the other (explore/search/search_pair.h).
#include "explore/search/search_pair.h"

#include <gtest/gtest.h>

#include <optional>
#include <utility>

namespace oncard::explore {
namespace {

using First = PairResult::First;

/// Searches with given results, which they give once.
struct Searches {
  StateSearch states;
  TraceSearch traces;
  SearchProgress* progress = nullptr;

  PairResult Run() {
    return RunInTurn({.traces = [this](const std::atomic<bool>*,
                                       const SearchPair::TakesPause&) { return traces; },
                      .states = [this](const std::atomic<bool>*) { return std::move(states); },
                      .progress = progress});
  }
};

TraceSearch CompleteTraces() {
  TraceSearch search;
  search.units.clear();
  return search;
}

TEST(SearchesInTurnTest, TheSearchOfStatesAnswersFirst) {
  Searches complete;
  complete.states.counts.complete = true;
  const PairResult answer = complete.Run();
  EXPECT_EQ(answer.first, First::kStates);
  EXPECT_FALSE(answer.traces);

  Searches failing;
  failing.states.counts.bad_states = 1;
  EXPECT_EQ(failing.Run().first, First::kStates);
}

TEST(SearchesInTurnTest, TheSearchOfTracesFollowsOneWithoutAnAnswer) {
  Searches complete;
  complete.traces = CompleteTraces();
  EXPECT_EQ(complete.Run().first, First::kTraces);

  Searches failing;
  failing.traces.bad = 1;
  EXPECT_EQ(failing.Run().first, First::kTraces);

  Searches neither;
  const PairResult answer = neither.Run();
  EXPECT_EQ(answer.first, First::kNeither);
  EXPECT_TRUE(answer.traces);
}

TEST(SearchesInTurnTest, NothingFollowsARequestToEnd) {
  SearchProgress progress;
  progress.stop = true;
  Searches stopped;
  stopped.progress = &progress;
  const PairResult answer = stopped.Run();
  EXPECT_EQ(answer.first, First::kNeither);
  EXPECT_FALSE(answer.traces);
}

TEST(SearchesInTurnTest, ARequestToSaveDoesNotEndThem) {
  SearchProgress progress;
  progress.pausing = true;
  progress.stop = true;
  Searches paused;
  paused.progress = &progress;
  paused.traces = CompleteTraces();
  EXPECT_EQ(paused.Run().first, First::kTraces);
}

}  // namespace
}  // namespace oncard::explore
