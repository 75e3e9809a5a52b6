// The graph of all reachable states and its evaluation. The search terminates for every program
// with finitely many states, including loops that wait for another thread, and gives the exact
// minimum of preemptions or steps that lead to a state.
//
// Deterministic; not thread-safe. Tested by tests/explore/state_graph_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "base/large_array.h"
#include "explore/engines/progress.h"
#include "explore/models/model.h"

namespace oncard::explore {

struct KnownSteps;

/// Flags of a state. Those of the caller begin with kCallersFlag.
enum StateFlag : uint32_t {
  kTerminal = 1,  ///< no thread can run
  kBad = 2,       ///< set by the caller
  kCallersFlag = 4
};

struct StateGraph {
  static constexpr uint32_t kNone = ~uint32_t{0};

  int threads = 0;
  /// For state s and thread t: element s * threads + t; kNone if the thread cannot execute a step
  /// there. The first state is 0.
  LargeArray<uint32_t> successors;
  LargeArray<uint32_t> flags;
  int64_t transitions = 0;
  /// False if the search was ended early; some successors are then missing.
  bool complete = false;
  /// The steps that first led to a kBad state, if there is one: not the simplest ones.
  std::vector<uint8_t> way_to_bad;
  /// False if every step brings its thread nearer to its end.
  bool may_cycle = true;
  /// A state stands for all that differ only in an exchange of equal threads
  /// (StateLimits::symmetry): its steps are those of one of them, and only `way_to_bad` is a run of
  /// the program.
  bool symmetric = false;
  /// The search has ended because some run can go round in a circle (StateLimits::ends_at_cycle).
  bool found_cycle = false;

  uint32_t size() const { return static_cast<uint32_t>(flags.size()); }
  uint32_t Next(uint32_t state, int thread) const {
    return successors[size_t{state} * static_cast<size_t>(threads) + static_cast<size_t>(thread)];
  }
};

/// Maximum number of private statements that are merged with one; this also cuts loops of private
/// statements.
inline constexpr int64_t kMergedMax = 10'000;

struct StateLimits {
  uint32_t states = 200'000'000;
  /// How many more states are explored after the first one that is kBad.
  uint32_t states_after_bad = ~uint32_t{0};
  /// A step combines a statement with the following ones, and those at the thread's start, that
  /// access nothing shared: there are fewer states, with the same ends and minimum preemptions.
  bool merge_private = false;
  /// With `merge_private`: locals that cannot matter any more count as 0 (SearchStates()), where no
  /// requirement names a local.
  bool dead_locals = false;
  /// With `merge_private`: states that differ only in an exchange of equal threads count as one
  /// (models/equal_threads.h).
  bool symmetry = false;
  /// A search with equal threads ends as soon as it finds a circle of states.
  bool ends_at_cycle = false;
  /// Of a card: its states are kept as whole ones and every step is executed, which gives the same
  /// graph (models/card_rows.h).
  bool whole_states = false;
  /// Of a card: what is known of its steps from the searches of other cases (SearchReduced());
  /// nullptr: nothing.
  std::shared_ptr<KnownSteps> known_steps = {};
  /// Set from another thread: the search ends soon.
  const std::atomic<bool>* stop = nullptr;
  /// A further limit that another thread can lower, as long as no state is kBad; nullptr: none.
  const std::atomic<uint32_t>* most_while_good = nullptr;
  SearchProgress* progress = nullptr;
};

/// Called once for each state, in the order of their numbers; returns its flags except kTerminal.
using StateJudge = std::function<uint32_t(const Model& model)>;

/// The states that are judged.
enum class Judged : uint8_t {
  kEveryState,
  /// Those in which no thread can run or a thread has ended with an error; the others have no
  /// flags. The search is several times as fast where single threads have few states.
  kEnds
};

/// Explores from the model's current state, depth first, and leaves the model in that state. If
/// statements are merged, the first state is the one after all private statements at the threads'
/// starts, and the model forgets what cannot matter (Model::ForgetDeadLocals()).
StateGraph BuildStateGraph(Model* model, const StateLimits& limits, const StateJudge& judge,
                           Judged judged = Judged::kEveryState);

/// The threads of a path from the first state, one per step.
struct Path {
  bool found = false;
  std::vector<uint8_t> steps;
  int preemptions = 0;
  uint32_t start = 0;  ///< the state in which it begins
};

/// A path with the fewest preemptions, and among those with the fewest steps, to a state with one
/// of the flags; without passing or reaching states with a flag to `avoid`. A preemption is a
/// switch away from a thread that could have continued. Not found also if `hurried` is set from
/// another thread.
Path FewestPreemptions(const StateGraph& graph, uint32_t flag, uint32_t avoid = 0,
                       const std::atomic<bool>* hurried = nullptr);

/// A path with the fewest steps, from one of the first `starts` states.
Path FewestSteps(const StateGraph& graph, uint32_t flag, uint32_t starts = 1);

/// For every state the minimum of preemptions that reach it; bound + 1 if more are needed. `bound`:
/// 0 .. 254. Not known for all if `hurried` is set from another thread.
std::vector<uint8_t> PreemptionsTo(const StateGraph& graph, int bound,
                                   const std::atomic<bool>* hurried = nullptr);

/// A cycle that a fair schedule can repeat for ever: every thread that could run executes steps in
/// it.
struct Lasso {
  bool found = false;
  std::vector<uint8_t> stem;   ///< path to the first state of the cycle
  std::vector<uint8_t> cycle;  ///< path back to it
};
/// All states of the cycle have the flag; 0: any states. Not found also if `hurried` is set from
/// another thread.
Lasso FindFairCycle(const StateGraph& graph, const std::atomic<bool>* hurried = nullptr,
                    uint32_t flag = 0);

/// A flag for OweResponses(): the state owes a response.
inline constexpr uint32_t kOwing = 1u << 31;

/// The same graph with what a response still owes as a part of its states: a state with the flag
/// `left` owes one, up to a state with `right`. States that do have kOwing, and are kBad if no
/// thread can run. Empty if `hurried` is set from another thread.
StateGraph OweResponses(const StateGraph& graph, uint32_t left, uint32_t right,
                        const std::atomic<bool>* hurried = nullptr);

/// Strongly connected components of the states with the flag (0: of all): for each state the number
/// of its component; StateGraph::kNone without the flag. A component's successors have smaller
/// numbers. Not known for all if `hurried` is set from another thread.
std::vector<uint32_t> Components(const StateGraph& graph, uint32_t* count,
                                 const std::atomic<bool>* hurried = nullptr, uint32_t flag = 0);

/// True if some run never ends; false also if `hurried` is set from another thread.
bool IsCyclic(const StateGraph& graph, const std::atomic<bool>* hurried = nullptr);

/// How many steps of a path can be executed before no terminal state that is not bad can be reached
/// any more; -1 if none can be reached from the start.
int64_t LastEscape(const StateGraph& graph, const std::vector<uint8_t>& path);

}  // namespace oncard::explore
