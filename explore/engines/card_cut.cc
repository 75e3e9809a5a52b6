#include "explore/engines/card_cut.h"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>

#include "explore/models/card_ends.h"
#include "explore/models/key_set.h"

namespace oncard::explore {
namespace {

class Cutting {
 public:
  Cutting(CardModel* model, const StateLimits& limits) : model_(*model), limits_(limits) {}

  CardCut Run(size_t enough) {
    Enter(model_.Start(), -1, 0);
    while (!waiting_.empty() && !cut_.fails && starts() < enough) {
      const Before before = {cut_.counts, waiting_, ends_.shown(), ends_.by_globals(), ends_.all()};
      if (TakeCycle()) continue;
      // What a part of a cycle has found is found again.
      cut_.counts = before.counts;
      waiting_ = before.waiting;
      Finish(before.ends, before.globals, before.full);
      return std::move(cut_);
    }
    Finish(ends_.shown(), ends_.by_globals(), ends_.all());
    return std::move(cut_);
  }

 private:
  struct Entry {
    CardModel::State state;
    int64_t node = 0;
  };
  /// By the cycle of the state.
  using Waiting = std::map<int64_t, std::vector<Entry>>;
  /// How the first run came to a state.
  struct Node {
    int64_t before = 0;
    uint8_t thread = 0;
  };
  struct Before {
    StateCounts counts;
    Waiting waiting;
    EndSet ends;
    int64_t globals = 0;
    int64_t full = 0;
  };

  size_t starts() const {
    size_t count = 0;
    for (const auto& [cycle, entries] : waiting_) count += entries.size();
    return count;
  }

  std::vector<uint8_t> WayTo(int64_t node) const {
    std::vector<uint8_t> way;
    for (; node > 0; node = nodes_[static_cast<size_t>(node)].before) {
      way.push_back(nodes_[static_cast<size_t>(node)].thread);
    }
    std::ranges::reverse(way);
    return way;
  }

  /// Searches the states of the earliest cycle. False if a limit was reached.
  bool TakeCycle() {
    const int64_t cycle = waiting_.begin()->first;
    // Its list grows meanwhile.
    for (size_t i = 0; i < waiting_.begin()->second.size(); ++i) {
      stopped_ = IsTold(limits_.stop);
      if (stopped_ || cut_.counts.states >= int64_t{limits_.states}) return false;
      const auto [state, node] = std::move(waiting_.begin()->second[i]);
      ++cut_.counts.states;
      for (uint32_t choices = state.choices; choices != 0; choices &= choices - 1) {
        const int thread = std::countr_zero(choices);
        ++cut_.counts.transitions;
        Enter(model_.Step(state, thread), node, static_cast<uint8_t>(thread));
        if (cut_.fails) return true;
      }
    }
    waiting_.erase(cycle);
    return true;
  }

  void Enter(CardModel::State state, int64_t before, uint8_t thread) {
    bool added = false;
    numbers_.FindOrAdd(model_.KeyOf(state), &added);
    if (!added) return;
    const auto node = static_cast<int64_t>(nodes_.size());
    nodes_.push_back({before, thread});
    if (state.finished) ends_.Add(model_, state);
    if (state.fault) {
      ++cut_.counts.bad_states;
      cut_.fails = true;
      cut_.failing = WayTo(node);
    }
    if (state.ended) {
      ++cut_.counts.states;
    } else {
      std::vector<Entry>& of_cycle = waiting_[CardModel::CycleOf(state)];
      of_cycle.push_back({std::move(state), node});
    }
  }

  void Finish(const EndSet& ends, int64_t globals, int64_t full) {
    cut_.ends = ends;
    cut_.counts.final_globals = globals;
    cut_.counts.final_full = full;
    cut_.counts.complete = !stopped_;
    if (cut_.fails || stopped_) return;
    for (auto& [cycle, entries] : waiting_) {
      for (Entry& entry : entries) {
        cut_.starts.push_back(std::move(entry.state));
        cut_.ways.push_back(WayTo(entry.node));
      }
    }
  }

  CardModel& model_;
  const StateLimits& limits_;
  CardCut cut_;
  Waiting waiting_;
  std::vector<Node> nodes_;
  KeySet numbers_;
  CardEnds ends_;
  bool stopped_ = false;
};

}  // namespace

CardCut CutCard(CardModel* model, size_t enough, const StateLimits& limits) {
  return Cutting(model, limits).Run(enough);
}

}  // namespace oncard::explore
