#include "explore/engines/reachable_ends.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace oncard::explore {
namespace {

/// Numbered sets of sorted ends.
class EndSets {
 public:
  using Set = std::vector<uint32_t>;

  uint32_t NumberOf(const Set& set) {
    const auto [entry, added] = numbers_.try_emplace(set, static_cast<uint32_t>(sets_.size()));
    if (added) sets_.push_back(set);
    return entry->second;
  }
  uint32_t Union(uint32_t a, uint32_t b) {
    if (a == b) return a;
    const auto pair = std::minmax(a, b);
    const auto known = unions_.find(pair);
    if (known != unions_.end()) return known->second;
    Set both;
    std::ranges::set_union(sets_[a], sets_[b], std::back_inserter(both));
    return unions_[pair] = NumberOf(both);
  }

 private:
  std::vector<Set> sets_;
  std::map<Set, uint32_t> numbers_;
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> unions_;
};

}  // namespace

std::vector<uint32_t> ReachableEnds(const StateGraph& graph, const std::vector<uint32_t>& end_of,
                                    const std::atomic<bool>* hurried) {
  uint32_t count = 0;
  const std::vector<uint32_t> component = Components(graph, &count, hurried);
  if (IsTold(hurried)) return {};
  std::vector<std::vector<uint32_t>> members(count);
  for (uint32_t state = 0; state < graph.size(); ++state) {
    members[component[state]].push_back(state);
  }
  EndSets sets;
  const uint32_t none = sets.NumberOf({});
  std::vector<uint32_t> ends(graph.size(), none);
  // A component's successors have smaller numbers.
  for (const std::vector<uint32_t>& states : members) {
    uint32_t all = none;
    for (const uint32_t state : states) {
      if (IsTold(hurried)) return {};
      if ((graph.flags[state] & kTerminal) != 0) {
        all = sets.Union(all, sets.NumberOf({end_of[state]}));
      }
      for (int thread = 0; thread < graph.threads; ++thread) {
        const uint32_t next = graph.Next(state, thread);
        if (next != StateGraph::kNone) all = sets.Union(all, ends[next]);
      }
    }
    for (const uint32_t state : states) ends[state] = all;
  }
  return ends;
}

bool OrderMatters(const StateGraph& graph, const std::vector<uint32_t>& ends, uint32_t state,
                  const Race& race) {
  const auto after = [&](int first, int second) {
    const uint32_t between = graph.Next(state, first);
    const uint32_t last = graph.Next(between, second);
    return last == StateGraph::kNone ? between
                                     : last;  // if the first one faults, the order is not prevented
  };
  const uint32_t one = after(race.first.thread, race.second.thread);
  const uint32_t other = after(race.second.thread, race.first.thread);
  return one != other && ends[one] != ends[other];
}

}  // namespace oncard::explore
