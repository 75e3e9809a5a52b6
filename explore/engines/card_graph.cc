#include "explore/engines/card_graph.h"

#include <algorithm>
#include <bit>
#include <deque>
#include <utility>

#include "explore/models/card_ends.h"
#include "explore/models/card_steps.h"
#include "explore/models/key_set.h"
#include "explore/models/whole_states.h"

namespace oncard::explore {
namespace {

/// `States`: WholeStates, or CardSteps, which has the same functions.
template <typename States>
class CardSearch {
  using State = typename States::State;

 public:
  CardSearch(CardModel* model, const StateLimits& limits)
      : model_(*model), states_(model), limits_(limits) {
    result_.graph.threads = model->thread_count();
  }

  /// Empty if what was computed of the states is not exact.
  std::optional<CardGraph> Run(const std::vector<CardModel::State>& starts) {
    StateGraph& graph = result_.graph;
    if (starts.empty()) Enter(states_.Start());
    for (const CardModel::State& start : starts) Enter(states_.From(start));
    if (!states_.exact()) return std::nullopt;
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
      for (uint32_t choices = states_.ChoicesOf(state); choices != 0; choices &= choices - 1) {
        const int thread = std::countr_zero(choices);
        const uint32_t next = Enter(states_.Step(state, thread));
        graph.successors[size_t{number} * static_cast<size_t>(graph.threads) +
                         static_cast<size_t>(thread)] = next;
        ++graph.transitions;
      }
      if (!states_.exact()) return std::nullopt;
    }
    return Finish(true);
  }

 private:
  /// Returns the number of a state; a new state is checked and queued.
  uint32_t Enter(State state) {
    bool added = false;
    const uint32_t number = numbers_.FindOrAdd(states_.KeyOf(state), &added);
    if (!added) return number;
    StateGraph& graph = result_.graph;
    graph.successors.Append(static_cast<size_t>(graph.threads), StateGraph::kNone);
    uint32_t flags = 0;
    const bool ended = states_.Ended(state);
    if (ended) flags |= kTerminal;
    if (state.finished) ends_.Add(model_, states_.Program(state));
    if (state.fault) {
      flags |= kBad;
      ++result_.bad_states;
      first_bad_ = std::min(first_bad_, graph.size());
    }
    graph.flags.Append(1, flags);
    if (!ended) waiting_.emplace_back(number, std::move(state));
    return number;
  }

  CardGraph Finish(bool complete) {
    result_.graph.complete = complete;
    result_.final_globals = ends_.by_globals();
    result_.final_full = ends_.all();
    result_.ends = ends_.shown();
    const auto earliest = std::ranges::min_element(
        waiting_, {}, [&](const auto& entry) { return states_.CycleOf(entry.second); });
    if (earliest != waiting_.end()) result_.open = states_.Whole(earliest->second);
    return std::move(result_);
  }

  CardModel& model_;
  States states_;
  const StateLimits& limits_;
  CardGraph result_;
  std::deque<std::pair<uint32_t, State>> waiting_;
  KeySet numbers_;
  CardEnds ends_;
  uint32_t first_bad_ = StateGraph::kNone;  ///< the first bad state
};

}  // namespace

CardGraph BuildCardGraph(CardModel* model, const StateLimits& limits,
                         const std::vector<CardModel::State>& starts) {
  if (CardRows::Possible(*model) && !limits.whole_states) {
    if (auto graph = CardSearch<CardSteps>(model, limits).Run(starts)) {
      graph->by_rows = true;
      return *std::move(graph);
    }
  }
  return *CardSearch<WholeStates>(model, limits).Run(starts);
}

}  // namespace oncard::explore
