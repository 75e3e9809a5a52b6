// What two threads can race for, as cells for vm/race_clocks.h and vm/race_history.h: the globals
// of a program, with their slots as numbers, and behind them what commands set. A command that sets
// an axis, a coordinate system or an output writes its cell; reading such a thing is no access.
//
//   axis                 also its profile, encoder, servo controller and pulse output
//   coordinate system    and with it each of its axes, when it is started or stopped
//   output               each bit of a word, each analogue output, those of extension modules
//
// Tested by tests/explore/race_steps_test.cc.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "runtime/observe/statement_access.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// Something that a statement does to a cell.
struct RaceStep {
  /// Reading a synchronising variable acquires, and writing it releases. In the order in which a
  /// statement does them: who acquires what it releases comes after all that it has accessed.
  enum class Kind : uint8_t { kAcquire, kRead, kWrite, kRelease };
  Kind kind = Kind::kRead;
  uint32_t cell = 0;
};

/// What the next statement of a running thread does, in order; element n of `sync` is true if the
/// global in slot n synchronises, missing ones are false.
std::vector<RaceStep> NextRaceSteps(const Controller& controller, int thread,
                                    const std::vector<bool>& sync);

/// True for a cell that commands set, false for a variable.
bool IsSetByCommands(uint32_t cell);
/// `axis 2`, `output 3 of word 12`; the name of a variable.
Message NameOfCell(uint32_t cell, const vm::Object& object);

/// The name of the command at a position in the function of a thread; empty for a statement without
/// one.
std::string_view CommandAt(const Controller& controller, int thread, int position);

/// A command that sets something, as it is named in sentences.
struct PlacedCommand {
  int thread = 0;
  int line = 0;
  std::string_view name;
};

/// `threads 0 and 1 both command axis 2: GT_SetVel in line 14, GT_Stop in line 31; nothing orders
/// them`; the thread with the smaller number comes first.
Message DescribeTwoOwners(uint32_t cell, const vm::Object& object, const PlacedCommand& one,
                          const PlacedCommand& other);

}  // namespace oncard::runtime
