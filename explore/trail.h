// What a failing schedule does, statement by statement, as reports show it.
// Tested by tests/explore/failure_test.cc and tests/explore/report_test.cc.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "explore/card_model.h"
#include "explore/explorer.h"
#include "explore/problem.h"
#include "runtime/step_log.h"
#include "runtime/trace.h"

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
  runtime::LoggedStep log;
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

/// What comes of one order of two racing statements.
struct RaceOrder {
  int first = 0;      ///< number of the thread that is first
  std::string after;  ///< `[x = 0] x = 2`: what they read, and what both touch after both
  /// The final values, as in `x = 2, y = 0`, of the globals that the two orders give different
  /// ones.
  std::string end;
};

/// A failure's statements, and those that then repeat for ever.
struct Trail {
  bool with_card = false;  ///< LoggedStep::at_ms says something
  std::vector<TrailStep> steps;
  std::vector<TrailStep> cycle;
  std::optional<RacingPair> pair;  ///< where the states are known
  Message actual;                  ///< `sum is 3, expected 10`; empty where there is nothing to say
  std::vector<RaceOrder> orders;   ///< of a data race: both, or none
  /// With a card: values over the failing run.
  std::optional<runtime::Trace> trace;
};

Trail Follow(const Problem& problem, const Failure& failure);
Trail Follow(CardModel* model, const Failure& failure);

}  // namespace oncard::explore
