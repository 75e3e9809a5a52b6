// What can be assigned: variables, elements of arrays with any number of dimensions, members.
#include <algorithm>
#include <utility>

#include "base/nearest.h"
#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {
namespace {

// Whether two places are in the same array. A structure and its first member begin with the same
// variable, and count differently.
bool IsInOneArray(const ArrayPlace& a, const ArrayPlace& b) {
  return a.variable == b.variable && a.dimensions.size() == b.dimensions.size() &&
         a.element.own == b.element.own;
}

}  // namespace

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

// `f().m`, `(a = b).m` and the like are parts of values, which C does not let be changed.
bool Lowerer::CheckPlace(const Expression& expression) {
  const Expression* whole = &WithoutParens(expression);
  while (whole->kind == Expression::Kind::kMember && whole->op == ".") {
    whole = &WithoutParens(*whole->operands[0]);
  }
  using Kind = Expression::Kind;
  const bool is_value = whole->kind == Kind::kCall || whole->kind == Kind::kAssign ||
                        whole->kind == Kind::kConditional || whole->kind == Kind::kComma;
  if (!is_value) return true;
  Report(Code::kMisuse, expression.range, Source(expression.range), MakeMessage("a value", "值"),
         MakeMessage("a variable, an element or a member of one", "变量、数组元素或它们的成员"));
  return false;
}

bool Lowerer::CheckWritable(const Place& place, const Expression& expression) {
  if (!CheckPlace(expression)) return false;
  if (!place.type.is_const) return true;
  Report(Code::kWriteToConst, expression.range, Source(expression.range));
  return false;
}

