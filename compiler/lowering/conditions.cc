// Conditions as jumps: `&&` and `||` compute their right side only if C does. BranchIf(c, when, l)
// jumps to l if c is true (`when`) or false, and otherwise goes on with the next statement.
#include "compiler/lowering/lowerer.h"
#include "compiler/operators.h"

namespace oncard::compiler::lowering {

void Lowerer::BranchOnValue(const Value& value, bool when, int label, SourceRange range) {
  if (value.operand.IsConstant()) {
    if ((value.operand.value != 0) == when) EmitGoto(label, range);
    return;
  }
  Operand condition = value.operand;
  if (value.type == BasicType::kDouble) {
    const auto op = when ? vm::BinaryOperator::kNotEqual : vm::BinaryOperator::kEqual;
    condition =
        Compute(op, condition, ConstantOperand(vm::DataType::kDouble, 0), BasicType::kInt, range)
            .operand;
  } else if (!when) {
    condition = Compute(vm::UnaryOperator::kNot, condition, BasicType::kInt, range).operand;
  } else if (condition.kind == Operand::Kind::kElement) {
    // The condition of an 'if' is a variable.
    const Operand loaded = NewTemporary(vm::DataType::kInt, range);
    EmitCopy(loaded, condition, range);
    condition = loaded;
  }
  EmitIf(condition, label, range);
}

void Lowerer::BranchIf(const Expression& condition, bool when, int label) {
  const Expression& inner = WithoutParens(condition);
  const SourceRange range = inner.range;
  if (const std::optional<TypedConstant> constant = Evaluate(inner)) {
    if ((constant->value.AsDouble() != 0) == when) EmitGoto(label, range);
    return;
  }
  if (inner.kind == Expression::Kind::kUnary && inner.op == "!") {
    BranchIf(*inner.operands[0], !when, label);
    return;
  }
  if (inner.kind == Expression::Kind::kComma) {
    LowerEffect(*inner.operands[0]);
    BranchIf(*inner.operands[1], when, label);
    return;
  }
  if (inner.kind == Expression::Kind::kConditional) {
    const int otherwise = NewLabel("cond", range, "else");
    const int end = NewLabel("cond", range, "end");
    BranchIf(*inner.operands[0], false, otherwise);
    BranchIf(*inner.operands[1], when, label);
    EmitGoto(end, range);
    EmitLabel(otherwise, range);
    BranchIf(*inner.operands[2], when, label);
    EmitLabel(end, range);
    return;
  }
  if (inner.kind == Expression::Kind::kBinary && (inner.op == "&&" || inner.op == "||")) {
    const bool decided_by = inner.op == "||";  // the value of the left side that decides
    if (decided_by == when) {
      // Either side alone leads to the label.
      BranchIf(*inner.operands[0], when, label);
      BranchIf(*inner.operands[1], when, label);
      return;
    }
    // The left side alone leads past both.
    const int end = NewLabel(inner.op == "||" ? "or" : "and", range, "end");
    BranchIf(*inner.operands[0], decided_by, end);
    BranchIf(*inner.operands[1], when, label);
    EmitLabel(end, range);
    return;
  }
  // The opposite comparison saves the statement that negates it.
  if (inner.kind == Expression::Kind::kBinary && !when) {
    const vm::OperatorInfo* info = vm::FindBinaryOperator(inner.op);
    const vm::OperatorInfo* opposite =
        info != nullptr && vm::IsComparison(*info) ? OppositeOf(*info) : nullptr;
    if (opposite != nullptr && IsArray(*inner.operands[1]) && IsArray(*inner.operands[0])) {
      const Value result = LowerPlaces(inner, *opposite);
      if (!IsVoid(result)) BranchOnValue(result, true, label, range);
      return;
    }
    if (opposite != nullptr) {
      const Value a = LowerValue(*inner.operands[0]);
      const Value b = LowerValue(*inner.operands[1]);
      const bool good = RequireNumber(a, *inner.operands[0]);
      if (!RequireNumber(b, *inner.operands[1]) || !good) return;
      const Value result = Arithmetic(*opposite, a, b, inner);
      if (!IsVoid(result)) BranchOnValue(result, true, label, range);
      return;
    }
  }
  const Value value = LowerValue(inner);
  if (RequireNumber(value, inner)) BranchOnValue(value, when, label, range);
}

// `&&`, `||` and `!` of them as a number.
Value Lowerer::LowerLogical(const Expression& expression) {
  const Operand result = NewTemporary(vm::DataType::kInt, expression.range);
  AssignBoth({result, Type{BasicType::kBool}}, expression);
  return {result, BasicType::kInt, BasicType::kBool};
}

Value Lowerer::LowerConditional(const Expression& expression) {
  const BasicType type = TypeOf(expression);
  if (type == BasicType::kVoid || type == BasicType::kStructure) {
    const int otherwise = NewLabel("cond", expression.range, "else");
    const int end = NewLabel("cond", expression.range, "end");
    BranchIf(*expression.operands[0], false, otherwise);
    LowerEffect(*expression.operands[1]);
    EmitGoto(end, expression.range);
    EmitLabel(otherwise, expression.range);
    LowerEffect(*expression.operands[2]);
    EmitLabel(end, expression.range);
    return {Operand(), BasicType::kVoid, BasicType::kVoid};
  }
  // Both sides assign the same temporary.
  const Operand result = NewTemporary(DataTypeOf(type), expression.range);
  AssignBoth({result, Type{type}}, expression);
  return {result, type, type};
}

}  // namespace oncard::compiler::lowering
