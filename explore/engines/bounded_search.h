// Every schedule with few preemptions: most faults need only one or two, and there are far fewer
// such schedules than schedules in all. First those without preemptions, then those with one, and
// so on, so that the first fault found has as few as possible.
//
// States are merged: nothing is explored twice from a state with the same running thread and number
// of preemptions. Deterministic; not thread-safe. Tested by tests/explore/bounded_search_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "explore/models/card_model.h"
#include "explore/models/ends.h"
#include "explore/models/problem.h"
#include "explore/models/statement_coverage.h"

namespace oncard::explore {

struct BoundedOptions {
  int preemptions = 2;  ///< at most
  int64_t statement_limit = 100'000;
  uint32_t state_limit = 50'000'000;
  /// Set from another thread: the search ends soon.
  const std::atomic<bool>* stop = nullptr;
};

struct BoundedCounts {
  int preemptions =
      -1;  ///< all schedules with this number were searched; -1 if not even those with 0
  int64_t states = 0;  ///< of the last bound, with the thread and the preemptions
  int64_t different_ends = 0;
  EndSet ends;  ///< if there are no requirements on results
  bool bad = false;
  /// The threads of the failing schedule, as numbered by the model.
  std::vector<uint8_t> failing;
  bool complete = false;  ///< a fault was found, or the search was complete up to the bound
  StatementCoverage coverage = {};  ///< without a card (CardModel::coverage())
};

BoundedCounts SearchBounded(const Problem& problem, const BoundedOptions& options);
/// The same with a card.
BoundedCounts SearchCardBounded(CardModel* model, const BoundedOptions& options);

}  // namespace oncard::explore
