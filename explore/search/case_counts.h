// Joins the explorations of several cases of one scenario, so that they are reported as one. Plain
// values. Tested by tests/explore/case_exploration_test.cc.
#pragma once

#include <cstdint>
#include <vector>

#include "base/message.h"
#include "explore/search/explorer.h"
#include "runtime/observe/supervisor.h"
#include "runtime/sim/refused_commands.h"

namespace oncard::explore {

/// Adds the exploration of one more case: sums of the counts, the weakest verdict, and the failure
/// that was found first. Both are of the same engine and the same program; `why` is that of the
/// weakest verdict.
void AddCase(Exploration next, Exploration* all);

/// What a search has used up of ExploreOptions::execution_limit and ExploreOptions::state_limit.
/// Executions that were counted without being executed are none.
int64_t ExecutionsUsed(const Exploration& exploration);
int64_t StatesUsed(const Exploration& exploration);

/// Adds what was found in places of the program, each place once.
void JoinFound(std::vector<runtime::RefusedCommand> next,
               std::vector<runtime::RefusedCommand>* all);
void JoinFound(std::vector<runtime::CardFinding> next, std::vector<runtime::CardFinding>* all);

/// What no case has put to the test.
struct UntestedInAll {
  static constexpr int64_t kNone = INT64_MAX;

  std::vector<Message> common;  ///< in each case
  std::vector<Message> first;   ///< in the first one
  int64_t fewest = kNone;       ///< texts of a case; kNone: there was no case

  /// Those of one more case.
  void Add(const std::vector<Message>& untested);
  /// Those of more cases.
  void Add(const UntestedInAll& others);

  /// A text can differ from case to case: an event that always comes too late comes at another
  /// instant. If each case has such a text, that of the first one stands for all.
  std::vector<Message> Texts() const {
    return fewest > static_cast<int64_t>(common.size()) ? first : common;
  }
};

}  // namespace oncard::explore
