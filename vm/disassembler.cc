// Tested by tests/vm/disassembler_test.cc.
#include "vm/disassembler.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "base/json_text.h"
#include "vm/object_writer.h"
#include "vm/record.h"

namespace oncard::vm {
namespace {

// Statements up to this width are padded, so that the words after them line up.
constexpr size_t kStatementWidthMax = 40;

// Writes the operands of one function, with the names of its symbols.
class OperandPrinter {
 public:
  OperandPrinter(const Object& object, const Function& function)
      : object_(object), function_(function) {}

  // A literal is written as a value of `type`.
  std::string Print(const Operand& operand, DataType type) const {
    if (const auto* variable = std::get_if<Variable>(&operand)) return Print(*variable);
    if (const auto* element = std::get_if<Element>(&operand)) return Print(*element);
    return PrintLiteral(std::get<Immediate>(operand).raw, type);
  }

  // The type is not known: a literal without a fraction is written as an int.
  std::string Print(const Operand& operand) const {
    const auto* literal = std::get_if<Immediate>(&operand);
    const bool whole = literal != nullptr && literal->raw % (1 << kFractionBits) == 0;
    return Print(operand, whole ? DataType::kInt : DataType::kDouble);
  }

 private:
  static std::string PrintLiteral(int64_t raw, DataType type) {
    std::string text = fmt::format("{}", DoubleFromFixed(raw));
    const bool looks_whole = text.find_first_of(".e") == std::string::npos;
    return type == DataType::kDouble && looks_whole ? text + ".0" : text;
  }

  std::string Print(const Variable& variable) const {
    for (const Symbol& symbol : SymbolsOf(variable.storage)) {
      if (variable.id < symbol.id || variable.id - symbol.id >= symbol.slots()) continue;
      if (symbol.array_size == 0) return symbol.name;
      return fmt::format("{}[{}]", symbol.name, variable.id - symbol.id);
    }
    return SlotName(variable.storage, variable.id);
  }

  std::string Print(const Element& element) const {
    const std::vector<Symbol>& symbols = SymbolsOf(element.storage);
    const auto array = std::find_if(symbols.begin(), symbols.end(), [&](const Symbol& symbol) {
      return symbol.array_size != 0 && symbol.id == element.base;
    });
    return fmt::format(
        "{}[{}]", array != symbols.end() ? array->name : SlotName(element.storage, element.base),
        Print(element.index));
  }

  static std::string SlotName(Storage storage, uint16_t id) {
    return fmt::format("{}:{}", storage == Storage::kLocal ? "local" : "global", id);
  }

  const std::vector<Symbol>& SymbolsOf(Storage storage) const {
    return storage == Storage::kLocal ? function_.variables : object_.globals;
  }

