// Expressions that compute a value from operands. A statement of the card has one operator, so that
// each operator of C becomes a statement with a temporary of its own as its target; what only
// renames a value (parentheses, a plus, a conversion that changes no bit) becomes none.
#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {

Value Lowerer::Compute(vm::BinaryOperator op, const Operand& a, const Operand& b, BasicType type,
                       SourceRange range) {
  const vm::OperatorInfo& info = *vm::FindBinaryOperator(static_cast<uint16_t>(op));
  Instruction instruction;
  instruction.kind = Instruction::Kind::kBinary;
  instruction.binary = op;
  instruction.a = a;
  instruction.b = b;
  instruction.target = NewTemporary(vm::ResultOf(info, a.type), range);
  const Operand target = instruction.target;
  Emit(std::move(instruction), range);
  // The type is that of C; the range tells those who convert or compare it that it is 0 or 1.
  const bool truth = vm::IsComparison(info) || vm::IsLogical(info);
  return {target, type, truth ? BasicType::kBool : type};
}

Value Lowerer::Compute(vm::UnaryOperator op, const Operand& a, BasicType type, SourceRange range) {
  const vm::OperatorInfo& info = *vm::FindUnaryOperator(static_cast<uint16_t>(op));
  Instruction instruction;
  instruction.unary = op;
  instruction.a = a;
  instruction.target = NewTemporary(vm::ResultOf(info, a.type), range);
  const Operand target = instruction.target;
  Emit(std::move(instruction), range);
  return {target, type, op == vm::UnaryOperator::kNot ? BasicType::kBool : type};
}

bool Lowerer::RequireNumber(const Value& value, const Expression& expression) {
  if (!IsVoid(value)) return true;
  const Expression& inner = WithoutParens(expression);
  if (inner.kind == Expression::Kind::kCall && value.type == BasicType::kVoid) {
    Report(Code::kVoidValue, expression.range, Source(expression.range));
  }
  return false;
}

Value Lowerer::LowerName(const Expression& expression) {
  const Value nothing = {Operand(), BasicType::kInt, BasicType::kInt};
  const Symbol* symbol = Lookup(expression.text);
  if (symbol == nullptr) {
    ReportUndeclared(expression);
    return nothing;
  }
  if (!IsUsable(*symbol, expression.text)) return nothing;
  if (symbol->kind == Symbol::Kind::kFunction) {
    Report(Code::kNotLowered, expression.range,
           MakeMessage("the address of a function", "函数的地址"),
           MakeMessage("call it: '{0}(...)'", "请调用它：'{0}(...)'", expression.text));
    return nothing;
  }
  if (!symbol->dimensions.empty()) {
    Report(Code::kArrayWithoutIndex, expression.range, expression.text);
    return nothing;
  }
  if (symbol->type.basic == BasicType::kStructure) {
    ReportStructure(expression);
    return nothing;
  }
  return {VariableOperand(symbol->variable), symbol->type.basic, symbol->type.basic};
}

Value Lowerer::LowerUnary(const Expression& expression) {
  const std::string_view op = expression.op;
  if (op == "++" || op == "--") return LowerStep(expression, true);
  if (op == "&") {
    Report(Code::kAddress, expression.op_range);
    return {};
  }
  if (op == "*") {
    const std::optional<Place> place = LowerPlace(expression);
    if (!place) return {};
    return {place->operand, place->type.basic, place->type.basic};
  }
  const Expression& inner = *expression.operands[0];
  if (op == "!") {
    const Expression& negated = WithoutParens(inner);
    // `!(a && b)` is decided by jumps, as `a && b` is: one value, without a `!` of its own.
    const bool jumps =
        negated.kind == Expression::Kind::kBinary && (negated.op == "&&" || negated.op == "||");
    if (jumps) return LowerLogical(expression);
  }
  Value value = LowerValue(inner);
  if (!RequireNumber(value, inner)) return {};
  const bool real = value.type == BasicType::kDouble;
  if (op == "!") {
    if (!real) {
      return Compute(vm::UnaryOperator::kNot, value.operand, BasicType::kInt, expression.range);
    }
    return Compute(vm::BinaryOperator::kEqual, value.operand,
                   ConstantOperand(vm::DataType::kDouble, 0), BasicType::kInt, expression.range);
  }
  const BasicType type = Promoted(value.type);
  if (op == "+") return {value.operand, type, value.range};
  if (op == "-") {
    // The card has no unary minus.
    return Compute(vm::BinaryOperator::kSubtract, ConstantOperand(value.operand.type, 0),
                   value.operand, type, expression.range);
  }
  if (real) {
    Report(Code::kIllegalOperator, expression.op_range, op,
           MakeMessage("it takes ints, and this is a double", "它的操作数是 int，而此处是 double"));
    return {};
  }
  return Compute(vm::UnaryOperator::kInvert, value.operand, type, expression.range);
}

