#include "explore/engines/island_search.h"

#include <algorithm>
#include <bit>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "explore/engines/island_failure.h"
#include "explore/models/card_steps.h"
#include "explore/models/key_set.h"
#include "explore/models/whole_states.h"
#include "vm/arithmetic.h"

namespace oncard::explore {
namespace {

/// The states of one island. `States`: WholeStates or CardSteps.
template <typename States>
class IslandSearch {
  using State = typename States::State;

 public:
  /// `summed`: Islands::summed().
  IslandSearch(IslandCard card, const std::vector<uint16_t>& summed, const StateLimits& limits,
               IslandCounts* counts)
      : card_(std::make_shared<IslandCard>(std::move(card))),
        model_(card_->model),
        states_(&model_),
        summed_(summed),
        limits_(limits),
        counts_(*counts) {}

  /// Searches as long as its threads run. False: a limit was reached, something fails, or what was
  /// computed is not exact.
  bool Run() {
    State start = states_.Start();
    before_ = SumsIn(start);
    if (!Enter(std::move(start), kNoWay, 0)) return false;
    while (!waiting_.empty()) {
      // Cycle by cycle, so that few states wait.
      const auto cycle = waiting_.begin();
      if (cycle->second.empty()) {
        waiting_.erase(cycle);
        continue;
      }
      const Found found = std::move(cycle->second.back());
      cycle->second.pop_back();
      if (IsOver() || !Expand(found)) return false;
    }
    return states_.exact();
  }

  /// Goes on from its ends while other islands run, at most up to a cycle.
  bool Outlast(int64_t last_cycle) {
    while (!ends_.empty()) {
      const Found found = std::move(ends_.back());
      ends_.pop_back();
      const int64_t cycle = states_.CycleOf(found.state);
      if (IsOver()) return false;
      NoteSums(found.state);
      const bool may_end = !card_->lasts || cycle >= model_.last_instant();
      if (may_end && model_.EndRun(states_.Whole(found.state))) {
        failing_ = found.way;
        return false;
      }
      if (card_->lasts && cycle < last_cycle && !EndCycle(found)) return false;
    }
    return states_.exact();
  }

  bool exact() const { return states_.exact(); }
  const runtime::StatementAccess& accesses() const { return accesses_; }
  /// The cycle in which its last thread can end.
  int64_t last_cycle() const { return last_cycle_; }
  const std::shared_ptr<IslandCard>& card() const { return card_; }
  /// The values of what sums are asked of, before its threads run.
  const GlobalSums& before() const { return before_; }
  /// What it can add to them.
  const std::set<GlobalSums>& added() const { return added_; }
  /// The way to what has failed; empty if a limit was reached.
  std::vector<uint8_t> FailingWay() const {
    std::vector<uint8_t> choices;
    for (uint32_t at = failing_; at != kNoWay && ways_[at].from != kNoWay; at = ways_[at].from) {
      choices.push_back(ways_[at].choice);
    }
    std::ranges::reverse(choices);
    return choices;
  }

 private:
  static constexpr uint32_t kNoWay = ~uint32_t{0};
  /// How a state was reached for the first time: from which one, by its number, with which thread
  /// or kOthersEndCycle.
  struct Way {
    uint32_t from = kNoWay;
    uint8_t choice = 0;
  };
  struct Found {
    State state;
    uint32_t way = kNoWay;  ///< its number
  };

  GlobalSums SumsIn(const State& state) {
    GlobalSums sums;
    if (summed_.empty()) return sums;
    model_.Load(states_.Whole(state));
    for (const uint16_t slot : summed_) {
      sums.push_back(
          static_cast<uint32_t>(vm::IntOf(model_.controller().machine().state().globals[slot])));
    }
    return sums;
  }

  /// Notes what has been added at an end of its threads.
  void NoteSums(const State& state) {
    GlobalSums added = SumsIn(state);
    for (size_t i = 0; i < added.size(); ++i) added[i] -= before_[i];
    added_.insert(std::move(added));
  }

  bool IsOver() const {
    if (limits_.progress != nullptr) {
      limits_.progress->states.store(counts_.states, std::memory_order_relaxed);
    }
    return counts_.states > limits_.states || IsTold(limits_.stop);
  }

  bool Expand(const Found& found) {
    const State& state = found.state;
    const uint32_t all = states_.ChoicesOf(state);
    for (uint32_t choices = all; choices != 0; choices &= choices - 1) {
      runtime::AddAccesses(states_.NewLastingAccess(state, std::countr_zero(choices)), &accesses_);
    }
    for (uint32_t choices = all; choices != 0; choices &= choices - 1) {
      const int thread = std::countr_zero(choices);
      ++counts_.transitions;
      if (!Enter(states_.Step(state, thread), found.way, static_cast<uint8_t>(thread)))
        return false;
    }
    return !states_.MayEndCycle(state) || EndCycle(found);
  }

  bool EndCycle(const Found& found) {
    ++counts_.transitions;
    return Enter(states_.EndCycle(found.state), found.way, kOthersEndCycle);
  }

  /// False if the state fails.
  bool Enter(State state, uint32_t from, uint8_t choice) {
    if (!known_.Insert(states_.KeyOf(state))) return true;
    ++counts_.states;
    const auto way = static_cast<uint32_t>(ways_.size());
    ways_.push_back({from, choice});
    if (state.fault) {
      failing_ = way;
      return false;
    }
    if (states_.Ended(state)) {
      NoteSums(state);
      return true;
    }
    const int64_t cycle = states_.CycleOf(state);
    if (state.finished) {
      last_cycle_ = std::max(last_cycle_, cycle);
      ends_.push_back({std::move(state), way});
    } else {
      waiting_[cycle].push_back({std::move(state), way});
    }
    return true;
  }

