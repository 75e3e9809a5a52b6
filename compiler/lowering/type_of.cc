// The type of an expression without computing it: for `?:`, whose branches need a common type, and
// for `sizeof`.
#include <algorithm>

#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {

namespace {

// The type of C that a member of a structure has.
BasicType TypeOfMember(const gtcalls::Member& member) {
  switch (member.type) {
    case gtcalls::Scalar::kChar:
      return BasicType::kChar;
    case gtcalls::Scalar::kUnsignedChar:
      return BasicType::kUnsignedChar;
    case gtcalls::Scalar::kShort:
      return BasicType::kShort;
    case gtcalls::Scalar::kUnsignedShort:
      return BasicType::kUnsignedShort;
    case gtcalls::Scalar::kInt:
    case gtcalls::Scalar::kLong:
      return BasicType::kInt;
    case gtcalls::Scalar::kUnsignedLong:
      return BasicType::kUnsigned;
    case gtcalls::Scalar::kDouble:
      return BasicType::kDouble;
  }
  return BasicType::kInt;
}

}  // namespace

// What `p++`, `--p`, `p += n` and `p = q` change, nullptr for other expressions.
const Expression* MovesOf(const Expression& expression) {
  using Kind = Expression::Kind;
  const bool moves = expression.kind == Kind::kPostfix || expression.kind == Kind::kAssign ||
                     expression.kind == Kind::kCompound ||
                     (expression.kind == Kind::kUnary && expression.op.size() == 2);
  return moves ? &WithoutParens(*expression.operands[0]) : nullptr;
}

// What an expression names by indices, stars, `&`, sums and moves. An index goes one dimension
// down, `&x` one up, `a + 1` is an array as `a` is. nullopt for other expressions.
std::optional<Shape> Lowerer::ShapeOf(const Expression& expression) const {
  using Kind = Expression::Kind;
  const Expression& inner = WithoutParens(expression);
  if (const Expression* const moved = MovesOf(inner)) return ShapeOf(*moved);
  const auto operand = [this, &inner](size_t i) { return ShapeOf(*inner.operands[i]); };
  const auto is_array = [](const std::optional<Shape>& shape) {
    return shape && !shape->dimensions.empty();
  };
  if (inner.kind == Kind::kName) {
    const Symbol* const symbol = Lookup(inner.text);
    if (symbol == nullptr || symbol->kind != Symbol::Kind::kVariable) return std::nullopt;
    return Shape{symbol->type, symbol->dimensions, symbol->is_reference, symbol->invalid};
  }
  if (inner.kind == Kind::kBinary && (inner.op == "+" || inner.op == "-")) {
    // The array of a sum is on either side.
    std::optional<Shape> left = operand(0);
    std::optional<Shape> array = is_array(left) || inner.op == "-" ? std::move(left) : operand(1);
    if (!is_array(array) || (inner.op == "-" && is_array(operand(1)))) return std::nullopt;
    array->is_pointer = true;
    return array;
  }
  if (inner.kind == Kind::kUnary && inner.op == "&") {
    std::optional<Shape> place = operand(0);
    if (!place) return std::nullopt;
    place->dimensions.insert(place->dimensions.begin(), 0);
    place->is_pointer = true;
    return place;
  }
  if (inner.kind == Kind::kComma) return operand(1);
  if (inner.kind == Kind::kCompoundLiteral) {
    return Shape{ResolveType(inner.type->specifiers), {}};
  }
  if (inner.kind == Kind::kConditional) {
    std::optional<Shape> yes = operand(1);
    const bool is_structure = yes && !is_array(yes) && yes->type.own != nullptr;
    return is_structure ? std::move(yes) : std::nullopt;
  }
  if (inner.kind == Kind::kCall) {
    const Expression& callee = WithoutParens(*inner.operands[0]);
    const Symbol* const symbol = callee.kind == Kind::kName ? Lookup(callee.text) : nullptr;
    const bool is_structure =
        symbol != nullptr && symbol->kind == Symbol::Kind::kFunction && symbol->type.own != nullptr;
    return is_structure ? std::optional(Shape{symbol->type, {}}) : std::nullopt;
  }
  if (inner.kind == Kind::kMember) {
    std::optional<Shape> whole = operand(0);
    if (inner.op == "->" && whole && whole->dimensions.size() == 1) whole->dimensions.clear();
    if (!whole || !whole->dimensions.empty() || whole->type.basic != BasicType::kStructure) {
      return std::nullopt;
    }
    const std::optional<int64_t> number = MemberNumber(whole->type, inner.text);
    if (!number) return std::nullopt;
    Shape member = PartOf(*whole, *number).shape;
    member.type.is_const |= whole->type.is_const;
    return member;
  }
  if (inner.kind == Kind::kIndex || (inner.kind == Kind::kUnary && inner.op == "*")) {
    std::optional<Shape> array = operand(0);
    if (!is_array(array)) return std::nullopt;
    array->dimensions.erase(array->dimensions.begin());
    array->is_pointer = false;
    return array;
  }
  return std::nullopt;
}

// Which member of a structure has a name.
std::optional<int64_t> Lowerer::MemberNumber(const Type& type, std::string_view name) {
  const std::vector<OwnMember>& members = type.own->members;
  const auto found = std::find_if(members.begin(), members.end(),
                                  [name](const OwnMember& member) { return member.name == name; });
  return found != members.end() ? std::optional(found - members.begin()) : std::nullopt;
}

