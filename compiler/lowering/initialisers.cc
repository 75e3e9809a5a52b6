// Initial values: of locals, which are assigned where they are declared, and of globals, which are
// collected for the start of the thread functions (start.cc).
#include <numeric>

#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {
namespace {

// Shorter runs of zeros are assigned one by one.
constexpr int64_t kClearedByLoop = 6;

int64_t Product(const std::vector<int64_t>& dimensions, size_t from) {
  return std::accumulate(dimensions.begin() + static_cast<std::ptrdiff_t>(from), dimensions.end(),
                         int64_t{1}, [](int64_t a, int64_t b) { return a * b; });
}

}  // namespace

// The values between braces in the order of the elements. Inner braces begin a row; without them
// the values continue from row to row, as in C.
bool Lowerer::Flatten(const Expression& braces, const std::vector<int64_t>& dimensions,
                      size_t level, int64_t base, Elements& elements) {
  const int64_t row = Product(dimensions, level + 1);
  const int64_t size = dimensions[level] * row;  // 0: as many as there are
  int64_t position = 0;
  for (const ExpressionPtr& item : braces.operands) {
    const bool nested = item->kind == Expression::Kind::kBraces;
    if (nested && level + 1 < dimensions.size()) {
      position = (position + row - 1) / row * row;
    }
    if (size > 0 && position >= size) {
      Report(Code::kTooManyValues, item->range, size);
      return false;
    }
    const size_t at = static_cast<size_t>(base + position);
    if (elements.size() <= at) elements.resize(at + 1, nullptr);
    if (!nested) {
      elements[at] = item.get();
      ++position;
    } else if (level + 1 < dimensions.size()) {
      if (!Flatten(*item, dimensions, level + 1, base + position, elements)) return false;
      position += row;
    } else if (item->operands.size() == 1) {
      elements[at] = item->operands[0].get();
      ++position;
    } else {
      Report(Code::kTooManyValues, item->range, int64_t{1});
      return false;
    }
  }
  return true;
}

std::optional<Lowerer::Elements> Lowerer::ElementsOf(const Declarator& declarator,
                                                     const Symbol& symbol) {
  const Expression* values = declarator.initialiser.get();
  std::vector<int64_t> dimensions = symbol.dimensions;
  if (symbol.type.structure != nullptr) {
    dimensions = {static_cast<int64_t>(symbol.type.structure->members.size())};
  }
  if (values == nullptr || values->kind != Expression::Kind::kBraces) {
    Report(Code::kArrayValues, values == nullptr ? declarator.head : values->range,
           declarator.name);
    return std::nullopt;
  }
  Elements elements;
  if (!Flatten(*values, dimensions, 0, 0, elements)) return std::nullopt;
  return elements;
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
    const Operand operand = ConstantValue(*converted, expression.range).operand;
    if (operand.value != 0) initial_values_.push_back({target, operand, expression.range});
  };
  if (symbol.dimensions.empty() && symbol.type.structure == nullptr) {
    const Expression* value = declarator.initialiser.get();
    if (value->kind == Expression::Kind::kBraces && value->operands.size() == 1) {
      value = value->operands[0].get();
    }
    add(VariableOperand(symbol.variable), *value);
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
    if (value->kind == Expression::Kind::kBraces && value->operands.size() == 1) {
      value = value->operands[0].get();
    }
    AssignInto({VariableOperand(symbol.variable), symbol.type}, *value);
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
      place.type.basic = TypeOfMember(symbol.type.structure->members[static_cast<size_t>(i)]);
    }
    AssignInto(place, *at(i));
    ++i;
  }
}

}  // namespace oncard::compiler::lowering
