// Small programs for the tests of the machine: functions built from instructions and linked without
// symbols, so that every slot can be used with any type, and the few commands that act on threads.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tests/vm/object_samples.h"
#include "vm/command_table.h"
#include "vm/image.h"
#include "vm/machine.h"

namespace oncard::vm {

/// Numbers of the commands that ThreadCommands knows.
enum ThreadCommand : uint16_t {
  kDelay = 1,      // long cycles
  kWaitFor = 2,    // long* variable, long value
  kUsePage = 3,    // short page
  kAddToEach = 4,  // long* values, short count, long amount; 7 for a negative count
  kHalve = 5,      // double* value
  kRefuse = 6,     // long* value: sets it and refuses, so that it must not change
};

/// The return code of the command that refuses.
inline constexpr int16_t kRefuseCode = 9;

class ThreadCommands final : public CommandTable {
 public:
  const CommandShape* Find(uint16_t number) const override;
  int16_t Execute(uint16_t number, Machine& machine, int thread,
                  std::span<CommandArgument> arguments) override;
};

// For tables of places.
inline constexpr Storage kL = Storage::kLocal;
inline constexpr Storage kG = Storage::kGlobal;

inline const Immediate kAlways = ImmediateInt(1);

/// `goto` over `displacement` instructions.
Instruction Goto(int16_t displacement);
/// `dst = src;` for ints.
Instruction Set(const Operand& dst, const Operand& src);
/// `dst = a + b;` for ints.
Instruction Add(const Operand& dst, const Operand& a, const Operand& b);

/// A function whose statement k (from 0) is on line 10 * (k + 1).
Function MakeFunction(std::vector<Instruction> instructions, DataType return_type = DataType::kInt);
Object MakeObject(std::vector<Function> functions);

/// Links an object that declares no variables; an invalid one makes the test fail.
std::shared_ptr<const Image> LinkRecords(const Object& object, const CommandTable& commands);

/// A machine with ThreadCommands.
class MachineTest : public testing::Test {
 protected:
  /// Loads functions; the first one has id 1.
  void Load(std::vector<Function> functions);
  /// Binds function `id` to `thread` with the page of the same number and runs it.
  void Start(int thread, int id = 1);
  /// Loads one function and starts it on thread 0.
  void LoadAndStart(std::vector<Instruction> instructions);

  int32_t LocalInt(int page, uint16_t id) const;
  int32_t GlobalInt(uint16_t id) const;
  void SetLocalInt(int page, uint16_t id, int32_t value);
  void SetGlobalInt(uint16_t id, int32_t value);

  ThreadCommands commands_;
  Machine machine_{&commands_};
};

}  // namespace oncard::vm
