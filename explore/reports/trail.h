// A failing schedule, statement by statement, as reports show it. Tested by
// tests/explore/failure_test.cc and tests/explore/report_test.cc.
#pragma once

#include <array>
#include <cstdint>
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

/// The card with which a program was explored, from its scenario.
struct CardConditions {
  int rate = 0;  ///< statements per ms
  int64_t cycle_us = 0;
  int axis_count = 0;
  int64_t limit_ms = 0;
  std::optional<int64_t> until_us;
  runtime::World world;
};

/// The explored program and its requirements.
struct Subject {
  std::vector<ThreadSetup> threads;
  std::shared_ptr<const vm::Image> image;
  std::vector<Requirement> requirements;
  std::shared_ptr<const HostEvents> host = {};  ///< nullptr: no recorded host
  // Filled in by Describe() (scenario_exploration.h).
  std::string program = {};    ///< its file's name
  std::string scenario = {};   ///< its file's name; empty: a source with comments
  std::string record = {};     ///< the file's name of the host's record; empty: no recorded host
  uint64_t scenario_hash = 0;  ///< of the scenario without the program's path, or of the record
  RaceRule races = RaceRule::kAny;
  std::vector<std::string> sync = {};
  bool endless = false;                     ///< the scenario's key
  bool may_last = false;                    ///< a run that never ends is no failure
  bool may_deadlock = false;                ///< nor is one whose threads wait for ever
  std::optional<CardConditions> card = {};  ///< empty: only variables, no time
};

Subject SubjectOf(const Problem& problem);
Subject SubjectOf(const CardModel& model);

/// One statement.
struct TrailStep {
  int thread = 0;  ///< index in Subject::threads
  runtime::LoggedStep log;
};

/// A call of a recorded host that changes the card.
struct HostStep {
  size_t before = 0;  ///< index of the statement that it precedes; their number: none
  double at_ms = 0;
  std::string call;  ///< `GT_SetVarValue(0, pVarInfo, pValue, 1)` with its inputs
};

/// The statement after which every continuation fails, and the nearest dependent one of another
/// thread: a later one if there is any, because the other order would have executed that first. One
/// that contributed to the failure comes before one that did not, and synchronising variables last.
struct RacingPair {
  struct Statement {
    size_t step = 0;  ///< index in Trail::steps
    bool writes = false;
  };
  std::string what;  ///< the resource that both access: `x`, `axis 1`
  Statement first;
  Statement second;
};

/// The result of one order of two racing statements.
struct RaceOrder {
  int first = 0;  ///< number of the thread that is first
  std::string
      after;  ///< `[x = 0] x = 2`: the values that they read, and the common variable after both
  /// The final values, as in `x = 2, y = 0`, of the globals for which the two orders differ.
  std::string end;
  /// Threads of the model: those of the statements up to the end, or of as many as are shown.
  std::vector<uint8_t> schedule = {};
  std::array<size_t, 2> racing = {};  ///< the two statements, as indices in `schedule`
  std::vector<TrailStep> steps = {};  ///< the statements of `schedule`
};

/// The statements of a failure, and those that then repeat for ever.
struct Trail {
  bool with_card = false;  ///< LoggedStep::at_ms is meaningful
  /// Number of statements before `steps`, for a run that is too long to be shown completely.
  int64_t skipped = 0;
  std::vector<TrailStep> steps;
  std::vector<bool> matters;  ///< for each of them: it contributed to the failure (relevance.h)
  std::vector<TrailStep> cycle;
  std::vector<HostStep> host;      ///< what the host does between these steps
  std::optional<RacingPair> pair;  ///< only if the states are known
  Message starvation;              ///< of a livelock (starvation.h); empty if it is none
  Message actual;                  ///< `sum is 3, expected 10`; empty if there are no values
  /// Of a response that is not given: the step after which its left side held.
  std::optional<size_t> unanswered;
  std::vector<RaceOrder> orders;  ///< of a data race: both, or none
  /// With a card: the trace of the failing run.
  std::optional<runtime::Trace> trace;
};

Trail Follow(const Problem& problem, const Failure& failure);
Trail Follow(CardModel* model, const Failure& failure);

}  // namespace oncard::explore
