#include "explore/engines/state_graph.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <queue>
#include <span>
#include <utility>

#include "explore/models/equal_threads.h"
#include "explore/models/key_set.h"
#include "explore/models/thread_states.h"

namespace oncard::explore {
namespace {

constexpr uint32_t kNone = StateGraph::kNone;

/// Shortest paths by (preemptions, steps) over pairs of a state and the thread that stepped last.
/// For each number of preemptions there are two queues, both ordered by steps: entries added by a
/// preemption, and entries added without one.
class PreemptionSearch {
 public:
  PreemptionSearch(const StateGraph& graph, uint32_t avoid, const std::atomic<bool>* hurried)
      : graph_(graph),
        avoid_(avoid),
        hurried_(hurried),
        width_(static_cast<size_t>(graph.threads) + 1),
        parents_(graph.size() * width_) {}

  /// Runs until a state with one of the flags is settled (true), or all states are (false). False
  /// also when told to end.
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
        if (IsTold(hurried_)) return false;
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
  const std::atomic<bool>* hurried_;
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
  FreeSteps(const StateGraph& graph, int bound, const std::atomic<bool>* hurried)
      : graph_(graph), bound_(bound), hurried_(hurried), followed_(graph.size(), 0) {
    fewest_.assign(graph.size(), static_cast<uint8_t>(bound + 1));
  }

