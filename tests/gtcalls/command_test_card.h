// A card for command tests: machine, motion core and the family's state combined as in the runtime,
// calls of commands by name, and a small program.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gtcalls/card.h"
#include "gtcalls/gts/catalogue.h"
#include "gtcalls/gts/family.h"
#include "motion/common/state_hash.h"
#include "vm/image.h"

namespace oncard::gtcalls::gts {

/// One argument of a call: a number, the cells behind a pointer, or NULL.
struct Argument {
  Argument(int number) : value(number) {}                     // NOLINT: implicit by design
  Argument(double number) : value(number) {}                  // NOLINT: implicit by design
  Argument(std::vector<double>* pointer) : cells(pointer) {}  // NOLINT: implicit by design
  Argument(std::nullptr_t) : null(true) {}                    // NOLINT: implicit by design
  Argument(const std::string& name) : text(name) {}           // NOLINT: implicit by design

  double value = 0;
  std::vector<double>* cells = nullptr;
  bool null = false;
  std::string text;
};

class CommandTestCard {
 public:
  explicit CommandTestCard(const motion::MotionConfig& config = {})
      : motion(GtsFamily().Configured(config)),
        commands(&card),
        machine(&commands),
        card{GtsFamily(), machine, motion, family_state} {}
  CommandTestCard(const CommandTestCard&) = delete;
  CommandTestCard& operator=(const CommandTestCard&) = delete;

  /// Calls a command as the host, or as a thread if `caller` says so.
  int16_t Call(const Command& command, const std::vector<Argument>& arguments,
               int caller = vm::kHostCaller) {
    std::vector<vm::CommandArgument> packed(arguments.size());
    for (size_t i = 0; i < arguments.size(); ++i) {
      packed[i].value = arguments[i].value;
      packed[i].null = arguments[i].null;
      if (arguments[i].cells != nullptr) packed[i].cells = *arguments[i].cells;
      if (command.parameters[i].passing == Passing::kText) {
        packed[i].host = const_cast<char*>(arguments[i].text.c_str());
      }
    }
    gtcalls::Call call{command, card, caller, packed, {}};
    const int16_t code = ExecuteCommand(call);
    reason = call.reason;
    EXPECT_EQ(reason.en.empty(), reason.zh.empty()) << command.name;
    if (command.name != "GT_LoadConfig") {  // which remarks on files that it has read
      EXPECT_EQ(reason.en.empty(), code == 0) << command.name << " gave " << code;
    }
    return code;
  }
  int16_t Call(std::string_view name, const std::vector<Argument>& arguments = {},
               int caller = vm::kHostCaller) {
    return Call(*GtsCatalogue().Find(name), arguments, caller);
  }

  /// Calls a command as the host and expects its code; a refused command must not change anything.
  void Expect(int16_t code, std::string_view name, const std::vector<Argument>& arguments = {}) {
    const uint64_t before = Hash();
    EXPECT_EQ(Call(name, arguments), code) << name << ": " << reason.en;
    if (code != 0) {
      EXPECT_EQ(Hash(), before) << name << " was refused and changed something";
    }
  }

  /// Links an object and loads it.
  void Load(const vm::Object& object) {
    auto image = vm::LinkObject(object, commands);
    ASSERT_TRUE(image.ok()) << image.error().message.en;
    machine.Load(image.value());
  }
  /// The program of TestProgram().
  void LoadTestProgram();

  /// One profile cycle in the order of the card, with 25 statements.
  void Cycle() {
    motion.Tick();
    card.family.after_tick(card);
    machine.BeginCycle(motion.state().cycle);
    card.family.before_threads(card);
    machine.Execute(25);
  }
  void Cycles(int count) {
    for (int i = 0; i < count; ++i) Cycle();
  }

  /// The hash of everything that a refused command must not change.
  uint64_t Hash() const {
    return machine.Hash() ^ (motion.Hash() * 3) ^ (HashOf(family_state) * 5);
  }
  GtsState& state() const { return card.state<GtsState>(); }

  motion::MotionCore motion;
  FamilyState family_state = GtsFamily().new_state();
  CardCommands commands;
  vm::Machine machine;
  Card card;
  Message reason;
};

/// Ids of the functions of TestProgram().
inline constexpr int kLoopFunction = 1;
inline constexpr int kIntFunction = 2;
inline constexpr int kDoubleFunction = 3;
inline constexpr int kFaultFunction = 4;

/// Globals: int g=0, double gd=1, int ga[3]=2..4.
///   1 int loop(int i=0, double d=1, int a[4]=2..5)   line 10: i = i + 1; line 11: goto line 10
///   2 int answer(double x=0, int y=1)                line 20: y = 41 + 1; line 21: return y
///   3 double half()                                  line 30: return 2.5
///   4 int fault(int z=0)                             line 40: z = 1 / z
inline vm::Object TestProgram() {
  using vm::DataType;
  using vm::ImmediateInt;
  using vm::Storage;
  constexpr vm::Variable kFirst{Storage::kLocal, 0};
  constexpr vm::Variable kSecond{Storage::kLocal, 1};
  const auto binary = [](vm::BinaryOperator op, vm::Operand a, vm::Operand b, vm::Operand dst) {
    return vm::Instruction{.opcode = vm::Opcode::kBinary,
                           .op = static_cast<uint16_t>(op),
                           .type = DataType::kInt,
                           .operands = {a, b, dst}};
  };
  const auto give = [](vm::Operand value) {
    return vm::Instruction{.opcode = vm::Opcode::kReturn, .operands = {ImmediateInt(1), value}};
  };
  vm::Object object;
  object.globals = {
      {"g", 0, DataType::kInt, 0}, {"gd", 1, DataType::kDouble, 0}, {"ga", 2, DataType::kInt, 3}};
  object.functions = {
      {.name = "loop",
       .file = "test.c",
       .return_type = DataType::kInt,
       .instructions = {binary(vm::BinaryOperator::kAdd, kFirst, ImmediateInt(1), kFirst),
                        {.opcode = vm::Opcode::kJump,
                         .operands = {ImmediateInt(1)},
                         .displacement = -1}},
       .lines = {10, 11},
       .variables = {{"i", 0, DataType::kInt, 0},
                     {"d", 1, DataType::kDouble, 0},
                     {"a", 2, DataType::kInt, 4}},
       .asserts = {}},
      {.name = "answer",
       .file = "test.c",
       .return_type = DataType::kInt,
       .instructions = {binary(vm::BinaryOperator::kAdd, ImmediateInt(41), ImmediateInt(1),
                               kSecond),
                        give(kSecond)},
       .lines = {20, 21},
       .variables = {{"x", 0, DataType::kDouble, 0}, {"y", 1, DataType::kInt, 0}},
       .asserts = {}},
      {.name = "half",
       .file = "test.c",
       .return_type = DataType::kDouble,
       .instructions = {give(vm::Immediate{5 << 15})},
       .lines = {30},
       .variables = {},
       .asserts = {}},
      {.name = "fault",
       .file = "test.c",
       .return_type = DataType::kInt,
       .instructions = {binary(vm::BinaryOperator::kDivide, ImmediateInt(1), kFirst, kFirst)},
       .lines = {40},
       .variables = {{"z", 0, DataType::kInt, 0}},
       .asserts = {}},
  };
  return object;
}

inline void CommandTestCard::LoadTestProgram() { Load(TestProgram()); }

}  // namespace oncard::gtcalls::gts
