// The graph of all reachable states, and what can be read off it: it ends for every program with
// finitely many states, loops that wait for another thread included, and answers exactly how few
// preemptions or steps lead to a state.
//
// Deterministic; not thread-safe. Tested by tests/explore/state_graph_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "explore/engines/progress.h"
#include "explore/models/model.h"

namespace oncard::explore {

/// What a state is, as bits. The caller's own begin with kCallersFlag.
enum StateFlag : uint32_t {
  kTerminal = 1,  ///< no thread can go on
  kBad = 2,       ///< the caller says so
  kCallersFlag = 4
};

struct StateGraph {
  static constexpr uint32_t kNone = ~uint32_t{0};

  int threads = 0;
  /// Of state s and thread t: element s * threads + t; kNone when the thread cannot step there. The
  /// first state is 0.
  std::vector<uint32_t> successors;
  std::vector<uint32_t> flags;
  int64_t transitions = 0;
  /// False when the search was ended early; some successors are then missing.
  bool complete = false;

  uint32_t size() const { return static_cast<uint32_t>(flags.size()); }
  uint32_t Next(uint32_t state, int thread) const {
    return successors[size_t{state} * static_cast<size_t>(threads) + static_cast<size_t>(thread)];
  }
};

/// Private statements that are merged with one; a loop of nothing else is then cut.
inline constexpr int64_t kMergedMax = 10'000;

struct StateLimits {
  uint32_t states = 200'000'000;
  /// How many more states are looked at after the first that is kBad.
  uint32_t states_after_bad = ~uint32_t{0};
  /// A step is a statement with all after it, and those at the thread's start, that touch nothing
  /// shared: there are fewer states, and the same ends with as few preemptions.
  bool merge_private = false;
  /// Set from another thread: the search ends soon.
  const std::atomic<bool>* stop = nullptr;
  SearchProgress* progress = nullptr;
};

/// Called once for each state, in the order of their numbers: its flags but for kTerminal.
using StateJudge = std::function<uint32_t(const Model& model)>;

/// Explores from the model's present state, depth first, and leaves it there. When statements are
/// merged, the first state is that behind all private statements at the threads' starts.
StateGraph BuildStateGraph(Model* model, const StateLimits& limits, const StateJudge& judge);

/// The threads of a path from the first state, one per step.
struct Path {
  bool found = false;
  std::vector<uint8_t> steps;
  int preemptions = 0;
};

/// A path with the fewest preemptions, and among those with the fewest steps, to a state with one
/// of the flags; not through, or to, states with a flag to `avoid`. A preemption is a change of
/// threads while the one before could have gone on.
Path FewestPreemptions(const StateGraph& graph, uint32_t flag, uint32_t avoid = 0);

/// A path with the fewest steps.
Path FewestSteps(const StateGraph& graph, uint32_t flag);

/// Of every state the fewest preemptions that reach it, bound + 1 when more are needed.
std::vector<int> PreemptionsTo(const StateGraph& graph, int bound);

/// A cycle that a fair schedule can follow for ever: every thread that could go on takes steps in
/// it.
struct Lasso {
  bool found = false;
  std::vector<uint8_t> stem;   ///< to the cycle's first state
  std::vector<uint8_t> cycle;  ///< back to it
};
Lasso FindFairCycle(const StateGraph& graph);

/// Strongly connected components: of each state its number. A component's successors have smaller
/// numbers.
std::vector<uint32_t> Components(const StateGraph& graph, uint32_t* count);

/// True when some run never ends.
bool IsCyclic(const StateGraph& graph);

/// How many steps of a path can be taken before no terminal state that is not bad can be reached
/// any more; -1 when there is none from the start.
int64_t LastEscape(const StateGraph& graph, const std::vector<uint8_t>& path);

}  // namespace oncard::explore
