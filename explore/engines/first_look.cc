#include "explore/engines/first_look.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <utility>

#include "explore/engines/bounded_search.h"
#include "explore/engines/progress.h"
#include "explore/engines/sampler.h"
#include "explore/engines/shrink.h"
#include "explore/engines/walk.h"

namespace oncard::explore {
namespace {

/// Maximum number of states for the schedules with few preemptions; with a card each state takes
/// much longer.
constexpr uint32_t kProgramStates = 50'000;
constexpr uint32_t kCardStates = 2000;
/// Maximum number of statements of all random schedules together.
constexpr int64_t kProgramStatements = 100'000;
constexpr int64_t kCardStatements = 200'000;
/// Maximum number of statements when the threads run one after the other: more than a scenario's
/// default limit_ms allows at its default rate.
constexpr int64_t kSerialStatements = 8'000'000;

/// In a long run a state is kept after every this many statements.
constexpr int64_t kKeptEvery = 100'000;

/// Runs the threads one after the other, each as long as it can run.
FirstLook LookAtThreadsInTurn(CardModel* model, const std::atomic<bool>* stop) {
  /// The earlier of the two latest states kept: it is far enough before the end to show how the end
  /// was reached.
  struct Kept {
    std::shared_ptr<const CardModel::State> state;
    int64_t steps = 0;
  };
  CardWalk walk(model, false);
  std::vector<uint8_t> steps;
  Kept kept;
  Kept latest;
  int last = 0;
  while (!walk.fault() && !walk.ended()) {
    const auto taken = static_cast<int64_t>(steps.size());
    if (taken == kSerialStatements || IsTold(stop)) return {};
    if (taken >= latest.steps + kKeptEvery) {
      kept = std::exchange(latest, {std::make_shared<CardModel::State>(walk.WholeState()), taken});
    }
    const uint32_t choices = walk.choices();
    if ((choices >> last & 1) == 0) last = std::countr_zero(choices);
    const int64_t more = walk.StepAlone(last, kSerialStatements - taken);
    steps.insert(steps.end(), static_cast<size_t>(more), static_cast<uint8_t>(last));
  }
  if (!walk.fault()) return {};
  if (static_cast<int64_t>(steps.size()) < kCardEffort) return {std::move(steps), false};
  Failure failure;
  failure.fault = walk.fault();
  failure.steps = std::move(steps);
  failure.late = std::move(kept.state);
  failure.late_steps = kept.steps;
  return {{}, false, std::move(failure)};
}

/// The share of a case.
uint32_t StatesFor(uint32_t states, int64_t cases) {
  return static_cast<uint32_t>(std::max<int64_t>(states / cases, 1));
}

SampleOptions Sampling(int64_t statements, const std::atomic<bool>* stop) {
  return {.kind = SamplerKind::kPct, .all_statements = statements, .until_bad = true, .stop = stop};
}

}  // namespace

FirstLook LookFirst(const Problem& problem, const std::atomic<bool>* stop, int64_t cases) {
  if (problem.races == RaceRule::kBenign) return {};
  BoundedCounts few =
      SearchBounded(problem, {.state_limit = StatesFor(kProgramStates, cases), .stop = stop});
  if (few.bad) {
    return {std::move(few.failing), problem.races == RaceRule::kAny, {}, std::move(few.coverage)};
  }
  SampleCounts samples = Sample(problem, Sampling(kProgramStatements / cases, stop));
  samples.coverage.Include(few.coverage);
  return {std::move(samples.failing), false, {}, std::move(samples.coverage)};
}

FirstLook LookFirstAtCard(CardModel* model, const std::atomic<bool>* stop, int64_t cases) {
  FirstLook in_turn = LookAtThreadsInTurn(model, stop);
  if (in_turn.found()) return in_turn;
  BoundedCounts few =
      SearchCardBounded(model, {.state_limit = StatesFor(kCardStates, cases), .stop = stop});
  if (few.bad) return {std::move(few.failing), true};
  return {SampleCard(model, Sampling(kCardStatements / cases, stop)).failing, false};
}

}  // namespace oncard::explore
