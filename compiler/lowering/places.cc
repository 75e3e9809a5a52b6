// What can be assigned: variables, elements of arrays with any number of dimensions, members.
#include "base/nearest.h"
#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {

void Lowerer::ReportUndeclared(const Expression& name) {
  Diagnostic* diagnostic = Report(Code::kUndeclared, name.range, name.text);
  if (diagnostic == nullptr) return;
  if (const gtcalls::Constant* constant = options_.catalogue->FindConstant(name.text)) {
    AddNote(
        *diagnostic,
        MakeMessage("the constants of gts.h are not known to motion programs; add '#define {} {}'",
                    "运动程序不识别 gts.h 中的常量；请加上 '#define {} {}'", name.text,
                    constant->value));
    return;
  }
  Nearest nearest(name.text);
  for (size_t i = frame_ != nullptr ? frame_->scope_base : scopes_.size(); i < scopes_.size();
       ++i) {
    for (const auto& [other, symbol] : scopes_[i]) nearest.Add(other);
  }
  for (const auto& [other, symbol] : scopes_[0]) nearest.Add(other);
  if (nearest.best().empty()) return;
  AddNote(*diagnostic, MakeMessage("did you mean '{0}'?", "您是否想写 '{0}'？", nearest.best()));
}

bool Lowerer::CheckWritable(const Place& place, const Expression& expression) {
  if (!place.type.is_const) return true;
  Report(Code::kWriteToConst, expression.range, Source(expression.range));
  return false;
}

// The array whose name an expression begins with, and the number of indices after it.
const Lowerer::Symbol* Lowerer::ArrayOf(const Expression& expression, size_t* indices) const {
  *indices = 0;
  const Expression* inner = &WithoutParens(expression);
  while (inner->kind == Expression::Kind::kIndex) {
    ++*indices;
    inner = &WithoutParens(*inner->operands[0]);
  }
  return inner->kind == Expression::Kind::kName ? Lookup(inner->text) : nullptr;
}

// True for a whole array or a row of one.
bool Lowerer::IsArray(const Expression& expression) const {
  size_t indices = 0;
  const Symbol* symbol = ArrayOf(expression, &indices);
  return symbol != nullptr && symbol->dimensions.size() > indices;
}

std::optional<Operand> Lowerer::LowerIndex(const Expression& index) {
  const Value value = LowerValue(index);
  if (!RequireNumber(value, index)) return std::nullopt;
  if (value.type != BasicType::kDouble) return value.operand;
  Report(Code::kTypeMismatch, index.range, MakeMessage("a double", "double"),
         MakeMessage("an int as the index", "int 下标"),
         MakeMessage("convert it: (int)", "请转换：(int)"));
  return std::nullopt;
}

std::optional<ArrayPlace> Lowerer::LowerArray(const Expression& expression) {
  const Expression& inner = WithoutParens(expression);
  if (inner.kind == Expression::Kind::kName) {
    const Symbol* symbol = Lookup(inner.text);
    if (symbol == nullptr) {
      ReportUndeclared(inner);
      return std::nullopt;
    }
    if (!IsUsable(*symbol, inner.text)) return std::nullopt;
    if (symbol->dimensions.empty()) {
      Report(Code::kMisuse, inner.range, inner.text, MakeMessage("not an array", "不是数组"),
             MakeMessage("an array before '['", "'[' 之前应为数组"));
      return std::nullopt;
    }
    return ArrayPlace{symbol->variable, symbol->offset, symbol->dimensions, symbol->type,
                      inner.text};
  }
  if (inner.kind != Expression::Kind::kIndex) {
    Report(Code::kMisuse, inner.range, Source(inner.range), MakeMessage("not an array", "不是数组"),
           MakeMessage("an array before '['", "'[' 之前应为数组"));
    return std::nullopt;
  }
  std::optional<ArrayPlace> array = LowerArray(*inner.operands[0]);
  if (!array) return std::nullopt;
  if (array->dimensions.empty()) {
    Report(Code::kMisuse, inner.operands[0]->range, Source(inner.operands[0]->range),
           MakeMessage("an element", "数组元素"), MakeMessage("fewer indices", "更少的下标"));
    return std::nullopt;
  }
  const Expression& index = *inner.operands[1];
  std::optional<Operand> offset = LowerIndex(index);
  if (!offset) return std::nullopt;
  const int64_t size = array->dimensions[0];
  const bool constant = offset->IsConstant();
  if (constant && (offset->value < 0 || (size > 0 && offset->value >= size))) {
    Report(Code::kIndexOutOfBounds, index.range, offset->value, array->name, size - 1);
    return std::nullopt;
  }
  array->dimensions.erase(array->dimensions.begin());
  int64_t row = 1;
  for (const int64_t dimension : array->dimensions) row *= dimension;
  if (row != 1) {
    offset = constant ? IntOperand(offset->value * row)
                      : Compute(vm::BinaryOperator::kMultiply, *offset, IntOperand(row),
                                BasicType::kInt, inner.range)
                            .operand;
  }
  if (array->offset.IsConstant() && array->offset.value == 0) {
    array->offset = *offset;
  } else if (array->offset.IsConstant() && offset->IsConstant()) {
    array->offset = IntOperand(array->offset.value + offset->value);
  } else if (!(offset->IsConstant() && offset->value == 0)) {
    array->offset =
        Compute(vm::BinaryOperator::kAdd, array->offset, *offset, BasicType::kInt, inner.range)
            .operand;
  }
  return array;
}

