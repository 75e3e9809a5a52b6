#include "explore/engines/state_graph.h"

#include <algorithm>
#include <bit>
#include <queue>
#include <span>
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

  /// Runs until a state with one of the flags is settled (true), or all states are (false).
  bool Run(uint32_t flag) {
    std::vector<Entry> preempted;
    if ((graph_.flags[0] & avoid_) == 0) preempted.push_back({});
    for (preemptions_ = 0; !preempted.empty(); ++preemptions_) {
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

/// The fewest preemptions to every state: for each number of preemptions, follows the steps that
/// are free, which need no further one. Every step is followed once.
class FreeSteps {
 public:
  FreeSteps(const StateGraph& graph, int bound)
      : graph_(graph), bound_(bound), followed_(graph.size(), 0) {
    fewest_.assign(graph.size(), static_cast<uint8_t>(bound + 1));
  }

  std::vector<uint8_t> Run() {
    Reach(0, kAll);
    for (; preemptions_ <= bound_ && !open_.empty(); ++preemptions_) {
      Follow();
      // From the states that were reached now, every step is one of the next round.
      open_.clear();
      for (const uint32_t state : std::exchange(reached_, {})) open_.push_back({state, kAll});
    }
    return std::move(fewest_);
  }

 private:
  static constexpr uint32_t kAll = ~uint32_t{0};

  void Follow() {
    while (!open_.empty()) {
      const auto [state, threads] = open_.back();
      open_.pop_back();
      const uint32_t free = threads & ~followed_[state];
      followed_[state] |= threads;
      for (int thread = 0; thread < graph_.threads; ++thread) {
        if ((free >> thread & 1) == 0) continue;
        const uint32_t next = graph_.Next(state, thread);
        if (next == kNone) continue;
        Reach(next, graph_.Next(next, thread) == kNone ? kAll : 1u << thread);
      }
    }
  }
  /// `free`: the threads that can step then without another preemption.
  void Reach(uint32_t state, uint32_t free) {
    if (fewest_[state] > preemptions_) {
      fewest_[state] = static_cast<uint8_t>(preemptions_);
      reached_.push_back(state);
    }
    if ((free & ~followed_[state]) != 0) open_.push_back({state, free});
  }

  struct Open {
    uint32_t state;
    uint32_t threads;
  };

  const StateGraph& graph_;
  int bound_;
  int preemptions_ = 0;
  std::vector<uint32_t> followed_;  ///< bit n: the step of thread n
  std::vector<uint8_t> fewest_;
  std::vector<Open> open_;
  std::vector<uint32_t> reached_;  ///< for the first time, with this number of preemptions
};

/// The search of all states, depth first. As soon as a state is entered, the keys of its successors
/// are computed and their places in the set prefetched: most are looked up much later, and most of
/// them are known, so that the model need not step there.
class GraphBuilder {
 public:
  GraphBuilder(Model* model, const StateLimits& limits, const StateJudge& judge)
      : model_(*model), limits_(limits), judge_(judge) {
    graph_.threads = model->thread_count();
    graph_.may_cycle = model->HasLoops();
  }

  StateGraph Build() {
    const int64_t start = model_.depth();
    for (int thread = 0; thread < graph_.threads; ++thread) Merge(thread);
    bool added = false;
    const uint32_t first = known_.FindOrAdd(model_.key(), &added);
    Enter(first, 0);
    while (!path_.empty() && !stopped_) {
      if (path_.back().untried == 0) {
        Undo(path_.back().statements);
        path_.pop_back();
      } else {
        TakeNext();
      }
    }
    Undo(model_.depth() - start);
    graph_.complete = !stopped_;
    return std::move(graph_);
  }

 private:
  struct Visit {
    uint32_t state;
    uint32_t untried;    // threads
    int64_t statements;  // of the step that led here
  };

  int64_t Merge(int thread) {
    return limits_.merge_private ? model_.StepPrivate(thread, kMergedMax) : 0;
  }
  /// Returns the number of statements.
  int64_t Take(int thread) {
    model_.Step(thread);
    return 1 + Merge(thread);
  }
  void Undo(int64_t statements) {
    for (; statements > 0; --statements) model_.Undo();
  }

  /// Takes the next untried step of the last state on the path.
  void TakeNext() {
    Visit& visit = path_.back();
    const int thread = std::countr_zero(visit.untried);
    visit.untried &= visit.untried - 1;
    bool added = false;
    const uint32_t next = known_.FindOrAdd(ahead_.back(), &added);
    ahead_.pop_back();
    // What was prefetched before a long way may be gone.
    if (ahead_.size() >= kSoon) known_.Prefetch(ahead_[ahead_.size() - kSoon]);
    ++graph_.transitions;
    graph_.successors[size_t{visit.state} * static_cast<size_t>(graph_.threads) +
                      static_cast<size_t>(thread)] = next;
    if (added) Enter(next, Take(thread));
  }

  /// A new state, which is the model's.
  void Enter(uint32_t state, int64_t statements) {
    LookAhead();
    graph_.successors.resize(graph_.successors.size() + static_cast<size_t>(graph_.threads), kNone);
    graph_.flags.push_back((model_.runnable() == 0 ? kTerminal : 0u) | judge_(model_));
    if ((graph_.flags.back() & kBad) != 0) after_bad_ = std::min(after_bad_, graph_.size());
    stopped_ = graph_.size() >= limits_.states ||
               graph_.size() - std::min(after_bad_, graph_.size()) >= limits_.states_after_bad ||
               (limits_.stop != nullptr && limits_.stop->load(std::memory_order_relaxed));
    path_.push_back({state, model_.runnable(), statements});
    if (limits_.progress != nullptr) {
      limits_.progress->states.store(graph_.size(), std::memory_order_relaxed);
      limits_.progress->frontier.store(static_cast<int64_t>(path_.size()),
                                       std::memory_order_relaxed);
    }
  }

  /// Appends the keys of the successors, that of the lowest thread last.
  void LookAhead() {
    const uint32_t runnable = model_.runnable();
    ahead_.resize(ahead_.size() + static_cast<size_t>(std::popcount(runnable)));
    StateKey* key = ahead_.data() + ahead_.size();
    for (uint32_t untried = runnable; untried != 0; untried &= untried - 1) {
      const int64_t statements = Take(std::countr_zero(untried));
      *--key = model_.key();
      known_.Prefetch(*key);
      Undo(statements);
    }
  }

  static constexpr size_t kSoon = 4;  ///< look-ups

  Model& model_;
  const StateLimits& limits_;
  const StateJudge& judge_;
  StateGraph graph_;
  KeySet known_;
  std::vector<Visit> path_;
  std::vector<StateKey> ahead_;  ///< of the untried steps of the states on the path
  bool stopped_ = false;
  uint32_t after_bad_ = kNone;  ///< number of states when the first bad one was found
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

/// For every state, the states with a step to it.
class ReversedEdges {
 public:
  explicit ReversedEdges(const StateGraph& graph) : ends_(size_t{graph.size()} + 1, 0) {
    for (const uint32_t next : graph.successors) {
      if (next != kNone) ++ends_[next];
    }
    for (size_t state = 1; state < ends_.size(); ++state) ends_[state] += ends_[state - 1];
    from_.resize(ends_.back());
    // Filled from the ends to the beginnings.
    for (size_t edge = 0; edge < graph.successors.size(); ++edge) {
      const uint32_t next = graph.successors[edge];
      if (next == kNone) continue;
      from_[--ends_[next]] = static_cast<uint32_t>(edge / static_cast<size_t>(graph.threads));
    }
  }

  std::span<const uint32_t> Of(uint32_t state) const {
    return {from_.data() + ends_[state], from_.data() + ends_[state + 1]};
  }

 private:
  std::vector<size_t> ends_;  ///< where the states of each begin; one more at the end
  std::vector<uint32_t> from_;
};

}  // namespace

StateGraph BuildStateGraph(Model* model, const StateLimits& limits, const StateJudge& judge) {
  return GraphBuilder(model, limits, judge).Build();
}

Path FewestPreemptions(const StateGraph& graph, uint32_t flag, uint32_t avoid) {
  PreemptionSearch search(graph, avoid);
  return search.Run(flag) ? search.PathToFound() : Path{};
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

std::vector<uint8_t> PreemptionsTo(const StateGraph& graph, int bound) {
  return FreeSteps(graph, bound).Run();
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
  if (!graph.may_cycle) return {};
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
  if (!graph.may_cycle) return false;
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
  const ReversedEdges before(graph);
  std::vector<uint8_t> escapes(graph.size(), 0);
  std::vector<uint32_t> open;
  for (uint32_t state = 0; state < graph.size(); ++state) {
    if ((graph.flags[state] & (kTerminal | kBad)) == kTerminal) {
      escapes[state] = 1;
      open.push_back(state);
    }
  }
  while (!open.empty()) {
    const uint32_t state = open.back();
    open.pop_back();
    for (const uint32_t previous : before.Of(state)) {
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
