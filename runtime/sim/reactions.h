// How the surroundings of a card react to it: some time after a condition has become true,
// something happens at its pins. So a gripper confirms that it has closed, however late the program
// closes it.
//
// Conditions are looked at at the boundaries of profile cycles, after the statements of the cycle
// that ends there. One that holds and did not at the boundary before, or at the first one, starts
// its reaction, which nothing cancels. What it causes happens at the first boundary that is not
// earlier than its instant, before the events of that boundary; without a delay at the same one.
// A reaction takes part in a loop at most at every other boundary, so that loops take time.
//
// What is pending, and which conditions have held, is part of the state of the card. Deterministic;
// not thread-safe. Tested by tests/runtime/reactions_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

#include "motion/motion_core.h"

namespace oncard::runtime {

class Reactions {
 public:
  /// The bits of a word.
  static constexpr size_t kMax = 64;

  struct Reaction {
    /// The delay. Who gives it bounds it, and with it what can be pending: a condition can become
    /// true at every other boundary only.
    int64_t after_us = 0;
    /// What happens, in this order; the instants of the events do not matter.
    motion::WorldEvents events;
  };

  /// What is known of the conditions at a boundary: bit n is that of reaction n.
  struct Look {
    uint64_t hold = 0;
    uint64_t exist = 0;  ///< their names exist; those of the others do not hold
  };
  using Conditions = std::function<Look()>;

  /// A reaction that has been started.
  struct Pending {
    int64_t at_ns = 0;  ///< since power-on, outside of the card
    uint32_t reaction = 0;

    auto Fields(auto visit) const { return visit(at_ns, reaction); }
    bool operator==(const Pending&) const = default;
  };
  struct State {
    uint64_t held = 0;             ///< the conditions that held at the last boundary
    std::vector<Pending> pending;  ///< in the order in which they happen

    auto Fields(auto visit) const { return visit(held, pending); }
    bool operator==(const State&) const = default;
  };

  /// At most kMax reactions.
  Reactions(std::vector<Reaction> reactions, Conditions conditions)
      : reactions_(std::move(reactions)), conditions_(std::move(conditions)) {}

  /// To be called at every boundary, which is at `now_ns`.
  void Act(int64_t now_ns, motion::MotionCore* core);

  const State& state() const { return state_; }
  void Restore(const State& state) { state_ = state; }
  /// What a state does not say: the reactions that have ever been started, and those whose names
  /// have ever existed, in all runs of the card.
  uint64_t started() const { return started_; }
  uint64_t existed() const { return existed_; }

 private:
  void Start(size_t reaction, int64_t now_ns);

  std::vector<Reaction> reactions_;
  Conditions conditions_;
  State state_;
  uint64_t started_ = 0;
  uint64_t existed_ = 0;
};

}  // namespace oncard::runtime