Value Lowerer::Arithmetic(const vm::OperatorInfo& info, Value a, Value b,
                          const Expression& expression) {
  const SourceRange range = expression.range;
  const bool shift = info.precedence == vm::Precedence::kShift;
  const BasicType type = shift ? Promoted(a.type) : Common(a.type, b.type);
  const bool real = type == BasicType::kDouble || (shift && b.type == BasicType::kDouble);
  if (real && !vm::Accepts(info, vm::DataType::kDouble)) {
    Report(Code::kIllegalOperator, expression.op_range, info.spelling,
           MakeMessage("it takes ints, and one operand is a double",
                       "它的操作数是 int，而有一个操作数是 double"));
    return {};
  }
  a = Convert(a, type, range);
  b = Convert(b, shift ? Promoted(b.type) : type, range);
  const auto op = static_cast<vm::BinaryOperator>(info.number);
  const bool comparison = vm::IsComparison(info);
  // The operators of the card are signed. Those whose result differs are made of several.
  if (type == BasicType::kUnsigned) {
    if (info.precedence == vm::Precedence::kRelation) return CompareUnsigned(op, a, b, range);
    if (op == vm::BinaryOperator::kShiftRight) return ShiftUnsignedRight(a, b, range);
    if (op == vm::BinaryOperator::kDivide || op == vm::BinaryOperator::kRemainder) {
      return DivideUnsigned(a, b, op == vm::BinaryOperator::kRemainder, range);
    }
  }
  return Compute(op, a.operand, b.operand, comparison ? BasicType::kInt : type, range);
}

Value Lowerer::LowerBinary(const Expression& expression) {
  const vm::OperatorInfo* info = vm::FindBinaryOperator(expression.op);
  if (info == nullptr) return {};
  if (vm::IsLogical(*info)) return LowerLogical(expression);
  if (IsArray(*expression.operands[1]) && IsArray(*expression.operands[0])) {
    return LowerPlaces(expression, *info);
  }
  const Value a = LowerValue(*expression.operands[0]);
  const Value b = LowerValue(*expression.operands[1]);
  const bool good = RequireNumber(a, *expression.operands[0]);
  if (!RequireNumber(b, *expression.operands[1]) || !good) return {};
  return Arithmetic(*info, a, b, expression);
}

Value Lowerer::LowerValue(const Expression& expression) {
  using Kind = Expression::Kind;
  if (stopped_) return {};
  // Constants first: what C computes when it compiles costs the card nothing.
  if (const std::optional<TypedConstant> constant = Evaluate(expression)) {
    return ConstantValue(*constant, expression);
  }
  switch (expression.kind) {
    case Kind::kName:
      return LowerName(expression);
    case Kind::kIndex:
    case Kind::kCompoundLiteral:
    case Kind::kMember: {
      if (IsArray(expression)) {
        Report(Code::kArrayWithoutIndex, expression.range, Source(expression.range));
        return {};
      }
      const std::optional<Place> place = LowerPlace(expression);
      if (!place) return {};
      return {place->operand, place->type.basic, place->type.basic};
    }
    case Kind::kUnary:
      return LowerUnary(expression);
    case Kind::kPostfix:
      return LowerStep(expression, true);
    case Kind::kBinary:
      return LowerBinary(expression);
    case Kind::kAssign:
      return LowerAssignment(expression, true);
    case Kind::kCompound:
      return LowerCompound(expression, true);
    case Kind::kCast: {
      const std::optional<BasicType> type = CastType(expression);
      if (!type) {
        Report(Code::kNotLowered, expression.range,
               MakeMessage("the cast '{0}'", "类型转换 '{0}'", Source(expression.range)),
               MakeMessage("cast to a number", "请转换为数值类型"));
        return {};
      }
      if (*type == BasicType::kVoid) {
        LowerEffect(*expression.operands[0]);
        return {Operand(), BasicType::kVoid, BasicType::kVoid};
      }
      const Value value = LowerValue(*expression.operands[0]);
      if (!RequireNumber(value, *expression.operands[0])) return {};
      return Convert(value, *type, expression.range);
    }
    case Kind::kCall: {
      const Value value = LowerCall(expression);
      if (value.type != BasicType::kStructure || IsVoid(value)) return value;
      ReportStructure(expression);
      return {};
    }
    case Kind::kConditional:
      return LowerConditional(expression);
    case Kind::kComma:
      LowerEffect(*expression.operands[0]);
      return LowerValue(*expression.operands[1]);
    case Kind::kParen:
      return LowerValue(*expression.operands[0]);
    case Kind::kBraces:
    case Kind::kDesignated:
      Report(Code::kArrayValues, expression.range, Source(expression.range));
      return {};
    case Kind::kSizeof:
      Report(Code::kNotLowered, expression.range,
             MakeMessage("the size '{0}'", "长度 '{0}'", Source(expression.range)),
             MakeMessage("only numbers, arrays and structures have a known size",
                         "只有数、数组和结构的长度是已知的"));
      return {};
    case Kind::kLiteral:
    case Kind::kString:
    case Kind::kError:
      return {};
  }
  return {};
}

// An expression whose value is dropped.
void Lowerer::LowerEffect(const Expression& expression) {
  using Kind = Expression::Kind;
  switch (expression.kind) {
    case Kind::kParen:
      LowerEffect(*expression.operands[0]);
      return;
    case Kind::kComma:
      LowerEffect(*expression.operands[0]);
      LowerEffect(*expression.operands[1]);
      return;
    case Kind::kAssign:
      LowerAssignment(expression, false);
      return;
    case Kind::kCompound:
      LowerCompound(expression, false);
      return;
    case Kind::kPostfix:
      LowerStep(expression, false);
      return;
    case Kind::kCall:
      LowerCall(expression);
      return;
    case Kind::kUnary:
      if (expression.op == "++" || expression.op == "--") {
        LowerStep(expression, false);
        return;
      }
      break;
    default:
      break;
  }
  // `s, x`: a structure whose value nobody wants.
  const std::optional<Shape> shape = ShapeOf(expression);
  if (shape && !shape->invalid && shape->type.own != nullptr && shape->dimensions.empty()) {
    LowerStructure(expression);
    return;
  }
  LowerValue(expression);
}

}  // namespace oncard::compiler::lowering
