#include "explore/engines/trace_count.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "explore/models/number_table.h"
#include "explore/models/step_model.h"

namespace oncard::explore {
namespace {

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
      : program_(model, limits.depth), limits_(limits), visit_(visit) {}

  std::optional<TraceCount> Run() {
    if (!program_.Begin() || !Enter(0)) return std::nullopt;
    while (!path_.empty()) {
      if (!(path_.back().awake != 0 ? Try() : Leave())) return std::nullopt;
    }
    return TraceCount{.traces = pairs_.front().traces, .pairs = pairs_.size()};
  }

 private:
  /// Each of these is false if there is no count.

  /// Arrives in a state: looks the pair up, or begins to count it.
  bool Enter(uint32_t sleep) {
    const uint32_t state = program_.StateNumber();
    if (state == StepModel::kNone) return false;
    const uint32_t known = numbers_.Find(state, sleep);
    if (known != NumberTable::kNone) return Add(pairs_[known]);
    const bool told = limits_.stop != nullptr && limits_.stop->load(std::memory_order_relaxed);
    if (told || pairs_.size() >= limits_.pairs) return false;
    const auto pair = static_cast<uint32_t>(pairs_.size());
    numbers_.Add(state, sleep, pair);
    const uint32_t awake = program_.runnable() & ~sleep;
    if (awake != 0) {
      pairs_.emplace_back();
      path_.push_back({.pair = pair, .awake = awake, .sleep = sleep});
      return true;
    }
    // An end; if there are threads that sleep, another execution has counted what comes.
    const bool ends = program_.runnable() == 0;
    pairs_.push_back({.traces = ends ? 1 : 0});
    return (!ends || visit_(program_.AsModel())) && Add(pairs_.back());
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
    return program_.Step(thread) && Enter(sleep);
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
