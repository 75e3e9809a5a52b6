// What a failing schedule does, statement by statement, as reports show it.
// Tested by tests/explore/failure_test.cc and tests/explore/report_test.cc.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "explore/models/card_model.h"
#include "explore/models/problem.h"
#include "explore/search/explorer.h"
#include "runtime/observe/step_log.h"
#include "runtime/observe/trace.h"

namespace oncard::explore {

/// The card with which a program was explored, as its scenario says.
struct CardConditions {
  int rate = 0;  ///< statements per ms
  int64_t cycle_us = 0;
  int axis_count = 0;
  int64_t limit_ms = 0;
  std::optional<int64_t> until_us;
  runtime::World world;
};

/// What has been explored, and what was asked of it.
struct Subject {
  std::vector<ThreadSetup> threads;
  std::shared_ptr<const vm::Image> image;
  std::vector<Requirement> requirements;
  // As Describe() (scenario_exploration.h) fills them in.
  std::string program = {};    ///< its file's name
  std::string scenario = {};   ///< its file's name; empty: a source with comments
  uint64_t scenario_hash = 0;  ///< of all that the scenario says but the program's place
  RaceRule races = RaceRule::kAny;
  std::vector<std::string> sync = {};
  std::optional<CardConditions> card = {};  ///< empty: variables alone, no time
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
  /// Statements before those of `steps`, of a run that is too long to be shown whole.
  int64_t skipped = 0;
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
