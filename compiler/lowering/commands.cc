// GT commands, which stay as they are: arguments become operands, and ints become doubles where the
// command takes doubles. A structure of the card that is an element of an array has no address on
// the card, so that it is copied to a variable before the command, and back behind it. Everything
// else about them is checked in the lowered text.
#include <fmt/core.h>

#include <algorithm>

#include "compiler/lexer.h"
#include "compiler/lowering/lowerer.h"
#include "compiler/parser.hh"
#include "vm/limits.h"

namespace oncard::compiler::lowering {

// The variable of a thread function in which commands get structures of a type.
ArrayPlace Lowerer::PassedThrough(const Type& type, SourceRange range) {
  const gtcalls::Structure* const card = type.own->card;
  const auto [entry, added] = variables_.try_emplace(card, -1);
  if (added) {
    entry->second = NewVariable(Variable::Role::kLocal, fmt::format("tmp{}", card->name.substr(1)),
                                type, {}, range);
    // No call comes between its statements.
    OwnByFrames(entry->second, type, 0);
  }
  return StructureAt(entry->second, type);
}

// A structure of the card as an argument; of an element of an array the variable that stands for
// it, which becomes one of those that are passed.
std::optional<Operand> Lowerer::LowerCardAddress(ArrayPlace structure, SourceRange range,
                                                 std::vector<Passed>& passed) {
  structure.offset = Stable(structure.offset, range);
  structure.dimensions.clear();
  std::optional<Operand> operand = ElementOf(structure, range);
  if (!operand) return std::nullopt;
  if (operand->kind == Operand::Kind::kElement) {
    const ArrayPlace variable = PassedThrough(structure.element, range);
    passed.push_back({structure, variable});
    operand = VariableOperand(variable.variable);
  }
  // The whole structure is a variable.
  operand->kind = Operand::Kind::kVariable;
  return operand;
}

// `&variable`, `&array[index]`, `&structure`, and an array's name for its first element.
std::optional<Operand> Lowerer::LowerAddress(const Expression& argument,
                                             std::vector<Passed>& passed) {
  const Expression& inner = WithoutParens(argument);
  const bool address = inner.kind == Expression::Kind::kUnary && inner.op == "&";
  const Expression& target = address ? WithoutParens(*inner.operands[0]) : inner;
  if (address && !CheckPlace(target)) return std::nullopt;
  const std::optional<Shape> shape = ShapeOf(target);
  Operand operand;
  if (shape && IsAggregate(*shape)) {
    const std::optional<ArrayPlace> array = LowerArray(target);
    if (!array) return std::nullopt;
    const OwnStructure* const own = array->element.own;
    if (own != nullptr && own->card == nullptr) {
      ReportStructure(target);
      return std::nullopt;
    }
    const std::optional<Operand> element = own != nullptr
                                               ? LowerCardAddress(*array, target.range, passed)
                                               : ElementOf(*array, target.range);
    if (!element) return std::nullopt;
    operand = *element;
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
  std::vector<Passed> passed;
  for (size_t i = 1; i < call.operands.size(); ++i) {
    const Expression& argument = *call.operands[i];
    const Expression& inner = WithoutParens(argument);
    const bool address = inner.kind == Expression::Kind::kUnary && inner.op == "&";
    const gtcalls::Parameter* parameter =
        i <= command.parameters.size() ? &command.parameters[i - 1] : nullptr;
    const bool by_value = parameter == nullptr || parameter->passing == gtcalls::Passing::kValue;
    if (address || (!by_value && IsArray(argument))) {
      const std::optional<Operand> operand = LowerAddress(argument, passed);
      if (!operand) return;
      instruction.arguments.push_back(*operand);
      continue;
    }
    const std::optional<Shape> shape = ShapeOf(inner);
    if (!by_value && shape && shape->dimensions.empty() && shape->type.own != nullptr) {
      Report(Code::kMisuse, inner.range, Source(inner.range), MakeMessage("a structure", "结构"),
             MakeMessage("its address: '&{0}'", "它的地址：'&{0}'", Source(inner.range)));
      return;
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
  // A command that fails leaves what it would write as it is.
  for (const Passed& one : passed) CopyStructure(one.variable, one.element, call.range);
  Emit(std::move(instruction), call.range);
  const bool writes = std::any_of(command.parameters.begin(), command.parameters.end(),
                                  [](const gtcalls::Parameter& parameter) {
                                    return parameter.structure != nullptr &&
                                           parameter.passing != gtcalls::Passing::kInput;
                                  });
  if (!writes) return;
  for (const Passed& one : passed) CopyStructure(one.element, one.variable, call.range);
}

}  // namespace oncard::compiler::lowering
