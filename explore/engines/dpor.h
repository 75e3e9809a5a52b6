// Optimal dynamic partial order reduction: one execution for every Mazurkiewicz trace of a program
// that ends under every schedule, and no other.
//
// Two statements depend on each other if they belong to the same thread, or access a common shared
// cell that one of them writes. Executions with the same order of all dependent statements are one
// trace: they pass through different states but end in the same one. The search executes a program
// once to its end, finds the races (dependent statements of two threads with nothing in between
// that orders them), and for each plans an execution with the opposite order. Wakeup trees hold
// these plans so that none leads to an execution that has been seen; sleep sets prevent the search
// from repeating executions. Abdulla, Aronis, Jonsson and Sagonas, "Optimal dynamic partial order
// reduction" (POPL 2014) gives the algorithm and its proof.
//
// A step of the search is one statement that accesses shared cells, together with the following
// statements that do not. Executions of few steps are searched by short_traces.h, in the same
// order.
//
// A thread that has executed a pass of a loop in which it waits (waiting_loop.h) executes the next
// one only after another thread has written what the loop reads. What is left out are passes that
// change nothing. So an execution ends also when all threads that run wait for ever; its last state
// is the end of no run. No thread disables another one, and where a write enables a thread, its
// order with that thread's step cannot be reversed: this is all that the algorithm needs to know.
// Deterministic; not thread-safe. Tested by tests/explore/dpor_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "explore/models/model.h"

namespace oncard::explore {

/// The result and the counts of a search.
struct DporResult {
  int64_t executions = 0;  ///< executed to the end: one per trace
  /// Abandoned because every thread that could run was asleep. Only parts of a search have such
  /// executions.
  int64_t blocked = 0;
  int64_t redundant = 0;  ///< executions of a trace already seen; counted on request
  bool complete = false;  ///< everything was explored
  bool too_deep = false;  ///< an execution was longer than the limit; the search cannot continue
};

struct DporLimits {
  int64_t executions = INT64_MAX;
  /// Maximum number of statements of one execution; this engine cannot explore programs that may
  /// run longer.
  int64_t depth = 1'000'000;
  /// Stores identifiers of the first 67 million traces to count redundant executions.
  bool count_redundant = false;
  /// Does not use the faster search of short executions (short_traces.h), whose results are the
  /// same.
  bool general = false;
  /// Set from another thread: the search ends soon.
  const std::atomic<bool>* stop = nullptr;
};

/// Planned steps form trees, listed in preorder: a thread, and the number of steps that are planned
/// directly after its own.
struct PlannedStep {
  uint8_t thread = 0;
  uint32_t next = 0;
  bool operator==(const PlannedStep&) const = default;
};

/// The data of an interrupted search about one state of its current path.
struct SavedFrame {
  /// Sleeping threads: their next step need not be explored here.
  std::vector<uint8_t> sleep;
  /// The first tree is being explored.
  std::vector<PlannedStep> plans;
  /// Earlier steps of the path with which the current one races.
  std::vector<uint32_t> races = {};
  bool operator==(const SavedFrame&) const = default;
};

/// A part of a search: all traces that begin with the steps `prefix`, except those that are
/// equivalent to one that begins with the next step of a sleeping thread. For the whole search both
/// are empty.
struct TraceUnit {
  std::vector<uint8_t> prefix;  ///< threads
  std::vector<uint8_t> sleep;   ///< threads
  /// The path at the interruption; empty: the search has not begun.
  std::vector<SavedFrame> frames = {};
  bool operator==(const TraceUnit&) const = default;
};

/// At least `count` units, if there are as many, that contain every trace exactly once; always the
/// same units. A unit can be without traces; its search then ends with a blocked execution.
std::vector<TraceUnit> SplitTraces(Model* model, size_t count);

/// An execution that has ended, as long as it is visited.
class TraceEnd {
 public:
  static constexpr uint32_t kNoNumber = ~uint32_t{0};

  TraceEnd() = default;
  TraceEnd(const TraceEnd&) = delete;
  TraceEnd& operator=(const TraceEnd&) = delete;
  virtual ~TraceEnd() = default;

  /// The final state; threads that run there wait for ever. Its steps are only known to Threads().
  virtual const Model& State() = 0;
  /// Within one call of ExploreUnit() equal numbers belong to equal final states; kNoNumber if that
  /// is not known. They are small enough to index a vector.
  virtual uint32_t StateNumber() = 0;
  /// Number of statements.
  virtual int64_t Statements() const = 0;
  /// The thread of each statement.
  virtual std::vector<uint8_t> Threads() const = 0;
};

/// Called at the end of each execution; false ends the search.
using FinalVisitor = std::function<bool(TraceEnd* end)>;

/// Explores a unit from the point of its interruption. The model must be at the start of the whole
/// search, and is left there. A search that ends early stores its progress in the unit.
DporResult ExploreUnit(Model* model, TraceUnit* unit, const DporLimits& limits,
                       const FinalVisitor& visit);

/// Explores everything from the model's current state, and leaves the model in that state.
DporResult ExploreTraces(Model* model, const DporLimits& limits, const FinalVisitor& visit);

}  // namespace oncard::explore