std::optional<Place> Lowerer::LowerElement(const Expression& expression) {
  std::optional<ArrayPlace> array = LowerArray(expression);
  if (!array) return std::nullopt;
  if (!array->dimensions.empty()) {
    Report(Code::kArrayWithoutIndex, expression.range, Source(expression.range));
    return std::nullopt;
  }
  const Variable& variable = program_.variables[static_cast<size_t>(array->variable)];
  Place place;
  place.type = array->element;
  place.operand.kind = Operand::Kind::kElement;
  place.operand.type = variable.type;
  place.operand.variable = array->variable;
  if (array->offset.IsConstant()) {
    place.operand.value = array->offset.value;
    place.operand.name = array->offset.name;
    if (array->offset.value >= variable.size) {
      Report(Code::kIndexOutOfBounds, expression.range, array->offset.value, array->name,
             int64_t{variable.size} - 1);
      return std::nullopt;
    }
  } else {
    Operand index = array->offset;
    if (!index.IsVariable()) {
      const Operand loaded = NewTemporary(vm::DataType::kInt, expression.range);
      EmitCopy(loaded, index, expression.range);
      index = loaded;
    }
    place.operand.index = index.variable;
  }
  return place;
}

std::optional<Place> Lowerer::LowerMember(const Expression& expression) {
  const std::optional<Place> structure = LowerPlace(*expression.operands[0]);
  if (!structure) return std::nullopt;
  if (structure->type.structure == nullptr) {
    Report(Code::kNoMember, expression.op_range, Source(expression.operands[0]->range),
           expression.text);
    return std::nullopt;
  }
  const auto& members = structure->type.structure->members;
  for (size_t i = 0; i < members.size(); ++i) {
    if (members[i].name != expression.text) continue;
    Place place;
    place.operand = structure->operand;
    place.operand.kind = Operand::Kind::kMember;
    place.operand.member = static_cast<int16_t>(i);
    place.operand.type = gtcalls::ProgramType(members[i].type);
    place.type.basic = MemberType(members[i]);
    place.type.is_const = structure->type.is_const;
    return place;
  }
  Report(Code::kNoMember, expression.op_range, structure->type.structure->name, expression.text);
  return std::nullopt;
}

std::optional<Place> Lowerer::LowerPlace(const Expression& expression) {
  const Expression& inner = WithoutParens(expression);
  switch (inner.kind) {
    case Expression::Kind::kIndex:
      return LowerElement(inner);
    case Expression::Kind::kMember:
      return LowerMember(inner);
    case Expression::Kind::kName: {
      const Symbol* symbol = Lookup(inner.text);
      if (symbol == nullptr) {
        ReportUndeclared(inner);
        return std::nullopt;
      }
      if (!IsUsable(*symbol, inner.text)) return std::nullopt;
      if (symbol->kind == Symbol::Kind::kConstant) {
        Report(Code::kWriteToConst, inner.range, inner.text);
        return std::nullopt;
      }
      if (symbol->kind == Symbol::Kind::kFunction) break;
      if (!symbol->dimensions.empty()) {
        Report(Code::kArrayWithoutIndex, inner.range, inner.text);
        return std::nullopt;
      }
      return Place{VariableOperand(symbol->variable), symbol->type};
    }
    case Expression::Kind::kError:
      return std::nullopt;
    default:
      break;
  }
  Report(Code::kMisuse, inner.range, Source(inner.range), MakeMessage("a value", "值"),
         MakeMessage("a variable, an element or a member", "变量、数组元素或结构成员"));
  return std::nullopt;
}

}  // namespace oncard::compiler::lowering
