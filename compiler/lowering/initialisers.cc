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
  const Type& type = shape.type;
  return Product(shape.dimensions, 0) * (type.own != nullptr ? type.own->values : 1);
}

// A row of an array, or a member of a structure.
Lowerer::Part Lowerer::PartOf(const Shape& whole, int64_t number) const {
  Part part;
  if (!whole.dimensions.empty()) {
    part.shape = {whole.type, {whole.dimensions.begin() + 1, whole.dimensions.end()}};
    part.begin = number * Width(part.shape);
  } else if (whole.type.own != nullptr) {
    const OwnMember& member = whole.type.own->members[static_cast<size_t>(number)];
    part.shape = {member.type, member.dimensions};
    part.begin = member.begin;
  }
  return part;
}

// Which row or member a value of an aggregate belongs to.
int64_t Lowerer::PartNumberAt(const Shape& whole, int64_t position) const {
  if (!whole.dimensions.empty()) return position / Width(PartOf(whole, 0).shape);
  if (whole.type.own == nullptr) return position;
  const std::vector<OwnMember>& members = whole.type.own->members;
  const auto next =
      std::upper_bound(members.begin(), members.end(), position,
                       [](int64_t place, const OwnMember& member) { return place < member.begin; });
  return next - members.begin() - 1;
}

