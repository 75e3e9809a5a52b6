// The program between C and the card's language: a list of the card's simple statements for each
// function, whose operands refer to variables by number. Lowering builds it, the passes rewrite it,
// the printer writes it as text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/diagnostic.h"
#include "gtcalls/catalogue.h"
#include "vm/opcodes.h"

namespace oncard::compiler::lowering {

/// A variable of the lowered program.
struct Variable {
  enum class Role : uint8_t { kGlobal, kParameter, kLocal, kTemporary };
  Role role = Role::kLocal;
  /// As it is printed; temporaries get theirs when they share slots.
  std::string name;
  /// How C calls it, with all sizes: `axis[3].gains[2]`. Empty: the same.
  std::string written;
  vm::DataType type = vm::DataType::kInt;
  /// Elements of an array; 0: not an array.
  int size = 0;
  /// One of the card. Each of its members has a variable, one behind the other. The first one is
  /// the structure itself, the others have no name and stand in no operand
  /// (Lowerer::VariableOperand).
  const gtcalls::Structure* structure = nullptr;
  int16_t member = 0;
  /// Of a temporary: the shared body whose statements use it, 0 for none.
  int body = 0;
  /// Of a local: the recursive functions of which each call has its own; 0: none.
  int group = 0;
  /// Of an array or a structure: the block that declares it (BlockInstance::block), 0 for none.
  int block = 0;
  /// A global array of constants.
  bool is_table = false;
  /// An array whose bounds are checked when it is written: that is never left out, unless the index
  /// is known.
  bool checks = false;
  SourceRange range;  ///< where it is declared
};

/// What a statement reads or writes.
struct Operand {
  enum class Kind : uint8_t {
    kNone,
    kConstant,  ///< value: an int, or the raw value of a double
    kVariable,
    kElement,  ///< variable, index; without an index variable, value is the index
    kMember    ///< variable, member
  };
  Kind kind = Kind::kNone;
  vm::DataType type = vm::DataType::kInt;
  bool address = false;  ///< an argument written with `&`
  int16_t member = 0;
  int variable = -1;
  int index = -1;  ///< the int variable that holds the index of an element
  int64_t value = 0;
  /// Of a constant, or a constant index: which one of Program::constants, if it has a name.
  int name = -1;

  bool operator==(const Operand&) const = default;
  bool IsConstant() const { return kind == Kind::kConstant; }
  bool IsVariable() const { return kind == Kind::kVariable; }
};

/// One simple statement of the card, a label, or an assert.
struct Instruction {
  enum class Kind : uint8_t {
    kUnary,   ///< target = op a; the copy too
    kBinary,  ///< target = a op b
    kLabel,   ///< label
    kGoto,    ///< label
    kIf,      ///< a is an int variable or member; label
    kReturn,  ///< a, which may be absent
    kCall,    ///< command, arguments
    kAssert   ///< assertion, whose names are the arguments; belongs to the next statement
  };
  Kind kind = Kind::kUnary;
  vm::UnaryOperator unary = vm::UnaryOperator::kCopy;
  vm::BinaryOperator binary = vm::BinaryOperator::kAdd;
  int label = -1;
  int assertion = -1;  ///< in Program::assertions
  Operand target;
  Operand a;
  Operand b;
  const gtcalls::Command* command = nullptr;
  std::vector<Operand> arguments;
  SourceRange range;  ///< the expression or statement of C that it computes
  int statement = 0;  ///< the full expression of C that it belongs to, for atomicity
  int instance = -1;  ///< in LoweredFunction::instances; -1: not known

