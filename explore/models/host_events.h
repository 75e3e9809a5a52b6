// What a host does to an explored card: its recorded calls, each in the profile cycle in which it
// was made, after the statements of that cycle, as when it was recorded. The host is part of the
// surroundings: it makes the same calls whatever the threads do. A call that the card does not
// answer with its recorded code is a fault of the interleaving.
//
// Deterministic; const members may be called from several threads if the calls' may. Tested by
// tests/explore/host_exploration_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/result.h"
#include "explore/models/model.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/record/host_calls.h"
#include "runtime/sim/controller.h"

namespace oncard::explore {

class HostEvents {
 public:
  /// A call that the card does not answer as recorded.
  struct Deviation {
    size_t call = 0;
    int16_t code = 0;
  };

  /// Makes the calls once as they were recorded. Fails if the card then answers otherwise, if no
  /// thread is started, and if programs or bindings change after that.
  static Result<HostEvents> Create(const runtime::Scenario& scenario,
                                   std::shared_ptr<const runtime::HostCalls> calls);

  /// Brings a card, as it is made for the scenario, to the call that starts the first thread.
  void Prepare(const runtime::Scenario& scenario, runtime::Controller* controller) const;
  /// Makes the calls of the card's present cycle, at its end, up to a deviation.
  std::optional<Deviation> Act(runtime::Controller* controller) const;
  /// The numbers of the calls in cycles from `first` on and before `end`: the first one, and the
  /// one behind the last.
  std::pair<size_t, size_t> CallsIn(int64_t first, int64_t end) const;
  /// True if calls of this cycle or of later ones exist.
  bool LeftAt(int64_t cycle) const { return !cycles_.empty() && cycle <= cycles_.back(); }
  /// The threads that the host binds, in the order of their numbers on the card.
  const std::vector<ThreadSetup>& threads() const { return threads_; }
  /// The cycle in which the host closed the card, or made its last call.
  int64_t end_cycle() const { return end_cycle_; }
  /// True if the recorded run ended while threads were running.
  bool cut() const { return cut_; }
  const runtime::HostCalls& calls() const { return *calls_; }
  /// The number of calls, without the end.
  size_t size() const { return first_ + cycles_.size(); }

 private:
  explicit HostEvents(std::shared_ptr<const runtime::HostCalls> calls) : calls_(std::move(calls)) {}

  std::shared_ptr<const runtime::HostCalls> calls_;
  size_t first_ = 0;             ///< the call that starts the first thread
  std::vector<int64_t> cycles_;  ///< of the calls from there on
  std::vector<ThreadSetup> threads_;
  int64_t end_cycle_ = 0;
  bool cut_ = false;
};

}  // namespace oncard::explore
