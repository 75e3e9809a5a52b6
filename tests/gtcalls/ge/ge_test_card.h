// A GE card for command tests.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string_view>
#include <vector>

#include "gtcalls/ge/command_register.h"
#include "tests/gtcalls/family_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::ge {

class GeTestCard : public FamilyTestCard {
 public:
  /// One of the types in gep_card_types.def and ges_card_types.def.
  explicit GeTestCard(std::string_view name = "GE-800-PG") : FamilyTestCard(name) {}

  double Status(int axis) { return Read("GT_GetSts", {static_cast<double>(axis)}); }
  bool StatusBit(int axis, int bit) {
    return (static_cast<uint32_t>(Status(axis)) >> bit & 1) != 0;
  }

  /// A command that is refused with a code and a cause, and changes nothing but what says so.
  void Refuses(int16_t code, uint16_t cause, std::string_view name,
               const std::vector<double>& values = {}) {
    const uint64_t before = motion.Hash();
    EXPECT_EQ(Call(name, values), code) << name << ": " << reason.en;
    EXPECT_EQ(motion.Hash(), before) << name << " was refused and changed something";
    EXPECT_EQ(Cause(), cause) << name;
  }

  /// A time that is a multiple of a control cycle.
  void Run(double ms) {
    for (int i = 0; i < static_cast<int>(ms * 4); ++i) Cycle();
  }
  /// Until an axis rests; how long that takes, within a cycle.
  double RunToRest(int axis) {
    double ms = 0;
    for (; StatusBit(axis, 10) && ms < 100'000; ms += 0.25) Cycle();
    return ms;
  }
  /// Begins a move in mode T.
  void MoveT(int axis, double position, double velocity, double acceleration) {
    const double number = axis;
    Do("GT_PrflT", {number});
    Do("GT_SetPos", {number, position});
    Do("GT_SetVel", {number, velocity});
    Do("GT_SetAcc", {number, acceleration});
    Do("GT_Update", {number});
  }
  /// Drives an input of an axis, or a general one, until the card has accepted it.
  void SetInput(motion::DiType type, int bit, bool level) {
    ChangeState(motion).io.SetPin(type, bit, level);
    Run(2);
  }

  GeState& state() const { return card.state<GeState>(); }
};

}  // namespace oncard::gtcalls::ge
