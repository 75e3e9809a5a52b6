// The plans of a search of traces (dpor.h): sequences of steps with common prefixes, stored as
// trees in a pool. Siblings are tried in their order. Tested by tests/explore/dpor_test.cc.
#pragma once

#include <cstdint>
#include <vector>

#include "explore/engines/dpor.h"

namespace oncard::explore {

using PlanIndex = uint32_t;
inline constexpr PlanIndex kNoPlan = ~PlanIndex{0};

/// `ThreadOf(step)` is the thread of a `Step`.
template <typename Step>
class PlanPool {
 public:
  struct Node {
    Step step;
    PlanIndex first_child = kNoPlan;
    PlanIndex next_sibling = kNoPlan;
  };

  Node& operator[](PlanIndex index) { return nodes_[index]; }
  const Node& operator[](PlanIndex index) const { return nodes_[index]; }

  PlanIndex Take(const Step& step) {
    if (free_ == kNoPlan) {
      nodes_.emplace_back();
      Release(static_cast<PlanIndex>(nodes_.size() - 1));
    }
    const PlanIndex index = free_;
    Node& node = nodes_[index];
    free_ = node.next_sibling;
    node = {step, kNoPlan, kNoPlan};
    return index;
  }
  /// Returns a node without children to the pool.
  void Release(PlanIndex index) {
    nodes_[index].next_sibling = free_;
    free_ = index;
  }

  std::vector<PlannedStep> Save(PlanIndex first) const {
    std::vector<PlannedStep> plans;
    std::vector<PlanIndex> open = {first};
    while (!open.empty()) {
      const PlanIndex plan = open.back();
      open.pop_back();
      if (plan == kNoPlan) continue;
      const Node& node = nodes_[plan];
      PlannedStep planned = {static_cast<uint8_t>(ThreadOf(node.step)), 0};
      for (PlanIndex i = node.first_child; i != kNoPlan; i = nodes_[i].next_sibling) ++planned.next;
      plans.push_back(planned);
      open.push_back(node.next_sibling);
      open.push_back(node.first_child);
    }
    return plans;
  }

  /// Stores saved plans again. The accesses of planned steps are not saved; they are determined by
  /// executing the steps in `run`, which is left where it was: `run->NextStep(thread)` returns a
  /// Step, `run->Take(thread)` executes it and is false if it cannot, `run->depth()` and
  /// `run->UndoTo(depth)` go back. False if a step could not be executed; the pool is not usable
  /// then.
  template <typename Run>
  bool Restore(const std::vector<PlannedStep>& plans, Run* run, PlanIndex* first) {
    using Depth = decltype(run->depth());
    /// Plans that follow the same step.
    struct Level {
      size_t left = 0;               ///< number of plans still to be read
      Depth depth = 0;               ///< of the run before that step
      PlanIndex before = kNoPlan;    ///< that step
      PlanIndex previous = kNoPlan;  ///< the plan read last
    };
    *first = kNoPlan;
    std::vector<Level> levels = {{plans.size(), run->depth()}};
    for (const PlannedStep& planned : plans) {
      for (; levels.back().left == 0; levels.pop_back()) run->UndoTo(levels.back().depth);
      Level& level = levels.back();
      --level.left;
      const PlanIndex plan = Take(run->NextStep(planned.thread));
      PlanIndex* link = first;
      if (level.previous != kNoPlan) {
        link = &nodes_[level.previous].next_sibling;
      } else if (level.before != kNoPlan) {
        link = &nodes_[level.before].first_child;
      }
      *link = plan;
      level.previous = plan;
      if (planned.next == 0) continue;
      levels.push_back({planned.next, run->depth(), plan});
      if (!run->Take(planned.thread)) return false;
    }
    run->UndoTo(levels.front().depth);
    return true;
  }

 private:
  std::vector<Node> nodes_;
  PlanIndex free_ = kNoPlan;
};

}  // namespace oncard::explore
