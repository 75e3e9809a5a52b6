// Objects built by hand and a small command table, shared by the tests of object files.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "vm/command_table.h"
#include "vm/object.h"

namespace oncard::vm {

constexpr Variable Local(uint16_t id) { return {Storage::kLocal, id}; }
constexpr Variable Global(uint16_t id) { return {Storage::kGlobal, id}; }

/// The literal `raw` / 2^16.
constexpr Immediate Raw(int64_t raw) { return {raw}; }

Instruction Unary(UnaryOperator op, DataType type, const Operand& src, const Operand& dst);
Instruction Binary(BinaryOperator op, DataType type, const Operand& a, const Operand& b,
                   const Operand& dst);
Instruction Jump(const Operand& condition, int16_t displacement);
Instruction Return(const Operand& condition, const Operand& value);
Instruction Command(uint16_t number, std::vector<Operand> arguments);
/// An instruction with any operands, whether valid or not.
Instruction Malformed(Opcode opcode, uint16_t op, std::vector<Operand> operands);

/// Numbers of the commands that FakeCommands knows.
enum FakeCommand : uint16_t {
  kSetDo = 1,       // short value
  kSetVel = 2,      // short profile, double velocity
  kGetPos = 3,      // short axis, double* position, short count
  kSetTrapPrm = 4,  // short profile, structure of three doubles and an int
  kGetClock = 5,    // long* clock
  kOpen = 6,        // not for motion programs
  kFifteen = 7,     // fifteen shorts
  kSixteen = 8,     // sixteen shorts, more than a record can hold
  kLoad = 9,        // a text, which a motion program cannot have
  kReadPairs = 10,  // structure of an int and a double, count of them
};

/// Commands of every shape that the verifier distinguishes; executing them does nothing.
class FakeCommands final : public CommandTable {
 public:
  const CommandShape* Find(uint16_t number) const override;
  int16_t Execute(uint16_t number, Machine& machine, int thread,
                  std::span<CommandArgument> arguments) override;
};

/// Example 10-1 of the GTS manual with the statements on the lines of the vendor's object.
Object SumObject();

/// Arrays with every combination of storages, commands, two functions, one of them empty.
Object ArrayObject();

/// Structures and doubles of the narrow format.
Object StructureObject();

}  // namespace oncard::vm
