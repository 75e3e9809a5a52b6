// What one instruction can compute: operands and operations of expressions (expressions.cc), and
// calls of GT commands (calls.cc). Everything else in an expression is reported, with what to write
// instead.
#pragma once

#include <optional>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "compiler/check_context.h"

namespace oncard::compiler {

/// A value that a statement can use directly.
struct TypedOperand {
  vm::Operand operand;
  vm::DataType type = vm::DataType::kInt;
  /// Set for a literal or macro, which becomes a double beside a double operand.
  std::optional<Literal> literal;
  SourceRange range;
};

/// The right-hand side of an assignment that one instruction can compute.
struct Operation {
  vm::Opcode opcode = vm::Opcode::kUnary;
  uint16_t op = static_cast<uint16_t>(vm::UnaryOperator::kCopy);
  std::vector<TypedOperand> operands;
  vm::DataType type = vm::DataType::kInt;    ///< of the operands
  vm::DataType result = vm::DataType::kInt;  ///< of the value
};

class Operands {
 public:
  /// The context must outlive this object.
  explicit Operands(CheckContext& context) : context_(context) {}

  /// Reports all errors inside an expression that no instruction can compute.
  void CheckNames(const Expression& expression);
  /// The same for an expression that needs statements of its own.
  void TeachNested(const Expression& expression);
  /// Checks a statement that is a call, and emits its instruction.
  void CheckCall(const Expression& call);
  /// A name, a number, an element or a member.
  std::optional<TypedOperand> ResolveOperand(const Expression& expression);
  /// What is written.
  std::optional<TypedOperand> ResolveTarget(const Expression& expression);
  /// What is assigned.
  std::optional<Operation> ResolveOperation(const Expression& expression);
  /// Converts a literal to the type of the other operand.
  bool Adapt(TypedOperand& operand, vm::DataType type);
  /// Reports a name that means nothing.
  void ReportUndeclared(const Expression& expression);

 private:
  // --- expressions.cc ---
  const Entity* ResolveName(const Expression& expression);
  std::optional<TypedOperand> ResolveIndex(const Expression& expression);
  void ResolveManyIndices(const Expression& expression);
  void LeaveArray(std::string_view name);
  bool CheckBounds(const Entity& array, int64_t size, const Expression& index);
  void CheckWritable(const Expression& target);
  std::optional<TypedOperand> ResolveMember(const Expression& expression);
  std::optional<Operation> ResolveBinary(const Expression& expression);
  /// The operand of an operation that has no other; it must not be an operation itself.
  std::optional<TypedOperand> ResolveOnlyOperand(const Expression& operand,
                                                 const Expression& operation);
  std::optional<Operation> ResolveUnary(const Expression& expression);
  std::optional<Operation> ResolveCast(const Expression& expression);
  std::optional<Operation> ResolveMagnitude(const Expression& expression);
  std::optional<TypedOperand> LiteralOperand(const Literal& literal, SourceRange range);

  // --- calls.cc ---
  void CheckCommand(const Expression& call, const gtcalls::Command& command);
  void ReportMissingArguments(const Expression& call, const gtcalls::Command& command);
  bool CheckInput(const Expression& argument, const gtcalls::Command& command, size_t index,
                  vm::Instruction& instruction);
  bool CheckAddress(const Expression& argument, const Expression& call,
                    const gtcalls::Command& command, size_t index, vm::Instruction& instruction);
  void ReportFraction(const Expression& argument, const Literal& literal,
                      std::string_view parameter);
  void ReportUnknownCall(const Expression& callee);

  CheckContext& context_;
  std::unordered_set<std::string_view> undeclared_macros_;
  std::unordered_set<const Expression*> flattened_;  // uses of arrays with many dimensions
};

/// A name, a number, an element or a member: no operation.
bool IsLeaf(const Expression& expression);

/// How messages name things.
Message DescribeType(vm::DataType type);
/// The smallest or the largest value.
Message DescribeRange(vm::DataType type, vm::DoubleFormat format, bool upper);
Message DescribeEntity(const Entity& entity);
/// Advice for a value of the other type.
Message ConvertAdvice();

}  // namespace oncard::compiler
