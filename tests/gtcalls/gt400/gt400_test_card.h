// A GT400 card for command tests.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string_view>
#include <vector>

#include "gtcalls/gt400/command_register.h"
#include "motion/common/state_hash.h"
#include "tests/gtcalls/family_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gt400 {

/// Bits of the status word.
enum StatusBitNumber {
  kBitComplete = 0,
  kBitBreakpoint = 2,
  kBitCaptured = 3,
  kBitMotionError = 4,
  kBitPositiveLimit = 5,
  kBitRefused = 7,
  kBitMoves = 10,
  kBitHomeArmed = 14,
  kBitIndexArmed = 15,
};

class Gt400TestCard : public FamilyTestCard {
 public:
  /// One of the types in card_types.def.
  explicit Gt400TestCard(std::string_view name = "GT-400-SV") : FamilyTestCard(name) {}

  uint32_t Status() { return static_cast<uint32_t>(Read("GT_GetSts")); }
  bool StatusBit(int bit) { return (Status() >> bit & 1) != 0; }

  /// A command that is refused with 1 and a cause, and changes no motion.
  void Refuses(CommandCause cause, std::string_view name, const std::vector<double>& values = {}) {
    const uint64_t before = motion.Hash();
    std::vector<double> cells(1);
    EXPECT_EQ(Call(name, values, &cells), 1) << name << ": " << reason.en;
    EXPECT_EQ(motion.Hash(), before) << name << " was refused and changed something";
    EXPECT_EQ(Cause(), cause) << name;
  }
  /// A command that is refused with 7: the card does not hear of it.
  void RefusesParameter(std::string_view name, const std::vector<double>& values) {
    const uint64_t before = Hash();
    std::vector<double> cells(8);
    EXPECT_EQ(Call(name, values, &cells), 7) << name << ": " << reason.en;
    EXPECT_EQ(Hash(), before) << name << " was refused and changed something";
  }

  /// Sample times.
  void Run(int cycles) {
    for (int i = 0; i < cycles; ++i) Cycle();
  }
  /// Until the current axis rests; how many sample times that takes.
  int RunToRest() {
    int cycles = 0;
    for (; StatusBit(10) && cycles < 1'000'000; ++cycles) Cycle();
    return cycles;
  }
  /// Enables an axis whose drive takes pulses; it becomes the current one, without events.
  void Enable(int axis) {
    Do("GT_Axis", {static_cast<double>(axis)});
    if (motion.config().defaults.closed_loop) Do("GT_CtrlMode", {1});
    Do("GT_AxisOn");
    Do("GT_ClrSts");
  }
  /// Begins a move of the current axis in mode T.
  void MoveT(double position, double velocity, double acceleration) {
    Do("GT_PrflT");
    Do("GT_SetPos", {position});
    Do("GT_SetVel", {velocity});
    Do("GT_SetAcc", {acceleration});
    Do("GT_Update");
  }
  /// Drives an input of an axis, or a general one, and lets the card see it.
  void SetInput(motion::DiType type, int bit, bool level) {
    ChangeState(motion).io.SetPin(type, bit, level);
    Cycle();
  }

  Gt400State& state() const { return card.state<Gt400State>(); }
  uint64_t Hash() const { return motion.Hash() ^ (HashOf(family_state) * 3); }
};

}  // namespace oncard::gtcalls::gt400
