#include "explore/engines/trace_count.h"

#include <algorithm>
#include <bit>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "explore/engines/progress.h"
#include "explore/models/number_table.h"
#include "explore/models/step_model.h"
#include "explore/models/thread_future.h"

namespace oncard::explore {
namespace {

/// What is known about the states of threads.
class KnownStates {
 public:
  KnownStates(const Model& model, bool tells_locals) : tells_locals_(tells_locals) {
    for (int thread = 0; thread < model.thread_count(); ++thread) {
      futures_.emplace_back(model, thread);
    }
  }

  /// To be called with every state of a thread that is met.
  void Meet(int thread, StepModel* program) {
    const uint32_t state = program->ThreadState(thread);
    if (state < names_.size() && names_[state] != StepModel::kNone) return;
    if (state >= names_.size()) {
      names_.resize(size_t{state} + 1, StepModel::kNone);
      accesses_.resize(size_t{state} + 1);
    }
    const Model& model = program->AsModel();
    const ThreadFuture& future = futures_[static_cast<size_t>(thread)];
    const int position = model.Position(thread);
    const auto name = static_cast<uint32_t>(numbers_.size());
    names_[state] = numbers_.try_emplace(KeyOf(model, thread, future), name).first->second;
    if (!model.Running(thread)) return;
    accesses_[state] = {BitsOf(model.NextAccess(thread)), future.Accesses(position)};
  }

  /// For each state a number: with equal ones, threads do the same from here on and their ends are
  /// the same, apart from locals unless those are to be told apart.
  const std::vector<uint32_t>& names() const { return names_; }
  /// What the next step of a thread in a state accesses, and what it may access from there on.
  const AccessBits& Next(uint32_t state) const { return accesses_[state].first; }
  const AccessBits& Future(uint32_t state) const { return accesses_[state].second; }

 private:
  std::vector<int64_t> KeyOf(const Model& model, int thread, const ThreadFuture& future) const {
    const std::span<const int64_t> cells = model.ThreadCells(thread);
    std::vector<int64_t> key = {thread, static_cast<int64_t>(model.End(thread))};
    if (tells_locals_) {
      key.insert(key.end(), cells.begin(), cells.end());
    } else if (model.Running(thread)) {
      key.push_back(model.Position(thread));
      for (const uint32_t slot : future.Locals(model.Position(thread))) key.push_back(cells[slot]);
    } else {
      key.push_back(model.ReturnValue(thread));
    }
    return key;
  }

  bool tells_locals_;
  std::vector<ThreadFuture> futures_;
  std::map<std::vector<int64_t>, uint32_t> numbers_;
  std::vector<uint32_t> names_;
  std::vector<std::pair<AccessBits, AccessBits>> accesses_;
};

/// What is known about a state and the threads that sleep in it.
struct CountedPair {
  static constexpr int64_t kOpen = -1;

  int64_t traces = kOpen;  ///< kOpen: being counted
  int64_t statements = 0;  ///< of the longest execution from here
};

/// A pair that is being counted.
struct CountedFrame {
  uint32_t pair = 0;
  uint32_t awake = 0;  ///< threads whose next step is still to be tried here
  uint32_t sleep = 0;  ///< threads that sleep, or whose next step was tried here
  int64_t before = 0;  ///< number of statements before the last step tried
  CountedPair found = {.traces = 0};
};

class TraceCounter {
 public:
  TraceCounter(const Model& model, const TraceCountLimits& limits, const CountVisitor& visit)
      : program_(model, limits.depth),
        known_(model, limits.tells_locals),
        limits_(limits),
        visit_(visit) {}

  std::optional<TraceCount> Run() {
    if (!program_.Begin()) return std::nullopt;
    for (int thread = 0; thread < program_.thread_count(); ++thread) known_.Meet(thread, &program_);
    if (!Enter(0)) return std::nullopt;
    while (!path_.empty()) {
      if (!(path_.back().awake != 0 ? Try() : Leave())) return std::nullopt;
    }
    return TraceCount{.traces = pairs_.front().traces, .pairs = pairs_.size()};
  }

