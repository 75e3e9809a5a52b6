#include "explore/engines/island_search.h"

#include <algorithm>
#include <bit>
#include <map>
#include <memory>
#include <utility>

#include "explore/models/key_set.h"

namespace oncard::explore {
namespace {

/// The states of one island.
class IslandSearch {
 public:
  IslandSearch(IslandCard card, const StateLimits& limits, IslandCounts* counts)
      : card_(std::make_shared<IslandCard>(std::move(card))),
        model_(card_->model),
        limits_(limits),
        counts_(*counts) {}

  /// Searches as long as its threads run. False: a limit was reached, or something fails.
  bool Run() {
    if (!Enter(model_.Start())) return false;
    while (!waiting_.empty()) {
      // Cycle by cycle, so that states which share their body are alive together.
      const auto cycle = waiting_.begin();
      if (cycle->second.empty()) {
        waiting_.erase(cycle);
        continue;
      }
      const CardModel::State state = std::move(cycle->second.back());
      cycle->second.pop_back();
      if (IsOver() || !Expand(state)) return false;
    }
    return true;
  }

  /// Goes on from its ends while other islands run, at most up to a cycle.
  bool Outlast(int64_t last_cycle) {
    while (!ends_.empty()) {
      const CardModel::State state = std::move(ends_.back());
      ends_.pop_back();
      const int64_t cycle = CardModel::CycleOf(state);
      if (IsOver()) return false;
      const bool may_end = !card_->lasts || cycle >= model_.last_instant();
      if (may_end && model_.EndRun(state)) return false;
      if (card_->lasts && cycle < last_cycle && !EnterFrom(model_.EndCycle(state))) return false;
    }
    return true;
  }

  const runtime::StatementAccess& accesses() const { return accesses_; }
  /// The cycle in which its last thread can end.
  int64_t last_cycle() const { return last_cycle_; }
  const std::shared_ptr<IslandCard>& card() const { return card_; }

 private:
  bool IsOver() const {
    if (limits_.progress != nullptr) {
      limits_.progress->states.store(counts_.states, std::memory_order_relaxed);
    }
    return counts_.states > limits_.states || IsTold(limits_.stop);
  }

  bool Expand(const CardModel::State& state) {
    model_.Load(state);
    for (uint32_t choices = state.choices; choices != 0; choices &= choices - 1) {
      AddAccesses(runtime::NextLastingAccess(model_.controller(),
                                             model_.setup(std::countr_zero(choices)).thread),
                  &accesses_);
    }
    for (uint32_t choices = state.choices; choices != 0; choices &= choices - 1) {
      if (!EnterFrom(model_.Step(state, std::countr_zero(choices)))) return false;
    }
    return !model_.MayEndCycle(state) || EnterFrom(model_.EndCycle(state));
  }

  bool EnterFrom(CardModel::State state) {
    ++counts_.transitions;
    return Enter(std::move(state));
  }

  /// False if the state fails.
  bool Enter(CardModel::State state) {
    if (!known_.Insert(model_.KeyOf(state))) return true;
    ++counts_.states;
    if (state.fault) return false;
    if (state.ended) return true;
    const int64_t cycle = CardModel::CycleOf(state);
    if (state.finished) {
      last_cycle_ = std::max(last_cycle_, cycle);
      ends_.push_back(std::move(state));
    } else {
      waiting_[cycle].push_back(std::move(state));
    }
    return true;
  }

  std::shared_ptr<IslandCard> card_;
  CardModel& model_;
  const StateLimits& limits_;
  IslandCounts& counts_;
  std::map<int64_t, std::vector<CardModel::State>> waiting_;  ///< by their cycles
  std::vector<CardModel::State> ends_;                        ///< of its threads
  KeySet known_;
  runtime::StatementAccess accesses_;
  int64_t last_cycle_ = 0;
};

}  // namespace

void IslandProof::IncludeIn(CardModel* whole) const {
  for (const auto& card : cards) whole->Include(card->model, card->origins);
}

std::optional<IslandProof> ProveByIslands(const CardModel& whole, Islands islands,
                                          const StateLimits& limits) {
  IslandProof proof;
  std::map<uint32_t, std::unique_ptr<IslandSearch>> searches;  // by their threads
  for (size_t i = 0; i < islands.all().size();) {
    std::unique_ptr<IslandSearch>& search = searches[islands.all()[i].threads];
    if (search != nullptr) {
      ++i;
      continue;
    }
    auto card = islands.Build(i, whole);
    if (!card) return std::nullopt;
    search = std::make_unique<IslandSearch>(*std::move(card), limits, &proof.counts);
    const bool good = search->Run();
    // What fails may be the fault of another island with which it shares more than was known.
    const bool joined = islands.Add(i, search->accesses());
    if (islands.all().size() < 2 || (!good && !joined)) return std::nullopt;
    if (joined) i = 0;
  }
  int64_t last_cycle = whole.last_instant();
  for (const Island& island : islands.all()) {
    last_cycle = std::max(last_cycle, searches[island.threads]->last_cycle());
  }
  for (const Island& island : islands.all()) {
    IslandSearch& search = *searches[island.threads];
    if (!search.Outlast(last_cycle)) return std::nullopt;
    proof.cards.push_back(search.card());
    std::vector<int>& threads = proof.counts.threads.emplace_back();
    for (const ThreadSetup& setup : search.card()->model.setups()) threads.push_back(setup.thread);
  }
  return proof;
}

}  // namespace oncard::explore
