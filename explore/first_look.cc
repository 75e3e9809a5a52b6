#include "explore/first_look.h"

#include <bit>
#include <utility>

#include "explore/bounded_search.h"
#include "explore/sampler.h"
#include "explore/walk.h"

namespace oncard::explore {
namespace {

/// States of the schedules with so many preemptions; with a card each takes much longer.
constexpr uint32_t kProgramStates = 50'000;
constexpr uint32_t kCardStates = 2000;
/// Statements of all random schedules together.
constexpr int64_t kProgramStatements = 100'000;
constexpr int64_t kCardStatements = 200'000;
/// Statements of the threads one after the other: more than a scenario's default limit_ms allows at
/// its default rate.
constexpr int64_t kSerialStatements = 8'000'000;

/// The threads one after the other, each as long as it can.
std::vector<uint8_t> LookAtThreadsInTurn(CardModel* model) {
  CardWalk walk(model, false);
  std::vector<uint8_t> steps;
  int last = 0;
  while (!walk.fault() && !walk.ended()) {
    if (static_cast<int64_t>(steps.size()) == kSerialStatements) return {};
    const uint32_t choices = walk.choices();
    if ((choices >> last & 1) == 0) last = std::countr_zero(choices);
    walk.Step(last);
    steps.push_back(static_cast<uint8_t>(last));
  }
  if (!walk.fault()) return {};
  return steps;
}

SampleOptions Sampling(int64_t statements, const std::atomic<bool>* stop) {
  return {.kind = SamplerKind::kPct, .all_statements = statements, .until_bad = true, .stop = stop};
}

}  // namespace

FirstLook LookFirst(const Problem& problem, const std::atomic<bool>* stop) {
  if (problem.races == RaceRule::kBenign) return {};
  BoundedCounts few = SearchBounded(problem, {.state_limit = kProgramStates, .stop = stop});
  if (few.bad) return {std::move(few.failing), problem.races == RaceRule::kAny};
  return {Sample(problem, Sampling(kProgramStatements, stop)).failing, false};
}

FirstLook LookFirstAtCard(CardModel* model, const std::atomic<bool>* stop) {
  std::vector<uint8_t> in_turn = LookAtThreadsInTurn(model);
  if (!in_turn.empty()) return {std::move(in_turn), false};
  BoundedCounts few = SearchCardBounded(model, {.state_limit = kCardStates, .stop = stop});
  if (few.bad) return {std::move(few.failing), true};
  return {SampleCard(model, Sampling(kCardStatements, stop)).failing, false};
}

}  // namespace oncard::explore
