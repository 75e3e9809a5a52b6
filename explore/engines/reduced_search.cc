#include "explore/engines/reduced_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <utility>

#include "explore/models/card_ends.h"
#include "explore/models/card_steps.h"
#include "explore/models/cycle_accesses.h"
#include "explore/models/dead_locals.h"
#include "explore/models/key_set.h"

namespace oncard::explore {
namespace {

/// Before the search two runs show what the program accesses; they end after so many statements.
constexpr int kWatchedStatements = 20'000;

using Row = CardRows::Row;

/// What is left out.
struct Reductions {
  CycleAccesses accesses;
  DeadLocals locals;

  void Begin() {
    accesses.Begin();
    locals.Begin();
  }
  /// What was taken for known when it began is wrong.
  bool grown() const { return accesses.grown() || locals.grown(); }
  /// Looks at the next statement of a thread, and returns the number of what it accesses.
  uint32_t LookAt(const Row& row, size_t place) {
    locals.LookAt(row, place);
    return accesses.LookAt(row, place);
  }
};

/// The states within a cycle that are reached from its starts.
class WithinCycle {
 public:
  static constexpr uint32_t kNone = ~uint32_t{0};

  WithinCycle(CardSteps* rows, Reductions* reductions, const StateLimits& limits,
              ReducedCounts* counts)
      : rows_(*rows),
        reductions_(*reductions),
        accesses_(reductions->accesses),
        limits_(limits),
        counts_(*counts) {}

  /// Another cycle begins. What this needs of memory is kept for it, except for large tables.
  void Begin() {
    known_ = KeySet();
    states_.clear();
    waiting_.clear();
  }

  /// Searches from a start with a number. For each state behind the cycle `leave(row, from,
  /// thread)` is called, with the number of the state in which the thread executed the last
  /// statement; it returns false to end the search. False: it has been ended, or a limit was
  /// reached.
  template <typename Leave>
  bool SearchFrom(uint32_t start, const Row& row, const Leave& leave) {
    Reach(row, 0, {kNone, start, kFreezes});
    AddReached();
    while (!waiting_.empty()) {
      if (IsOver()) return false;
      const Waiting state = waiting_.back();
      waiting_.pop_back();
      if (!Expand(state, leave)) return false;
    }
    return true;
  }

  uint32_t StartOf(uint32_t number) const { return states_[number].start; }
  /// The threads that execute the statements from its start to a state.
  std::vector<uint8_t> WayTo(uint32_t number) const {
    std::vector<uint8_t> threads;
    for (; number != kNone; number = states_[number].before) {
      if (states_[number].thread != kFreezes) threads.push_back(states_[number].thread);
    }
    std::ranges::reverse(threads);
    return threads;
  }

  /// Where a cycle does not end because it is used up, all states are the same that differ only in
  /// what is left of it.
  void ForgetBudget(Row* row) const {
    const CardRows::Progress& progress = rows_.ProgressOf(*row);
    const int64_t most = MostOf(*row, 0);
    if (progress.ended || progress.left < most) return;
    CardRows::Progress enough = progress;
    enough.left = most;
    enough.served = ~uint32_t{0};
    rows_.SetProgress(std::move(enough), row);
  }

 private:
  static constexpr uint8_t kFreezes = 0xff;

  struct State {
    uint32_t before = kNone;  ///< kNone: it is a start
    uint32_t start = 0;
    uint8_t thread = kFreezes;  ///< that has executed a statement since then
  };
  struct Waiting {
    uint32_t number = 0;
    uint32_t frozen = 0;  ///< bit n: the thread with the place n
    Row row;
  };
  struct Reached {
    StateKey key;
    State state;
    Waiting waiting;
  };
  /// A statement that nobody notices.
  struct Unnoticed {
    int thread = -1;
    bool may_freeze = false;  ///< or it may be executed in a later cycle
  };