  std::vector<uint8_t> Run() {
    Reach(0, kAll);
    for (; preemptions_ <= bound_ && !open_.empty() && !IsTold(hurried_); ++preemptions_) {
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
    while (!open_.empty() && !IsTold(hurried_)) {
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
  const std::atomic<bool>* hurried_;
  int preemptions_ = 0;
  std::vector<uint32_t> followed_;  ///< bit n: the step of thread n
  std::vector<uint8_t> fewest_;
  std::vector<Open> open_;
  std::vector<uint32_t> reached_;  ///< for the first time, with this number of preemptions
};

/// A step that has not been taken.
struct Ahead {
  StateKey key;       ///< of the state that it leads to
  uint32_t step = 0;  ///< for StepWalk
};

/// The current state of a search of all states: the model executes every step.
class StatementWalk {
 public:
  /// Begins at the model's current state, in which private statements were merged if `merge` is
  /// set.
  StatementWalk(Model* model, bool merge, const EqualThreads& equal)
      : model_(*model), merge_(merge), equal_(equal) {
    if (equal_.empty()) return;
    for (int thread = 0; thread < model_.thread_count(); ++thread) {
      keys_.push_back(KeysOf(thread));
      difference_ = difference_ ^ keys_.back().own;
      sum_ = sum_ + keys_.back().exchangeable;
    }
  }

  /// Of the current state; the same for all that differ in an exchange of equal threads.
  StateKey key() const { return model_.key() ^ difference_ ^ sum_; }
  const Model& State() const { return model_; }
  uint32_t runnable() const { return model_.runnable(); }
  bool failed() const {
    for (int thread = 0; thread < model_.thread_count(); ++thread) {
      if (Fails(model_.End(thread))) return true;
    }
    return false;
  }
  bool LookAhead(int thread, Ahead* ahead) {
    const int64_t statements = Execute(thread);
    if (equal_.GroupOf(thread) == EqualThreads::kNone) {
      ahead->key = key();
    } else {
      const Keys before = keys_[static_cast<size_t>(thread)];
      const Keys after = KeysOf(thread);
      ahead->key = model_.key() ^ difference_ ^ before.own ^ after.own ^
                   (sum_ - before.exchangeable + after.exchangeable);
    }
    Undo(statements);
    return true;
  }
  void Take(int thread, const Ahead& /*ahead*/) {
    Taken taken = {thread, Execute(thread), {}};
    if (!equal_.empty()) {
      taken.before = keys_[static_cast<size_t>(thread)];
      Replace(thread, KeysOf(thread));
    }
    taken_.push_back(taken);
  }
  void Undo() {
    const Taken& taken = taken_.back();
    if (!equal_.empty()) Replace(taken.thread, taken.before);
    Undo(taken.statements);
    taken_.pop_back();
  }

 private:
  /// The part of the key that belongs to a thread with equals, and what stands for it; 0 for
  /// others.
  struct Keys {
    StateKey own;
    StateKey exchangeable;
  };
  struct Taken {
    int thread = 0;
    int64_t statements = 0;
    Keys before;
  };

  Keys KeysOf(int thread) const {
    Keys keys;
    const int group = equal_.GroupOf(thread);
    if (group == EqualThreads::kNone) return keys;
    uint32_t cell = model_.FirstThreadCell(thread);
    for (const int64_t value : model_.ThreadCells(thread)) AddToKey(cell++, value, &keys.own);
    keys.exchangeable = ExchangeableKey(model_.ThreadCells(thread), group);
    return keys;
  }
  void Replace(int thread, const Keys& keys) {
    Keys& now = keys_[static_cast<size_t>(thread)];
    difference_ = difference_ ^ now.own ^ keys.own;
    sum_ = sum_ - now.exchangeable + keys.exchangeable;
    now = keys;
  }
  /// Returns the number of statements.
  int64_t Execute(int thread) {
    model_.Step(thread);
    if (!merge_) return 1;
    const int64_t more = model_.StepPrivate(thread, kMergedMax);
    model_.ForgetDeadLocals(thread);
    return 1 + more;
  }
  void Undo(int64_t statements) {
    for (; statements > 0; --statements) model_.Undo();
  }

  Model& model_;
  bool merge_;
  const EqualThreads& equal_;
  std::vector<Keys> keys_;  ///< of each thread; empty if there are no equal ones
  StateKey difference_;
  StateKey sum_;
  std::vector<Taken> taken_;
};

/// The same by remembered steps (thread_states.h), which is several times as fast, with the same
/// keys.
class StepWalk {
 public:
  /// From the same state as a StatementWalk of the model; its accesses must be local.
  StepWalk(const Model& model, bool merge, const EqualThreads& equal)
      : known_(model, merge ? kMergedMax : ThreadStates::kSingleStatements),
        equal_(equal),
        globals_(known_.globals()),
        cell_keys_(globals_.size()),
        end_(known_.model()) {
    for (uint32_t cell = 0; cell < globals_.size(); ++cell) {
      AddToKey(cell, globals_[cell], &cell_keys_[cell]);
    }
    // What a step writes that writes no global.
    globals_.push_back(0);
    cell_keys_.emplace_back();
  }

  /// `key`: of the model. False if the walk is not possible.
  bool Begin(StateKey key) {
    key_ = key;
    for (int thread = 0; thread < end_.thread_count(); ++thread) {
      const auto begun = known_.Begin(thread);
      if (!begun) return false;
      now_.push_back(begun->next);
      if (known_.Runs(begun->next)) runnable_ |= 1u << thread;
      const int group = equal_.GroupOf(thread);
      if (group == EqualThreads::kNone) continue;
      key_ = key_ ^ known_.KeyOf(begun->next);
      sum_ = sum_ + ExchangeableKey(known_.CellsOf(begun->next), group);
    }
    return true;
  }

  /// Valid until the next call.
  const Model& State() {
    known_.Load(now_, globals_, &end_);
    return end_;
  }
  uint32_t runnable() const { return runnable_; }
  bool failed() const { return failures_ > 0; }
  /// False: the step is not known, and cannot be remembered.
  bool LookAhead(int thread, Ahead* ahead) {
    const uint32_t now = now_[Index(thread)];
    const ThreadStates::Step* known = known_.StepOf(now, globals_);
    if (known == nullptr) return false;
    const uint32_t number = known_.NumberOf(known);
    if (number >= moves_.size()) AddMoves();
    const Move& move = moves_[number];
    *ahead = {key_ ^ thread_keys_[now] ^ cell_keys_[move.cell] ^ move.key, number};
    if (!equal_.empty()) ahead->key = ahead->key ^ (sum_ - thread_sums_[now] + move.sum);
    return true;
  }
  void Take(int thread, const Ahead& ahead) {
    const Move& move = moves_[ahead.step];
    uint32_t& now = now_[Index(thread)];
    int64_t& value = globals_[move.cell];
    StateKey& cell_key = cell_keys_[move.cell];
    path_.push_back({key_, sum_, cell_key, value, move.cell, now, runnable_, thread, move.failed});
    key_ = key_ ^ thread_keys_[now] ^ cell_key ^ move.key;
    if (!equal_.empty()) sum_ = sum_ - thread_sums_[now] + move.sum;
    cell_key = move.cell_key;
    value = move.value;
    now = move.next;
    if (!known_.Runs(move.next)) runnable_ &= ~(1u << thread);
    failures_ += move.failed ? 1 : 0;
  }
  void Undo() {
    const Taken& taken = path_.back();
    key_ = taken.key;
    sum_ = taken.sum;
    cell_keys_[taken.cell] = taken.cell_key;
    globals_[taken.cell] = taken.value;
    now_[Index(taken.thread)] = taken.now;
    runnable_ = taken.runnable;
    failures_ -= taken.failed ? 1 : 0;
    path_.pop_back();
  }
  /// The threads of the steps to the current state.
  std::vector<int> Threads() const {
    std::vector<int> threads;
    for (const Taken& taken : path_) threads.push_back(taken.thread);
    return threads;
  }

 private:
  /// What a known step does.
  struct Move {
    StateKey key;  ///< of what it writes and of the thread's next state
    StateKey sum;  ///< of the thread's next state, if the thread has equals
    StateKey cell_key;
    int64_t value = 0;
    uint32_t cell = 0;
    uint32_t next = 0;
    bool failed = false;  ///< the thread ends with an error
  };
  /// What a step has changed.
  struct Taken {
    StateKey key;
    StateKey sum;
    StateKey cell_key;
    int64_t value;
    uint32_t cell;
    uint32_t now;
    uint32_t runnable;
    int thread;
    bool failed;
  };

  static size_t Index(int thread) { return static_cast<size_t>(thread); }

  void AddMoves() {
    while (moves_.size() < known_.step_count()) {
      const ThreadStates::Step& step = known_.step(static_cast<uint32_t>(moves_.size()));
      while (thread_keys_.size() < known_.state_count()) {
        AddThreadKey(static_cast<uint32_t>(thread_keys_.size()));
      }
      Move move = {.key = {},
                   .sum = thread_sums_[step.next],
                   .cell_key = {},
                   .value = step.value,
                   .cell = static_cast<uint32_t>(globals_.size() - 1),
                   .next = step.next,
                   .failed = known_.Failed(step.next)};
      if (step.cell != AccessSet::kNone) {
        move.cell = step.cell;
        AddToKey(step.cell, step.value, &move.cell_key);
      }
      move.key = move.cell_key ^ thread_keys_[step.next];
      moves_.push_back(move);
    }
  }

  /// A thread with equals has its part of the key among the sums.
  void AddThreadKey(uint32_t state) {
    const int group = equal_.GroupOf(known_.ThreadOf(state));
    const bool has_equals = group != EqualThreads::kNone;
    thread_keys_.push_back(has_equals ? StateKey{} : known_.KeyOf(state));
    thread_sums_.push_back(has_equals ? ExchangeableKey(known_.CellsOf(state), group) : StateKey{});
  }

  ThreadStates known_;
  const EqualThreads& equal_;
  StateKey key_;
  StateKey sum_;
  std::vector<int64_t> globals_;
  std::vector<StateKey> cell_keys_;
  std::vector<uint32_t> now_;  ///< the state of each thread
  uint32_t runnable_ = 0;
  int failures_ = 0;  ///< number of threads that ended with an error
  std::vector<Move> moves_;
  std::vector<StateKey> thread_keys_;  ///< of the known states of threads
  std::vector<StateKey> thread_sums_;
  std::vector<Taken> path_;
  Model end_;
};

/// The search of all states, depth first. As soon as a state is entered, the keys of its successors
/// are computed and their places in the set prefetched: most are looked up much later, and most of
/// them are known, so that no step need be taken there.
class GraphBuilder {
 public:
  GraphBuilder(Model* model, const StateLimits& limits, const StateJudge& judge, Judged judged)
      : model_(*model), limits_(limits), judge_(judge), judged_(judged) {
    graph_.threads = model->thread_count();
    graph_.may_cycle = model->HasLoops();
    if (limits.merge_private && limits.symmetry) equal_ = EqualThreads(*model);
    graph_.symmetric = !equal_.empty();
    looks_for_cycle_ = graph_.symmetric && graph_.may_cycle && limits.ends_at_cycle;
  }

  StateGraph Build() {
    const int64_t start = model_.depth();
    std::optional<StepWalk> steps;
    // A walk by steps has no model in most states.
    if (judged_ == Judged::kEnds && model_.AccessesAreLocal()) {
      steps.emplace(model_, limits_.merge_private, equal_);
    }
    for (int thread = 0; thread < graph_.threads; ++thread) Merge(thread);
    StatementWalk walk(&model_, limits_.merge_private, equal_);
    bool added = false;
    current_ = known_.FindOrAdd(walk.key(), &added);
    if (steps && steps->Begin(model_.key()) && Explore(&*steps)) {
      // Everything was searched by steps.
    } else {
      if (steps) {
        for (const int thread : steps->Threads()) walk.Take(thread, {});
      }
      Explore(&walk);
    }
    while (model_.depth() > start) model_.Undo();
    graph_.complete = !stopped_;
    return std::move(graph_);
  }

 private:
  struct Visit {
    uint32_t state;
    uint32_t untried;  // threads
  };

  void Merge(int thread) {
    if (!limits_.merge_private) return;
    model_.StepPrivate(thread, kMergedMax);
    model_.ForgetDeadLocals(thread);
  }

  /// Searches from the state current_, which is new, and back along the path. False, and the walk
  /// stands in a new state current_, if it is not able to look ahead there.
  template <typename Walk>
  bool Explore(Walk* walk) {
    if (!Enter(walk)) return false;
    while (!path_.empty() && !stopped_) {
      // Many steps in a row may lead to known states.
      if (IsTold(limits_.stop)) {
        stopped_ = true;
        break;
      }
      Visit& visit = path_.back();
      if (visit.untried == 0) {
        if (looks_for_cycle_) on_path_[visit.state] = false;
        path_.pop_back();
        if (!path_.empty()) walk->Undo();
        continue;
      }
      // Takes the next untried step.
      const int thread = std::countr_zero(visit.untried);
      visit.untried &= visit.untried - 1;
      const Ahead ahead = ahead_.back();
      ahead_.pop_back();
      bool added = false;
      current_ = known_.FindOrAdd(ahead.key, &added);
      // What was prefetched before a long way may be gone.
      if (ahead_.size() >= kSoon) known_.Prefetch(ahead_[ahead_.size() - kSoon].key);
      ++graph_.transitions;
      graph_.successors[size_t{visit.state} * static_cast<size_t>(graph_.threads) +
                        static_cast<size_t>(thread)] = current_;
      if (!added) {
        if (looks_for_cycle_ && on_path_[current_]) stopped_ = graph_.found_cycle = true;
        continue;
      }
      walk->Take(thread, ahead);
      if (!Enter(walk)) return false;
    }
    return true;
  }

  /// Enters the new state in which the walk stands. False, without a change: it cannot look ahead.
  template <typename Walk>
  bool Enter(Walk* walk) {
    const uint32_t runnable = walk->runnable();
    if (!LookAhead(runnable, walk)) return false;
    graph_.successors.Append(static_cast<size_t>(graph_.threads), kNone);
    uint32_t flags = runnable == 0 ? kTerminal : 0u;
    if (judged_ == Judged::kEveryState || runnable == 0 || walk->failed()) {
      flags |= judge_(walk->State());
    }
    graph_.flags.Append(1, flags);
    if ((flags & kBad) != 0 && after_bad_ == kNone) {
      after_bad_ = graph_.size();
      graph_.way_to_bad = WayHere();
    }
    const bool enough_good =
        after_bad_ == kNone && limits_.most_while_good != nullptr &&
        graph_.size() >= limits_.most_while_good->load(std::memory_order_relaxed);
    stopped_ = graph_.size() >= limits_.states || enough_good ||
               graph_.size() - std::min(after_bad_, graph_.size()) >= limits_.states_after_bad;
    path_.push_back({current_, runnable});
    if (looks_for_cycle_) on_path_.push_back(true);
    if (limits_.progress != nullptr) {
      limits_.progress->states.store(graph_.size(), std::memory_order_relaxed);
      limits_.progress->frontier.store(static_cast<int64_t>(path_.size()),
                                       std::memory_order_relaxed);
    }
    return true;
  }

  /// The steps to the state current_.
  std::vector<uint8_t> WayHere() const {
    std::vector<uint8_t> way;
    for (size_t i = 0; i < path_.size(); ++i) {
      const uint32_t next = i + 1 < path_.size() ? path_[i + 1].state : current_;
      int thread = 0;
      while (graph_.Next(path_[i].state, thread) != next) ++thread;
      way.push_back(static_cast<uint8_t>(thread));
    }
    return way;
  }

  /// Appends the steps of the threads that can run, that of the lowest thread last.
  template <typename Walk>
  bool LookAhead(uint32_t runnable, Walk* walk) {
    const size_t before = ahead_.size();
    ahead_.resize(before + static_cast<size_t>(std::popcount(runnable)));
    Ahead* ahead = ahead_.data() + ahead_.size();
    for (uint32_t left = runnable; left != 0; left &= left - 1) {
      if (!walk->LookAhead(std::countr_zero(left), --ahead)) {
        ahead_.resize(before);
        return false;
      }
      known_.Prefetch(ahead->key);
    }
    return true;
  }

  static constexpr size_t kSoon = 4;  ///< look-ups

  Model& model_;
  const StateLimits& limits_;
  const StateJudge& judge_;
  Judged judged_;
  StateGraph graph_;
  EqualThreads equal_;
  bool looks_for_cycle_ = false;
  std::vector<bool> on_path_;  ///< for each state, while that matters
  KeySet known_;
  uint32_t current_ = 0;  ///< the state that was looked up last
  std::vector<Visit> path_;
  std::vector<Ahead> ahead_;  ///< the untried steps of the states on the path
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

StateGraph BuildStateGraph(Model* model, const StateLimits& limits, const StateJudge& judge,
                           Judged judged) {
  return GraphBuilder(model, limits, judge, judged).Build();
}

Path FewestPreemptions(const StateGraph& graph, uint32_t flag, uint32_t avoid,
                       const std::atomic<bool>* hurried) {
  if (IsTold(hurried)) return {};
  PreemptionSearch search(graph, avoid, hurried);
  return search.Run(flag) ? search.PathToFound() : Path{};
}

Path FewestSteps(const StateGraph& graph, uint32_t flag, uint32_t starts) {
  std::vector<uint32_t> parent(graph.size(), kNone);
  std::vector<uint8_t> by(graph.size(), 0);
  std::queue<uint32_t> queue;
  for (uint32_t start = 0; start < starts; ++start) queue.push(start);
  while (!queue.empty()) {
    uint32_t state = queue.front();
    queue.pop();
    if ((graph.flags[state] & flag) != 0) {
      Path path;
      path.found = true;
      for (; state >= starts; state = parent[state]) path.steps.push_back(by[state]);
      path.start = state;
      std::reverse(path.steps.begin(), path.steps.end());
      return path;
    }
    for (int thread = 0; thread < graph.threads; ++thread) {
      const uint32_t next = graph.Next(state, thread);
      if (next == kNone || next < starts || parent[next] != kNone) continue;
      parent[next] = state;
      by[next] = static_cast<uint8_t>(thread);
      queue.push(next);
    }
  }
  return {};
}

std::vector<uint8_t> PreemptionsTo(const StateGraph& graph, int bound,
                                   const std::atomic<bool>* hurried) {
  return FreeSteps(graph, bound, hurried).Run();
}

// Tarjan's algorithm without recursion.
std::vector<uint32_t> Components(const StateGraph& graph, uint32_t* count,
                                 const std::atomic<bool>* hurried, uint32_t flag) {
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
  const auto belongs = [&](uint32_t state) {
    return flag == 0 || (graph.flags[state] & flag) != 0;
  };
  uint32_t root = 0;
  while (!IsTold(hurried)) {
    if (path.empty()) {
      while (root < graph.size() && (order[root] != kNone || !belongs(root))) ++root;
      if (root == graph.size()) break;
      enter(root);
    }
    Visit& visit = path.back();
    const uint32_t state = visit.state;
    if (visit.next_thread < graph.threads) {
      const uint32_t next = graph.Next(state, visit.next_thread++);
      if (next == kNone || !belongs(next) || component[next] != kNone) continue;
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

Lasso FindFairCycle(const StateGraph& graph, const std::atomic<bool>* hurried, uint32_t flag) {
  if (!graph.may_cycle) return {};
  uint32_t count = 0;
  const std::vector<uint32_t> component = Components(graph, &count, hurried, flag);
  if (IsTold(hurried)) return {};
  // A finished thread never continues, so the runnable threads are the same in all states of a
  // component.
  std::vector<uint32_t> able(count, 0);
  std::vector<uint32_t> moving(count, 0);
  std::vector<uint32_t> first(count, kNone);
  for (uint32_t state = 0; state < graph.size(); ++state) {
    const uint32_t own = component[state];
    if (own == kNone) continue;
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

StateGraph OweResponses(const StateGraph& graph, uint32_t left, uint32_t right,
                        const std::atomic<bool>* hurried) {
  StateGraph owing;
  owing.threads = graph.threads;
  owing.complete = graph.complete;
  owing.may_cycle = graph.may_cycle;
  // Each state twice: without and with what it owes.
  std::vector<uint32_t> numbers(size_t{graph.size()} * 2, kNone);
  std::vector<size_t> states;
  const auto enter = [&](uint32_t state, bool owes) {
    const uint32_t flags = graph.flags[state];
    owes = (owes || (flags & left) != 0) && (flags & right) == 0;
    const size_t both = size_t{state} * 2 + (owes ? 1 : 0);
    if (numbers[both] != kNone) return numbers[both];
    numbers[both] = owing.size();
    states.push_back(both);
    owing.successors.Append(static_cast<size_t>(graph.threads), kNone);
    const uint32_t bad = owes && (flags & kTerminal) != 0 ? uint32_t{kBad} : 0u;
    owing.flags.Append(1, (flags & kTerminal) | bad | (owes ? kOwing : 0u));
    return numbers[both];
  };
  enter(0, false);
  for (uint32_t number = 0; number < states.size(); ++number) {
    if (IsTold(hurried)) return {};
    const auto state = static_cast<uint32_t>(states[number] / 2);
    for (int thread = 0; thread < graph.threads; ++thread) {
      const uint32_t next = graph.Next(state, thread);
      if (next == kNone) continue;
      const uint32_t entered = enter(next, states[number] % 2 != 0);
      owing.successors[size_t{number} * static_cast<size_t>(graph.threads) +
                       static_cast<size_t>(thread)] = entered;
      ++owing.transitions;
    }
  }
  return owing;
}

bool IsCyclic(const StateGraph& graph, const std::atomic<bool>* hurried) {
  if (!graph.may_cycle) return false;
  uint32_t count = 0;
  Components(graph, &count, hurried);
  if (IsTold(hurried)) return false;
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