 private:
  // Each of these functions returns false if there is no count.

  /// Arrives in a state: looks the pair up, or begins to count it.
  bool Enter(uint32_t sleep) {
    if (sleep != 0 && !CanWake(sleep)) return Add({.traces = 0});
    const uint32_t state = program_.StateNumber(known_.names());
    if (state == StepModel::kNone) return false;
    const uint32_t known = numbers_.Find(state, sleep);
    if (known != NumberTable::kNone) return Add(pairs_[known]);
    if (IsTold(limits_.stop) || pairs_.size() >= limits_.pairs) return false;
    const auto pair = static_cast<uint32_t>(pairs_.size());
    numbers_.Add(state, sleep, pair);
    const uint32_t awake = program_.runnable() & ~sleep;
    if (awake != 0) {
      pairs_.emplace_back();
      path_.push_back({.pair = pair, .awake = awake, .sleep = sleep});
      return true;
    }
    pairs_.push_back({.traces = 1});
    return visit_(program_.AsModel()) && Add(pairs_.back());
  }

  /// Whether all threads that sleep can wake. If one cannot, what follows is counted elsewhere,
  /// with its next step before it.
  bool CanWake(uint32_t sleep) const {
    AccessBits accesses;  // of threads that can take a step
    uint32_t left = sleep;
    for (uint32_t added = program_.runnable() & ~sleep; added != 0;) {
      for (; added != 0; added &= added - 1) accesses.Add(known_.Future(StateOf(added)));
      for (uint32_t asleep = left; asleep != 0; asleep &= asleep - 1) {
        if (accesses.MayDependOn(known_.Next(StateOf(asleep)))) added |= asleep & (~asleep + 1);
      }
      left &= ~added;
    }
    return left == 0;
  }
  /// The state of the first one of threads.
  uint32_t StateOf(uint32_t threads) const {
    return program_.ThreadState(std::countr_zero(threads));
  }

  /// Executes the next step that is to be tried.
  bool Try() {
    CountedFrame& frame = path_.back();
    const int thread = std::countr_zero(frame.awake);
    const uint64_t dependent = program_.Dependent(program_.NextAccess(thread));
    uint32_t sleep = 0;
    for (uint32_t left = frame.sleep; left != 0; left &= left - 1) {
      const int asleep = std::countr_zero(left);
      if ((dependent >> program_.NextAccess(asleep) & 1) == 0) sleep |= 1u << asleep;
    }
    frame.awake &= frame.awake - 1;
    frame.sleep |= 1u << thread;
    frame.before = program_.statements();
    if (!program_.Step(thread)) return false;
    known_.Meet(thread, &program_);
    return Enter(sleep);
  }

  /// Adds what was counted after a step, and undoes it.
  bool Add(const CountedPair& after) {
    if (after.traces == CountedPair::kOpen) return false;  // a run that does not end
    const int64_t statements = program_.statements();
    if (after.statements >= limits_.depth - statements) return false;
    if (path_.empty()) return true;
    CountedFrame& frame = path_.back();
    CountedPair& found = frame.found;
    found.statements = std::max(found.statements, statements - frame.before + after.statements);
    program_.Undo();
    return !__builtin_add_overflow(found.traces, after.traces, &found.traces);
  }

  /// Ends the count of a pair.
  bool Leave() {
    const CountedFrame frame = path_.back();
    path_.pop_back();
    pairs_[frame.pair] = frame.found;
    return Add(frame.found);
  }

  StepModel program_;
  KnownStates known_;
  const TraceCountLimits& limits_;
  const CountVisitor& visit_;
  NumberTable numbers_;  ///< of pairs: a state and the threads that sleep, as bits
  std::vector<CountedPair> pairs_;
  std::vector<CountedFrame> path_;
};

}  // namespace

std::optional<TraceCount> CountTraces(const Model& model, const TraceCountLimits& limits,
                                      const CountVisitor& visit) {
  if (model.depth() != 0 || !model.AccessesAreLocal()) return std::nullopt;
  return TraceCounter(model, limits, visit).Run();
}

}  // namespace oncard::explore