  bool IsOver() const {
    if (limits_.progress != nullptr) {
      limits_.progress->states.store(counts_.states, std::memory_order_relaxed);
    }
    return counts_.states > limits_.states || IsTold(limits_.stop);
  }

  /// Notes a state that will be added. The table of keys is larger than the processor's cache, so
  /// that it is told early which place will be asked for.
  void Reach(const Row& row, uint32_t frozen, const State& state) {
    const StateKey key = rows_.KeyOf(row, frozen);
    known_.Prefetch(key);
    reached_.push_back({key, state, {0, frozen, row}});
  }
  /// Adds those of the noted states that are new.
  void AddReached() {
    for (Reached& reached : reached_) {
      if (!known_.Insert(reached.key)) continue;
      ++counts_.states;
      reached.waiting.number = static_cast<uint32_t>(states_.size());
      waiting_.push_back(reached.waiting);
      states_.push_back(reached.state);
    }
    reached_.clear();
  }

  template <typename Leave>
  bool Expand(const Waiting& state, const Leave& leave) {
    const bool goes_on = ReachNext(state, leave);
    AddReached();
    return goes_on;
  }

  template <typename Leave>
  bool ReachNext(const Waiting& state, const Leave& leave) {
    const uint32_t choices = ChoicesOf(state);
    for (uint32_t each = choices; each != 0; each &= each - 1) {
      const size_t place = rows_.PlaceOf(std::countr_zero(each));
      next_accesses_[place] = reductions_.LookAt(state.row, place);
    }
    const Unnoticed unnoticed = UnnoticedOf(state, choices);
    if (unnoticed.thread < 0) {
      for (uint32_t each = choices; each != 0; each &= each - 1) {
        if (!Step(state, std::countr_zero(each), leave)) return false;
      }
      return true;
    }
    if (unnoticed.may_freeze) {
      const uint32_t frozen = state.frozen | 1u << rows_.PlaceOf(unnoticed.thread);
      Reach(state.row, frozen, {state.number, StartOf(state.number), kFreezes});
    }
    return Step(state, unnoticed.thread, leave);
  }

  /// The threads that may execute the next statement; none if those that are not frozen cannot use
  /// up the cycle.
  uint32_t ChoicesOf(const Waiting& state) const {
    uint32_t choices = rows_.ChoicesOf(state.row);
    if (state.frozen == 0) return choices;
    if (MostOf(state.row, state.frozen) < rows_.ProgressOf(state.row).left) return 0;
    for (uint32_t each = choices; each != 0; each &= each - 1) {
      const int thread = std::countr_zero(each);
      if ((state.frozen >> rows_.PlaceOf(thread) & 1) != 0) choices &= ~(1u << thread);
    }
    return choices;
  }

  /// One that must be executed in this cycle if there is any: it leads to one state only.
  Unnoticed UnnoticedOf(const Waiting& state, uint32_t choices) {
    Unnoticed found;
    for (; choices != 0; choices &= choices - 1) {
      const int thread = std::countr_zero(choices);
      const size_t place = rows_.PlaceOf(thread);
      if (!accesses_.NobodyNotices(state.row, place, next_accesses_[place], state.frozen)) continue;
      if (!MayFreeze(state, place)) return {thread, false};
      if (found.thread < 0) found = {thread, true};
    }
    return found;
  }

  bool MayFreeze(const Waiting& state, size_t place) const {
    const CardRows::Progress& progress = rows_.ProgressOf(state.row);
    const bool served = (progress.served >> rows_.NumberOnCard(place) & 1) != 0;
    return served && MostOf(state.row, state.frozen | 1u << place) >= progress.left;
  }

  /// The most statements that threads which are not frozen can execute in the cycle.
  int64_t MostOf(const Row& row, uint32_t frozen) const {
    int64_t most = 0;
    for (size_t place = 0; place < rows_.thread_count(); ++place) {
      if ((frozen >> place & 1) != 0) continue;
      const int64_t of_thread = accesses_.MostOf(row, place);
      if (of_thread == CycleCode::kUnlimited) return of_thread;
      most += of_thread;
    }
    return most;
  }

