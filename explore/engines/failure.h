// How a problem goes wrong under some schedule.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "explore/models/card_model.h"
#include "explore/models/problem.h"

namespace oncard::explore {

struct Failure {
  bool livelock = false;
  Fault fault;                 ///< none for a livelock
  std::vector<uint8_t> steps;  ///< threads of the model, one per statement
  std::vector<uint8_t> cycle;  ///< livelock: what then repeats for ever
  int preemptions = 0;
  bool fewest_preemptions = false;  ///< no schedule with fewer fails
  int64_t fewest_steps = 0;         ///< of any failing schedule; 0 when not known
  /// Statements after which a good end could still be reached; -1 when not known.
  int64_t last_escape = -1;
  /// Of a long run with a card: a state on the way, and the statements before it, so that its end
  /// can be shown without the rest.
  std::shared_ptr<const CardModel::State> late;
  int64_t late_steps = 0;
};

}  // namespace oncard::explore