// True for a whole array, a row of one, or the place of a number, as in `&x`.
bool Lowerer::IsArray(const Expression& expression) const {
  const std::optional<Shape> shape = ShapeOf(expression);
  return shape && !shape->dimensions.empty();
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

std::optional<ArrayPlace> Lowerer::LowerNamedArray(const Expression& name) {
  const Symbol* symbol = Lookup(name.text);
  if (symbol == nullptr) {
    ReportUndeclared(name);
    return std::nullopt;
  }
  if (!IsUsable(*symbol, name.text)) return std::nullopt;
  if (symbol->kind == Symbol::Kind::kFunction) {
    Report(Code::kMisuse, name.range, name.text, MakeMessage("a function", "函数"),
           MakeMessage("a call: '{0}(...)'", "函数调用：'{0}(...)'", name.text));
    return std::nullopt;
  }
  if (symbol->dimensions.empty() && symbol->type.own == nullptr) {
    Report(Code::kMisuse, name.range, name.text, MakeMessage("not an array", "不是数组"),
           MakeMessage("an array before '['", "'[' 之前应为数组"));
    return std::nullopt;
  }
  return ArrayPlace{symbol->variable, symbol->offset, symbol->dimensions, symbol->type, name.text};
}

// `&target`: an array whose first element, or row, it is.
std::optional<ArrayPlace> Lowerer::LowerAddressed(const Expression& target) {
  const Expression& inner = WithoutParens(target);
  if (!CheckPlace(inner)) return std::nullopt;
  const Symbol* symbol = inner.kind == Expression::Kind::kName ? Lookup(inner.text) : nullptr;
  const bool number = symbol != nullptr && symbol->kind == Symbol::Kind::kVariable &&
                      symbol->dimensions.empty() && symbol->type.basic != BasicType::kStructure;
  const std::optional<Shape> shape = ShapeOf(inner);
  const bool own = shape && (shape->type.own != nullptr || !shape->dimensions.empty());
  const bool member = inner.kind == Expression::Kind::kMember;
  if ((member && !IsOwnMember(inner)) || (symbol != nullptr && !number && !own)) {
    Report(Code::kMisuse, inner.range, Source(inner.range),
           MakeMessage("nothing that a parameter can stand for", "不能由参数代表的内容"),
           MakeMessage("a variable or an array; copy it to one before the call, and back",
                       "变量或数组；请在调用前复制到变量中，之后再复制回来"));
    return std::nullopt;
  }
  std::optional<ArrayPlace> array;
  if (!number) {
    array = LowerArray(inner);
  } else if (IsUsable(*symbol, inner.text)) {
    array = ArrayPlace{symbol->variable, IntOperand(0), {}, symbol->type, inner.text};
  }
  if (array) array->dimensions.insert(array->dimensions.begin(), 0);
  return array;
}

// `a + 1`, `1 + a`, `a - 1`: what begins there.
std::optional<ArrayPlace> Lowerer::LowerArraySum(const Expression& sum) {
  const Expression* whole = sum.operands[0].get();
  const Expression* number = sum.operands[1].get();
  const bool back = sum.op == "-";
  if (!back && !IsArray(*whole)) std::swap(whole, number);
  std::optional<ArrayPlace> array = LowerArray(*whole);
  if (!array) return std::nullopt;
  const std::optional<Operand> count = LowerIndex(*number);
  if (!count) return std::nullopt;
  Advance(*array, *count, back, sum.range);
  array->dimensions[0] = 0;
  return array;
}

// `p++`, `--p`, `p += n`, `p = q`: moves a parameter within the array that the caller names.
std::optional<ArrayPlace> Lowerer::LowerMove(const Expression& expression, bool value_used) {
  const SourceRange range = expression.range;
  const Expression& name = *MovesOf(expression);
  const Symbol* symbol = name.kind == Expression::Kind::kName ? Lookup(name.text) : nullptr;
  if (symbol == nullptr || !symbol->moves) {
    Report(Code::kMisuse, name.range, Source(name.range), MakeMessage("an array", "数组"),
           MakeMessage("a parameter, which alone can be moved, or an index",
                       "参数（只有参数可以移动）或下标"));
    return std::nullopt;
  }
  std::optional<ArrayPlace> array = LowerNamedArray(name);
  const Operand where = array->offset;
  std::optional<Operand> before;
  if (expression.kind == Expression::Kind::kAssign) {
    const std::optional<ArrayPlace> other = LowerArray(*expression.operands[1]);
    if (!other) return std::nullopt;
    if (!IsInOneArray(*other, *array)) {
      Report(Code::kNotLowered, range,
             MakeMessage("a parameter that changes to another array", "改为代表另一个数组的参数"),
             MakeMessage("pass the array in a call", "请在调用中传递该数组"));
      return std::nullopt;
    }
    array->offset = other->offset;
  } else {
    const bool step = expression.kind != Expression::Kind::kCompound;
    const char sign = expression.op[0];
    if (sign != '+' && sign != '-') {
      Report(Code::kArrayWithoutIndex, name.range, name.text);
      return std::nullopt;
    }
    if (value_used && expression.kind == Expression::Kind::kPostfix) {
      before = NewTemporary(vm::DataType::kInt, range);
      EmitCopy(*before, where, range);
    }
    const std::optional<Operand> count =
        step ? std::optional(IntOperand(1)) : LowerIndex(*expression.operands[1]);
    if (!count) return std::nullopt;
    Advance(*array, *count, sign == '-', range);
  }
  Value offset;
  offset.operand = array->offset;
  Store({where, Type{}}, offset, range, false);
  array->offset = before.value_or(where);
  return array;
}

// `p - q` and `p < q`, of places in one array.
Value Lowerer::LowerPlaces(const Expression& expression, const vm::OperatorInfo& info) {
  const std::optional<ArrayPlace> a = LowerArray(*expression.operands[0]);
  const std::optional<ArrayPlace> b = LowerArray(*expression.operands[1]);
  if (!a || !b) return {};
  const bool difference = expression.op == "-";
  if (!IsInOneArray(*a, *b) || !(difference || vm::IsComparison(info))) {
    Report(
        Code::kNotLowered, expression.range,
        MakeMessage("'{0}' of places in different arrays", "不同数组中位置的 '{0}'", expression.op),
        MakeMessage("pass and compare indices", "请传递并比较下标"));
    return {};
  }
  const auto op = static_cast<vm::BinaryOperator>(info.number);
  Operand left = a->offset;
  if (left.IsConstant()) {
    left = NewTemporary(vm::DataType::kInt, expression.range);
    EmitCopy(left, a->offset, expression.range);
  }
  const Value result = Compute(op, left, b->offset, BasicType::kInt, expression.range);
  int64_t row = 1;
  for (size_t i = 1; i < a->dimensions.size(); ++i) row *= a->dimensions[i];
  if (!difference || row == 1) return result;
  return Compute(vm::BinaryOperator::kDivide, result.operand, IntOperand(row), BasicType::kInt,
                 expression.range);
}

// Moves the beginning of an array by rows of its first dimension.
void Lowerer::Advance(ArrayPlace& array, const Operand& count, bool back, SourceRange range) {
  int64_t row = 1;
  for (size_t i = 1; i < array.dimensions.size(); ++i) row *= array.dimensions[i];
  Operand offset = count;
  if (count.IsConstant() && (row != 1 || back)) {
    offset = IntOperand(back ? -count.value * row : count.value * row);
  } else if (row != 1) {
    offset = Compute(vm::BinaryOperator::kMultiply, count, IntOperand(row), BasicType::kInt, range)
                 .operand;
  }
  const bool subtracts = back && !count.IsConstant();
  if (array.offset.IsConstant() && array.offset.value == 0 && !subtracts) {
    array.offset = offset;
  } else if (array.offset.IsConstant() && offset.IsConstant()) {
    array.offset = IntOperand(array.offset.value + offset.value);
  } else if (!(offset.IsConstant() && offset.value == 0)) {
    array.offset = Compute(subtracts ? vm::BinaryOperator::kSubtract : vm::BinaryOperator::kAdd,
                           array.offset, offset, BasicType::kInt, range)
                       .operand;
  }
}

std::optional<ArrayPlace> Lowerer::LowerArray(const Expression& expression) {
  using Kind = Expression::Kind;
  const Expression& inner = WithoutParens(expression);
  if (inner.kind == Kind::kName) return LowerNamedArray(inner);
  if (inner.kind == Kind::kCompoundLiteral) return LowerCompoundLiteral(inner);
  if (inner.kind == Kind::kUnary && inner.op == "&") return LowerAddressed(*inner.operands[0]);
  if (inner.kind == Kind::kMember && IsOwnMember(inner)) return LowerOwnMember(inner);
  if (inner.kind == Kind::kBinary && IsArray(inner)) return LowerArraySum(inner);
  if (MovesOf(inner) != nullptr && IsArray(inner)) return LowerMove(inner, true);
  if (inner.kind == Kind::kComma) {
    LowerEffect(*inner.operands[0]);
    return LowerArray(*inner.operands[1]);
  }
  const bool star = inner.kind == Kind::kUnary && inner.op == "*";
  if (inner.kind != Kind::kIndex && !star) {
    Report(Code::kMisuse, inner.range, Source(inner.range), MakeMessage("not an array", "不是数组"),
           MakeMessage("an array before '['", "'[' 之前应为数组"));
    return std::nullopt;
  }
  if (star && !IsArray(*inner.operands[0])) {
    const std::optional<Shape> shape = ShapeOf(*inner.operands[0]);
    if (shape && shape->invalid) return std::nullopt;
    Report(Code::kNeedsPointer, inner.op_range, inner.op);
    return std::nullopt;
  }
  std::optional<ArrayPlace> array = LowerArray(*inner.operands[0]);
  if (!array) return std::nullopt;
  if (array->dimensions.empty() && array->element.own != nullptr) {
    ReportStructure(*inner.operands[0]);
    return std::nullopt;
  }
  if (array->dimensions.empty()) {
    Report(Code::kMisuse, inner.operands[0]->range, Source(inner.operands[0]->range),
           MakeMessage("an element", "数组元素"), MakeMessage("fewer indices", "更少的下标"));
    return std::nullopt;
  }
  if (!star) {
    const Expression& index = *inner.operands[1];
    const std::optional<Operand> count = LowerIndex(index);
    if (!count) return std::nullopt;
    const int64_t size = array->dimensions[0];
    if (size > 0 && count->IsConstant() && (count->value < 0 || count->value >= size)) {
      Report(Code::kIndexOutOfBounds, index.range, count->value, array->name, size - 1);
      return std::nullopt;
    }
    Advance(*array, *count, false, inner.range);
  }
  array->dimensions.erase(array->dimensions.begin());
  return array;
}

// The first element of an array; a number, if the array is the place of one.
std::optional<Operand> Lowerer::ElementOf(const ArrayPlace& array, SourceRange range) {
  const Variable& variable = program_.variables[static_cast<size_t>(array.variable)];
  const int64_t size = std::max(variable.size, 1);
  if (array.offset.IsConstant() && (array.offset.value < 0 || array.offset.value >= size)) {
    Report(Code::kIndexOutOfBounds, range, array.offset.value, array.name, size - 1);
    return std::nullopt;
  }
  if (variable.size == 0 && array.offset.IsConstant()) return VariableOperand(array.variable);
  if (variable.size == 0) {
    Report(Code::kNotLowered, range,
           MakeMessage("an index into '{0}', which is one number here",
                       "'{0}' 的下标，它在此处是一个数", array.name),
           MakeMessage("pass an array", "请传递数组"));
    return std::nullopt;
  }
  Operand operand;
  operand.kind = Operand::Kind::kElement;
  operand.type = variable.type;
  operand.variable = array.variable;
  if (array.offset.IsConstant()) {
    operand.value = array.offset.value;
    operand.name = array.offset.name;
    return operand;
  }
  Operand index = array.offset;
  if (!index.IsVariable()) {
    const Operand loaded = NewTemporary(vm::DataType::kInt, range);
    EmitCopy(loaded, index, range);
    index = loaded;
  }
  operand.index = index.variable;
  return operand;
}

std::optional<Place> Lowerer::LowerElement(const Expression& expression) {
  const std::optional<ArrayPlace> array = LowerArray(expression);
  if (!array) return std::nullopt;
  if (!array->dimensions.empty()) {
    Report(Code::kArrayWithoutIndex, expression.range, Source(expression.range));
    return std::nullopt;
  }
  if (array->element.own != nullptr) {
    ReportStructure(expression);
    return std::nullopt;
  }
  const std::optional<Operand> operand = ElementOf(*array, expression.range);
  if (!operand) return std::nullopt;
  return Place{*operand, array->element};
}

// Where a number is expected.
void Lowerer::ReportStructure(const Expression& expression) {
  Report(Code::kMisuse, expression.range, Source(expression.range),
         MakeMessage("a structure", "结构"), MakeMessage("one of its members", "它的成员"));
}

// A member of a structure.
bool Lowerer::IsOwnMember(const Expression& expression) const {
  const std::optional<Shape> whole = ShapeOf(*expression.operands[0]);
  return whole && whole->type.own != nullptr;
}

void Lowerer::ReportNotAStructure(const Expression& member) {
  const Expression& whole = *member.operands[0];
  if (member.op == "->") {
    Report(Code::kNeedsPointer, member.range, member.op);
  } else if (LowerPlace(whole)) {
    Report(Code::kNoMember, member.op_range, Source(whole.range), member.text);
  }
}

std::optional<Place> Lowerer::LowerPlace(const Expression& expression) {
  const Expression& inner = WithoutParens(expression);
  switch (inner.kind) {
    case Expression::Kind::kIndex:
    case Expression::Kind::kCompoundLiteral:
      return LowerElement(inner);
    case Expression::Kind::kUnary:
      if (inner.op == "*") return LowerElement(inner);
      break;
    case Expression::Kind::kMember:
      if (IsOwnMember(inner)) return LowerElement(inner);
      ReportNotAStructure(inner);
      return std::nullopt;
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
      if (symbol->type.own != nullptr) {
        ReportStructure(inner);
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
