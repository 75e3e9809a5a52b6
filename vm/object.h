// A motion program as its compiler knows it and its object files (`X.bin` with `X.ini`) hold it:
// functions of one-statement instructions over numbered variables, and the symbols that name them.
// The compiler builds an Object, object_writer.h turns it into the two files, object_reader.h reads
// them back, verifier.h decides whether it may run, image.h turns it into what the machine
// executes.
//
// A plain value: copyable, no identity, nothing hidden. docs/object-format.md gives the bytes.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "vm/fixed_point.h"
#include "vm/opcodes.h"

namespace oncard::vm {

/// Where a variable lives, numbered as in the records: the thread's data page, or the globals.
enum class Storage : uint16_t { kLocal = 1, kGlobal = 3 };

/// One slot: a scalar, a structure's member, or an array's element with a constant index.
struct Variable {
  Storage storage = Storage::kLocal;
  uint16_t id = 0;
  bool operator==(const Variable&) const = default;
};

/// An array's element with a variable index, checked against `size` when it runs.
struct Element {
  Storage storage = Storage::kLocal;
  uint16_t base = 0;  ///< id of element 0
  uint16_t size = 0;
  Variable index;  ///< an int
  bool operator==(const Element&) const = default;
};

/// A literal: a raw 32.16 number, so an int literal n is n * 2^16.
struct Immediate {
  int64_t raw = 0;
  bool operator==(const Immediate&) const = default;
};

/// The int literal `value`.
constexpr Immediate ImmediateInt(int32_t value) {
  return {static_cast<int64_t>(value) * (1 << kFractionBits)};
}

using Operand = std::variant<Immediate, Variable, Element>;

/// One statement.
struct Instruction {
  Opcode opcode = Opcode::kReturn;
  /// Number of the unary or binary operator, or of the GT command; 0 for jumps and returns.
  uint16_t op = 0;
  /// Type of the operands of a unary or binary operator; kInt otherwise.
  DataType type = DataType::kInt;
  /// kUnary: src, dst. kBinary: a, b, dst. kJump: cond. kReturn: cond, value. kCommand: the
  /// arguments; an output's or a structure's operand is the variable whose address is passed.
  /// A cond is an int variable, or the literal 1 when the jump or return is unconditional.
  std::vector<Operand> operands;
  /// kJump: target minus own index.
  int16_t displacement = 0;
  bool operator==(const Instruction&) const = default;
};

/// A name of the `.ini` file.
struct Symbol {
  std::string name;  ///< `v`, or `s.member` for one member of a structure
  uint16_t id = 0;   ///< first slot
  DataType type = DataType::kInt;
  uint16_t array_size = 0;  ///< elements, 0 for what is not an array
  /// Of structured C: how its source calls it, with all sizes, `axis[3].gains[2]` or `m[2][3]`; the
  /// elements are in that order. Empty: as above.
  std::string written = {};
  bool operator==(const Symbol&) const = default;

  uint16_t slots() const { return array_size == 0 ? 1 : array_size; }
};

/// What its source says must hold whenever a thread executes a statement: `//@ assert: x < 3`
/// before it. The files of an object do not have it.
struct Assert {
  uint16_t position = 0;  ///< of the statement in its function, from 0
  std::string condition;  ///< `x < 3`
  /// Of structured C: the condition as its source has it, and by the names of the program those
  /// that its source uses. Empty: the same.
  std::string written = {};
  std::vector<std::pair<std::string, std::string>> names = {};
  bool operator==(const Assert&) const = default;
};

/// Of structured C: where the calls of a recursive function keep what they need, and how deep they
/// may be. The files of an object do not have it.
struct RecursionFrames {
  std::string function;  ///< the first of those that call each other
  int depth = 0;         ///< calls at the same time
  uint16_t array = 0;    ///< first slot of the local array that every call uses
  bool operator==(const RecursionFrames&) const = default;
};

struct Function {
  std::string name;
  std::string file;  ///< source file that defines it, as written in the `.ini`
  DataType return_type = DataType::kInt;
  std::vector<Instruction> instructions;
  std::vector<uint16_t> lines;    ///< source line of each instruction; 0 = unknown
  std::vector<Symbol> variables;  ///< parameters, then locals, in order of declaration
  std::vector<Assert> asserts;    ///< by position
  std::vector<RecursionFrames> frames = {};
  bool operator==(const Function&) const = default;
};

/// A whole program. Function k (from 0) has id k + 1.
struct Object {
  std::vector<Function> functions;
  std::vector<Symbol> globals;
  DoubleFormat double_format = DoubleFormat::k32_16;
  bool operator==(const Object&) const = default;
};

/// The two files of an object.
struct ObjectFiles {
  std::string bin;
  std::string ini;
};

}  // namespace oncard::vm
