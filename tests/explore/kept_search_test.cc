// Searches that are saved while they run (explore/search/kept_search.h).
#include "explore/search/kept_search.h"

#include <gtest/gtest.h>

#include "explore/search/search_check.h"
#include "explore_programs.h"

namespace oncard::explore {
namespace {

class KeptSearch : public ::testing::Test {
 protected:
  /// Requests a pause, as the watcher does every minute.
  void Pause() {
    progress_.pausing = true;
    progress_.stop = true;
  }
  SearchFile Begin(EngineKind engine) {
    SearchFile file;
    file.input = "inc.c";
    file.problem = HashOf(problem_);
    file.engine = engine;
    file.held = {1};
    file.runs = file.runs_cut = engine == EngineKind::kDpor ? 0 : 50;
    return file;
  }

  Problem problem_ = ProblemOf(Increments(2, 3));
  SearchProgress progress_;
  ExploreOptions options_{.progress = &progress_};
};

TEST_F(KeptSearch, GoesOnAfterEachTimeAndLosesNothing) {
  for (const EngineKind engine : {EngineKind::kDpor, EngineKind::kRandom, EngineKind::kPct}) {
    SearchFile whole = Begin(engine);
    ASSERT_TRUE(GoOn(problem_, {}, {}, &whole).ok());

    SearchFile file = Begin(engine);
    int kept = 0;
    Pause();
    const auto keep = [&](const SearchFile& present) {
      const auto read = ParseSearchFile(FormatSearchFile(present));
      EXPECT_TRUE(read.ok() && CheckSearch(problem_, read.value()).ok());
      EXPECT_FALSE(present.done());
      if (++kept < 4) Pause();
      return true;
    };
    const auto found = GoOn(problem_, options_, keep, &file);
    ASSERT_TRUE(found.ok());
    EXPECT_EQ(kept, 4);
    EXPECT_TRUE(file.done());
    EXPECT_EQ(file.traces.executions, whole.traces.executions);
    EXPECT_EQ(file.traces.full, whole.traces.full);
    EXPECT_EQ(file.traces.bad, whole.traces.bad);
    EXPECT_EQ(file.samples.runs, whole.samples.runs);
    EXPECT_EQ(file.samples.bad, whole.samples.bad);
    EXPECT_EQ(file.samples.ends, whole.samples.ends);
  }
}

TEST_F(KeptSearch, AnInterruptionEndsItEvenDuringAPause) {
  SearchFile file = Begin(EngineKind::kDpor);
  Pause();
  progress_.interrupted = true;
  const auto found = GoOn(
      problem_, options_,
      [](const SearchFile&) {
        ADD_FAILURE() << "the search goes on";
        return true;
      },
      &file);
  ASSERT_TRUE(found.ok());
  EXPECT_FALSE(file.done());
  EXPECT_FALSE(file.traces.units.empty());
}

TEST_F(KeptSearch, EndsWhenItCannotBeKept) {
  SearchFile file = Begin(EngineKind::kDpor);
  Pause();
  int asked = 0;
  ASSERT_TRUE(GoOn(
                  problem_, options_, [&](const SearchFile&) { return ++asked > 1; }, &file)
                  .ok());
  EXPECT_EQ(asked, 1);
  EXPECT_FALSE(file.done());
}

TEST_F(KeptSearch, TheLimitOfExecutionsIsThatOfAllPieces) {
  SearchFile file = Begin(EngineKind::kDpor);
  options_.execution_limit = 7;
  Pause();
  const auto keep = [&](const SearchFile&) {
    Pause();
    return true;
  };
  ASSERT_TRUE(GoOn(problem_, options_, keep, &file).ok());
  EXPECT_EQ(file.traces.executions, 7);
}

// --- Searches that nobody keeps a file of --------------------------------------------------------

TEST_F(KeptSearch, ASearchIsToldOnTheWayAndLosesNothing) {
  // Without a failure, which would end the search soon.
  const Problem problem = {problem_.model};
  const Exploration whole = Explore(problem, {.engine = EngineKind::kDpor}).value();
  options_.engine = EngineKind::kDpor;
  int kept = 0;
  options_.keep = [&](const TraceSearch& search) {
    EXPECT_FALSE(search.complete());
    if (++kept < 3) Pause();
  };
  Pause();
  const auto found = Explore(problem, options_);
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(kept, 3);
  EXPECT_EQ(found.value().verdict, whole.verdict);
  EXPECT_EQ(found.value().traces->executions, whole.traces->executions);
  EXPECT_EQ(found.value().ends, whole.ends);
}

TEST_F(KeptSearch, AutoGoesOnAfterItWasKept) {
  // Far too many traces: only the interruption ends the search.
  const Problem large = {ProblemOf(Increments(8, 50)).model};
  std::vector<int64_t> kept;
  options_.all = true;
  options_.keep = [&](const TraceSearch& search) {
    kept.push_back(search.executions);
    if (kept.size() == 1) return Pause();
    progress_.interrupted = true;
    progress_.stop = true;
  };
  Pause();
  const auto found = Explore(large, options_);
  ASSERT_TRUE(found.ok());
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_LE(kept[0], kept[1]);
  EXPECT_LE(kept[1], found.value().traces->executions);
  EXPECT_EQ(found.value().verdict, Verdict::kIncomplete);
  EXPECT_EQ(found.value().why.en, "it was interrupted");
}

}  // namespace
}  // namespace oncard::explore