  template <typename Leave>
  bool Step(const Waiting& state, int thread, const Leave& leave) {
    Row next = rows_.Step(state.row, thread);
    ++counts_.transitions;
    reductions_.locals.Forget(rows_.PlaceOf(thread), &next);
    if (rows_.Ended(next) || rows_.CycleOf(next) != rows_.CycleOf(state.row)) {
      AddReached();
      return leave(next, state.number, thread);
    }
    if (state.frozen == 0) ForgetBudget(&next);
    Reach(next, state.frozen, {state.number, StartOf(state.number), static_cast<uint8_t>(thread)});
    return true;
  }

  CardSteps& rows_;
  Reductions& reductions_;
  CycleAccesses& accesses_;
  const StateLimits& limits_;
  ReducedCounts& counts_;
  KeySet known_;
  std::vector<State> states_;  ///< by the numbers of their keys
  std::vector<Waiting> waiting_;
  std::vector<Reached> reached_;
  /// Of the threads that may execute the next statement, by their places.
  std::array<uint32_t, vm::kThreadCount> next_accesses_{};
};

class LayeredSearch {
  static constexpr uint32_t kNone = WithinCycle::kNone;

 public:
  LayeredSearch(CardModel* model, const StateLimits& limits)
      : model_(*model),
        rows_(model, StepsFor(limits)),
        reductions_{{*model, &rows_}, {*model, &rows_}},
        limits_(limits) {}

  std::optional<ReducedSearch> Run() {
    rows_.ForgetRuns();
    Watch([](uint32_t choices, uint32_t /*last*/) { return std::countr_zero(choices); });
    Watch([](uint32_t choices, uint32_t last) {
      const uint32_t later = choices & ~((uint32_t{2} << last) - 1);
      return std::countr_zero(later != 0 ? later : choices);
    });
    for (bool known = false; !known && rows_.exact();) {
      reductions_.Begin();
      known = SearchAll();
    }
    if (!rows_.exact()) {
      if (limits_.known_steps != nullptr) *limits_.known_steps = {};
      return std::nullopt;
    }
    result_.final_globals = ends_.by_globals();
    result_.final_full = ends_.all();
    result_.ends = ends_.shown();
    return std::move(result_);
  }

 private:
  /// Those that are known; of too many none.
  static std::shared_ptr<KnownSteps> StepsFor(const StateLimits& limits) {
    if (limits.known_steps == nullptr) return std::make_shared<KnownSteps>();
    if (limits.known_steps->rows.bodies.size() > KnownSteps::kBodiesMax) *limits.known_steps = {};
    return limits.known_steps;
  }

  /// A state at the start of a cycle.
  struct Start {
    uint32_t before = kNone;  ///< the start from which it was reached
    StateKey key;
  };
  /// The starts of a cycle that have been reached, with their numbers.
  struct Layer {
    KeySet known;
    std::vector<std::pair<uint32_t, Row>> starts;
  };

  /// A run that shows what statements access.
  template <typename Next>
  void Watch(const Next& next) {
    Row row = rows_.Start();
    uint32_t last = 0;
    for (int i = 0; i < kWatchedStatements; ++i) {
      const uint32_t choices = rows_.ChoicesOf(row);
      if (choices == 0) return;
      for (uint32_t each = choices; each != 0; each &= each - 1) {
        reductions_.LookAt(row, rows_.PlaceOf(std::countr_zero(each)));
      }
      last = static_cast<uint32_t>(next(choices, last));
      row = rows_.Step(row, static_cast<int>(last));
    }
  }

