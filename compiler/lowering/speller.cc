#include "compiler/lowering/speller.h"

#include <fmt/core.h>

#include "compiler/literal.h"
#include "vm/fixed_point.h"

namespace oncard::compiler::lowering {

std::string Speller::Spell(const Operand& operand) const {
  const std::string* const name = named_.contains(operand.name)
                                      ? &program_.constants[static_cast<size_t>(operand.name)].name
                                      : nullptr;
  if (operand.IsConstant()) {
    if (name != nullptr) return *name;
    return operand.type == vm::DataType::kDouble ? SpellDouble(operand.value)
                                                 : std::to_string(operand.value);
  }
  const Variable& variable = VariableAt(operand.variable);
  std::string text = operand.address ? "&" + variable.name : variable.name;
  if (operand.kind == Operand::Kind::kElement) {
    text += operand.index >= 0 ? fmt::format("[{}]", VariableAt(operand.index).name)
            : name != nullptr  ? fmt::format("[{}]", *name)
                               : fmt::format("[{}]", operand.value);
  } else if (operand.kind == Operand::Kind::kMember) {
    text += MemberOf(operand);
  }
  return text;
}

std::string Speller::SpellUnary(const Instruction& instruction) const {
  std::string operand = Spell(instruction.a);
  switch (instruction.unary) {
    case vm::UnaryOperator::kCopy:
      return operand;
    case vm::UnaryOperator::kNot:
      return "!" + operand;
    case vm::UnaryOperator::kInvert:
      return "~" + operand;
    case vm::UnaryOperator::kAbs:
      return fmt::format("abs({})", operand);
    case vm::UnaryOperator::kFabs:
      return fmt::format("fabs({})", operand);
    case vm::UnaryOperator::kToInt:
      return "(int) " + operand;
    case vm::UnaryOperator::kToDouble:
      return "(double) " + operand;
  }
  return operand;
}

std::string Speller::Spell(const Instruction& instruction, const LoweredFunction& function) const {
  switch (instruction.kind) {
    case Instruction::Kind::kUnary:
      return fmt::format("{} = {};", Spell(instruction.target), SpellUnary(instruction));
    case Instruction::Kind::kBinary:
      return fmt::format(
          "{} = {} {} {};", Spell(instruction.target), Spell(instruction.a),
          vm::FindBinaryOperator(static_cast<uint16_t>(instruction.binary))->spelling,
          Spell(instruction.b));
    case Instruction::Kind::kLabel:
      return function.labels[static_cast<size_t>(instruction.label)] + ":";
    case Instruction::Kind::kGoto:
      return fmt::format("goto {};", function.labels[static_cast<size_t>(instruction.label)]);
    case Instruction::Kind::kIf:
      return fmt::format("if ({}) goto {};", Spell(instruction.a),
                         function.labels[static_cast<size_t>(instruction.label)]);
    case Instruction::Kind::kReturn:
      return instruction.a.kind == Operand::Kind::kNone
                 ? "return;"
                 : fmt::format("return {};", Spell(instruction.a));
    case Instruction::Kind::kCall: {
      std::string arguments;
      for (const Operand& argument : instruction.arguments) {
        if (!arguments.empty()) arguments += ", ";
        arguments += Spell(argument);
      }
      return fmt::format("{}({});", instruction.command->name, arguments);
    }
    case Instruction::Kind::kAssert: {
      const Assertion& assertion = program_.assertions[static_cast<size_t>(instruction.assertion)];
      std::string text = "//@ assert: " + assertion.texts.front();
      for (size_t i = 0; i < instruction.arguments.size(); ++i) {
        text += SpellName(instruction, i) + assertion.texts[i + 1];
      }
      return text;
    }
  }
  return {};
}

std::string Speller::SpellName(const Instruction& assert, size_t argument) const {
  const int64_t element =
      program_.assertions[static_cast<size_t>(assert.assertion)].elements[argument];
  const Operand& operand = assert.arguments[argument];
  const std::string& name = VariableAt(operand.variable).name;
  if (operand.kind == Operand::Kind::kMember) return name + MemberOf(operand);
  return element < 0 ? name : fmt::format("{}[{}]", name, element);
}

std::string Speller::MemberOf(const Operand& operand) const {
  const gtcalls::Structure& structure = *VariableAt(operand.variable).structure;
  return fmt::format(".{}", structure.members[static_cast<size_t>(operand.member)].name);
}

std::string_view SpellType(const Variable& variable) {
  return variable.structure != nullptr ? variable.structure->name : vm::TypeName(variable.type);
}

std::string SpellDouble(int64_t raw) {
  const double value = vm::DoubleFromFixed(raw);
  for (int digits = 1; digits < vm::kFractionBits; ++digits) {
    std::string text = fmt::format("{:.{}f}", value < 0 ? -value : value, digits);
    const Literal literal = ParseFixed(text);
    const int64_t magnitude = static_cast<int64_t>(literal.magnitude);
    if ((value < 0 ? -magnitude : magnitude) == raw) return (value < 0 ? "-" : "") + text;
  }
  return fmt::format("{:.{}f}", value, vm::kFractionBits);
}

}  // namespace oncard::compiler::lowering
