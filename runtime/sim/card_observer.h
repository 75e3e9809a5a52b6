// One who looks at a card while it runs: at the commands that it executes, and at what it does
// without one. It must not change the card. Tested by tests/runtime/supervisor_test.cc.
#pragma once

#include "gtcalls/card.h"
#include "motion/card_event.h"

namespace oncard::runtime {

class CardObserver : public gtcalls::CommandObserver {
 public:
  /// Something that the card did by itself (motion/card_event.h).
  virtual void Happened(const motion::CardEvent& event) = 0;
  /// A periodic thread has to start anew and still runs.
  virtual void Overran(int thread) = 0;
  /// The card has been reset.
  virtual void Reset() = 0;
};

}  // namespace oncard::runtime
