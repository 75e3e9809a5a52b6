// The different ends of the runs of a card, as a search of its states finds them. Tested by
// tests/explore/card_cut_test.cc, card_steps_test.cc and reduced_search_test.cc.
#pragma once

#include <cstdint>

#include "explore/models/card_model.h"
#include "explore/models/ends.h"
#include "explore/models/key_set.h"

namespace oncard::explore {

class CardEnds {
 public:
  /// A state that is `finished`.
  void Add(const CardModel& model, const CardModel::State& end) {
    globals_.Insert(model.GlobalsKey(end));
    const bool added = full_.Insert(model.FinalKey(end));
    if (added && model.asks_nothing()) shown_.Add(EndOf(model, end));
  }

  /// How many there are by the globals alone, and with the return values of the threads.
  int64_t by_globals() const { return globals_.size(); }
  int64_t all() const { return full_.size(); }
  /// The smallest few, if nothing is required of results.
  const EndSet& shown() const { return shown_; }

 private:
  KeySet globals_;
  KeySet full_;
  EndSet shown_;
};

}  // namespace oncard::explore
