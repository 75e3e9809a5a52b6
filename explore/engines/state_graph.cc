#include "explore/engines/state_graph.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <queue>
#include <utility>

#include "explore/models/key_set.h"

namespace oncard::explore {
namespace {

constexpr uint32_t kNone = StateGraph::kNone;

/// Shortest paths by (preemptions, steps) over pairs of a state and the thread that stepped last.
/// For each number of preemptions there are two queues, both ordered by steps: entries added by a
/// preemption, and entries added without one.
class PreemptionSearch {
 public:
  PreemptionSearch(const StateGraph& graph, uint32_t avoid)
      : graph_(graph),
        avoid_(avoid),
        width_(static_cast<size_t>(graph.threads) + 1),
        parents_(graph.size() * width_) {}

  /// Runs until a state with one of the flags is settled (true), or all states within `bound`
  /// preemptions are (false). `settle` receives every state with its preemptions, some of them more
  /// than once.
  template <typename Settle>
  bool Run(uint32_t flag, int bound, const Settle& settle) {
    std::vector<Entry> preempted;
    if ((graph_.flags[0] & avoid_) == 0) preempted.push_back({});
    for (preemptions_ = 0; !preempted.empty() && preemptions_ <= bound; ++preemptions_) {
      after_preemption_.clear();
      std::queue<Entry> going_on;
      for (size_t i = 0; i < preempted.size() || !going_on.empty();) {
        const bool first = going_on.empty() ||
                           (i < preempted.size() && preempted[i].steps < going_on.front().steps);
        const Entry entry = first ? preempted[i++] : going_on.front();
        if (!first) going_on.pop();
        Parent& parent = parents_[IndexOf(entry.state, entry.last)];
        if (parent.settled) continue;
        parent = {entry.parent, entry.parent_last, true};
        settle(entry.state, preemptions_);
        found_ = entry;
        if ((graph_.flags[entry.state] & flag) != 0) return true;
        Expand(entry, &going_on);
      }
      preempted.swap(after_preemption_);
    }
    return false;
  }

  /// The path to the state that was found.
  Path PathToFound() const {
    Path path;
    path.found = true;
    path.preemptions = preemptions_;
    uint32_t state = found_.state;
    for (uint8_t last = found_.last; last != 0;) {
      path.steps.push_back(static_cast<uint8_t>(last - 1));
      const Parent& parent = parents_[IndexOf(state, last)];
      state = parent.state;
      last = parent.last;
    }
    std::reverse(path.steps.begin(), path.steps.end());
    return path;
  }

 private:
  /// Threads are counted from 1 here; 0 means none.
  struct Entry {
    uint32_t state = 0;
    uint32_t parent = 0;
    int steps = 0;
    uint8_t last = 0;
    uint8_t parent_last = 0;
  };
  struct Parent {
    uint32_t state = 0;
    uint8_t last = 0;
    bool settled = false;
  };

  size_t IndexOf(uint32_t state, uint8_t last) const { return size_t{state} * width_ + last; }

  void Expand(const Entry& entry, std::queue<Entry>* going_on) {
    const bool last_could = entry.last != 0 && graph_.Next(entry.state, entry.last - 1) != kNone;
    for (int thread = 0; thread < graph_.threads; ++thread) {
      const uint32_t next = graph_.Next(entry.state, thread);
      if (next == kNone || (graph_.flags[next] & avoid_) != 0) continue;
      const auto last = static_cast<uint8_t>(thread + 1);
      if (parents_[IndexOf(next, last)].settled) continue;
      const Entry after = {next, entry.state, entry.steps + 1, last, entry.last};
      if (last_could && last != entry.last) {
        after_preemption_.push_back(after);
      } else {
        going_on->push(after);
      }
    }
  }

