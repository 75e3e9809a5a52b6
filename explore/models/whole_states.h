// Whole states of a card (CardModel::State) for searches that can have rows instead
// (models/card_steps.h): the same functions. Tested by tests/explore/card_steps_test.cc.
#pragma once

#include <cstdint>

#include "explore/models/card_model.h"
#include "explore/models/state_key.h"
#include "runtime/observe/lasting_access.h"

namespace oncard::explore {

class WholeStates {
 public:
  using State = CardModel::State;

  explicit WholeStates(CardModel* model) : model_(*model) {}

  static bool exact() { return true; }
  State Start() { return model_.Start(); }
  static const State& From(const State& state) { return state; }
  State Step(const State& state, int thread) { return model_.Step(state, thread); }
  State EndCycle(const State& state) { return model_.EndCycle(state); }
  StateKey KeyOf(const State& state) const { return model_.KeyOf(state); }
  static uint32_t ChoicesOf(const State& state) { return state.choices; }
  bool MayEndCycle(const State& state) const { return model_.MayEndCycle(state); }
  static bool Ended(const State& state) { return state.ended; }
  static int64_t CycleOf(const State& state) { return CardModel::CycleOf(state); }
  static const State& Program(const State& state) { return state; }
  static const State& Whole(const State& state) { return state; }
  runtime::StatementAccess NewLastingAccess(const State& state, int thread) {
    model_.Load(state);
    return runtime::NextLastingAccess(model_.controller(), model_.setup(thread).thread);
  }

 private:
  CardModel& model_;
};

}  // namespace oncard::explore