  std::shared_ptr<IslandCard> card_;
  CardModel& model_;
  States states_;
  const std::vector<uint16_t>& summed_;
  GlobalSums before_;
  std::set<GlobalSums> added_;
  const StateLimits& limits_;
  IslandCounts& counts_;
  std::map<int64_t, std::vector<Found>> waiting_;  ///< by their cycles
  std::vector<Found> ends_;                        ///< of its threads
  KeySet known_;
  std::vector<Way> ways_;
  uint32_t failing_ = kNoWay;
  runtime::StatementAccess accesses_;
  int64_t last_cycle_ = 0;
};

/// So many different sums are checked at most.
constexpr size_t kSumsMax = 100'000;

/// Whether what is required of sums holds whatever each island adds. Counts as a failure where they
/// are too many. `search_of` gives the search of an island.
template <typename SearchOf>
bool SumsHold(const Islands& islands, const vm::Object& object, const SearchOf& search_of,
              IslandCounts* counts) {
  if (islands.summed().empty()) return true;
  std::set<GlobalSums> sums = {search_of(islands.all().front()).before()};
  std::vector<int> adding(islands.summed().size());  // islands
  for (const Island& island : islands.all()) {
    const std::set<GlobalSums>& added = search_of(island).added();
    std::set<GlobalSums> next;
    for (const GlobalSums& sum : sums) {
      for (const GlobalSums& more : added) {
        GlobalSums both = sum;
        for (size_t i = 0; i < both.size(); ++i) both[i] += more[i];
        next.insert(std::move(both));
        if (next.size() > kSumsMax) return false;
      }
    }
    sums = std::move(next);
    for (size_t i = 0; i < adding.size(); ++i) {
      if (std::ranges::any_of(added, [&](const GlobalSums& more) { return more[i] != 0; })) {
        ++adding[i];
      }
    }
  }
  for (size_t i = 0; i < adding.size(); ++i) {
    if (adding[i] > 1) {
      counts->sums.push_back(
          runtime::NameOf({gtcalls::Resource::kVariable, islands.summed()[i]}, object));
    }
  }
  return std::ranges::all_of(sums,
                             [&](const GlobalSums& values) { return islands.HoldsWith(values); });
}

/// `exact` becomes false if there is no proof because of what was computed of states.
template <typename States>
IslandResult Prove(CardModel* whole, Islands islands, const StateLimits& limits, bool* exact) {
  using OfIsland = IslandSearch<States>;
  IslandProof proof;
  const auto failure_of = [&](const Island& island, const OfIsland& search) {
    const std::vector<uint8_t> way = search.FailingWay();
    IslandResult result;
    if (!way.empty()) {
      result.failing = FailInWhole(whole, &search.card()->model, island.threads, way, limits.stop);
    }
    return result;
  };
  std::map<uint32_t, std::unique_ptr<OfIsland>> searches;  // by their threads
  for (size_t i = 0; i < islands.all().size();) {
    std::unique_ptr<OfIsland>& search = searches[islands.all()[i].threads];
    if (search != nullptr) {
      ++i;
      continue;
    }
    auto card = islands.Build(i, *whole);
    if (!card) return {};
    search = std::make_unique<OfIsland>(*std::move(card), islands.summed(), limits, &proof.counts);
    const bool good = search->Run();
    *exact = *exact && search->exact();
    if (!*exact) return {};
    // What fails may be the fault of another island with which it shares more than was known.
    const bool joined = islands.Add(i, search->accesses());
    if (islands.all().size() < 2) return {};
    if (!good && !joined) return failure_of(islands.all()[i], *search);
    if (joined) i = 0;
  }
  int64_t last_cycle = whole->last_instant();
  for (const Island& island : islands.all()) {
    last_cycle = std::max(last_cycle, searches[island.threads]->last_cycle());
  }
  for (const Island& island : islands.all()) {
    OfIsland& search = *searches[island.threads];
    const bool good = search.Outlast(last_cycle);
    *exact = *exact && search.exact();
    if (!*exact) return {};
    if (!good) return failure_of(island, search);
    proof.cards.push_back(search.card());
    std::vector<int>& threads = proof.counts.threads.emplace_back();
    for (const ThreadSetup& setup : search.card()->model.setups()) threads.push_back(setup.thread);
  }
  const auto search_of = [&](const Island& island) -> const OfIsland& {
    return *searches[island.threads];
  };
  if (!SumsHold(islands, whole->image()->object, search_of, &proof.counts)) return {};
  return {std::move(proof), {}};
}

}  // namespace

void IslandProof::IncludeIn(CardModel* whole) const {
  for (const auto& card : cards) whole->Include(card->model, card->origins);
}

IslandResult ProveByIslands(CardModel* whole, Islands islands, const StateLimits& limits) {
  if (CardRows::Possible(*whole) && !limits.whole_states) {
    bool exact = true;
    IslandResult result = Prove<CardSteps>(whole, islands, limits, &exact);
    if (exact) return result;
  }
  bool exact = true;
  return Prove<WholeStates>(whole, std::move(islands), limits, &exact);
}

}  // namespace oncard::explore