  const Object& object_;
  const Function& function_;
};

std::string DescribeUnary(const Instruction& instruction, const OperandPrinter& printer) {
  const OperatorInfo* info = FindUnaryOperator(instruction.op);
  const std::string src = printer.Print(instruction.operands[0], instruction.type);
  const std::string dst = printer.Print(instruction.operands[1]);
  if (info == nullptr) return fmt::format("{} := operator {}({})", dst, instruction.op, src);
  const std::string_view spelling = info->spelling;
  if (spelling.empty()) return fmt::format("{} := {}", dst, src);
  const bool is_name = spelling.front() >= 'a' && spelling.front() <= 'z';
  return is_name ? fmt::format("{} := {}({})", dst, spelling, src)
                 : fmt::format("{} := {} {}", dst, spelling, src);
}

std::string DescribeBinary(const Instruction& instruction, const OperandPrinter& printer) {
  const OperatorInfo* info = FindBinaryOperator(instruction.op);
  const std::string a = printer.Print(instruction.operands[0], instruction.type);
  const std::string b = printer.Print(instruction.operands[1], instruction.type);
  const std::string dst = printer.Print(instruction.operands[2]);
  if (info == nullptr) return fmt::format("{} := operator {}({}, {})", dst, instruction.op, a, b);
  return fmt::format("{} := {} {} {}", dst, a, info->spelling, b);
}

// `if cond `, or nothing for the constant 1.
std::string DescribeCondition(const Operand& condition, const OperandPrinter& printer) {
  if (condition == Operand(ImmediateInt(1))) return {};
  return fmt::format("if {} ", printer.Print(condition));
}

std::string DescribeReturn(const Instruction& instruction, DataType return_type,
                           const OperandPrinter& printer) {
  const Operand& value = instruction.operands[1];
  const std::string condition = DescribeCondition(instruction.operands[0], printer);
  if (return_type == DataType::kVoid && value == Operand(Immediate{})) return condition + "return";
  return fmt::format("{}return {}", condition, printer.Print(value, return_type));
}

std::string DescribeCommand(const Instruction& instruction, const OperandPrinter& printer,
                            const CommandTable& commands) {
  const CommandShape* command = commands.Find(instruction.op);
  std::vector<std::string> arguments;
  for (size_t i = 0; i < instruction.operands.size(); ++i) {
    const Operand& operand = instruction.operands[i];
    if (command == nullptr || i >= command->parameters.size()) {
      arguments.push_back(printer.Print(operand));
    } else if (command->parameters[i].address) {
      const std::string name = printer.Print(operand);
      // A parameter of several slots takes the structure, not its first member.
      const bool whole = command->parameters[i].slots.size() > 1;
      arguments.push_back(fmt::format("&{}", whole ? name.substr(0, name.find('.')) : name));
    } else {
      arguments.push_back(printer.Print(operand, command->parameters[i].slots.front()));
    }
  }
  const std::string name =
      command == nullptr ? fmt::format("command {}", instruction.op) : std::string(command->name);
  return fmt::format("{}({})", name, fmt::join(arguments, ", "));
}

std::string SymbolDeclaration(const Symbol& symbol) {
  return symbol.array_size == 0 ? symbol.name
                                : fmt::format("{}[{}]", symbol.name, symbol.array_size);
}

void ListSymbols(std::string_view title, const std::vector<Symbol>& symbols, std::string* text) {
  if (symbols.empty()) return;
  auto out = std::back_inserter(*text);
  fmt::format_to(out, "{}\n", title);
  for (const Symbol& symbol : symbols) {
    fmt::format_to(out, "  {:>5}  {:<6}  {}\n", symbol.id, TypeName(symbol.type),
                   SymbolDeclaration(symbol));
  }
}

// `0003 5080 0003 0004  0002 0001 0001`
std::string ListWords(std::span<const uint16_t> record) {
  const size_t length = size_t{record[0]} + 1;
  return fmt::format("{:04X}  {:04X}", fmt::join(record.first(length), " "),
                     fmt::join(record.subspan(length), " "));
}

int LineOf(const Function& function, size_t index) {
  return index < function.lines.size() ? function.lines[index] : 0;
}

void ListFunction(const Object& object, const Function& function, const CommandTable& commands,
                  std::string* text) {
  ListSymbols("variables", function.variables, text);
  if (function.instructions.empty()) return;
  std::vector<std::string> statements;
  size_t width = 0;
  for (size_t i = 0; i < function.instructions.size(); ++i) {
    statements.push_back(DescribeInstruction(object, function, i, commands));
    if (statements.back().size() <= kStatementWidthMax) {
      width = std::max(width, statements.back().size());
    }
  }
  *text += "instructions\n";
  for (size_t i = 0; i < statements.size(); ++i) {
    fmt::format_to(std::back_inserter(*text), "  {:>5}  line {:<5}  {:<{}}  ; {}\n", i,
                   LineOf(function, i), statements[i], width,
                   ListWords(EncodeRecord(function.instructions[i])));
  }
}

using Json = nlohmann::ordered_json;

Json SymbolsJson(const std::vector<Symbol>& symbols) {
  Json list = Json::array();
  for (const Symbol& symbol : symbols) {
    Json entry = {{"name", symbol.name}, {"id", symbol.id}, {"type", TypeName(symbol.type)}};
    if (symbol.array_size != 0) entry["size"] = symbol.array_size;
    list.push_back(std::move(entry));
  }
  return list;
}

Json FunctionJson(const Object& object, size_t number, const CommandTable& commands) {
  const Function& function = object.functions[number];
  Json instructions = Json::array();
  for (size_t i = 0; i < function.instructions.size(); ++i) {
    instructions.push_back({{"index", i},
                            {"line", LineOf(function, i)},
                            {"statement", DescribeInstruction(object, function, i, commands)},
                            {"words", ListWords(EncodeRecord(function.instructions[i]))}});
  }
  return {{"id", number + 1},
          {"name", function.name},
          {"file", function.file},
          {"returns", TypeName(function.return_type)},
          {"variables", SymbolsJson(function.variables)},
          {"instructions", std::move(instructions)}};
}

}  // namespace

std::string DescribeInstruction(const Object& object, const Function& function, size_t index,
                                const CommandTable& commands) {
  const Instruction& instruction = function.instructions[index];
  const OperandPrinter printer(object, function);
  switch (instruction.opcode) {
    case Opcode::kUnary:
      return DescribeUnary(instruction, printer);
    case Opcode::kBinary:
      return DescribeBinary(instruction, printer);
    case Opcode::kJump:
      return fmt::format("{}goto {}", DescribeCondition(instruction.operands[0], printer),
                         static_cast<int64_t>(index) + instruction.displacement);
    case Opcode::kReturn:
      return DescribeReturn(instruction, function.return_type, printer);
    case Opcode::kCommand:
      return DescribeCommand(instruction, printer, commands);
  }
  return {};
}

std::string Disassemble(const Object& object, const CommandTable& commands) {
  std::string text = fmt::format("double {}\n", DoubleFormatName(object.double_format));
  ListSymbols("globals", object.globals, &text);
  int id = 0;
  for (const Function& function : object.functions) {
    fmt::format_to(std::back_inserter(text), "\nfunction {} '{}' of {} returns {}\n", ++id,
                   function.name, function.file, TypeName(function.return_type));
    ListFunction(object, function, commands, &text);
  }
  return text;
}

std::string DisassembleJson(const Object& object, const CommandTable& commands) {
  Json functions = Json::array();
  for (size_t i = 0; i < object.functions.size(); ++i) {
    functions.push_back(FunctionJson(object, i, commands));
  }
  const Json document = {{"double", DoubleFormatName(object.double_format)},
                         {"globals", SymbolsJson(object.globals)},
                         {"functions", std::move(functions)}};
  return JsonText(document, 2) + "\n";
}

}  // namespace oncard::vm
