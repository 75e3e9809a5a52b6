#include "explore/engines/bounded_search.h"

#include <bit>
#include <utility>

#include "explore/engines/progress.h"
#include "explore/engines/walk.h"
#include "explore/models/key_set.h"

namespace oncard::explore {
namespace {

template <typename Walk>
class BoundedSearch {
 public:
  BoundedSearch(Walk walk, const BoundedOptions& options)
      : walk_(std::move(walk)), options_(options) {}

  BoundedCounts Run() {
    for (int bound = 0; bound <= options_.preemptions; ++bound) {
      visited_ = {};
      cut_ = false;
      if (!Search(bound)) return Finish(false);
      counts_.preemptions = bound;
      if (counts_.bad) return Finish(true);
      if (!cut_) {
        // No schedule needs more preemptions.
        counts_.preemptions = options_.preemptions;
        break;
      }
    }
    return Finish(true);
  }

 private:
  struct Visit {
    uint32_t untried = 0;  ///< threads
    int last = -1;         ///< the thread whose statement led here
    int preemptions = 0;
  };

  BoundedCounts Finish(bool complete) {
    counts_.complete = complete;
    counts_.states = visited_.size();
    counts_.different_ends = ends_.size();
    return std::move(counts_);
  }

  /// False if a limit was reached.
  bool Search(int bound) {
    std::vector<Visit> path;
    Enter(-1, 0, bound, &path);
    while (!path.empty()) {
      if (walk_.fault()) {
        counts_.bad = true;
        for (size_t i = 1; i < path.size(); ++i) {
          counts_.failing.push_back(static_cast<uint8_t>(path[i].last));
        }
        return true;
      }
      if (visited_.size() >= options_.state_limit) return false;
      if (IsTold(options_.stop)) return false;
      Visit& visit = path.back();
      if (visit.untried == 0) {
        path.pop_back();
        if (!path.empty()) walk_.Undo();
        continue;
      }
      const int thread = std::countr_zero(visit.untried);
      visit.untried &= visit.untried - 1;
      const int preemptions = visit.preemptions + (Preempts(visit.last, thread) ? 1 : 0);
      if (static_cast<int64_t>(path.size()) > options_.statement_limit) return false;
      walk_.Step(thread);
      if (!Enter(thread, preemptions, bound, &path)) walk_.Undo();
    }
    return true;
  }

  bool Preempts(int last, int thread) const {
    return last >= 0 && thread != last && (walk_.choices() >> last & 1) != 0;
  }

  /// False if the current state was entered in the same way before.
  bool Enter(int last, int preemptions, int bound, std::vector<Visit>* path) {
    StateKey key = walk_.Key();
    AddToKey(kPlaceOfVisit, last, &key);
    AddToKey(kPlaceOfVisit + 1, preemptions, &key);
    if (!visited_.Insert(key) && !walk_.fault()) return false;
    if (walk_.finished() && ends_.Insert(walk_.EndKey()) && walk_.asks_nothing()) {
      counts_.ends.Add(walk_.EndNow());
    }
    Visit visit = {walk_.ended() ? 0 : walk_.choices(), last, preemptions};
    if (preemptions == bound && last >= 0 && (visit.untried >> last & 1) != 0) {
      cut_ = cut_ || visit.untried != 1u << last;
      visit.untried = 1u << last;
    }
    path->push_back(visit);
    return true;
  }

  /// Greater than all cell numbers of a model.
  static constexpr uint32_t kPlaceOfVisit = 0xfffffff0;

  Walk walk_;
  const BoundedOptions& options_;
  BoundedCounts counts_;
  KeySet visited_;
  KeySet ends_;
  bool cut_ = false;  ///< a schedule would have needed another preemption
};

}  // namespace

BoundedCounts SearchBounded(const Problem& problem, const BoundedOptions& options) {
  StatementCoverage coverage;
  BoundedCounts counts = BoundedSearch(ProgramWalk(problem, &coverage), options).Run();
  counts.coverage = std::move(coverage);
  return counts;
}

BoundedCounts SearchCardBounded(CardModel* model, const BoundedOptions& options) {
  return BoundedSearch(CardWalk(model, true), options).Run();
}

}  // namespace oncard::explore
