// Locals of a thread whose values can no longer be read, and those of a thread that has ended. They
// count as 0, so that states which differ only in them are one.
//
// Which ones they are is known from the code, except that a command which is refused does not write
// its outputs: what they had before can then still be read. That a command writes all its outputs
// is believed until it is seen not to, as with what statements access (cycle_accesses.h).
// Slots that a requirement, an assert or a reaction names always count.
//
// Deterministic; not thread-safe. Tested by tests/explore/dead_locals_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "explore/models/card_model.h"
#include "explore/models/card_steps.h"
#include "explore/models/live_locals.h"
#include "vm/object.h"

namespace oncard::explore {

class DeadLocals {
 public:
  using Row = CardRows::Row;

  /// `rows` are those of the model, in which no command changes the data page of its thread.
  DeadLocals(const CardModel& model, CardSteps* rows);

  /// From now on commands write all their outputs, except those that have been seen not to.
  void Begin();
  /// True if another one has been seen since then.
  bool grown() const { return grown_; }

  /// Looks at the next statement of a thread before it is executed.
  void LookAt(const Row& row, size_t place);
  /// Sets the locals of a thread to 0 that are dead.
  void Forget(size_t place, Row* row);

 private:
  struct OfThread {
    size_t function = 0;
    uint8_t page = 0;
    LocalSlots named;
    /// Of each statement: its command has been seen not to write its outputs.
    std::vector<bool> unsure;
    std::vector<LocalSlots> dead;     ///< before each statement, and behind the last one
    std::vector<uint32_t> forgotten;  ///< by the number of a thread: that without dead locals
  };

  std::vector<LocalSlots> DeadIn(const OfThread& thread) const;
  uint32_t WithoutDead(const OfThread& thread, uint32_t number) const;

  const vm::Object& object_;
  CardSteps& rows_;
  bool shares_pages_ = false;
  std::vector<OfThread> threads_;  ///< by their places
  bool grown_ = false;
};

}  // namespace oncard::explore
