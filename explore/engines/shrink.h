// Makes a failing schedule easier to read: fewer preemptions, then fewer steps.
// Deterministic. Tested by tests/explore/shrink_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "explore/engines/failure.h"
#include "explore/models/card_model.h"
#include "explore/models/problem.h"

namespace oncard::explore {

/// Maximum number of statements executed to simplify a schedule with a card; a longer failure is
/// not simplified.
inline constexpr int64_t kCardEffort = 500'000;

/// Preemptions of a schedule: switches away from a thread that could have continued.
int CountPreemptions(Model* model, const std::vector<uint8_t>& steps);

/// Executes the two statements of a race, which the steps of the failure have reached.
void TakeRacingStatements(const Problem& problem, Failure* failure);

/// A schedule that still leads to a fault, with as few preemptions, and then statements, as can be
/// reached by joining, shortening and removing turns of threads one by one; parts that do not
/// contribute to the fault are removed. `steps` must lead to a fault. Where the state graph is
/// known, FewestPreemptions() (state_graph.h) is exact instead. Once `hurried` is set from another
/// thread, the simplest schedule so far is taken.
Failure Shrink(const Problem& problem, const std::vector<uint8_t>& steps,
               const std::atomic<bool>* hurried = nullptr);
/// The same of an execution of the search of traces (dpor.h); if it leads to no fault, all threads
/// that run wait for ever, and nothing is removed.
Failure ShrinkExecution(const Problem& problem, const std::vector<uint8_t>& steps,
                        const std::atomic<bool>* hurried = nullptr);
/// The same with a card.
Failure ShrinkCard(CardModel* model, const std::vector<uint8_t>& steps,
                   const std::atomic<bool>* hurried = nullptr);

/// A schedule that was followed.
struct FollowedRun {
  Failure failure;     ///< the first failure; Failure::fault is none if there was none
  bool ended = false;  ///< the run ended
};

/// Executes the statements as far as the threads can, then the threads in turns.
FollowedRun TakeSteps(const Problem& problem, const std::vector<uint8_t>& steps);
/// The same with a card.
FollowedRun TakeCardSteps(CardModel* model, const std::vector<uint8_t>& steps);

}  // namespace oncard::explore
