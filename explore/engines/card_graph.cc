#include "explore/engines/card_graph.h"

#include <algorithm>
#include <bit>
#include <deque>
#include <utility>

#include "explore/models/key_set.h"

namespace oncard::explore {
namespace {

class CardSearch {
 public:
  CardSearch(CardModel* model, const StateLimits& limits) : model_(*model), limits_(limits) {
    result_.graph.threads = model->thread_count();
  }

  CardGraph Run() {
    StateGraph& graph = result_.graph;
    Enter(model_.Start());
    for (; !waiting_.empty(); waiting_.pop_front()) {
      if (graph.size() > limits_.states) return Finish(false);
      if (graph.size() - std::min(first_bad_, graph.size()) > limits_.states_after_bad) {
        return Finish(false);
      }
      if (IsTold(limits_.stop)) return Finish(false);
      if (limits_.progress != nullptr) {
        limits_.progress->states.store(graph.size(), std::memory_order_relaxed);
        limits_.progress->frontier.store(static_cast<int64_t>(waiting_.size()),
                                         std::memory_order_relaxed);
      }
      const auto& [number, state] = waiting_.front();
      for (uint32_t choices = state.choices; choices != 0; choices &= choices - 1) {
        const int thread = std::countr_zero(choices);
        const uint32_t next = Enter(model_.Step(state, thread));
        graph.successors[size_t{number} * static_cast<size_t>(graph.threads) +
                         static_cast<size_t>(thread)] = next;
        ++graph.transitions;
      }
    }
    return Finish(true);
  }

 private:
  /// Returns the number of a state; a new state is checked and queued.
  uint32_t Enter(CardModel::State state) {
    bool added = false;
    const uint32_t number = numbers_.FindOrAdd(model_.KeyOf(state), &added);
    if (!added) return number;
    StateGraph& graph = result_.graph;
    graph.successors.Append(static_cast<size_t>(graph.threads), StateGraph::kNone);
    uint32_t flags = 0;
    if (state.ended) flags |= kTerminal;
    if (state.finished) {
      globals_.Insert(model_.GlobalsKey(state));
      const bool new_end = full_.Insert(model_.FinalKey(state));
      if (new_end && model_.asks_nothing()) result_.ends.Add(EndOf(model_, state));
    }
    if (state.fault) {
      flags |= kBad;
      ++result_.bad_states;
      first_bad_ = std::min(first_bad_, graph.size());
    }
    graph.flags.Append(1, flags);
    if (!state.ended) waiting_.emplace_back(number, std::move(state));
    return number;
  }

  CardGraph Finish(bool complete) {
    result_.graph.complete = complete;
    result_.final_globals = globals_.size();
    result_.final_full = full_.size();
    const auto earliest = std::ranges::min_element(
        waiting_, {}, [](const auto& entry) { return CardModel::CycleOf(entry.second); });
    if (earliest != waiting_.end()) result_.open = std::move(earliest->second);
    return std::move(result_);
  }

  CardModel& model_;
  const StateLimits& limits_;
  CardGraph result_;
  std::deque<std::pair<uint32_t, CardModel::State>> waiting_;
  KeySet numbers_;
  KeySet globals_;
  KeySet full_;
  uint32_t first_bad_ = StateGraph::kNone;  ///< the first bad state
};

}  // namespace

CardGraph BuildCardGraph(CardModel* model, const StateLimits& limits) {
  return CardSearch(model, limits).Run();
}

}  // namespace oncard::explore
