// Initial values: of locals, which are assigned where they are declared, and of globals, which are
// collected for the start of the thread functions (start.cc).
#include <algorithm>
#include <numeric>

#include "compiler/lowering/lowerer.h"
#include "compiler/tree_walk.h"
#include "vm/limits.h"

namespace oncard::compiler::lowering {
namespace {

// Shorter runs of zeros are assigned one by one.
constexpr int64_t kClearedByLoop = 6;

int64_t Product(const std::vector<int64_t>& dimensions, size_t from) {
  return std::accumulate(dimensions.begin() + static_cast<std::ptrdiff_t>(from), dimensions.end(),
                         int64_t{1}, [](int64_t a, int64_t b) { return a * b; });
}

}  // namespace

// The value of a number, which may have braces; nullptr: 0, or an error.
const Expression* Lowerer::ScalarValue(const Expression& value) {
  const Expression* inner = &value;
  while (inner->kind == Expression::Kind::kBraces) {
    if (inner->operands.empty()) return nullptr;
    if (inner->operands.size() > 1) {
      Report(Code::kTooManyValues, inner->operands[1]->range, int64_t{1});
      return nullptr;
    }
    inner = inner->operands[0].get();
  }
  if (inner->kind != Expression::Kind::kDesignated) return inner;
  Report(Code::kTooManyValues, inner->range, int64_t{1});
  return nullptr;
}

int64_t Lowerer::Width(const Shape& shape) {
  const int64_t values = shape.type.structure != nullptr
                             ? static_cast<int64_t>(shape.type.structure->members.size())
                             : 1;
  return Product(shape.dimensions, 0) * values;
}

// A row of an array, or a member of a structure.
Lowerer::Part Lowerer::PartOf(const Shape& whole, int64_t number) const {
  Part part;
  if (!whole.dimensions.empty()) {
    part.shape = {whole.type, {whole.dimensions.begin() + 1, whole.dimensions.end()}};
    part.begin = number * Width(part.shape);
  } else {
    part.shape.type.basic = MemberType(whole.type.structure->members[static_cast<size_t>(number)]);
    part.begin = number;
  }
  return part;
}

// The outermost part of an aggregate that begins at a value of it.
Shape Lowerer::PartAt(const Shape& whole, int64_t position) const {
  Part part = {whole, 0};
  do {
    const int64_t row = part.shape.dimensions.empty() ? 1 : Width(PartOf(part.shape, 0).shape);
    part = PartOf(part.shape, position / row);
    position -= part.begin;
  } while (position != 0);
  return part.shape;
}

bool Lowerer::IsAggregate(const Shape& shape) {
  return !shape.dimensions.empty() || shape.type.basic == BasicType::kStructure;
}

// Where a designator leads from the beginning of a row or a structure; nullopt, with a report, if
// there is no such place.
std::optional<Lowerer::Designation> Lowerer::Designate(const Expression& designator,
                                                       const Shape& whole, std::string_view name) {
  const bool is_structure = whole.dimensions.empty() && whole.type.basic == BasicType::kStructure;
  if (is_structure || !designator.text.empty()) {
    const std::optional<int64_t> member =
        is_structure ? MemberNumber(whole.type, designator.text) : std::nullopt;
    if (member) return Designation{*member, *member};
    Report(Code::kNoMember, designator.op_range, is_structure ? NameOfStructure(whole.type) : name,
           Source(designator.op_range));
    return std::nullopt;
  }
  if (whole.dimensions.empty()) {
    Report(Code::kTooManyValues, designator.range, int64_t{1});
    return std::nullopt;
  }
  // An array without a size has at most all slots.
  const int64_t size = whole.dimensions[0] > 0 ? whole.dimensions[0] : int64_t{vm::kSlotCount};
  Designation result;
  for (size_t i = 1; i < designator.operands.size(); ++i) {
    const Expression& index = *designator.operands[i];
    const std::optional<int64_t> value = EvaluateInteger(index);
    if (!value) {
      Report(Code::kConstantNeeded, index.range, Source(index.range));
      return std::nullopt;
    }
    if (*value < 0 || *value >= size || (i > 1 && *value < result.first)) {
      Report(Code::kIndexOutOfBounds, index.range, *value, name, size - 1);
      return std::nullopt;
    }
    if (i == 1) result.first = *value;
    result.last = *value;
  }
  if (result.last > result.first && HasEffects(*designator.operands[0])) {
    Report(Code::kNotForTheCard, designator.range, Source(designator.range),
           MakeMessage("its value does something else, too; write it for each element",
                       "其值还有其他作用；请为每个元素分别写出"));
    return std::nullopt;
  }
  return result;
}

// The part that begins at a value of an aggregate, or within it, for which an item is: the
// outermost one if it has braces, otherwise a number.
Shape Lowerer::PartFor(const Expression& item, Shape part) const {
  if (item.kind == Expression::Kind::kBraces) return part;
  while (IsAggregate(part)) part = PartOf(part, 0).shape;
  return part;
}

// The values between braces in the order of the elements, by C17 6.7.9, paragraphs 17 to 20: inner
// braces hold the row or the element that begins there; without them the values continue from row
// to row, and after a designator from its place.
bool Lowerer::Flatten(const Expression& braces, const Shape& whole, int64_t base,
                      Filling& filling) {
  const int64_t size = Width(whole);  // 0: as many as there are
  int64_t position = 0;
  for (const ExpressionPtr& item : braces.operands) {
    if (item->kind == Expression::Kind::kDesignated) {
      if (!FlattenDesignated(*item, whole, base, filling, &position)) return false;
      continue;
    }
    if (size > 0 && position >= size) {
      Report(Code::kTooManyValues, item->range, size);
      return false;
    }
    const Shape part = PartFor(*item, PartAt(whole, position));
    if (!FlattenItem(*item, part, base + position, filling)) return false;
    position += Width(part);
  }
  return true;
}

// The value of an element, or the braces of a row, which replace what was there.
bool Lowerer::FlattenItem(const Expression& item, const Shape& part, int64_t position,
                          Filling& filling) {
  Elements& elements = filling.elements;
  const size_t begin = static_cast<size_t>(position);
  const size_t end = begin + static_cast<size_t>(Width(part));
  if (elements.size() <= begin) elements.resize(begin + 1, nullptr);
  std::fill(elements.begin() + static_cast<std::ptrdiff_t>(std::min(begin, elements.size())),
            elements.begin() + static_cast<std::ptrdiff_t>(std::min(end, elements.size())),
            nullptr);
  if (IsAggregate(part)) return Flatten(item, part, position, filling);
  elements[begin] = ScalarValue(item);
  return true;
}

// `[1] = value` within an aggregate that begins at `base`; `position` becomes the place after it.
bool Lowerer::FlattenDesignated(const Expression& item, const Shape& whole, int64_t base,
                                Filling& filling, int64_t* position) {
  const std::optional<Designation> place = Designate(item, whole, filling.name);
  if (!place) return false;
  const Expression& value = *item.operands[0];
  for (int64_t i = place->first; i <= place->last; ++i) {
    const Part designated = PartOf(whole, i);
    const int64_t begin = base + designated.begin;
    int64_t within = 0;
    if (value.kind == Expression::Kind::kDesignated) {
      if (!FlattenDesignated(value, designated.shape, begin, filling, &within)) return false;
    } else {
      const Shape part = PartFor(value, designated.shape);
      if (!FlattenItem(value, part, begin, filling)) return false;
      within = Width(part);
    }
    *position = designated.begin + within;
  }
  return true;
}

std::optional<Lowerer::Elements> Lowerer::ElementsOf(const Declarator& declarator,
                                                     const Symbol& symbol) {
  const Expression* values = declarator.initialiser.get();
  if (values == nullptr || values->kind != Expression::Kind::kBraces) {
    Report(Code::kArrayValues, values == nullptr ? declarator.head : values->range,
           declarator.name);
    return std::nullopt;
  }
  Filling filling;
  filling.name = declarator.name;
  if (!Flatten(*values, {symbol.type, symbol.dimensions}, 0, filling)) return std::nullopt;
  return std::move(filling.elements);
}

Operand Lowerer::ElementOperand(const Symbol& symbol, int64_t index) const {
  Operand operand = VariableOperand(symbol.variable);
  if (symbol.type.structure != nullptr) {
    operand.kind = Operand::Kind::kMember;
    operand.member = static_cast<int16_t>(index);
    operand.type =
        gtcalls::ProgramType(symbol.type.structure->members[static_cast<size_t>(index)].type);
  } else {
    operand.kind = Operand::Kind::kElement;
    operand.value = index;
  }
  return operand;
}

void Lowerer::InitialiseGlobal(const Declarator& declarator, const Symbol& symbol) {
  const auto add = [this, &symbol](const Operand& target, const Expression& expression) {
    const std::optional<TypedConstant> value = Evaluate(expression);
    const BasicType type = target.type == vm::DataType::kDouble ? BasicType::kDouble
                           : symbol.type.structure != nullptr   ? BasicType::kInt
                                                                : symbol.type.basic;
    const std::optional<TypedConstant> converted =
        value ? ConvertConstant(*value, type) : std::nullopt;
    if (!converted) {
      Report(Code::kConstantNeeded, expression.range, Source(expression.range));
      return;
    }
    const Operand operand = ConstantValue(*converted, expression).operand;
    if (operand.value != 0) initial_values_.push_back({target, operand, expression.range});
  };
  if (symbol.dimensions.empty() && symbol.type.structure == nullptr) {
    const Expression* value = ScalarValue(*declarator.initialiser);
    if (value != nullptr) add(VariableOperand(symbol.variable), *value);
    return;
  }
  const std::optional<Elements> elements = ElementsOf(declarator, symbol);
  if (!elements) return;
  for (size_t i = 0; i < elements->size(); ++i) {
    if ((*elements)[i] == nullptr) continue;
    add(ElementOperand(symbol, static_cast<int64_t>(i)), *(*elements)[i]);
  }
}

void Lowerer::ClearElements(const Symbol& symbol, int64_t begin, int64_t end, SourceRange range) {
  const Operand zero = ConstantOperand(DataTypeOf(symbol.type.basic), 0);
  if (end - begin < kClearedByLoop || symbol.type.structure != nullptr) {
    for (int64_t i = begin; i < end; ++i) {
      Operand target = ElementOperand(symbol, i);
      EmitCopy(target, ConstantOperand(target.type, 0), range);
    }
    return;
  }
  const Operand index = NewTemporary(vm::DataType::kInt, range);
  const int loop = NewLabel("clear", range);
  EmitCopy(index, IntOperand(begin), range);
  EmitLabel(loop, range);
  Operand target = ElementOperand(symbol, 0);
  target.index = index.variable;
  EmitCopy(target, zero, range);
  Instruction step;
  step.kind = Instruction::Kind::kBinary;
  step.target = index;
  step.a = index;
  step.b = IntOperand(1);
  Emit(std::move(step), range);
  const Value more =
      Compute(vm::BinaryOperator::kLess, index, IntOperand(end), BasicType::kInt, range);
  EmitIf(more.operand, loop, range);
}

void Lowerer::InitialiseLocal(const Declarator& declarator, const Symbol& symbol) {
  const Expression* value = declarator.initialiser.get();
  BeginFullExpression(declarator.range);
  const bool aggregate = !symbol.dimensions.empty() || symbol.type.structure != nullptr;
  if (!aggregate) {
    const Operand target = VariableOperand(symbol.variable);
    value = ScalarValue(*value);
    if (value != nullptr) {
      AssignInto({target, symbol.type}, *value);
    } else {
      EmitCopy(target, ConstantOperand(target.type, 0), declarator.range);
    }
    return;
  }
  if (symbol.type.structure != nullptr && value->kind != Expression::Kind::kBraces) {
    const std::optional<Place> source = LowerPlace(*value);
    if (source && source->type.structure == symbol.type.structure) {
      for (size_t i = 0; i < symbol.type.structure->members.size(); ++i) {
        const Operand target = ElementOperand(symbol, static_cast<int64_t>(i));
        Operand from = target;
        from.variable = source->operand.variable;
        EmitCopy(target, from, value->range);
      }
      return;
    }
  }
  const std::optional<Elements> elements = ElementsOf(declarator, symbol);
  if (!elements) return;
  const int64_t size = symbol.type.structure != nullptr
                           ? static_cast<int64_t>(symbol.type.structure->members.size())
                           : Product(symbol.dimensions, 0);
  const auto at = [&elements](int64_t i) {
    return static_cast<size_t>(i) < elements->size() ? (*elements)[static_cast<size_t>(i)]
                                                     : nullptr;
  };
  for (int64_t i = 0; i < size;) {
    if (at(i) == nullptr) {
      int64_t end = i;
      while (end < size && at(end) == nullptr) ++end;
      ClearElements(symbol, i, end, declarator.range);
      i = end;
      continue;
    }
    Place place = {ElementOperand(symbol, i), symbol.type};
    if (symbol.type.structure != nullptr) {
      place.type = Type();
      place.type.basic = MemberType(symbol.type.structure->members[static_cast<size_t>(i)]);
    }
    AssignInto(place, *at(i));
    ++i;
  }
}

}  // namespace oncard::compiler::lowering