  bool Writes() const { return kind == Kind::kUnary || kind == Kind::kBinary; }
  bool IsStatement() const { return kind != Kind::kLabel && kind != Kind::kAssert; }
  /// To its label, always or under a condition.
  bool Jumps() const { return kind == Kind::kGoto || kind == Kind::kIf; }
  /// The next one may follow.
  bool GoesOn() const { return kind != Kind::kGoto && kind != Kind::kReturn; }
};

/// Replaces what an instruction does by a copy of a value to its target.
inline void MakeCopy(Instruction& instruction, const Operand& value) {
  instruction.kind = Instruction::Kind::kUnary;
  instruction.unary = vm::UnaryOperator::kCopy;
  instruction.a = value;
  instruction.b = Operand();
}

/// A function whose statements stand once in a thread function that calls it several times.
struct SharedCalls {
  std::string name;
  int number = -1;  ///< the variable that says which call it is, from 0; each call assigns its own
};

/// What the calls of recursive functions that wait for another one take.
struct KeptFrames {
  std::string name;  ///< of the first function
  int array = -1;    ///< a variable that every call uses
  int count = 0;     ///< of frames
  int slots = 0;     ///< of each
  int depth = 0;     ///< of the calls
};

/// A block of C at one place of a thread function: a function that is inlined twice has two
/// instances of each of its blocks. The arrays of a block are used in its instances only, and have
/// no values where one begins.
struct BlockInstance {
  int parent = -1;  ///< -1: of a thread function, or of a shared body
  int block = 0;    ///< the same number for all instances of a block, from 1; 0: none
  int body = 0;     ///< the shared body that it belongs to; 0: none
};

/// Variables that share the slots of another one (passes/slots.cc).
struct SharedSlots {
  int owner = -1;
  std::vector<int> others;
};

/// A thread function.
struct LoweredFunction {
  std::string name;
  vm::DataType type = vm::DataType::kVoid;
  std::vector<int> parameters;  ///< variables, in the order of the host
  std::vector<Instruction> code;
  std::vector<std::string> labels;  ///< names, by number
  std::vector<SharedCalls> calls;   ///< those that are jumps; all others are inlined
  std::vector<KeptFrames> frames;
  std::vector<BlockInstance> instances;  ///< parents come first
  std::vector<SharedSlots> shared_slots;
  std::vector<int> tables;  ///< globals of C that are in the page
  SourceRange header;
  SourceRange end;  ///< the closing brace
};

/// A constant to which C gives a name, for the arguments of commands.
struct NamedConstant {
  std::string name;
  Operand value;
  SourceRange range;       ///< where it is defined
  bool ambiguous = false;  ///< the name has another value elsewhere, so nothing is called so
};

/// An assert at one place of a thread function, where what it names are variables of that function.
struct Assertion {
  SourceRange comment;
  std::string written;             ///< its condition in C
  std::vector<std::string> texts;  ///< of the condition, before, between and after the arguments
  std::vector<std::string> names;  ///< of the arguments in C: `x`, `a[1][2]`
  std::vector<int64_t> elements;   ///< of the arguments: the index in their array; -1: none
};

struct Program {
  std::vector<NamedConstant> constants;
  std::vector<Variable> variables;  ///< of all functions, and the globals
  std::vector<int> globals;         ///< in the order of their declarations
  std::vector<LoweredFunction> functions;
  std::vector<SourceRange> statements;  ///< the full expressions of C, by Instruction::statement
  /// From this statement on they are the initial values of globals, which thread functions write.
  int start_statements = 0;
  std::vector<Assertion> assertions;  ///< by Instruction::assertion
  /// Statements of all attempts to find out which calls should be jumps: the work of that.
  int64_t tried_statements = 0;
};

/// Calls `visit(Operand&, bool written)` for every operand of an instruction, those that it reads
/// before the one that it writes. The address of an argument counts as written.
template <typename Code, typename Visitor>
void ForEachOperand(Code& instruction, const Visitor& visit) {
  for (auto& argument : instruction.arguments) visit(argument, argument.address);
  if (instruction.a.kind != Operand::Kind::kNone) visit(instruction.a, false);
  if (instruction.b.kind != Operand::Kind::kNone) visit(instruction.b, false);
  if (instruction.target.kind != Operand::Kind::kNone) visit(instruction.target, true);
}

/// An int or double as an operand.
inline Operand ConstantOperand(vm::DataType type, int64_t value) {
  Operand operand;
  operand.kind = Operand::Kind::kConstant;
  operand.type = type;
  operand.value = value;
  return operand;
}

inline Operand IntOperand(int64_t value) { return ConstantOperand(vm::DataType::kInt, value); }

}  // namespace oncard::compiler::lowering
