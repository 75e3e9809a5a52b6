// A card of any family for command tests: machine, motion core and the family's state combined as
// in the runtime, and calls of commands by name. The test cards of families with registers of their
// own are derived from it.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gtcalls/card.h"
#include "gtcalls/card_type.h"

namespace oncard::gtcalls {

class FamilyTestCard {
 public:
  /// A type of cards, as scenarios name it.
  explicit FamilyTestCard(std::string_view name)
      : family(*FindCard(name)->family),
        motion(ConfigOf(name)),
        commands(&card),
        machine(&commands) {}
  FamilyTestCard(const FamilyTestCard&) = delete;
  FamilyTestCard& operator=(const FamilyTestCard&) = delete;

  /// A command that waits for the next tick gets it.
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
    int16_t code = ExecuteCommand(call);
    while (call.waits) {
      Cycle();
      code = ResumeCommand(call);
    }
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
  /// The command register.
  uint16_t Cause() { return static_cast<uint16_t>(Read("GT_GetCmdSts")); }

  /// One control cycle.
  void Cycle() {
    motion.Tick();
    card.family.after_tick(card);
  }

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

}  // namespace oncard::gtcalls