  const StateGraph& graph_;
  uint32_t avoid_;
  size_t width_;
  std::vector<Parent> parents_;
  int preemptions_ = 0;
  Entry found_;
  std::vector<Entry> after_preemption_;
};

/// The steps of a shortest path between two states inside a set of states.
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

}  // namespace

StateGraph BuildStateGraph(Model* model, const StateLimits& limits, const StateJudge& judge) {
  StateGraph graph;
  graph.threads = model->thread_count();
  KeySet known;
  struct Visit {
    uint32_t state;
    uint32_t untried;    // threads
    int64_t statements;  // of the step that led here
  };
  std::vector<Visit> path;
  bool stopped = false;
  uint32_t after_bad = kNone;  // number of states when the first bad one was found
  const auto enter = [&](bool* added) {
    const uint32_t state = known.FindOrAdd(model->key(), added);
    if (!*added) return state;
    graph.successors.resize(graph.successors.size() + static_cast<size_t>(graph.threads), kNone);
    graph.flags.push_back((model->runnable() == 0 ? kTerminal : 0u) | judge(*model));
    if ((graph.flags.back() & kBad) != 0) after_bad = std::min(after_bad, graph.size());
    stopped = graph.size() >= limits.states ||
              graph.size() - std::min(after_bad, graph.size()) >= limits.states_after_bad ||
              (limits.stop != nullptr && limits.stop->load(std::memory_order_relaxed));
    return state;
  };
  const auto undo = [&](int64_t statements) {
    for (; statements > 0; --statements) model->Undo();
  };
  const int64_t start = model->depth();
  const auto merge = [&](int thread) {
    return limits.merge_private ? model->StepPrivate(thread, kMergedMax) : 0;
  };
  for (int thread = 0; thread < graph.threads; ++thread) merge(thread);
  bool added = false;
  path.push_back({enter(&added), model->runnable(), 0});
  while (!path.empty()) {
    Visit& visit = path.back();
    if (visit.untried == 0 || stopped) {
      undo(visit.statements);
      path.pop_back();
      continue;
    }
    const int thread = std::countr_zero(visit.untried);
    visit.untried &= visit.untried - 1;
    model->Step(thread);
    const int64_t statements = 1 + merge(thread);
    ++graph.transitions;
    const uint32_t next = enter(&added);
    graph.successors[size_t{visit.state} * static_cast<size_t>(graph.threads) +
                     static_cast<size_t>(thread)] = next;
    if (added) {
      path.push_back({next, model->runnable(), statements});
      if (limits.progress != nullptr) {
        limits.progress->states.store(graph.size(), std::memory_order_relaxed);
        limits.progress->frontier.store(static_cast<int64_t>(path.size()),
                                        std::memory_order_relaxed);
      }
    } else {
      undo(statements);
    }
  }
  undo(model->depth() - start);
  graph.complete = !stopped;
  return graph;
}

Path FewestPreemptions(const StateGraph& graph, uint32_t flag, uint32_t avoid) {
  PreemptionSearch search(graph, avoid);
  const bool found = search.Run(flag, std::numeric_limits<int>::max() - 1, [](uint32_t, int) {});
  return found ? search.PathToFound() : Path{};
}

Path FewestSteps(const StateGraph& graph, uint32_t flag) {
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

std::vector<int> PreemptionsTo(const StateGraph& graph, int bound) {
  std::vector<int> fewest(graph.size(), bound + 1);
  PreemptionSearch(graph, 0).Run(0, bound, [&](uint32_t state, int preemptions) {
    fewest[state] = std::min(fewest[state], preemptions);
  });
  return fewest;
}

// Tarjan's algorithm without recursion.
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

Lasso FindFairCycle(const StateGraph& graph) {
  uint32_t count = 0;
  const std::vector<uint32_t> component = Components(graph, &count);
  // A finished thread never continues, so the runnable threads are the same in all states of a
  // component.
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

bool IsCyclic(const StateGraph& graph) {
  uint32_t count = 0;
  Components(graph, &count);
  if (count < graph.size()) return true;
  for (uint32_t state = 0; state < graph.size(); ++state) {
    for (int thread = 0; thread < graph.threads; ++thread) {
      if (graph.Next(state, thread) == state) return true;
    }
  }
  return false;
}

int64_t LastEscape(const StateGraph& graph, const std::vector<uint8_t>& path) {
  // Backwards from the good ends along the reversed edges, to a fixed point.
  std::vector<std::vector<uint32_t>> before(graph.size());
  std::vector<uint8_t> escapes(graph.size(), 0);
  std::vector<uint32_t> open;
  for (uint32_t state = 0; state < graph.size(); ++state) {
    for (int thread = 0; thread < graph.threads; ++thread) {
      const uint32_t next = graph.Next(state, thread);
      if (next != kNone) before[next].push_back(state);
    }
    if ((graph.flags[state] & (kTerminal | kBad)) == kTerminal) {
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
