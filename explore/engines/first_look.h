// The first search before the complete one: most faults need few preemptions, and those that need
// none or one are found quickly even if the complete search is too large. A program alone:
// schedules with at most two preemptions, then random ones. With its card: the threads one after
// the other, then the same.
//
// The limits are numbers of statements, so that the same program gives the same result everywhere.
// Tested by tests/explore/first_look_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "explore/engines/failure.h"
#include "explore/models/card_model.h"
#include "explore/models/problem.h"

namespace oncard::explore {

struct FirstLook {
  /// The threads of a failing schedule, as numbered by the model; empty: none was found.
  std::vector<uint8_t> failing;
  bool fewest_preemptions = false;  ///< no schedule with fewer preemptions fails
  /// Instead of `failing`: a failing run that is too long to be simplified.
  std::optional<Failure> failure = {};
  StatementCoverage coverage = {};  ///< without a card (CardModel::coverage())

  bool found() const { return !failing.empty() || failure; }
};

/// `stop` as for BoundedOptions. Only the graph of all states can judge benign races: with
/// RaceRule::kBenign nothing is searched. The limits are divided by the number of `cases` that are
/// each looked at.
FirstLook LookFirst(const Problem& problem, const std::atomic<bool>* stop, int64_t cases = 1);
/// The same with a card.
FirstLook LookFirstAtCard(CardModel* model, const std::atomic<bool>* stop, int64_t cases = 1);

}  // namespace oncard::explore
