#include "explore/state_graph.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <queue>
#include <utility>

#include "explore/key_set.h"

namespace oncard::explore {
namespace {

constexpr uint32_t kNone = StateGraph::kNone;

/// Shortest paths by (preemptions, steps) over states and the thread that stepped last.
class PreemptionSearch {
 public:
  explicit PreemptionSearch(const StateGraph& graph)
      : graph_(graph),
        width_(static_cast<size_t>(graph.threads) + 1),
        best_(graph.size() * width_, kUnreached),
        parent_(graph.size() * width_, ~size_t{0}) {}

  /// Runs until a state with one of the flags is settled (its index), or all are (kNone).
  size_t Run(uint8_t flag) {
    Push(0, {0, 0}, ~size_t{0});
    while (!queue_.empty()) {
      const auto [cost, index] = queue_.top();
      queue_.pop();
      if (cost != best_[index]) continue;
      const auto state = static_cast<uint32_t>(index / width_);
      if ((graph_.flags[state] & flag) != 0) return index;
      Expand(index, cost);
    }
    return ~size_t{0};
  }

  Path PathTo(size_t index) const {
    Path path;
    path.found = true;
    path.preemptions = best_[index].first;
    for (; parent_[index] != ~size_t{0}; index = parent_[index]) {
      path.steps.push_back(static_cast<uint8_t>(index % width_ - 1));
    }
    std::reverse(path.steps.begin(), path.steps.end());
    return path;
  }

  std::vector<int> PreemptionsOfStates() const {
    std::vector<int> fewest(graph_.size());
    for (size_t state = 0; state < fewest.size(); ++state) {
      const auto first = best_.begin() + static_cast<std::ptrdiff_t>(state * width_);
      fewest[state] = std::min_element(first, first + static_cast<std::ptrdiff_t>(width_))->first;
    }
    return fewest;
  }

 private:
  using Cost = std::pair<int, int>;
  static constexpr Cost kUnreached = {std::numeric_limits<int>::max(), 0};

  void Push(size_t index, Cost cost, size_t parent) {
    if (cost >= best_[index]) return;
    best_[index] = cost;
    parent_[index] = parent;
    queue_.emplace(cost, index);
  }

  void Expand(size_t index, Cost cost) {
    const auto state = static_cast<uint32_t>(index / width_);
    const int last = static_cast<int>(index % width_) - 1;
    const bool last_could = last >= 0 && graph_.Next(state, last) != kNone;
    for (int thread = 0; thread < graph_.threads; ++thread) {
      const uint32_t next = graph_.Next(state, thread);
      if (next == kNone) continue;
      const int preempts = last_could && thread != last ? 1 : 0;
      Push(size_t{next} * width_ + static_cast<size_t>(thread) + 1,
           {cost.first + preempts, cost.second + 1}, index);
    }
  }

