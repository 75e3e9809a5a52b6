// Makes a failing schedule easier to read: fewer preemptions, then fewer steps.
// Deterministic. Tested by tests/explore/shrink_test.cc.
#pragma once

#include <cstdint>
#include <vector>

#include "explore/engines/failure.h"
#include "explore/models/card_model.h"
#include "explore/models/problem.h"

namespace oncard::explore {

/// Statements that may be spent on finding a simpler schedule with a card; a longer failure stays
/// as it is.
inline constexpr int64_t kCardEffort = 500'000;

/// Preemptions of a schedule: changes of threads while the one before could have gone on.
int CountPreemptions(Model* model, const std::vector<uint8_t>& steps);

/// Takes the two statements of a race, at which the failure's steps have arrived.
void TakeRacingStatements(const Problem& problem, Failure* failure);

/// A schedule that still leads to a fault, with as few preemptions, and then statements, as
/// joining, shortening and leaving out turns of threads one by one can reach: what has nothing to
/// do with the fault goes. `steps` leads to a fault. Where the state graph is known,
/// FewestPreemptions() (state_graph.h) is exact instead.
Failure Shrink(const Problem& problem, const std::vector<uint8_t>& steps);
/// The same with a card.
Failure ShrinkCard(CardModel* model, const std::vector<uint8_t>& steps);

/// A schedule that was followed.
struct FollowedRun {
  Failure failure;     ///< what went wrong first; Failure::fault is none when nothing did
  bool ended = false;  ///< it came to its end
};

/// Takes the statements as far as the threads can, then lets the threads go on in turns.
FollowedRun TakeSteps(const Problem& problem, const std::vector<uint8_t>& steps);
/// The same with a card.
FollowedRun TakeCardSteps(CardModel* model, const std::vector<uint8_t>& steps);

}  // namespace oncard::explore
