// How a problem fails under some schedule.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "explore/models/card_model.h"
#include "explore/models/problem.h"

namespace oncard::explore {

struct Failure {
  bool livelock = false;  ///< the run never ends
  Fault fault;            ///< of a run that never ends: a response that it never gives, or none
  std::vector<uint8_t> steps;  ///< threads of the model, one for each statement
  std::vector<uint8_t> cycle;  ///< livelock: the cycle that then repeats for ever
  int preemptions = 0;
  bool fewest_preemptions = false;  ///< no schedule with fewer fails
  int64_t fewest_steps = 0;         ///< of any failing schedule; 0 if not known
  /// Number of statements after which a correct end could still be reached; -1 if not known.
  int64_t last_escape = -1;
  /// Of a long run with a card: an intermediate state, and the number of statements before it, so
  /// that the end of the run can be shown without the rest.
  std::shared_ptr<const CardModel::State> late;
  int64_t late_steps = 0;
};

}  // namespace oncard::explore
