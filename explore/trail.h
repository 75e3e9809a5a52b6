// What a schedule does, statement by statement, as reports show it.
// Tested by tests/explore/report_test.cc.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "explore/card_model.h"
#include "explore/explorer.h"
#include "explore/problem.h"

namespace oncard::explore {

/// What has been explored.
struct Subject {
  std::vector<ThreadSetup> threads;
  std::shared_ptr<const vm::Image> image;
  std::vector<Requirement> requirements;
};

Subject SubjectOf(const Problem& problem);
Subject SubjectOf(const CardModel& model);

/// One statement.
struct TrailStep {
  int thread = 0;  ///< index in Subject::threads
  int line = 0;    ///< of the source, 0 when unknown
  /// The globals that it read, as in `x = 3`; without a card.
  std::string read = {};
  /// The variable that it wrote, as in `x = 3`; empty when there is none.
  std::string written = {};
  double at_ms = -1;  ///< with a card: the cycle in which it is executed
};

/// A failure's statements, and those that then repeat for ever.
struct Trail {
  std::vector<TrailStep> steps;
  std::vector<TrailStep> cycle;
  /// The statement with which every end became bad, and one of another thread that touches the same
  /// variable; without a card, where the states are known.
  Race pair;
};

Trail Follow(const Problem& problem, const Failure& failure);
Trail Follow(CardModel* model, const Failure& failure);

}  // namespace oncard::explore
