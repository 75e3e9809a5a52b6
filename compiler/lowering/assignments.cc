// Assignments, compound ones, `++` and `--`.
#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {

// Writes a converted value. If the statement before computes it, that statement writes it at once.
Value Lowerer::Store(const Place& place, Value value, SourceRange range, bool value_used) {
  value = Convert(value, place.type.basic, range);
  const Operand& target = place.operand;
  const bool shared = target.kind != Operand::Kind::kVariable || IsShared(target);
  Instruction* last = out_->code.empty() ? nullptr : &out_->code.back();
  const bool computed = value.operand.IsVariable() && last != nullptr && last->Writes() &&
                        last->target == value.operand &&
                        program_.variables[static_cast<size_t>(value.operand.variable)].role ==
                            Variable::Role::kTemporary;
  if (computed && !(value_used && shared)) {
    last->target = target;
    return {target, place.type.basic, value.range};
  }
  // What is assigned is the value of the expression, so a global is not read again for it.
  if (value_used) value = Load(value, range);
  EmitCopy(target, value.operand, range);
  return {value.operand, place.type.basic, value.range};
}

// `c ? a : b`, `a && b` and the like, written where they are decided.
void Lowerer::AssignBoth(const Place& place, const Expression& expression) {
  const SourceRange range = expression.range;
  if (expression.kind == Expression::Kind::kConditional) {
    const BasicType type = TypeOf(expression);
    const int otherwise = NewLabel("cond", range, "else");
    const int end = NewLabel("cond", range, "end");
    const auto assign = [this, &place, type](const Expression& value) {
      const Value computed = LowerValue(value);
      if (!RequireNumber(computed, value)) return;
      Store(place, Convert(computed, type, value.range), value.range, false);
    };
    BranchIf(*expression.operands[0], false, otherwise);
    assign(*expression.operands[1]);
    EmitGoto(end, range);
    EmitLabel(otherwise, range);
    assign(*expression.operands[2]);
    EmitLabel(end, range);
    return;
  }
  const char* construct = expression.op == "&&" ? "and" : expression.op == "||" ? "or" : "not";
  const int no = NewLabel(construct, range, "false");
  const int end = NewLabel(construct, range, "end");
  const auto set = [this, &place, range](int64_t truth) {
    Value value;
    value.operand = IntOperand(truth);
    Store(place, value, range, false);
  };
  BranchIf(expression, false, no);
  set(1);
  EmitGoto(end, range);
  EmitLabel(no, range);
  set(0);
  EmitLabel(end, range);
}

void Lowerer::AssignInto(const Place& place, const Expression& value) {
  const Expression& inner = WithoutParens(value);
  if (const std::optional<TypedConstant> constant = Evaluate(inner)) {
    const std::optional<TypedConstant> converted = ConvertConstant(*constant, place.type.basic);
    Store(place, ConstantValue(converted ? *converted : *constant, inner), inner.range, false);
    return;
  }
  const bool logical =
      inner.kind == Expression::Kind::kBinary && (inner.op == "&&" || inner.op == "||");
  const bool chosen =
      inner.kind == Expression::Kind::kConditional && TypeOf(inner) != BasicType::kVoid;
  if (logical || chosen) {
    AssignBoth(place, inner);
    return;
  }
  const Value computed = LowerValue(inner);
  if (RequireNumber(computed, inner)) Store(place, computed, value.range, false);
}

// A place in an array is no number: it may be moved, and used where a place may stand.
Value Lowerer::LowerMoved(const Expression& expression, bool value_used) {
  const std::optional<ArrayPlace> moved = LowerMove(expression, value_used);
  if (moved && value_used) Report(Code::kArrayWithoutIndex, expression.range, moved->name);
  return {};
}

Value Lowerer::LowerAssignment(const Expression& expression, bool value_used) {
  const Expression& target = *expression.operands[0];
  const Expression& value = *expression.operands[1];
  if (IsArray(target)) return LowerMoved(expression, value_used);
  if (TypeOf(target) == BasicType::kStructure) {
    AssignStructure(target, value);
    return {Operand(), BasicType::kStructure, BasicType::kStructure};
  }
  const std::optional<Place> place = LowerPlace(target);
  if (!place || !CheckWritable(*place, target)) {
    LowerEffect(value);
    return {};
  }
  if (!value_used) {
    AssignInto(*place, value);
    return {};
  }
  const Value computed = LowerValue(value);
  if (!RequireNumber(computed, value)) return {};
  return Store(*place, computed, expression.range, true);
}

// place = place op change. The place is read in the statement that computes, so `g += 1` is one
// statement of the card.
Value Lowerer::Update(Place place, const vm::OperatorInfo& info, const Value& change,
                      const Expression& expression, bool value_used) {
  const Value before = {place.operand, place.type.basic, place.type.basic};
  const Value after = Arithmetic(info, before, change, expression);
  if (IsVoid(after)) return {};
  return Store(place, after, expression.range, value_used);
}

Value Lowerer::LowerCompound(const Expression& expression, bool value_used) {
  if (IsArray(*expression.operands[0])) return LowerMoved(expression, value_used);
  const Expression& target = *expression.operands[0];
  std::optional<Place> place = LowerPlace(target);
  if (!place || !CheckWritable(*place, target)) return {};
  // The index is read once although the element is used twice.
  if (place->operand.index >= 0) {
    place->operand.index = Stable(VariableOperand(place->operand.index), target.range).variable;
  }
  const Value change = LowerValue(*expression.operands[1]);
  if (!RequireNumber(change, *expression.operands[1])) return {};
  const std::string_view op = expression.op.substr(0, expression.op.size() - 1);
  return Update(*place, *vm::FindBinaryOperator(op), change, expression, value_used);
}

Value Lowerer::LowerStep(const Expression& expression, bool value_used) {
  if (IsArray(*expression.operands[0])) return LowerMoved(expression, value_used);
  const Expression& target = *expression.operands[0];
  std::optional<Place> place = LowerPlace(target);
  if (!place || !CheckWritable(*place, target)) return {};
  if (place->operand.index >= 0) {
    place->operand.index = Stable(VariableOperand(place->operand.index), target.range).variable;
  }
  const vm::OperatorInfo& info = *vm::FindBinaryOperator(expression.op.substr(0, 1));
  Value one;
  one.operand = IntOperand(1);
  one.range = BasicType::kBool;
  const bool postfix = expression.kind == Expression::Kind::kPostfix;
  if (!postfix || !value_used) return Update(*place, info, one, expression, value_used);
  const Value before = {NewTemporary(place->operand.type, expression.range), place->type.basic,
                        place->type.basic};
  EmitCopy(before.operand, place->operand, expression.range);
  const Value after = Arithmetic(info, before, one, expression);
  if (!IsVoid(after)) Store(*place, after, expression.range, false);
  return before;
}

}  // namespace oncard::compiler::lowering