  const StateGraph& graph_;
  size_t width_;
  std::vector<Cost> best_;
  std::vector<size_t> parent_;
  std::priority_queue<std::pair<Cost, size_t>, std::vector<std::pair<Cost, size_t>>, std::greater<>>
      queue_;
};

/// The steps of a shortest path from one state to another inside a set of states.
std::vector<uint8_t> PathBetween(const StateGraph& graph, uint32_t from, uint32_t to,
                                 const std::function<bool(uint32_t)>& inside) {
  std::vector<uint32_t> parent(graph.size(), kNone);
  std::vector<uint8_t> by(graph.size(), 0);
  std::queue<uint32_t> queue;
  queue.push(from);
  const auto collect = [&](uint32_t state, uint8_t thread) {
    std::vector<uint8_t> steps = {thread};
    for (; state != from; state = parent[state]) steps.push_back(by[state]);
    std::reverse(steps.begin(), steps.end());
    return steps;
  };
  while (!queue.empty()) {
    const uint32_t state = queue.front();
    queue.pop();
    for (int thread = 0; thread < graph.threads; ++thread) {
      const uint32_t next = graph.Next(state, thread);
      if (next == kNone || !inside(next)) continue;
      if (next == to) return collect(state, static_cast<uint8_t>(thread));
      if (next == from || parent[next] != kNone) continue;
      parent[next] = state;
      by[next] = static_cast<uint8_t>(thread);
      queue.push(next);
    }
  }
  return {};
}

/// Strongly connected components, numbered; Tarjan's algorithm without recursion.
std::vector<uint32_t> Components(const StateGraph& graph, uint32_t* count) {
  struct Visit {
    uint32_t state;
    int next_thread;
  };
  std::vector<uint32_t> component(graph.size(), kNone);
  std::vector<uint32_t> order(graph.size(), kNone);
  std::vector<uint32_t> low(graph.size(), 0);
  std::vector<uint32_t> open;
  std::vector<Visit> path;
  uint32_t visited = 0;
  *count = 0;
  const auto enter = [&](uint32_t state) {
    order[state] = low[state] = visited++;
    open.push_back(state);
    path.push_back({state, 0});
  };
  enter(0);
  while (!path.empty()) {
    Visit& visit = path.back();
    const uint32_t state = visit.state;
    if (visit.next_thread < graph.threads) {
      const uint32_t next = graph.Next(state, visit.next_thread++);
      if (next == kNone || component[next] != kNone) continue;
      if (order[next] == kNone) {
        enter(next);
      } else {
        low[state] = std::min(low[state], order[next]);
      }
      continue;
    }
    path.pop_back();
    if (!path.empty()) low[path.back().state] = std::min(low[path.back().state], low[state]);
    if (low[state] != order[state]) continue;
    uint32_t member = kNone;
    do {
      member = open.back();
      open.pop_back();
      component[member] = *count;
    } while (member != state);
    ++*count;
  }
  return component;
}

}  // namespace

StateGraph BuildStateGraph(Model* model, const StateLimits& limits, const StateJudge& judge) {
  StateGraph graph;
  graph.threads = model->thread_count();
  KeySet known;
  struct Visit {
    uint32_t state;
    uint32_t untried;  // threads
  };
  std::vector<Visit> path;
  bool stopped = false;
  const auto enter = [&](bool* added) {
    const uint32_t state = known.FindOrAdd(model->key(), added);
    if (!*added) return state;
    graph.successors.resize(graph.successors.size() + static_cast<size_t>(graph.threads), kNone);
    graph.flags.push_back(static_cast<uint8_t>((model->runnable() == 0 ? kTerminal : 0) |
                                               (judge(*model) ? kBad : 0)));
    stopped = graph.size() >= limits.states ||
              (limits.stop != nullptr && limits.stop->load(std::memory_order_relaxed));
    return state;
  };
  bool added = false;
  path.push_back({enter(&added), model->runnable()});
  while (!path.empty()) {
    Visit& visit = path.back();
    if (visit.untried == 0 || stopped) {
      path.pop_back();
      if (!path.empty()) model->Undo();
      continue;
    }
    const int thread = std::countr_zero(visit.untried);
    visit.untried &= visit.untried - 1;
    model->Step(thread);
    ++graph.transitions;
    const uint32_t next = enter(&added);
    graph.successors[size_t{visit.state} * static_cast<size_t>(graph.threads) +
                     static_cast<size_t>(thread)] = next;
    if (added) {
      path.push_back({next, model->runnable()});
    } else {
      model->Undo();
    }
  }
  graph.complete = !stopped;
  return graph;
}

Path FewestPreemptions(const StateGraph& graph, uint8_t flag) {
  PreemptionSearch search(graph);
  const size_t found = search.Run(flag);
  return found == ~size_t{0} ? Path{} : search.PathTo(found);
}

Path FewestSteps(const StateGraph& graph, uint8_t flag) {
  std::vector<uint32_t> parent(graph.size(), kNone);
  std::vector<uint8_t> by(graph.size(), 0);
  std::queue<uint32_t> queue;
  queue.push(0);
  while (!queue.empty()) {
    uint32_t state = queue.front();
    queue.pop();
    if ((graph.flags[state] & flag) != 0) {
      Path path;
      path.found = true;
      for (; state != 0; state = parent[state]) path.steps.push_back(by[state]);
      std::reverse(path.steps.begin(), path.steps.end());
      return path;
    }
    for (int thread = 0; thread < graph.threads; ++thread) {
      const uint32_t next = graph.Next(state, thread);
      if (next == kNone || next == 0 || parent[next] != kNone) continue;
      parent[next] = state;
      by[next] = static_cast<uint8_t>(thread);
      queue.push(next);
    }
  }
  return {};
}

std::vector<int> PreemptionsTo(const StateGraph& graph) {
  PreemptionSearch search(graph);
  search.Run(0);
  return search.PreemptionsOfStates();
}

Lasso FindFairCycle(const StateGraph& graph) {
  uint32_t count = 0;
  const std::vector<uint32_t> component = Components(graph, &count);
  // Threads end for good, so those that can go on are the same in all states of a component.
  std::vector<uint32_t> able(count, 0);
  std::vector<uint32_t> moving(count, 0);
  std::vector<uint32_t> first(count, kNone);
  for (uint32_t state = 0; state < graph.size(); ++state) {
    const uint32_t own = component[state];
    if (first[own] == kNone) first[own] = state;
    for (int thread = 0; thread < graph.threads; ++thread) {
      const uint32_t next = graph.Next(state, thread);
      if (next == kNone) continue;
      able[own] |= 1u << thread;
      if (component[next] == own) moving[own] |= 1u << thread;
    }
  }
  for (uint32_t own = 0; own < count; ++own) {
    if (able[own] == 0 || moving[own] != able[own]) continue;
    const auto inside = [&](uint32_t state) { return component[state] == own; };
    Lasso lasso;
    lasso.found = true;
    const uint32_t start = first[own];
    if (start != 0) lasso.stem = PathBetween(graph, 0, start, [](uint32_t) { return true; });
    uint32_t at = start;
    const auto walk_to = [&](uint32_t state) {
      if (at == state) return;
      const auto steps = PathBetween(graph, at, state, inside);
      lasso.cycle.insert(lasso.cycle.end(), steps.begin(), steps.end());
      at = state;
    };
    for (int thread = 0; thread < graph.threads; ++thread) {
      if ((able[own] >> thread & 1) == 0) continue;
      uint32_t state = start;
      while (!inside(state) || graph.Next(state, thread) == kNone ||
             !inside(graph.Next(state, thread))) {
        ++state;
      }
      walk_to(state);
      lasso.cycle.push_back(static_cast<uint8_t>(thread));
      at = graph.Next(state, thread);
    }
    walk_to(start);
    return lasso;
  }
  return {};
}

int64_t LastEscape(const StateGraph& graph, const std::vector<uint8_t>& path) {
  // Backwards from the good ends, to a fixed point over the reversed edges.
  std::vector<std::vector<uint32_t>> before(graph.size());
  std::vector<uint8_t> escapes(graph.size(), 0);
  std::vector<uint32_t> open;
  for (uint32_t state = 0; state < graph.size(); ++state) {
    for (int thread = 0; thread < graph.threads; ++thread) {
      const uint32_t next = graph.Next(state, thread);
      if (next != kNone) before[next].push_back(state);
    }
    if (graph.flags[state] == kTerminal) {
      escapes[state] = 1;
      open.push_back(state);
    }
  }
  while (!open.empty()) {
    const uint32_t state = open.back();
    open.pop_back();
    for (const uint32_t previous : before[state]) {
      if (escapes[previous] != 0) continue;
      escapes[previous] = 1;
      open.push_back(previous);
    }
  }
  int64_t last = -1;
  uint32_t state = 0;
  for (size_t i = 0;; ++i) {
    if (escapes[state] != 0) last = static_cast<int64_t>(i);
    if (i == path.size()) return last;
    state = graph.Next(state, path[i]);
  }
}

}  // namespace oncard::explore
