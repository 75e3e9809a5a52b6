// The number of Mazurkiewicz traces of a program that ends under every schedule, without an
// execution for each.
//
// A search with sleep sets alone completes exactly one execution of every trace (P. Godefroid,
// "Partial-Order Methods for the Verification of Concurrent Systems", 1996): after a thread's step,
// those threads sleep whose next step was tried before it, here or earlier, and is independent of
// it. What such a search completes from a state is determined by the state and the threads that
// sleep in it, so it is counted once for every such pair and remembered:
//
//   count(state, sleep) = 1 if no thread runs, otherwise the sum, over the threads t that run and
//   do not sleep, in order, of count(state after t, {u in sleep or tried before t: the steps of u
//   and t are independent})
//
// There are far fewer pairs than traces where many orders lead to the same states. States are told
// apart only by what matters from there on (thread_future.h): not by a local that is written before
// it is read again. If a thread sleeps whose next step is independent of all that others may still
// do, it never wakes, so the count is 0.
//
// A program has an endless run exactly if a pair is met again while it is being counted: of every
// run, the search begins one that is equivalent, or it has put a step of a thread before it that
// the run lacks. So some are as long as one likes, while the number of pairs is limited. Steps are
// those of dpor.h, and so is the count.
//
// Deterministic; not thread-safe. Tested by tests/explore/trace_count_test.cc.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "explore/models/model.h"

namespace oncard::explore {

struct TraceCountLimits {
  /// Maximum number of pairs. Each takes up to 150 bytes, and each different state some more.
  size_t pairs = size_t{1} << 20;
  /// Every run must have fewer statements.
  int64_t depth = 1'000'000;
  /// Ends that differ in locals alone are different; otherwise one of them is visited.
  bool tells_locals = false;
  /// Set from another thread: the search ends soon, without a count.
  const std::atomic<bool>* stop = nullptr;
};

struct TraceCount {
  int64_t traces = 0;
  size_t pairs = 0;  ///< different pairs of a state and the threads that sleep in it
};

/// Called with every different final state, rarely with one again; false ends the search.
using CountVisitor = std::function<bool(const Model& end)>;

/// Counts the traces from the model's current state, which must be its start (Model::depth()).
/// Empty: a limit was reached, the visitor or `stop` has ended the search, a run does not end,
/// there are more than INT64_MAX traces, or the program is none of those whose steps can be
/// remembered (step_model.h).
std::optional<TraceCount> CountTraces(const Model& model, const TraceCountLimits& limits,
                                      const CountVisitor& visit);

}  // namespace oncard::explore
