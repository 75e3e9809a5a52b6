// Two searches of one problem (explore/search/search_pair.h).
#include "explore/search/search_pair.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <optional>
#include <thread>
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
                      .states = [this](const std::atomic<bool>*,
                                       const std::atomic<uint32_t>*) { return std::move(states); },
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

// Whichever search is the first to know of a failure, that of states shows it, so it must be over.
TEST(SearchesAtOnceTest, AFailureOfTheTracesIsShownByTheStates) {
  TraceSearch failing;
  failing.bad = 1;
  bool told_to_end = false;
  const PairResult answer = RunPair(
      {.traces = [&](const std::atomic<bool>*, const SearchPair::TakesPause&) { return failing; },
       .states =
           [&](const std::atomic<bool>* stop, const std::atomic<uint32_t>* most) {
             while (*most == std::numeric_limits<uint32_t>::max()) std::this_thread::yield();
             // Longer than the grace of a search that is not awaited.
             std::this_thread::sleep_for(std::chrono::milliseconds(50));
             told_to_end = *stop;
             StateSearch search;
             search.counts.bad_states = 1;
             return search;
           }});
  EXPECT_FALSE(told_to_end);
  EXPECT_EQ(answer.states.counts.bad_states, 1);
}

}  // namespace
}  // namespace oncard::explore