// The outermost part of an aggregate that begins at a value of it.
Shape Lowerer::PartAt(const Shape& whole, int64_t position) const {
  Part part = {whole, 0};
  do {
    part = PartOf(part.shape, PartNumberAt(part.shape, position));
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
    if (is_structure && !designator.text.empty()) {
      ReportNoMember(*whole.type.own, designator.text, designator.op_range);
    } else {
      Report(Code::kNoMember, designator.op_range, is_structure ? whole.type.own->name : name,
             Source(designator.op_range));
    }
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
// outermost one if it has braces, otherwise a number, or a structure if the item is one.
Shape Lowerer::PartFor(const Expression& item, Shape part) const {
  if (item.kind == Expression::Kind::kBraces) return part;
  while (IsAggregate(part) && !HasType(item, part)) part = PartOf(part, 0).shape;
  return part;
}

// Whether a value is a structure of this type.
bool Lowerer::HasType(const Expression& value, const Shape& shape) const {
  const Type& type = shape.type;
  if (type.basic != BasicType::kStructure || !shape.dimensions.empty()) return false;
  const std::optional<Shape> given = ShapeOf(value);
  return given && given->dimensions.empty() && given->type.own == type.own;
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

// The value of an element, or of a structure, or the braces of a row, which replace what was there.
bool Lowerer::FlattenItem(const Expression& item, const Shape& part, int64_t position,
                          Filling& filling) {
  Elements& elements = filling.elements;
  const size_t begin = static_cast<size_t>(position);
  const size_t end = begin + static_cast<size_t>(Width(part));
  const bool is_braces = item.kind == Expression::Kind::kBraces;
  if (elements.size() <= begin) elements.resize(begin + 1);
  const bool within = elements[begin].of_structure && elements[begin].value == nullptr;
  const bool before =
      end < elements.size() && elements[end].of_structure && elements[end].value == nullptr;
  if (within || before) {
    Report(
        Code::kNotForTheCard, item.range, Source(item.range),
        MakeMessage("a structure before it gives this member its value; write the members of the "
                    "structure one by one",
                    "它之前的结构已给出该成员的值；请逐个写出该结构的成员"));
    return false;
  }
  std::fill(elements.begin() + static_cast<std::ptrdiff_t>(begin),
            elements.begin() + static_cast<std::ptrdiff_t>(std::min(end, elements.size())),
            Element());
  if (IsAggregate(part) && is_braces) return Flatten(item, part, position, filling);
  if (!IsAggregate(part)) {
    elements[begin].value = ScalarValue(item);
    return true;
  }
  if (elements.size() < end) elements.resize(end);
  for (size_t i = begin; i < end; ++i) elements[i].of_structure = true;
  elements[begin].value = &item;
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
  if (declarator.initialiser != nullptr) {
    return ElementsOf(*declarator.initialiser, declarator.name, symbol);
  }
  Report(Code::kArrayValues, declarator.head, declarator.name);
  return std::nullopt;
}

std::optional<Lowerer::Elements> Lowerer::ElementsOf(const Expression& values,
                                                     std::string_view name, const Symbol& symbol) {
  if (values.kind != Expression::Kind::kBraces) {
    Report(Code::kArrayValues, values.range, name);
    return std::nullopt;
  }
  Filling filling;
  filling.name = name;
  if (!Flatten(values, {symbol.type, symbol.dimensions}, 0, filling)) return std::nullopt;
  return std::move(filling.elements);
}

// The number of a variable, or an element of an array.
Operand Lowerer::ElementOperand(int variable, int64_t index) const {
  Operand operand = VariableOperand(variable);
  if (program_.variables[static_cast<size_t>(variable)].size > 0) {
    operand.kind = Operand::Kind::kElement;
    operand.value = index;
  }
  return operand;
}

// Where a value of a variable is: the number, or the structure of a type that begins there.
ArrayPlace Lowerer::PlaceAt(const Symbol& symbol, int64_t position, const OwnStructure* own) const {
  Part part = {{symbol.type, symbol.dimensions}, 0};
  ArrayPlace place;
  place.variable = symbol.variable;
  int64_t element = 0;
  while (IsAggregate(part.shape)) {
    const OwnStructure* const structure = part.shape.type.own;
    if (part.shape.dimensions.empty() && structure == own) break;
    const int64_t number = PartNumberAt(part.shape, position);
    if (!part.shape.dimensions.empty()) {
      element = element * part.shape.dimensions[0] + number;
    } else if (structure != nullptr) {
      place.variable += structure->members[static_cast<size_t>(number)].leaf;
    }
    part = PartOf(part.shape, number);
    position -= part.begin;
  }
  place.element = part.shape.type;
  place.offset = IntOperand(element);
  place.name = Source(symbol.range);
  return place;
}

void Lowerer::InitialiseGlobal(const Declarator& declarator, const Symbol& symbol) {
  const auto add = [this](const Operand& target, const Type& type, const Expression& expression) {
    const std::optional<TypedConstant> value = Evaluate(expression);
    const std::optional<TypedConstant> converted =
        value ? ConvertConstant(*value, type.basic) : std::nullopt;
    if (!converted) {
      Report(Code::kConstantNeeded, expression.range, Source(expression.range));
      return;
    }
    const Operand operand = ConstantValue(*converted, expression).operand;
    if (operand.value != 0) initial_values_.push_back({target, operand, expression.range});
  };
  if (!IsAggregate({symbol.type, symbol.dimensions})) {
    const Expression* value = ScalarValue(*declarator.initialiser);
    if (value != nullptr) add(VariableOperand(symbol.variable), symbol.type, *value);
    return;
  }
  const std::optional<Elements> elements = ElementsOf(declarator, symbol);
  if (!elements) return;
  for (size_t i = 0; i < elements->size(); ++i) {
    const Expression* const value = (*elements)[i].value;
    if (value == nullptr) continue;
    const ArrayPlace place = PlaceAt(symbol, static_cast<int64_t>(i), nullptr);
    add(ElementOperand(place.variable, place.offset.value), place.element, *value);
  }
}

void Lowerer::ClearElements(int variable, int64_t begin, int64_t end, SourceRange range) {
  if (end - begin < kClearedByLoop) {
    for (int64_t i = begin; i < end; ++i) {
      const Operand target = ElementOperand(variable, i);
      EmitCopy(target, ConstantOperand(target.type, 0), range);
    }
    return;
  }
  const Operand index = NewTemporary(vm::DataType::kInt, range);
  const int loop = NewLabel("clear", range);
  EmitCopy(index, IntOperand(begin), range);
  EmitLabel(loop, range);
  Operand target = ElementOperand(variable, 0);
  target.index = index.variable;
  EmitCopy(target, ConstantOperand(target.type, 0), range);
  StepTo(index, end, loop, range);
}

// Gives a number or an array its values; those that a structure gives it are there already.
void Lowerer::InitialiseLeaf(int variable, const Type& type, const Elements& values,
                             SourceRange range) {
  const auto is_zero = [&values](size_t i) {
    return values[i].value == nullptr && !values[i].of_structure;
  };
  for (size_t i = 0; i < values.size();) {
    if (is_zero(i)) {
      size_t end = i;
      while (end < values.size() && is_zero(end)) ++end;
      ClearElements(variable, static_cast<int64_t>(i), static_cast<int64_t>(end), range);
      i = end;
      continue;
    }
    if (!values[i].of_structure) {
      AssignInto({ElementOperand(variable, static_cast<int64_t>(i)), type}, *values[i].value);
    }
    ++i;
  }
}

void Lowerer::InitialiseLocal(const Declarator& declarator, const Symbol& symbol) {
  BeginFullExpression(declarator.range);
  Initialise(*declarator.initialiser, declarator.name, declarator.range, symbol);
}

void Lowerer::Initialise(const Expression& initialiser, std::string_view name, SourceRange range,
                         const Symbol& symbol) {
  const Expression* value = &initialiser;
  const Shape whole = {symbol.type, symbol.dimensions};
  if (!IsAggregate(whole)) {
    const Operand target = VariableOperand(symbol.variable);
    value = ScalarValue(*value);
    if (value != nullptr) {
      AssignInto({target, symbol.type}, *value);
    } else {
      EmitCopy(target, ConstantOperand(target.type, 0), range);
    }
    return;
  }
  if (symbol.dimensions.empty() && value->kind != Expression::Kind::kBraces) {
    StoreStructure(PlaceAt(symbol, 0, symbol.type.own), *value);
    return;
  }
  std::optional<Elements> elements = ElementsOf(initialiser, name, symbol);
  if (!elements) return;
  elements->resize(static_cast<size_t>(Width(whole)));
  // C leaves the order of the values open. Those of one variable of the card come together.
  const size_t leaves = symbol.type.own != nullptr ? symbol.type.own->leaves.size() : 1;
  std::vector<Elements> values(leaves);
  for (size_t i = 0; i < elements->size(); ++i) {
    const Element& element = (*elements)[i];
    const ArrayPlace place = PlaceAt(symbol, static_cast<int64_t>(i), nullptr);
    Elements& of_leaf = values[static_cast<size_t>(place.variable - symbol.variable)];
    of_leaf.resize(std::max(of_leaf.size(), static_cast<size_t>(place.offset.value) + 1));
    of_leaf[static_cast<size_t>(place.offset.value)] = element;
    if (!element.of_structure || element.value == nullptr) continue;
    const OwnStructure* const own = ShapeOf(*element.value)->type.own;
    StoreStructure(PlaceAt(symbol, static_cast<int64_t>(i), own), *element.value);
  }
  for (size_t i = 0; i < leaves; ++i) {
    const Type& type = symbol.type.own != nullptr ? symbol.type.own->leaves[i].type : symbol.type;
    InitialiseLeaf(symbol.variable + static_cast<int>(i), type, values[i], range);
  }
}

// `(struct s){1, 2}`: a variable without a name.
std::optional<ArrayPlace> Lowerer::LowerCompoundLiteral(const Expression& literal) {
  const std::string_view written = Source(literal.range);
  Symbol symbol;
  symbol.type = ResolveType(literal.type->specifiers);
  symbol.range = literal.range;
  symbol.offset = IntOperand(0);
  if (!literal.type->sizes.empty() || symbol.type.rows != nullptr) {
    Report(Code::kNotLowered, literal.range,
           MakeMessage("an array without a name", "没有名称的数组"),
           MakeMessage("declare a variable", "请声明变量"));
    return std::nullopt;
  }
  if (!IsComplete(symbol.type, written, literal.range)) return std::nullopt;
  symbol.variable =
      VariableOf(&literal, Variable::Role::kLocal, "literal", symbol.type, {}, literal.range);
  Initialise(*literal.operands[0], written, literal.range, symbol);
  return ArrayPlace{symbol.variable, symbol.offset, {}, symbol.type, written};
}

}  // namespace oncard::compiler::lowering
