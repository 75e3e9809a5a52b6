// GT commands, which stay as they are: arguments become operands, and ints become doubles where the
// command takes doubles. Everything else about them is checked in the lowered text.
#include <algorithm>

#include "compiler/lexer.h"
#include "compiler/lowering/lowerer.h"
#include "compiler/parser.hh"
#include "vm/limits.h"

namespace oncard::compiler::lowering {

// `&variable`, `&array[index]`, `&structure`, and an array's name for its first element.
std::optional<Operand> Lowerer::LowerAddress(const Expression& argument) {
  const Expression& inner = WithoutParens(argument);
  const bool address = inner.kind == Expression::Kind::kUnary && inner.op == "&";
  const Expression& target = address ? WithoutParens(*inner.operands[0]) : inner;
  const std::optional<Shape> shape = ShapeOf(target);
  Operand operand;
  if (shape && IsAggregate(*shape)) {
    const std::optional<ArrayPlace> array = LowerArray(target);
    if (!array) return std::nullopt;
    if (array->element.own != nullptr && array->element.own->card == nullptr) {
      ReportStructure(target);
      return std::nullopt;
    }
    const std::optional<Operand> element = ElementOf(*array, target.range);
    if (!element) return std::nullopt;
    operand = *element;
    // The whole structure is a variable.
    if (array->element.own != nullptr) operand.kind = Operand::Kind::kVariable;
    if (operand.index >= 0) {
      operand.index = Stable(VariableOperand(operand.index), target.range).variable;
    }
    if (array->element.is_const) Report(Code::kWriteToConst, target.range, Source(target.range));
  } else {
    const std::optional<Place> place = LowerPlace(target);
    if (!place || !CheckWritable(*place, target)) return std::nullopt;
    operand = place->operand;
  }
  operand.address = true;
  return operand;
}

// Whether the card's language leaves a name to programs.
bool Lowerer::IsFreeName(std::string_view name) const {
  if (name.size() > vm::kNameLengthMax || name == "bool") return false;
  if (options_.catalogue->Find(name) != nullptr) return false;
  Reporter unused;
  const SourceFile text("", std::string(name));
  const std::vector<Token> tokens = Tokenize(text, 0, 2, *options_.catalogue, unused);
  return tokens.size() == 1 && tokens[0].kind == Parser::token::kName;
}

// An argument that is a macro without parameters, a constant of an enum or a const number keeps
// this name.
void Lowerer::NameConstant(const Expression& argument, Operand& value) {
  if (!value.IsConstant()) return;
  std::string_view name;
  SourceRange range;
  for (const Expression* part = &argument; name.empty();) {
    const MacroUses::Macro* const macro = macros_.Find(part->range);
    const Symbol* const symbol =
        part->kind == Expression::Kind::kName ? Lookup(part->text) : nullptr;
    if (macro != nullptr && Source(part->range) == macro->name) {
      name = macro->name;
      range = macro->name_range;
    } else if (symbol != nullptr && symbol->kind == Symbol::Kind::kConstant) {
      name = part->text;
      range = symbol->range;
    } else if (part->kind == Expression::Kind::kParen) {
      part = part->operands[0].get();
    } else {
      return;
    }
  }
  std::vector<NamedConstant>& constants = program_.constants;
  auto known = std::find_if(constants.begin(), constants.end(),
                            [name](const NamedConstant& other) { return other.name == name; });
  if (known == constants.end()) {
    if (!IsFreeName(name) || constants.size() == size_t{vm::kMacroMax}) return;
    known = constants.insert(constants.end(), {std::string(name), value, range});
  }
  known->ambiguous |= !(known->value == value);
  value.name = static_cast<int>(known - constants.begin());
}

void Lowerer::LowerCommand(const Expression& call, const gtcalls::Command& command) {
  Instruction instruction;
  instruction.kind = Instruction::Kind::kCall;
  instruction.command = &command;
  for (size_t i = 1; i < call.operands.size(); ++i) {
    const Expression& argument = *call.operands[i];
    const Expression& inner = WithoutParens(argument);
    const bool address = inner.kind == Expression::Kind::kUnary && inner.op == "&";
    const gtcalls::Parameter* parameter =
        i <= command.parameters.size() ? &command.parameters[i - 1] : nullptr;
    const bool by_value = parameter == nullptr || parameter->passing == gtcalls::Passing::kValue;
    if (address || (!by_value && IsArray(argument))) {
      const std::optional<Operand> operand = LowerAddress(argument);
      if (!operand) return;
      instruction.arguments.push_back(*operand);
      continue;
    }
    Value value = LowerValue(argument);
    if (!RequireNumber(value, argument)) return;
    if (parameter != nullptr && by_value) {
      const bool real = parameter->type == gtcalls::Scalar::kDouble;
      if (real != (value.type == BasicType::kDouble)) {
        value = Convert(value, real ? BasicType::kDouble : BasicType::kInt, argument.range);
      } else {
        NameConstant(argument, value.operand);
      }
    }
    instruction.arguments.push_back(value.operand);
  }
  Emit(std::move(instruction), call.range);
}

}  // namespace oncard::compiler::lowering
