// What a schedule does, statement by statement, as reports show it.
// Tested by tests/explore/report_test.cc.
#pragma once

#include <memory>
#include <optional>
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

/// The statement with which every end became bad, and the nearest one of another thread that
/// depends on it: a later one if there is any, since the other order would have taken that first.
struct RacingPair {
  struct Statement {
    size_t step = 0;  ///< index in Trail::steps
    bool writes = false;
  };
  std::string what;  ///< that both touch: `x`, `axis 1`
  Statement first;
  Statement second;
};

/// A failure's statements, and those that then repeat for ever.
struct Trail {
  std::vector<TrailStep> steps;
  std::vector<TrailStep> cycle;
  std::optional<RacingPair> pair;  ///< where the states are known
};

Trail Follow(const Problem& problem, const Failure& failure);
Trail Follow(CardModel* model, const Failure& failure);

}  // namespace oncard::explore
