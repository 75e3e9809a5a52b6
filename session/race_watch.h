// The data races of a run: statements of different threads that access a global variable, of which
// one writes it, and which nothing orders (vm/race_clocks.h); and commands of different threads
// that set one axis, coordinate system or output without an order (runtime/observe/race_steps.h).
// What orders are the variables of the scenario's `sync`, and those for which statements wait. What
// the host does is not looked at.
//
// Each pair of statements is told once. A copy goes on by itself; deterministic. Tested by
// tests/session/race_watch_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/result.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/sim/controller.h"
#include "vm/race_clocks.h"

namespace oncard::session {

class RaceWatch {
 public:
  /// Fails with the variables of `sync` that the program does not have.
  static Result<RaceWatch> Create(const runtime::Scenario& scenario,
                                  const runtime::Controller& controller);

  /// To be called before a thread executes its next statement: the race between this statement and
  /// an earlier one, if there is any.
  std::optional<Message> BeforeStatement(const runtime::Controller& controller, int thread);
  /// To be called after it.
  void AfterStatement(const runtime::Controller& controller, int thread);

 private:
  /// Two statements by function and position, the smaller one first.
  using Pair = std::array<std::pair<int, int>, 2>;

  RaceWatch() : clocks_(vm::kThreadCount) {}
  static Message Describe(const runtime::Controller& controller, uint32_t cell,
                          const vm::RacingAccess& first, const vm::RacingAccess& second);

  std::shared_ptr<const std::vector<bool>> sync_;  ///< by the slots of globals
  vm::RaceClocks clocks_;
  /// The variables for which threads wait: when a thread goes on it has seen their values.
  std::array<std::optional<uint16_t>, vm::kThreadCount> awaited_{};
  std::set<Pair> told_;
};

}  // namespace oncard::session
