#include "explore/engines/trace_search.h"

#include <algorithm>
#include <utility>

#include "explore/engines/found_parts.h"
#include "explore/engines/trace_count.h"
#include "explore/engines/walk.h"
#include "explore/models/key_set.h"

namespace oncard::explore {
namespace {

std::vector<StateKey> SortedKeys(const KeySet& set) {
  std::vector<StateKey> keys = set.Keys();
  std::ranges::sort(keys);
  return keys;
}

/// The number of failing executions among which a short one is selected.
constexpr int64_t kFailingTried = 1000;

/// When executions are counted: after so many, with so many pairs (TraceCountLimits), which takes
/// about as long. If that is not enough, the search goes on until both have grown.
struct CountPlan {
  static constexpr size_t kPairsMax = size_t{1} << 20;

  bool active = false;
  int64_t after = 10'000;
  size_t pairs = size_t{1} << 14;

  void GrowUnless(bool bad) {
    after *= 4;
    pairs *= 4;
    active = !bad && pairs <= kPairsMax;
  }
};

/// Different ends of executions.
struct FoundEnds {
  KeySet globals;
  KeySet full;
  EndSet values;  ///< only if there are no requirements on results

  void Add(const Problem& problem, const Model& state) {
    if (!full.Insert(state.FinalKey())) return;
    globals.Insert(state.GlobalsKey());
    if (problem.requirements.empty()) values.Add(EndOf(state));
  }
  void MoveTo(TraceSearch* search) const {
    for (const End& end : values.ends()) search->ends.Add(end);
    search->globals = UnionOf(search->globals, SortedKeys(globals));
    search->full = UnionOf(search->full, SortedKeys(full));
  }
};

/// Replaces a search by the results of counting all its executions. False, without a change: that
/// is not possible, or an end is bad; `bad` says that.
bool CountAll(const Problem& problem, const TraceSearchLimits& limits, size_t pairs,
              TraceSearch* search, bool* bad) {
  FoundEnds ends;
  const auto sees_locals = [](const BoundRequirement& requirement) {
    return requirement.property.SeesLocals();
  };
  const TraceCountLimits of_count = {
      .pairs = pairs,
      .depth = limits.depth,
      .tells_locals = std::ranges::any_of(problem.requirements, sees_locals),
      .stop = limits.stop};
  Model model = ModelOfTraces(problem);
  model.NoteIn(&search->coverage);
  const auto found = CountTraces(model, of_count, [&](const Model& state) {
    ends.Add(problem, state);
    *bad = static_cast<bool>(FindFault(problem, state));
    return !*bad;
  });
  if (!found) return false;
  StatementCoverage coverage = std::move(search->coverage);
  *search = {};
  search->coverage = std::move(coverage);
  search->units.clear();
  search->executions = found->traces;
  search->counted = true;
  ends.MoveTo(search);
  return true;
}

}  // namespace

TraceCounts TraceSearch::Counts() const {
  return {.executions = executions,
          .blocked = blocked,
          .redundant = redundant,
          .bad_traces = bad,
          .final_globals = static_cast<int64_t>(globals.size()),
          .final_full = static_cast<int64_t>(full.size()),
          .complete = complete(),
          .counted = counted};
}

void SearchTraces(const Problem& problem, const TraceSearchLimits& limits, TraceSearch* search) {
  Model model = ModelOfTraces(problem);
  model.TrackKey(false);
  model.NoteIn(&search->coverage);
  const bool bad_at_once = static_cast<bool>(FindFault(problem, model));
  FoundEnds ends;
  ProgramWalk walk(problem);
  const auto goes_wrong = [&](TraceEnd* end) {
    if (bad_at_once) return true;
    if (problem.races == RaceRule::kAny) return static_cast<bool>(FindFault(problem, end->State()));
    walk.Restart();
    for (const uint8_t thread : end->Threads()) {
      walk.Step(thread);
      if (walk.fault()) return true;
    }
    return false;
  };
  // Of the unit that is searched: final states by their numbers. Only if they can be judged alone.
  enum class Judgement : uint8_t { kNot, kGood, kBad };
  std::vector<Judgement> judged;
  const auto judge = [&](TraceEnd* end) {
    if (end->State().runnable() != 0) return !problem.may_last || goes_wrong(end);
    ends.Add(problem, end->State());
    return goes_wrong(end);
  };
  const auto is_bad = [&](TraceEnd* end) {
    const uint32_t number =
        problem.races == RaceRule::kAny ? end->StateNumber() : TraceEnd::kNoNumber;
    if (number == TraceEnd::kNoNumber) return judge(end);
    if (number >= judged.size()) judged.resize(size_t{number} + 1);
    if (judged[number] == Judgement::kNot) {
      judged[number] = judge(end) ? Judgement::kBad : Judgement::kGood;
    }
    return judged[number] == Judgement::kBad;
  };
  const int64_t before = search->executions;
  int64_t executions = 0;
  int64_t after_bad = 0;
  const auto visit = [&](TraceEnd* end) {
    ++executions;
    if (limits.progress != nullptr) {
      limits.progress->executions.store(before + executions, std::memory_order_relaxed);
    }
    if (is_bad(end) && search->bad++ < kFailingTried) {
      TakeSimpler(end->Threads(), &search->failing);
    }
    if (search->bad > 0) after_bad += end->Statements();
    return after_bad <= limits.statements_after_bad;
  };
  // A search that has just begun as a whole can be counted as one.
  CountPlan plan;
  plan.active = limits.counts && problem.races == RaceRule::kAny && before == 0 &&
                search->units == std::vector{TraceUnit{}};
  while (!search->units.empty()) {
    const int64_t most = plan.active ? std::min(limits.executions, plan.after) : limits.executions;
    const DporLimits of_unit = {.executions = most - executions,
                                .depth = limits.depth,
                                .count_redundant = true,
                                .stop = limits.stop};
    judged.clear();
    const DporResult result = ExploreUnit(&model, &search->units.front(), of_unit, visit);
    search->executions += result.executions;
    search->blocked += result.blocked;
    search->redundant += result.redundant;
    search->too_deep = search->too_deep || result.too_deep;
    const bool over = IsTold(limits.stop) || executions >= limits.executions ||
                      after_bad > limits.statements_after_bad;
    if (result.complete) search->units.erase(search->units.begin());
    if (over) break;
    if (result.complete) continue;
    if (!plan.active || result.too_deep) break;
    bool bad = search->bad > 0;
    if (!bad && CountAll(problem, limits, plan.pairs, search, &bad)) return;
    plan.GrowUnless(bad);
  }
  ends.MoveTo(search);
}

void MergeInto(TraceSearch* search, const TraceSearch& other) {
  search->units.insert(search->units.end(), other.units.begin(), other.units.end());
  search->executions += other.executions;
  search->blocked += other.blocked;
  search->redundant += other.redundant;
  search->bad += other.bad;
  search->too_deep = search->too_deep || other.too_deep;
  search->globals = UnionOf(search->globals, other.globals);
  search->full = UnionOf(search->full, other.full);
  for (const End& end : other.ends.ends()) search->ends.Add(end);
  TakeSimpler(other.failing, &search->failing);
}

}  // namespace oncard::explore
