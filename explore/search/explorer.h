// Decides whether any interleaving of a problem's threads fails, and if so how.
//
// Two engines can prove it: `dpor`, one execution per Mazurkiewicz trace, and `stateful`, the graph
// of all states. Neither is always better; `auto` starts with a short first search (first_look.h),
// then runs both at the same time on two cores, the first one counting traces without an execution
// for each where that is possible (trace_count.h). Programs that are too large can be sampled with
// random schedules (sampler.h). A program that calls GT commands is explored together with its
// card, by its state graph. Deterministic except for the counts of `auto` beside the verdict, and
// for which of several failures it shows if the first search found none and there are more than
// kStatesBesideFailure states. docs/interleavings.md says which engine is suitable when. Tested by
// tests/explore/explorer_test.cc.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "explore/engines/bounded_search.h"
#include "explore/engines/failure.h"
#include "explore/engines/island_search.h"
#include "explore/engines/progress.h"
#include "explore/engines/reduced_search.h"
#include "explore/engines/sampler.h"
#include "explore/engines/state_search.h"
#include "explore/engines/trace_search.h"
#include "explore/models/card_model.h"
#include "explore/models/ends.h"
#include "explore/models/problem.h"
#include "explore/models/statement_coverage.h"

namespace oncard::explore {

/// Those with a name stand in the order of kEngineNames (runtime/scenario/file/search_names.h).
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

/// True for those that try random schedules.
constexpr bool IsRandom(EngineKind engine) {
  return engine == EngineKind::kRandom || engine == EngineKind::kPct || engine == EngineKind::kPos;
}

/// In the order of kVerdictNames (runtime/scenario/file/search_names.h).
enum class Verdict : uint8_t {
  kProved,     ///< no interleaving fails
  kPassed,     ///< none that was tried fails; others were not tried, or only up to a horizon
  kFailed,     ///< one fails; Exploration::failure shows it
  kIncomplete  ///< a limit was reached before the search was complete
};

/// `PROVED`, `PASSED`, `FAILED`, `INCOMPLETE`.
std::string_view VerdictName(Verdict verdict);

/// True for a verdict that no schedule which was searched fails.
constexpr bool IsGood(Verdict verdict) {
  return verdict == Verdict::kProved || verdict == Verdict::kPassed;
}

struct ExploreOptions {
  EngineKind engine = EngineKind::kAuto;
  /// kAuto: where it is lower, traces are never counted without executing each.
  int64_t execution_limit = 100'000'000;
  uint32_t state_limit = 50'000'000;
  /// Maximum number of statements of one execution; the dpor engine cannot handle longer ones.
  int64_t depth_limit = 100'000;
  /// kStateful, kAuto: combines a statement that accesses no global with the one before it
  /// (StateLimits). It is an error where a requirement can see what is between them. Not given:
  /// statements are combined where none can, as long as no failure is found; a failure is then
  /// sought again in single statements, so that the simplest one is shown.
  std::optional<bool> merge_private = {};
  /// kStateful, kAuto, where statements are combined: locals that cannot matter any more count as
  /// 0, and states that differ only in an exchange of equal threads count as one (StateLimits).
  bool dead_locals = true;
  bool symmetry = true;
  /// kAuto, with a card: threads that share nothing are searched by themselves
  /// (explore/models/islands.h).
  bool islands = true;
  /// kAuto, with a card: states that differ only in the order of what nobody notices are searched
  /// once (explore/engines/reduced_search.h).
  bool reductions = true;
  /// Continues the search to its end after the first failure, so that all are counted. Otherwise it
  /// continues for a limited time, which is enough for complete counts of a small program.
  bool all = false;
  /// kAuto: the first look is divided among so many searches.
  int64_t cases = 1;
  /// States that were searched in other cases, by which `state_limit` is lower than for all.
  int64_t states_before = 0;
  /// With a card: what the searches of all cases know of its steps; nullptr: one case.
  std::shared_ptr<KnownSteps> known_steps = {};
  /// kAuto, kStateful, with a card: only one of `groups` groups of schedules, from 0
  /// (explore/engines/card_cut.h). What comes before them is counted in the first one.
  int group = 0;
  int groups = 1;
  int preemption_limit = BoundedOptions{}.preemptions;  ///< kBounded
  // For the engines with random schedules.
  int64_t runs = SampleOptions{}.runs;
  int64_t first_run = 0;
  uint64_t seed = SampleOptions{}.seed;
  int depth = SampleOptions{}.depth;  ///< kPct: 1..kPctDepthMax

