#include "explore/search/case_counts.h"

#include <algorithm>
#include <utility>

namespace oncard::explore {
namespace {

/// From the strongest to the weakest, for what all cases are to fulfil.
int WeaknessOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kProved:
      return 0;
    case Verdict::kPassed:
      return 1;
    case Verdict::kIncomplete:
      return 2;
    case Verdict::kFailed:
      break;
  }
  return 3;
}

void Add(const TraceCounts& next, TraceCounts* all) {
  all->executions += next.executions;
  all->blocked += next.blocked;
  all->redundant += next.redundant;
  all->bad_traces += next.bad_traces;
  all->final_globals += next.final_globals;
  all->final_full += next.final_full;
  all->complete = all->complete && next.complete;
  all->counted = all->counted || next.counted;
}

void Add(const StateCounts& next, StateCounts* all) {
  all->states += next.states;
  all->transitions += next.transitions;
  all->bad_states += next.bad_states;
  all->final_globals += next.final_globals;
  all->final_full += next.final_full;
  all->merged = all->merged || next.merged;
  all->in_groups = all->in_groups || next.in_groups;
  all->symmetric = all->symmetric || next.symmetric;
  all->finals_within.resize(std::max(all->finals_within.size(), next.finals_within.size()));
  for (size_t i = 0; i < next.finals_within.size(); ++i) {
    all->finals_within[i] += next.finals_within[i];
  }
  if (all->symmetric) all->finals_within.clear();  // not known of all
  all->complete = all->complete && next.complete;
}

/// The islands are those of the first case that has some.
void Add(const IslandCounts& next, IslandCounts* all) {
  all->states += next.states;
  all->transitions += next.transitions;
}

void Add(const ReducedCounts& next, ReducedCounts* all) {
  all->states += next.states;
  all->transitions += next.transitions;
  all->starts += next.starts;
}

void Add(const BoundedCounts& next, BoundedCounts* all) {
  all->preemptions = std::min(all->preemptions, next.preemptions);
  all->states += next.states;
  all->different_ends += next.different_ends;
  all->bad = all->bad || next.bad;
  all->complete = all->complete && next.complete;
}

void Add(const SampleCounts& next, SampleCounts* all) { MergeInto(all, next); }

/// Counts that an engine may have left out.
template <typename Counts>
void AddSome(const std::optional<Counts>& next, std::optional<Counts>* all) {
  if (!next) return;
  if (*all) {
    Add(*next, &**all);
  } else {
    *all = next;
  }
}

/// Each race once; harmless if it is so in every case.
void AddRaces(const std::vector<FoundRace>& next, std::vector<FoundRace>* all) {
  for (const FoundRace& found : next) {
    const auto known = std::ranges::find(*all, found.race, &FoundRace::race);
    if (known == all->end()) {
      all->push_back(found);
    } else {
      known->benign = known->benign && found.benign;
    }
  }
}

bool IsSamePlace(const runtime::CommandPlace& a, const runtime::CommandPlace& b) {
  return a.function == b.function && a.file == b.file && a.line == b.line && a.call == b.call;
}
bool IsSame(const runtime::RefusedCommand& a, const runtime::RefusedCommand& b) {
  return IsSamePlace(a.place, b.place) && a.call.en == b.call.en;
}
bool IsSame(const runtime::CardFinding& a, const runtime::CardFinding& b) {
  return IsSamePlace(a.place, b.place) && a.text.en == b.text.en;
}

template <typename Found>
void JoinPlaces(std::vector<Found> next, std::vector<Found>* all) {
  for (Found& found : next) {
    const auto known =
        std::ranges::find_if(*all, [&](const Found& other) { return IsSame(other, found); });
    if (known == all->end()) {
      all->push_back(std::move(found));
    } else {
      known->first_us = std::min(known->first_us, found.first_us);
      known->count += found.count;
    }
  }
}

}  // namespace

int64_t ExecutionsUsed(const Exploration& exploration) {
  const auto& traces = exploration.traces;
  return traces && !traces->counted ? traces->executions : 0;
}

int64_t StatesUsed(const Exploration& exploration) {
  int64_t states = 0;
  if (exploration.states) states += exploration.states->states;
  if (exploration.islands) states += exploration.islands->states;
  if (exploration.reduced) states += exploration.reduced->states;
  if (exploration.bounded) states += exploration.bounded->states;
  return states;
}

void AddCase(Exploration next, Exploration* all) {
  AddSome(next.traces, &all->traces);
  AddSome(next.states, &all->states);
  AddSome(next.islands, &all->islands);
  AddSome(next.reduced, &all->reduced);
  AddSome(next.bounded, &all->bounded);
  AddSome(next.samples, &all->samples);
  AddRaces(next.races, &all->races);
  EndSet ends;
  for (std::vector<End>* some : {&all->ends, &next.ends}) {
    for (End& end : *some) ends.Add(std::move(end));
  }
  all->ends = ends.ends();
  all->paired = all->paired || next.paired;
  all->horizon.axes |= next.horizon.axes;
  all->horizon.threads |= next.horizon.threads;
  if (next.horizon.at_ms) all->horizon.at_ms = next.horizon.at_ms;
  if (WeaknessOf(next.verdict) > WeaknessOf(all->verdict)) {
    all->verdict = next.verdict;
    all->why = std::move(next.why);
  }
  all->coverage.Include(next.coverage);
  if (!all->failure) all->failure = std::move(next.failure);
}

void JoinFound(std::vector<runtime::RefusedCommand> next,
               std::vector<runtime::RefusedCommand>* all) {
  JoinPlaces(std::move(next), all);
}
void JoinFound(std::vector<runtime::CardFinding> next, std::vector<runtime::CardFinding>* all) {
  JoinPlaces(std::move(next), all);
}

void UntestedInAll::Add(const std::vector<Message>& untested) {
  Add(UntestedInAll{untested, untested, static_cast<int64_t>(untested.size())});
}

void UntestedInAll::Add(const UntestedInAll& others) {
  if (others.fewest == kNone) return;
  if (fewest == kNone) {
    *this = others;
    return;
  }
  fewest = std::min(fewest, others.fewest);
  std::erase_if(common, [&](const Message& text) {
    return std::ranges::find(others.common, text.en, &Message::en) == others.common.end();
  });
}

}  // namespace oncard::explore
