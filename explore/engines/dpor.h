// Optimal dynamic partial order reduction: one execution for every Mazurkiewicz trace of a program
// that ends under every schedule, and no other.
//
// Two statements depend on each other when they are of one thread or touch a common shared cell
// that one of them writes. Executions that order all dependent statements alike are one trace; they
// pass through different states but end in the same one. The search executes a program once to its
// end, finds the races (dependent statements of two threads with nothing in between that orders
// them), and for each plans an execution in which they come the other way round. Wakeup trees keep
// these plans such that none leads to an execution that has been seen; sleep sets keep the search
// from coming back. Abdulla, Aronis, Jonsson and Sagonas, "Optimal dynamic partial order reduction"
// (POPL 2014) gives the algorithm and its proof.
//
// A step of the search is one statement that touches shared cells with all statements after it that
// do not.
// Deterministic; not thread-safe. Tested by tests/explore/dpor_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "explore/models/model.h"

namespace oncard::explore {

/// How a search ended, with what it did.
struct DporResult {
  int64_t executions = 0;  ///< to the end: one per trace
  /// Given up because every thread that could go on slept. Only parts of a search have such.
  int64_t blocked = 0;
  int64_t redundant = 0;  ///< whose trace another execution had; counted on request
  bool complete = false;  ///< everything was explored
  bool too_deep = false;  ///< an execution was longer than the limit; the search cannot go on
  int64_t steps = 0;      ///< statements executed
};

struct DporLimits {
  int64_t executions = INT64_MAX;
  /// Statements of one execution; a program that may run longer is not for this engine.
  int64_t depth = 1'000'000;
  /// Keeps keys of traces, the first 67 million, to count redundant executions.
  bool count_redundant = false;
  /// Set from another thread: the search ends soon.
  const std::atomic<bool>* stop = nullptr;
};

/// Steps that are still to be tried are trees. In a list of them each comes before what is planned
/// after it, however deep that is: a thread, and how many steps are planned directly after its own.
struct PlannedStep {
  uint8_t thread = 0;
  uint32_t next = 0;
  bool operator==(const PlannedStep&) const = default;
};

/// What an interrupted search knows of one state on its present path.
struct SavedFrame {
  /// Threads whose next step need not be tried here.
  std::vector<uint8_t> sleep;
  /// The first one is under way.
  std::vector<PlannedStep> plans;
  /// Earlier steps of the path with which the one under way races.
  std::vector<uint32_t> races = {};
  bool operator==(const SavedFrame&) const = default;
};

/// A part of a search: all traces that begin with the steps `prefix`, but for those that might as
/// well begin with the next step of a thread that sleeps then. The whole search has neither.
struct TraceUnit {
  std::vector<uint8_t> prefix;  ///< threads
  std::vector<uint8_t> sleep;   ///< threads
  /// Where it was interrupted; empty: it has not begun.
  std::vector<SavedFrame> frames = {};
  bool operator==(const TraceUnit&) const = default;
};

/// At least `count` units, if there are so many, that have every trace in exactly one of them:
/// always the same ones. A unit may have none; its search then ends with a blocked execution.
std::vector<TraceUnit> SplitTraces(Model* model, size_t count);

/// Called at the end of each execution with the model in its final state; false ends the search.
using FinalVisitor = std::function<bool(const Model& model)>;

/// Explores a unit from where it was interrupted, with the model at the start of the whole search,
/// and leaves it there. A search that ends early leaves in the unit where it was.
DporResult ExploreUnit(Model* model, TraceUnit* unit, const DporLimits& limits,
                       const FinalVisitor& visit);

/// Explores everything from the model's present state and leaves it there.
DporResult ExploreTraces(Model* model, const DporLimits& limits, const FinalVisitor& visit);

}  // namespace oncard::explore
