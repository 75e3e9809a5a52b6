#include "explore/engines/trace_search.h"

#include <algorithm>
#include <utility>

#include "explore/engines/found_parts.h"
#include "explore/engines/walk.h"
#include "explore/models/key_set.h"

namespace oncard::explore {
namespace {

std::vector<StateKey> SortedKeys(const KeySet& set) {
  std::vector<StateKey> keys = set.Keys();
  std::ranges::sort(keys);
  return keys;
}

std::vector<uint8_t> StepsOf(const Model& model) {
  std::vector<uint8_t> steps;
  for (int64_t i = 0; i < model.depth(); ++i) {
    steps.push_back(static_cast<uint8_t>(model.StepThread(i)));
  }
  return steps;
}

/// The number of failing executions among which a short one is selected.
constexpr int64_t kFailingTried = 1000;

}  // namespace

TraceCounts TraceSearch::Counts() const {
  return {.executions = executions,
          .blocked = blocked,
          .redundant = redundant,
          .bad_traces = bad,
          .final_globals = static_cast<int64_t>(globals.size()),
          .final_full = static_cast<int64_t>(full.size()),
          .complete = complete()};
}

void SearchTraces(const Problem& problem, const TraceSearchLimits& limits, TraceSearch* search) {
  Model model = problem.model;
  model.TrackKey(false);
  KeySet globals;
  KeySet full;
  ProgramWalk walk(problem);
  const auto goes_wrong = [&](const Model& state) {
    if (problem.races == RaceRule::kAny) return static_cast<bool>(FindFault(problem, state));
    walk.Restart();
    for (int64_t i = 0; i < state.depth() && !walk.fault(); ++i) walk.Step(state.StepThread(i));
    return static_cast<bool>(walk.fault());
  };
  const int64_t before = search->executions;
  int64_t executions = 0;
  int64_t after_bad = 0;
  const auto visit = [&](const Model& state) {
    ++executions;
    if (limits.progress != nullptr) {
      limits.progress->executions.store(before + executions, std::memory_order_relaxed);
    }
    if (full.Insert(state.FinalKey())) {
      globals.Insert(state.GlobalsKey());
      if (problem.requirements.empty()) search->ends.Add(EndOf(state));
    }
    if (goes_wrong(state) && search->bad++ < kFailingTried) {
      TakeSimpler(StepsOf(state), &search->failing);
    }
    if (search->bad > 0) after_bad += state.depth();
    return after_bad <= limits.statements_after_bad;
  };
  while (!search->units.empty()) {
    const DporLimits of_unit = {.executions = limits.executions - executions,
                                .depth = limits.depth,
                                .count_redundant = true,
                                .stop = limits.stop};
    const DporResult result = ExploreUnit(&model, &search->units.front(), of_unit, visit);
    search->executions += result.executions;
    search->blocked += result.blocked;
    search->redundant += result.redundant;
    search->too_deep = search->too_deep || result.too_deep;
    if (!result.complete) break;
    search->units.erase(search->units.begin());
    const bool told = limits.stop != nullptr && limits.stop->load(std::memory_order_relaxed);
    if (told || executions >= limits.executions || after_bad > limits.statements_after_bad) break;
  }
  search->globals = UnionOf(search->globals, SortedKeys(globals));
  search->full = UnionOf(search->full, SortedKeys(full));
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
