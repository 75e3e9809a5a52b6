// Commands that the tests of axes, positions and modes often call. Axes are numbered from 1, as in
// the commands.
#pragma once

#include <string_view>
#include <vector>

#include "gtcalls/gts/defaults.h"
#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {

inline constexpr int kSmoothStop = 0x80;
inline constexpr int kAbruptStop = 0x100;
inline constexpr int kServoOn = 0x200;
inline constexpr int kMoving = 0x400;
inline constexpr int kInPosition = 0x800;

class AxisCommandCard : public CommandTestCard {
 public:
  explicit AxisCommandCard(const motion::MotionConfig& config = {.cycle_us = 1000})
      : CommandTestCard(config) {}

  /// The value of a command such as GT_GetPrfPos for one axis.
  double Read(std::string_view command, int axis = 1) {
    std::vector<double> value(1, -12345);
    EXPECT_EQ(Call(command, {axis, &value, 1, nullptr}), 0) << command;
    return value[0];
  }
  int Status(int axis = 1) { return static_cast<int>(Read("GT_GetSts", axis)); }

  /// Mode Trap at 1 pulse/ms^2 without smoothing, with a target and a velocity.
  void PrepareTrap(int axis, int target, double velocity) {
    std::vector<double> parameters = {1, 1, 0, 0};
    EXPECT_EQ(Call("GT_PrfTrap", {axis}), 0);
    EXPECT_EQ(Call("GT_SetTrapPrm", {axis, &parameters}), 0);
    EXPECT_EQ(Call("GT_SetPos", {axis, target}), 0);
    EXPECT_EQ(Call("GT_SetVel", {axis, velocity}), 0);
  }
  void PrepareJog(int axis, double velocity) {
    std::vector<double> parameters = {1, 1, 0};
    EXPECT_EQ(Call("GT_PrfJog", {axis}), 0);
    EXPECT_EQ(Call("GT_SetJogPrm", {axis, &parameters}), 0);
    EXPECT_EQ(Call("GT_SetVel", {axis, velocity}), 0);
  }
  int16_t Update(int axis) { return Call("GT_Update", {1 << (axis - 1)}); }
  /// PrepareTrap and GT_Update.
  void MoveTo(int axis, int target, double velocity) {
    PrepareTrap(axis, target, velocity);
    EXPECT_EQ(Update(axis), 0);
  }
  /// Cycles until the axis is at rest, at most ten seconds.
  void CyclesToRest(int axis = 1) {
    for (int i = 0; i < 10000 && (Status(axis) & kMoving) != 0; ++i) Cycle();
  }
  /// Sets a pin, counted from 0, and runs the cycles of its filter.
  void Drive(motion::DiType type, int bit, bool level) {
    motion.digital_io().SetPin(type, bit, level);
    Cycles(kDefaults.filter_ticks);
  }

  /// Expects that the call is refused with `code` and changes nothing.
  void ExpectRefused(int code, std::string_view command, const std::vector<Argument>& arguments) {
    const uint64_t before = Hash();
    EXPECT_EQ(Call(command, arguments), code) << command;
    EXPECT_EQ(Hash(), before) << command;
  }
};

}  // namespace oncard::gtcalls::gts
