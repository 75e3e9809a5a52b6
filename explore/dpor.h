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

#include "explore/model.h"

namespace oncard::explore {

/// How a search ended, with what it did.
struct DporResult {
  int64_t executions = 0;  ///< to the end: one per trace
  int64_t blocked = 0;     ///< given up because every thread that could go on slept
  int64_t redundant = 0;   ///< whose trace another execution had; counted on request
  bool complete = false;   ///< everything was explored
  int64_t steps = 0;       ///< statements executed
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

/// Called at the end of each execution with the model in its final state; false ends the search.
using FinalVisitor = std::function<bool(const Model& model)>;

/// Explores from the model's present state and leaves it there.
DporResult ExploreTraces(Model* model, const DporLimits& limits, const FinalVisitor& visit);

}  // namespace oncard::explore
