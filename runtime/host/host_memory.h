// The memory of a card that survives power-off, between two hosts: a file that ONCARD_MRAM or the
// key `mram` of the scenario names. Without one the memory of every card is clear when it is
// opened. The file is read when the card is opened, and written when it is closed or its host ends,
// if the memory has changed. Tested by tests/tools/exec_memory_test.cc.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// The file of one card while it is open.
class CardMemory {
 public:
  /// `before`: the memory when the card is switched on.
  CardMemory(std::string path, std::string before)
      : path_(std::move(path)), before_(std::move(before)) {}

  /// The memory of a card that is switched off; nothing is written if it is as it was.
  Result<void> Keep(const Controller& controller) const;

 private:
  std::string path_;
  std::string before_;
};

/// Reads the file of a card into Scenario::memory. The first card, number 0, has the file that is
/// named; card n has the one with `.n` after its name. Empty if none is named; no file yet is a
/// clear memory. Fails if the file cannot be read, or is not such a file.
Result<std::optional<CardMemory>> TakeMemory(int card, Scenario* scenario);

}  // namespace oncard::runtime