  /// False: more is accessed than was known, so that the search must begin again.
  bool SearchAll() {
    result_ = {};
    starts_.clear();
    layers_.clear();
    ends_ = CardEnds();
    Row first = rows_.Start();
    cycle_.ForgetBudget(&first);
    if (first.fault) result_.fails = true;
    if (!first.fault) Enter(first, kNone);
    while (!layers_.empty() && !result_.fails) {
      const Layer layer = std::move(layers_.extract(layers_.begin()).mapped());
      const Row* open = SearchLayer(layer);
      if (open != nullptr) {
        result_.open = rows_.Whole(*open);
        return true;
      }
      if (result_.fails) break;
      if (reductions_.grown() || !rows_.exact()) return false;
    }
    result_.complete = !result_.fails;
    return true;
  }

  /// Searches a cycle. Returns a start of which not everything was searched; nullptr: there is
  /// none, or a run fails.
  const Row* SearchLayer(const Layer& layer) {
    cycle_.Begin();
    for (const auto& [number, row] : layer.starts) {
      const auto leave = [&](Row next, uint32_t from, int thread) {
        const uint32_t start = cycle_.StartOf(from);
        if (next.fault) {
          result_.fails = true;
          result_.failing = WayTo(start);
          std::vector<uint8_t> rest = cycle_.WayTo(from);
          result_.failing.insert(result_.failing.end(), rest.begin(), rest.end());
          result_.failing.push_back(static_cast<uint8_t>(thread));
          return false;
        }
        cycle_.ForgetBudget(&next);
        Enter(next, start);
        return true;
      };
      if (!cycle_.SearchFrom(number, row, leave)) return result_.fails ? nullptr : &row;
    }
    return nullptr;
  }

  /// A good state at the start of a cycle, or at the end of a run.
  void Enter(const Row& row, uint32_t before) {
    if (row.finished) ends_.Add(model_, rows_.Program(row));
    if (rows_.Ended(row)) return;
    Layer& layer = layers_[rows_.CycleOf(row)];
    const StateKey key = rows_.KeyOf(row);
    if (!layer.known.Insert(key)) return;
    ++result_.counts.starts;
    layer.starts.emplace_back(static_cast<uint32_t>(starts_.size()), row);
    starts_.push_back({before, key});
  }

  /// The threads of a run up to a start: every cycle is searched again.
  std::vector<uint8_t> WayTo(uint32_t start) {
    std::vector<uint32_t> way;
    for (; start != kNone; start = starts_[start].before) way.push_back(start);
    std::vector<uint8_t> threads;
    Row row = rows_.Start();
    StateLimits unlimited = limits_;
    unlimited.states = ~uint32_t{0};
    unlimited.stop = nullptr;
    for (size_t i = way.size() - 1; i-- > 0;) {
      ReducedCounts counts;
      WithinCycle cycle(&rows_, &reductions_, unlimited, &counts);
      cycle.ForgetBudget(&row);
      Row reached;
      const auto leave = [&](Row next, uint32_t from, int thread) {
        cycle.ForgetBudget(&next);
        if (next.fault || rows_.KeyOf(next) != starts_[way[i]].key) return true;
        const std::vector<uint8_t> steps = cycle.WayTo(from);
        threads.insert(threads.end(), steps.begin(), steps.end());
        threads.push_back(static_cast<uint8_t>(thread));
        reached = next;
        return false;
      };
      cycle.SearchFrom(0, row, leave);
      row = reached;
    }
    return threads;
  }

  CardModel& model_;
  CardSteps rows_;
  Reductions reductions_;
  const StateLimits& limits_;
  ReducedSearch result_;
  WithinCycle cycle_{&rows_, &reductions_, limits_, &result_.counts};
  std::vector<Start> starts_;
  std::map<int64_t, Layer> layers_;  ///< by their cycles
  CardEnds ends_;
};

}  // namespace

std::optional<ReducedSearch> SearchReduced(CardModel* model, const StateLimits& limits) {
  if (!CardRows::Possible(*model) || limits.whole_states) return std::nullopt;
  if (!CycleAccesses::Possible(*model)) return std::nullopt;
  return LayeredSearch(model, limits).Run();
}

}  // namespace oncard::explore
