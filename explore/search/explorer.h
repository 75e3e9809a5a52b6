// Answers whether any interleaving of a problem's threads can go wrong, and if so how.
//
// Two engines can prove it: `dpor`, one execution per Mazurkiewicz trace, and `stateful`, the graph
// of all states. Neither is always better; `auto` takes a first look (first_look.h), then runs both
// at the same time on two cores.
// What is too large can be tried by random schedules (sampler.h).
// A program that calls GT commands is explored together with its card, by its state graph.
// Deterministic but for what `auto` happens to count beside the verdict, and which of several
// failures it shows where the first look has found none and the states are too many.
// docs/interleavings.md says when which engine is the right one. Tested by
// tests/explore/explorer_test.cc.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "explore/engines/bounded_search.h"
#include "explore/engines/failure.h"
#include "explore/engines/progress.h"
#include "explore/engines/sampler.h"
#include "explore/engines/state_search.h"
#include "explore/engines/trace_search.h"
#include "explore/models/card_model.h"
#include "explore/models/ends.h"
#include "explore/models/problem.h"

namespace oncard::explore {

enum class EngineKind : uint8_t {
  kAuto,
  kDpor,
  kStateful,
  kBounded,
  kRandom,
  kPct,
  kPos,
  kFollow  ///< one given schedule: FollowSchedule() (scenario_exploration.h)
};

/// `auto`, `dpor`, `stateful`, `bounded`, `random`, `pct`, `pos`; empty for any other name.
std::optional<EngineKind> EngineNamed(std::string_view name);
std::string_view EngineName(EngineKind engine);

enum class Verdict : uint8_t {
  kProved,     ///< no interleaving goes wrong
  kPassed,     ///< none that was tried does: some were not, or until `until_ms` only
  kFailed,     ///< one does; Exploration::failure shows it
  kIncomplete  ///< a limit was reached before the search was done
};

/// `PROVED`, `PASSED`, `FAILED`, `INCOMPLETE`.
std::string_view VerdictName(Verdict verdict);

struct ExploreOptions {
  EngineKind engine = EngineKind::kAuto;
  int64_t execution_limit = 100'000'000;
  uint32_t state_limit = 50'000'000;
  /// Statements of one execution; the dpor engine gives up on longer ones.
  int64_t depth_limit = 100'000;
  /// kStateful, kAuto: a statement that touches no global goes with the one before it
  /// (StateLimits).
  bool merge_private = false;
  /// After the first failure the search goes on to its end, so that all are counted. Otherwise it
  /// goes on for a while only, after which a small program's counts are complete all the same.
  bool all = false;
  int preemption_limit = BoundedOptions{}.preemptions;  ///< kBounded
  // Of the engines that try random schedules.
  int64_t runs = SampleOptions{}.runs;
  int64_t first_run = 0;
  uint64_t seed = SampleOptions{}.seed;
  int depth = SampleOptions{}.depth;  ///< kPct: 1..kPctDepthMax

  const TraceSearch* begun = nullptr;  ///< kAuto, kDpor: a search to go on with
  /// kAuto, kDpor: told what the search of traces has so far when SearchProgress::pausing is set;
  /// the search then goes on. It may be called by another thread.
  std::function<void(const TraceSearch& search)> keep = {};
  SearchProgress* progress = nullptr;  ///< for another thread to look at
};

struct Exploration {
  Verdict verdict = Verdict::kIncomplete;
  EngineKind engine = EngineKind::kAuto;  ///< the one whose verdict it is
  Message why;                            ///< kPassed, kIncomplete: what was reached
  std::optional<TraceCounts> traces;
  TraceSearch search;  ///< kAuto, kDpor: to go on with when it is not complete
  std::optional<StateCounts> states;
  std::optional<BoundedCounts> bounded;
  std::optional<SampleCounts> samples;
  std::vector<FoundRace> races;  ///< all of the program, when the stateful engine looked for them
  /// Different ends, the smallest few; where nothing is asked of results.
  std::vector<End> ends;
  bool merged = false;  ///< ExploreOptions::merge_private
  std::optional<Failure> failure;
};

/// The verdict of random schedules; the failure is left to the caller.
Exploration ConcludeSamples(EngineKind engine, SampleCounts samples);

/// Explores. Fails when the engine cannot answer the problem's requirements.
Result<Exploration> Explore(const Problem& problem, const ExploreOptions& options);

/// The same for a card: the graph of all its states, or random schedules.
Exploration ExploreCard(CardModel* model, const ExploreOptions& options);

}  // namespace oncard::explore
