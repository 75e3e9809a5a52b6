// A GE card for command tests: machine, motion core and the family's state combined as in the
// runtime, and calls of commands by name.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gtcalls/card.h"
#include "gtcalls/card_type.h"
#include "gtcalls/ge/command_register.h"
#include "motion/common/state_hash.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::ge {

class GeTestCard {
 public:
  /// One of the types in gep_card_types.def and ges_card_types.def.
  explicit GeTestCard(std::string_view name = "GE-800-PG")
      : family(*FindCard(name)->family),
        motion(ConfigOf(name)),
        commands(&card),
        machine(&commands) {}
  GeTestCard(const GeTestCard&) = delete;
  GeTestCard& operator=(const GeTestCard&) = delete;

  int16_t Call(std::string_view name, const std::vector<double>& values = {},
               std::vector<double>* cells = nullptr) {
    const Command& command = *family.catalogue.Find(name);
    std::vector<vm::CommandArgument> packed(command.parameters.size());
    size_t next = 0;
    for (size_t i = 0; i < packed.size(); ++i) {
      if (command.parameters[i].passing == Passing::kValue) {
        packed[i].value = values.at(next++);
      } else if (cells != nullptr) {
        packed[i].cells = *cells;
      } else {
        packed[i].null = true;
      }
    }
    gtcalls::Call call{command, card, vm::kHostCaller, packed, {}};
    const int16_t code = ExecuteCommand(call);
    reason = call.reason;
    // A command that succeeds may have a remark.
    EXPECT_TRUE(code == 0 || !reason.en.empty()) << name << " gave " << code;
    EXPECT_EQ(reason.en.empty(), reason.zh.empty()) << name;
    return code;
  }
  /// Calls a command that must succeed.
  void Do(std::string_view name, const std::vector<double>& values = {}) {
    EXPECT_EQ(Call(name, values), 0) << name << ": " << reason.en;
  }
  /// The only output of a command.
  double Read(std::string_view name, const std::vector<double>& values = {}) {
    std::vector<double> cell = {-12345};
    EXPECT_EQ(Call(name, values, &cell), 0) << name << ": " << reason.en;
    return cell[0];
  }
  double Status(int axis) { return Read("GT_GetSts", {static_cast<double>(axis)}); }
  bool StatusBit(int axis, int bit) {
    return (static_cast<uint32_t>(Status(axis)) >> bit & 1) != 0;
  }
  uint16_t Cause() { return static_cast<uint16_t>(Read("GT_GetCmdSts")); }

  /// A command that is refused with a code and a cause, and changes nothing but what says so.
  void Refuses(int16_t code, uint16_t cause, std::string_view name,
               const std::vector<double>& values = {}) {
    const uint64_t before = motion.Hash();
    EXPECT_EQ(Call(name, values), code) << name << ": " << reason.en;
    EXPECT_EQ(motion.Hash(), before) << name << " was refused and changed something";
    EXPECT_EQ(Cause(), cause) << name;
  }

  /// One control cycle, and a time that is a multiple of it.
  void Cycle() {
    motion.Tick();
    card.family.after_tick(card);
  }
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

  const Family& family;
  motion::MotionCore motion;
  FamilyState family_state = family.new_state();
  CardCommands commands;
  vm::Machine machine;
  Card card{family, machine, motion, family_state};
  Message reason;

 private:
  static motion::MotionConfig ConfigOf(std::string_view name) {
    const auto named = FindCard(name);
    motion::MotionConfig config;
    config.axis_count = named->type->axis_count;
    return named->family->Configured(config, named->type);
  }
};

}  // namespace oncard::gtcalls::ge
