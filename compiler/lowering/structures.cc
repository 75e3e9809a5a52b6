// Structures. The card has none of a program, so a variable of one becomes a variable for each of
// its leaves: the numbers and arrays of numbers in it, also those in members that are structures
// themselves. Their variables have consecutive numbers, so that a member of a place is found by
// adding its first leaf. An array of structures becomes an array for each leaf: of `a[i].m[j]` the
// leaf is `a_m`, and the index `i * 3 + j`. The leaves of a structure of the card are one variable
// of the card, whose members they name; in an array they are arrays as well, and commands get the
// structure through a variable (commands.cc).
#include <fmt/core.h>

#include <algorithm>

#include "base/nearest.h"
#include "compiler/lowering/lowerer.h"
#include "vm/limits.h"

namespace oncard::compiler::lowering {
namespace {

// Longer arrays are copied by a loop.
constexpr int64_t kCopiedOneByOne = 6;

int64_t RoundedUp(int64_t bytes, int64_t alignment) {
  return (bytes + alignment - 1) / alignment * alignment;
}

}  // namespace

// A structure of the card.
const OwnStructure* Lowerer::CardStructure(const gtcalls::Structure& card) {
  const auto [entry, added] = card_structures_.try_emplace(&card);
  OwnStructure& structure = entry->second;
  if (!added) return &structure;
  structure.name = card.name;
  structure.card = &card;
  structure.complete = true;
  for (const gtcalls::Member& written : card.members) {
    OwnMember member;
    member.name = written.name;
    member.type.basic = MemberType(written);
    member.leaf = static_cast<int>(structure.leaves.size());
    member.begin = structure.values++;
    Leaf leaf;
    leaf.type = member.type;
    leaf.card = &card;
    leaf.member = static_cast<int16_t>(member.leaf);
    const int64_t size = SizeOfType(member.type);
    structure.bytes = RoundedUp(structure.bytes, size) + size;
    structure.alignment = std::max(structure.alignment, size);
    structure.leaves.push_back(std::move(leaf));
    structure.members.push_back(std::move(member));
  }
  structure.bytes = RoundedUp(structure.bytes, structure.alignment);
  return &structure;
}

// The structure that a type names; one without members if it is not defined there.
const OwnStructure* Lowerer::FindStructure(const StructSpecifier& syntax,
                                           const Scope* scope) const {
  static const OwnStructure kUnknown;
  if (syntax.defined) {
    const auto defined = structures_.find(&syntax);
    return defined != structures_.end() ? &defined->second : &kUnknown;
  }
  const Symbol* symbol = Lookup(syntax.tag);
  if (scope != nullptr) {
    const auto found = scope->find(syntax.tag);
    symbol = found != scope->end() ? &found->second : nullptr;
  }
  return symbol != nullptr ? symbol->type.own : &kUnknown;
}

// False, with a report, for a structure whose members are not known where something is declared.
bool Lowerer::IsComplete(const Type& type, std::string_view name, SourceRange range) {
  if (type.own == nullptr) return true;
  // Without members there was an error.
  if (type.own->complete) return type.own->values > 0;
  Report(Code::kNotForTheCard, range, name,
         MakeMessage("its structure is not defined before it; define it with its members first",
                     "它的结构在此之前没有定义；请先定义该结构及其成员"));
  return false;
}

void Lowerer::DefineStructure(const StructSpecifier& syntax) {
  const auto [entry, added] = structures_.try_emplace(&syntax);
  OwnStructure& structure = entry->second;
  structure.name = syntax.tag.empty() ? std::string_view("struct") : syntax.tag;
  for (const StatementPtr& member : syntax.members) {
    DefineTypesOf(member->specifiers);
    if (!added) continue;
    if (member->kind != Statement::Kind::kDeclaration) structure.invalid = true;
    const Type type = ResolveType(member->specifiers);
    for (const Declarator& declarator : member->declarators) AddMember(structure, declarator, type);
  }
  if (added) structure.bytes = RoundedUp(structure.bytes, structure.alignment);
  structure.complete = true;
  if (syntax.tag.empty()) return;
  Symbol symbol;
  symbol.kind = Symbol::Kind::kType;
  symbol.type.basic = BasicType::kStructure;
  symbol.type.own = &structure;
  symbol.range = syntax.name_range;
  Define(syntax.tag, std::move(symbol));
}

void Lowerer::AddMember(OwnStructure& structure, const Declarator& declarator, const Type& type) {
  const std::optional<std::vector<int64_t>> dimensions = Dimensions(declarator, type);
  const bool again = MemberOf(structure, declarator.name) != nullptr;
  if (again) Report(Code::kRedefinition, declarator.name_range, declarator.name);
  const bool good =
      dimensions && !again && IsComplete(type, declarator.name, declarator.name_range);
  if (!good) {
    structure.invalid = true;
    return;
  }
  OwnMember member;
  member.name = declarator.name;
  member.type = type;
  member.type.rows = nullptr;
  member.dimensions = *dimensions;
  member.leaf = static_cast<int>(structure.leaves.size());
  member.begin = structure.values;
  const int64_t width = Width({member.type, member.dimensions});
  if (structure.values + width > vm::kSlotCount) {
    Report(Code::kArraySize, declarator.head, declarator.name,
           std::to_string(structure.values + width), int64_t{vm::kSlotCount});
    structure.invalid = true;
    return;
  }
  structure.values += width;
  const int64_t count = Width({Type{}, member.dimensions});
  const std::string written = fmt::format(".{}{}", declarator.name, SpellSizes(member.dimensions));
  const auto add = [&](std::string name, const Leaf& leaf) {
    Leaf added = leaf;
    added.name = std::move(name);
    added.written = written + leaf.written;
    added.type.is_const |= type.is_const;
    added.is_array |= !member.dimensions.empty();
    added.size *= count;
    structure.leaves.push_back(std::move(added));
  };
  if (type.own != nullptr) {
    for (const Leaf& leaf : type.own->leaves) {
      add(JoinNames(declarator.name, leaf.name), leaf);
    }
  } else {
    Leaf leaf;
    leaf.type = member.type;
    add(std::string(declarator.name), leaf);
  }
  const int64_t alignment = AlignmentOf(member.type);
  structure.bytes = RoundedUp(structure.bytes, alignment) + count * SizeOfType(member.type);
  structure.alignment = std::max(structure.alignment, alignment);
  structure.members.push_back(std::move(member));
}

const OwnMember* Lowerer::MemberOf(const OwnStructure& structure, std::string_view name) {
  Type type;
  type.own = &structure;
  const std::optional<int64_t> number = MemberNumber(type, name);
  return number ? &structure.members[static_cast<size_t>(*number)] : nullptr;
}

void Lowerer::ReportNoMember(const OwnStructure& structure, std::string_view name,
                             SourceRange range) {
  // What was wrong about the structure may have been this member.
  if (structure.invalid) return;
  Diagnostic* const diagnostic = Report(Code::kNoMember, range, structure.name, name);
  if (diagnostic == nullptr) return;
  Nearest nearest(name);
  for (const OwnMember& member : structure.members) nearest.Add(member.name);
  if (nearest.best().empty()) return;
  AddNote(*diagnostic, MakeMessage("did you mean '{0}'?", "您是否想写 '{0}'？", nearest.best()));
}

// What begins at a member of a structure.
void Lowerer::Narrow(ArrayPlace& place, const OwnMember& member, SourceRange range) {
  const int64_t count = Width({Type{}, member.dimensions});
  place.variable += member.leaf;
  if (place.offset.IsConstant()) {
    place.offset = IntOperand(place.offset.value * count);
  } else if (count != 1) {
    place.offset = Compute(vm::BinaryOperator::kMultiply, place.offset, IntOperand(count),
                           BasicType::kInt, range)
                       .operand;
  }
  place.dimensions = member.dimensions;
  const bool is_const = place.element.is_const;
  place.element = member.type;
  place.element.is_const |= is_const;
  place.name = Source(range);
}

// `s.m` and `p->m`.
std::optional<ArrayPlace> Lowerer::LowerOwnMember(const Expression& expression) {
  const Expression& whole = *expression.operands[0];
  const bool arrow = expression.op == "->";
  std::optional<ArrayPlace> place = arrow ? LowerArray(whole) : LowerStructure(whole);
  if (!place) return std::nullopt;
  if (arrow && place->dimensions.size() != 1) {
    Report(Code::kNeedsPointer, expression.range, expression.op);
    return std::nullopt;
  }
  place->dimensions.clear();
  const OwnMember* const member = MemberOf(*place->element.own, expression.text);
  if (member == nullptr) {
    ReportNoMember(*place->element.own, expression.text, expression.op_range);
    return std::nullopt;
  }
  Narrow(*place, *member, expression.range);
  return place;
}

// A structure that is no part of another one, or of an array.
ArrayPlace Lowerer::StructureAt(int variable, const Type& type) {
  ArrayPlace place;
  place.variable = variable;
  place.offset = IntOperand(0);
  place.element = type;
  place.name = type.own->name;
  return place;
}

// Variables that a variable of a type becomes.
int Lowerer::LeavesOf(const Type& type) {
  return type.own != nullptr ? static_cast<int>(type.own->leaves.size()) : 1;
}

// Where a structure is that is the value of an expression.
std::optional<ArrayPlace> Lowerer::LowerStructure(const Expression& expression) {
  const Expression& inner = WithoutParens(expression);
  if (inner.kind == Expression::Kind::kAssign) {
    return AssignStructure(*inner.operands[0], *inner.operands[1]);
  }
  if (inner.kind == Expression::Kind::kComma) {
    LowerEffect(*inner.operands[0]);
    return LowerStructure(*inner.operands[1]);
  }
  if (inner.kind == Expression::Kind::kConditional) {
    const std::optional<Shape> shape = ShapeOf(inner);
    if (shape && shape->type.own != nullptr) {
      const ArrayPlace chosen = StructureAt(
          VariableOf(&inner, Variable::Role::kLocal, "chosen", shape->type, {}, inner.range),
          shape->type);
      StoreStructure(chosen, inner);
      return chosen;
    }
  }
  if (inner.kind == Expression::Kind::kCall) {
    const std::optional<Shape> result = ShapeOf(inner);
    const Value value = LowerCall(inner);
    if (!RequireNumber(value, inner)) return std::nullopt;
    if (result && result->type.own != nullptr) {
      return StructureAt(value.operand.variable, result->type);
    }
    Report(Code::kMisuse, inner.range, Source(inner.range), MakeMessage("a number", "数"),
           MakeMessage("a structure", "结构"));
    return std::nullopt;
  }
  const std::optional<Shape> shape = ShapeOf(inner);
  const bool known = !shape || shape->invalid || shape->type.own != nullptr;
  const bool names =
      inner.kind == Expression::Kind::kName || inner.kind == Expression::Kind::kMember ||
      inner.kind == Expression::Kind::kIndex || inner.kind == Expression::Kind::kUnary ||
      inner.kind == Expression::Kind::kCompoundLiteral;
  std::optional<ArrayPlace> place = known && names ? LowerArray(inner) : std::nullopt;
  if (place && place->element.own != nullptr && place->dimensions.empty()) return place;
  if (place || !known || !names) {
    const bool array = shape && !shape->dimensions.empty();
    Report(Code::kMisuse, inner.range, Source(inner.range),
           array ? MakeMessage("an array", "数组") : MakeMessage("a number", "数"),
           MakeMessage("a structure", "结构"));
  }
  return std::nullopt;
}

std::optional<ArrayPlace> Lowerer::AssignStructure(const Expression& target,
                                                   const Expression& value) {
  if (!CheckPlace(target)) return std::nullopt;
  std::optional<ArrayPlace> to = LowerStructure(target);
  if (!to) return std::nullopt;
  const std::vector<Leaf>& leaves = to->element.own->leaves;
  const bool is_const =
      to->element.is_const || std::any_of(leaves.begin(), leaves.end(),
                                          [](const Leaf& leaf) { return leaf.type.is_const; });
  if (is_const) {
    Report(Code::kWriteToConst, target.range, Source(target.range));
    return std::nullopt;
  }
  to->offset = Stable(to->offset, target.range);
  StoreStructure(*to, value);
  return to;
}

// Gives a structure the value of an expression.
void Lowerer::StoreStructure(const ArrayPlace& to, const Expression& value) {
  const Expression& inner = WithoutParens(value);
  const SourceRange range = inner.range;
  if (inner.kind == Expression::Kind::kConditional) {
    const int otherwise = NewLabel("cond", range, "else");
    const int end = NewLabel("cond", range, "end");
    BranchIf(*inner.operands[0], false, otherwise);
    StoreStructure(to, *inner.operands[1]);
    EmitGoto(end, range);
    EmitLabel(otherwise, range);
    StoreStructure(to, *inner.operands[2]);
    EmitLabel(end, range);
    return;
  }
  const std::optional<ArrayPlace> from = LowerStructure(inner);
  if (!from) return;
  if (from->element.own == to.element.own) {
    CopyStructure(to, *from, range);
    return;
  }
  Report(Code::kTypeMismatch, range, MakeMessage("a '{}'", "'{}'", from->element.own->name),
         ToMessage(fmt::format("'{}'", to.element.own->name)),
         MakeMessage("assign member by member", "请逐个成员赋值"));
}

void Lowerer::CopyStructure(const ArrayPlace& to, const ArrayPlace& from, SourceRange range) {
  // Where they are is read once.
  const Operand to_offset = Stable(to.offset, range);
  const Operand from_offset = Stable(from.offset, range);
  const std::vector<Leaf>& leaves = to.element.own->leaves;
  for (size_t i = 0; i < leaves.size(); ++i) {
    OwnMember leaf;
    leaf.leaf = static_cast<int>(i);
    leaf.type = leaves[i].type;
    if (leaves[i].is_array) leaf.dimensions = {leaves[i].size};
    ArrayPlace target = to;
    ArrayPlace source = from;
    target.offset = to_offset;
    source.offset = from_offset;
    Narrow(target, leaf, range);
    Narrow(source, leaf, range);
    CopyLeaf(target, source, range);
  }
}

// Copies a number or an array of numbers.
void Lowerer::CopyLeaf(ArrayPlace to, ArrayPlace from, SourceRange range) {
  const auto copy = [this, range](const ArrayPlace& target, const ArrayPlace& source) {
    const std::optional<Operand> into = ElementOf(target, range);
    const std::optional<Operand> value = ElementOf(source, range);
    if (into && value) EmitCopy(*into, *value, range);
  };
  if (to.dimensions.empty()) {
    copy(to, from);
    return;
  }
  const int64_t size = to.dimensions[0];
  const ArrayPlace first_to = to;
  const ArrayPlace first_from = from;
  if (size < kCopiedOneByOne) {
    for (int64_t i = 0; i < size; ++i) {
      to = first_to;
      from = first_from;
      Advance(to, IntOperand(i), false, range);
      Advance(from, IntOperand(i), false, range);
      copy(to, from);
    }
    return;
  }
  const Operand index = NewTemporary(vm::DataType::kInt, range);
  const int loop = NewLabel("copy", range);
  EmitCopy(index, IntOperand(0), range);
  EmitLabel(loop, range);
  Advance(to, index, false, range);
  Advance(from, index, false, range);
  copy(to, from);
  StepTo(index, size, loop, range);
}

// The end of a loop that counts an index up to a size.
void Lowerer::StepTo(const Operand& index, int64_t size, int loop, SourceRange range) {
  Instruction step;
  step.kind = Instruction::Kind::kBinary;
  step.target = index;
  step.a = index;
  step.b = IntOperand(1);
  Emit(std::move(step), range);
  const Value more =
      Compute(vm::BinaryOperator::kLess, index, IntOperand(size), BasicType::kInt, range);
  EmitIf(more.operand, loop, range);
}

}  // namespace oncard::compiler::lowering