  std::string kept = {};  ///< the file in which the search is kept, as command lines name it
  const TraceSearch* begun = nullptr;  ///< kAuto, kDpor: a search to continue
  /// kAuto, kDpor: receives the progress of the search of traces when SearchProgress::pausing is
  /// set; the search then continues. It may be called from another thread.
  std::function<void(const TraceSearch& search)> keep = {};
  SearchProgress* progress = nullptr;  ///< progress, readable from another thread
};

/// Up to where the search of a card's states has come.
struct Reached {
  double at_ms = 0;        ///< every schedule was searched up to this instant
  double until_ms = 0;     ///< with this `until_ms` the search would have been complete
  std::vector<int> lines;  ///< of a state there: where each thread is; 0 if it does not run
};

struct Exploration {
  Verdict verdict = Verdict::kIncomplete;
  EngineKind engine = EngineKind::kAuto;  ///< the engine that reached the verdict
  /// Two engines ran beside each other: which one reached the verdict, and what the other one had
  /// counted by then, depends on the clock.
  bool paired = false;
  Message why;                     ///< kPassed, kIncomplete: the bound that was reached
  std::optional<Reached> reached;  ///< kIncomplete, with a card: by its states
  bool remembers_steps = true;     ///< with a card: its states were rows (models/card_rows.h)
  Horizon horizon;                 ///< with a card: what goes on where its runs end
  std::optional<TraceCounts> traces;
  TraceSearch search;  ///< kAuto, kDpor: the search to continue if it is not complete
  std::optional<StateCounts> states;
  std::optional<IslandCounts> islands;  ///< kAuto, with a card: they have been the proof
  /// kAuto, with a card: states were left out. They are the proof, unless StateCounts are complete.
  std::optional<ReducedCounts> reduced;
  std::optional<BoundedCounts> bounded;
  std::optional<SampleCounts> samples;
  /// All races of the program, if the stateful engine searched for them to its end; with a card
  /// those with which runs end.
  std::vector<FoundRace> races;
  /// Different ends, the smallest few; if there are no requirements on results.
  std::vector<End> ends;
  std::optional<Failure> failure;
  /// What was executed; with `islands` it may be more than the program executes. Empty if the
  /// engine does not note it: of a search that was continued, and of one followed schedule.
  StatementCoverage coverage;
};

/// The verdict of random schedules; the caller fills in the failure.
Exploration ConcludeSamples(EngineKind engine, SampleCounts samples);

/// Why a search is incomplete: it was stopped, or reached this limit.
Message WhyIncomplete(const ExploreOptions& options, Message limit);
/// What random schedules have shown that found no failure.
Message DescribeSamples(const SampleCounts& samples);
/// The same for a search with few preemptions.
Message DescribeBound(const BoundedCounts& bounded);
/// The limits of a search of all schedules.
Message DescribeLimits(const ExploreOptions& options);

/// Why statements that access no global cannot be combined with the one before them: a requirement
/// can see what is between them. Empty if they can.
std::optional<Message> WhyNotMerged(const Problem& problem);

/// Explores. Fails when the engine cannot answer the problem's requirements.
Result<Exploration> Explore(const Problem& problem, const ExploreOptions& options);

/// Adds to kPassed what still goes on where the runs of a card end.
void BoundByHorizon(const Horizon& horizon, Exploration* exploration);

/// The same for a card: the graph of all its states, or random schedules.
Exploration ExploreCard(CardModel* model, const ExploreOptions& options);

}  // namespace oncard::explore