// Bytes, as the controllers' compilers lay types out.
int64_t Lowerer::SizeOfType(const Type& type) {
  return type.own != nullptr ? type.own->bytes : SizeOf(type.basic);
}

int64_t Lowerer::AlignmentOf(const Type& type) {
  return type.own != nullptr ? type.own->alignment : SizeOf(type.basic);
}

BasicType Lowerer::MemberType(const gtcalls::Member& member) const { return TypeOfMember(member); }

std::optional<BasicType> Lowerer::CastType(const Expression& expression) {
  const TypeName& name = *expression.type;
  if (!name.sizes.empty()) return std::nullopt;
  const Type type = ResolveType(name.specifiers);
  return type.basic == BasicType::kStructure || type.rows != nullptr ? std::nullopt
                                                                     : std::optional(type.basic);
}

// Empty for what has no size here.
std::optional<int64_t> Lowerer::SizeOfOperand(const Expression& expression) {
  const auto product = [](int64_t size, const std::vector<int64_t>& dimensions, size_t from) {
    for (size_t i = from; i < dimensions.size(); ++i) size *= dimensions[i];
    return size > 0 ? std::optional(size) : std::nullopt;
  };
  if (expression.type != nullptr) {
    const Type type = ResolveType(expression.type->specifiers);
    std::vector<int64_t> dimensions;
    for (const ExpressionPtr& size : expression.type->sizes) {
      const std::optional<int64_t> value = size != nullptr ? EvaluateInteger(*size) : std::nullopt;
      if (!value) return std::nullopt;
      dimensions.push_back(*value);
    }
    if (type.rows != nullptr) {
      dimensions.insert(dimensions.end(), type.rows->begin(), type.rows->end());
    }
    return product(SizeOfType(type), dimensions, 0);
  }
  const Expression& operand = WithoutParens(*expression.operands[0]);
  if (const std::optional<Shape> shape = ShapeOf(operand)) {
    if (shape->is_pointer) return SizeOf(BasicType::kUnsigned);
    return product(SizeOfType(shape->type), shape->dimensions, 0);
  }
  const BasicType type = TypeOf(operand);
  return IsArithmetic(type) ? std::optional<int64_t>(SizeOf(type)) : std::nullopt;
}

BasicType Lowerer::TypeOf(const Expression& expression) {
  using Kind = Expression::Kind;
  const auto operand = [this, &expression](size_t i) { return TypeOf(*expression.operands[i]); };
  switch (expression.kind) {
    case Kind::kLiteral: {
      const std::optional<TypedConstant> constant = Evaluate(expression);
      return constant ? constant->type : BasicType::kInt;
    }
    case Kind::kName: {
      const Symbol* symbol = Lookup(expression.text);
      if (symbol == nullptr) return BasicType::kInt;
      return symbol->kind == Symbol::Kind::kConstant ? symbol->constant.type : symbol->type.basic;
    }
    case Kind::kIndex: {
      const std::optional<Shape> element = ShapeOf(expression);
      return element ? element->type.basic : operand(0);
    }
    case Kind::kParen:
    case Kind::kPostfix:
    case Kind::kAssign:
    case Kind::kCompound:
      return operand(0);
    case Kind::kComma:
      return operand(1);
    case Kind::kCompoundLiteral:
    case Kind::kMember: {
      const std::optional<Shape> member = ShapeOf(expression);
      return member ? member->type.basic : BasicType::kInt;
    }
    case Kind::kUnary:
      if (expression.op == "!") return BasicType::kInt;
      if (expression.op == "*") {
        const std::optional<Shape> element = ShapeOf(expression);
        return element ? element->type.basic : operand(0);
      }
      if (expression.op == "++" || expression.op == "--") return operand(0);
      return Promoted(operand(0));
    case Kind::kBinary: {
      const vm::OperatorInfo* info = vm::FindBinaryOperator(expression.op);
      if (info == nullptr || vm::IsLogical(*info) || vm::IsComparison(*info)) {
        return BasicType::kInt;
      }
      if (IsArray(*expression.operands[1])) return BasicType::kInt;
      if (info->precedence == vm::Precedence::kShift) return Promoted(operand(0));
      return Common(operand(0), operand(1));
    }
    case Kind::kCast:
      return CastType(expression).value_or(BasicType::kInt);
    case Kind::kSizeof:
      return BasicType::kUnsigned;
    case Kind::kConditional: {
      const BasicType yes = operand(1);
      const BasicType no = operand(2);
      if (yes == BasicType::kStructure) return yes;
      return IsArithmetic(yes) && IsArithmetic(no) ? Common(yes, no) : BasicType::kVoid;
    }
    case Kind::kCall: {
      const Expression& callee = WithoutParens(*expression.operands[0]);
      const Symbol* symbol = callee.kind == Kind::kName ? Lookup(callee.text) : nullptr;
      if (symbol != nullptr) return symbol->type.basic;
      if (callee.text == "fabs") return BasicType::kDouble;
      return callee.text == "abs" ? BasicType::kInt : BasicType::kVoid;
    }
    default:
      return BasicType::kInt;
  }
}

}  // namespace oncard::compiler::lowering
