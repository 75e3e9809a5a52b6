// Calls of GT commands.
#include <algorithm>
#include <limits>

#include "base/trim.h"
#include "compiler/operands.h"
#include "compiler/rewriter.h"

namespace oncard::compiler {
namespace {

using gtcalls::Parameter;
using gtcalls::Passing;
using gtcalls::Scalar;
using vm::DataType;

struct Limits {
  int64_t minimum;
  int64_t maximum;
};

Limits LimitsOf(Scalar scalar) {
  switch (scalar) {
    case Scalar::kChar:
      return {-128, 255};  // signed and unsigned char are treated alike
    case Scalar::kShort:
      return {INT16_MIN, INT16_MAX};
    case Scalar::kUnsignedShort:
      return {0, UINT16_MAX};
    case Scalar::kUnsignedLong:
      return {0, UINT32_MAX};
    default:
      return {INT32_MIN, INT32_MAX};
  }
}

// The value that C passes for an int if the parameter has a narrower type.
int32_t Truncated(int32_t value, Scalar scalar) {
  switch (scalar) {
    case Scalar::kShort:
      return static_cast<int16_t>(value);
    case Scalar::kUnsignedShort:
      return static_cast<uint16_t>(value);
    case Scalar::kChar:
      return value >= -128 && value <= 255 ? value : static_cast<int8_t>(value);
    default:
      return value;
  }
}

bool IsAddressParameter(const Parameter& parameter) {
  return parameter.structure != nullptr || parameter.passing == Passing::kInput ||
         parameter.passing == Passing::kOutput;
}

// True if a parameter is the number of an axis: it selects axes in the command's accesses.
bool IsAxis(const gtcalls::Command& command, size_t index) {
  return std::any_of(command.accesses.begin(), command.accesses.end(),
                     [index](const gtcalls::Access& access) {
                       return access.resource == gtcalls::Resource::kAxis && !access.mask &&
                              access.selector == static_cast<int>(index);
                     });
}

// Advice for a command that takes another structure than the one passed.
Message StructureAdvice(const gtcalls::Structure& structure) {
  if (structure.in_motion_program) {
    return MakeMessage("declare one with '{0} name;'", "请用 '{0} 名称;' 声明", structure.name);
  }
  return MakeMessage("programs cannot declare one: let the host call the command",
                     "运动程序不能声明该结构：请由主机调用该指令");
}

// Advice for a command that takes the address of a variable of another type. The command accesses
// the variable's own slots, so no conversion is possible.
Message AddressAdvice(const Expression& variable, DataType type) {
  const Message wanted = DescribeType(type);
  if (variable.kind == Expression::Kind::kMember) {
    return MakeMessage("pass another variable that is {0} and copy it in a statement",
                       "请另用一个 {1} 变量，再用语句复制", wanted.en, wanted.zh);
  }
  return MakeMessage(
      "declare '{0}' as {1}, or pass another variable that is {1} and copy it in a statement",
      "请把 '{0}' 声明为 {2}，或另用一个 {2} 变量，再用语句复制", BaseName(variable), wanted.en,
      wanted.zh);
}

std::string NumberText(double value) { return fmt::format("{:g}", value); }

}  // namespace

void Operands::ReportUnknownCall(const Expression& callee) {
  const std::string_view name = callee.text;
  if (context_.function_names.contains(name)) {
    context_.Teach(Code::kUserCall, callee.range, name);
    return;
  }
  context_.statement.failed = true;
  if (context_.skipped_names.contains(name)) return;
  if (const Entity* entity = context_.Lookup(name)) {
    if (!entity->invalid) {
      AddNote(context_.reporter.Report(Code::kMisuse, callee.range, name, DescribeEntity(*entity),
                                       MakeMessage("a GT command", "GT 指令")),
              entity->range, MakeMessage("it is defined here", "其定义在此处"));
    }
    return;
  }
  Diagnostic& diagnostic = context_.reporter.Report(Code::kNotACommand, callee.range, name);
  if (context_.catalogue.Find(name) != nullptr) {
    AddNote(diagnostic, MakeMessage("the command exists, but only the host may call it",
                                    "该指令存在，但只能由主机调用"));
    return;
  }
  AddNote(diagnostic, name.starts_with("GT_")
                          ? MakeMessage("no GT command has this name", "没有这个名称的 GT 指令")
                          : MakeMessage("only GT commands, abs and fabs can be called",
                                        "只能调用 GT 指令、abs 和 fabs"));
  if (!context_.MaySuggest()) return;
  Nearest nearest(name);
  for (const gtcalls::Command& command : context_.catalogue.commands()) {
    if (command.in_motion_program) nearest.Add(command.name);
  }
  for (const std::string_view candidate : {"abs", "fabs"}) nearest.Add(candidate);
  if (!nearest.best().empty()) {
    AddNote(diagnostic, MakeMessage("did you mean '{0}'?", "您是否想写 '{0}'？", nearest.best()));
    Replace(diagnostic, callee.range, std::string(nearest.best()));
  }
}

void Operands::CheckCall(const Expression& call) {
  const Expression& callee = *call.operands[0];
  if (callee.kind != Expression::Kind::kName) {
    CheckNames(call);
    return;
  }
  const gtcalls::Command* command = context_.catalogue.Find(callee.text);
  if (command != nullptr && command->in_motion_program) {
    CheckCommand(call, *command);
    return;
  }
  if ((callee.text == "abs" || callee.text == "fabs") && context_.Lookup(callee.text) == nullptr) {
    CheckNames(call);
    if (!context_.statement.failed) {
      context_.statement.lesson.reset();
      context_.Fail(Code::kNoEffect, call.range);
    }
    return;
  }
  ReportUnknownCall(callee);
}

void Operands::CheckCommand(const Expression& call, const gtcalls::Command& command) {
  const size_t given = call.operands.size() - 1;
  const size_t wanted = command.parameters.size();
  if (given > wanted) {
    const Expression& extra = *call.operands[wanted + 1];
    SourceRange range = extra.range;
    range.end = call.operands.back()->range.end;
    Diagnostic& diagnostic =
        context_.Fail(Code::kTooManyParameters, range, command.name, static_cast<int64_t>(wanted),
                      static_cast<int64_t>(given));
    if (wanted > 0) range.begin = call.operands[wanted]->range.end;
    Replace(diagnostic, range, "");
  }
  vm::Instruction instruction;
  instruction.opcode = vm::Opcode::kCommand;
  instruction.op = command.number;
  bool good = true;
  for (size_t i = 0; i < std::min(given, wanted); ++i) {
    const Expression& argument = *call.operands[i + 1];
    const Parameter& parameter = command.parameters[i];
    const bool fine = IsAddressParameter(parameter)
                          ? CheckAddress(argument, call, command, i, instruction)
                          : CheckInput(argument, command, i, instruction);
    good = good && fine;
  }
  if (given < wanted) {
    ReportMissingArguments(call, command);
    return;
  }
  if (good && !context_.statement.failed && !context_.statement.lesson) {
    context_.Emit(std::move(instruction));
  }
}

void Operands::ReportMissingArguments(const Expression& call, const gtcalls::Command& command) {
  const size_t given = call.operands.size() - 1;
  const bool good_so_far = !context_.statement.failed && !context_.statement.lesson;
  std::string names;
  bool can_write = true;
  for (size_t i = given; i < command.parameters.size(); ++i) {
    const Parameter& parameter = command.parameters[i];
    if (!names.empty()) names += ", ";
    names += fmt::format("'{}'", parameter.name);
    const bool output = parameter.passing == Passing::kOutput && parameter.structure == nullptr &&
                        parameter.count_parameter < 0;
    const bool value = !IsAddressParameter(parameter) && !parameter.default_text.empty();
    can_write = can_write && (output || value);
  }
  SourceRange close = call.range;
  close.begin = close.end - 1;
  Diagnostic& diagnostic = context_.Fail(Code::kTooFewArguments, call.range, command.name,
                                         static_cast<int64_t>(command.parameters.size()),
                                         static_cast<int64_t>(given), names);
  std::string prototype;
  for (const Parameter& parameter : command.parameters) {
    if (!prototype.empty()) prototype += ", ";
    prototype += gtcalls::DeclareParameter(parameter);
  }
  AddNote(diagnostic,
          MakeMessage("its parameters are {0}({1})", "其参数为 {0}({1})", command.name, prototype));
  if (!can_write || !good_so_far) return;
  Rewriter rewriter(context_, diagnostic);
  std::string text;
  for (size_t i = given; i < command.parameters.size(); ++i) {
    const Parameter& parameter = command.parameters[i];
    if (i > 0) text += ", ";
    if (parameter.passing == Passing::kOutput) {
      std::string_view base = parameter.name;
      if (base.size() > 2 && base[0] == 'p' && base[1] >= 'A' && base[1] <= 'Z') {
        base.remove_prefix(1);
      }
      std::string name(base);
      name[0] = static_cast<char>(name[0] | 0x20);
      text += '&';
      text += rewriter.OutputVariable(name, gtcalls::ProgramType(parameter.type));
    } else {
      text += parameter.default_text;
    }
  }
  InsertBefore(diagnostic, close, text);
  rewriter.Finish();
}

// A fixed-point number where an integer is required: C would truncate it, and GT_Delay(0.5) would
// not wait.
void Operands::ReportFraction(const Expression& argument, const Literal& literal,
                              std::string_view parameter) {
  Diagnostic& diagnostic =
      context_.Fail(Code::kTypeMismatch, argument.range, DescribeType(DataType::kDouble),
                    DescribeType(DataType::kInt), MakeMessage("write a whole number", "请写整数"));
  const uint64_t one = uint64_t{1} << vm::kFractionBits;
  const uint64_t whole = literal.magnitude / one;
  if (literal.magnitude % one == 0 && whole <= INT32_MAX) {
    Replace(diagnostic, argument.range, fmt::format("{}{}", literal.negative ? "-" : "", whole));
    return;
  }
  AddNote(diagnostic, MakeMessage("'{0}' takes whole numbers; a cast would truncate {1} to {2}{3}",
                                  "'{0}' 需要整数；强制转换会把 {1} 截断为 {2}{3}", parameter,
                                  context_.Source(argument.range),
                                  literal.negative && whole > 0 ? "-" : "", whole));
}

bool Operands::CheckInput(const Expression& argument, const gtcalls::Command& command, size_t index,
                          vm::Instruction& instruction) {
  const Parameter& parameter = command.parameters[index];
  const DataType wanted = gtcalls::ProgramType(parameter.type);
  if (argument.kind == Expression::Kind::kUnary && argument.op == "&") {
    CheckNames(*argument.operands[0]);
    Diagnostic& diagnostic =
        context_.Fail(Code::kIllegalOperator, argument.op_range, argument.op,
                      MakeMessage("the parameter '{0}' of {1} takes a value",
                                  "{1} 的参数 '{0}' 需要数值", parameter.name, command.name));
    Replace(diagnostic, argument.op_range, "");
    return false;
  }
  if (!IsLeaf(argument) && !context_.ConstantOf(argument)) {
    const bool failed_before = context_.statement.failed;
    CheckNames(argument);
    if (context_.statement.failed == failed_before) {
      context_.Teach(Code::kNestedExpression, argument.range);
    }
    return false;
  }
  std::optional<TypedOperand> operand = ResolveOperand(argument);
  if (!operand) return false;
  if (!Adapt(*operand, wanted)) {
    if (operand->literal) {
      ReportFraction(argument, *operand->literal, parameter.name);
    } else {
      context_.Teach(Code::kTypeMismatch, argument.range, DescribeType(operand->type),
                     DescribeType(wanted), ConvertAdvice());
    }
    return false;
  }
  if (operand->literal && !operand->literal->invalid && wanted == DataType::kInt) {
    const int32_t value = *IntValue(*operand->literal);
    if (IsAxis(command, index) && (value < parameter.minimum || value > parameter.maximum)) {
      context_.Fail(Code::kAxisOutOfRange, argument.range, context_.Source(argument.range),
                    int64_t{value}, parameter.name, command.name, NumberText(parameter.minimum),
                    NumberText(parameter.maximum));
      return false;
    }
    const Limits limits = LimitsOf(parameter.type);
    const bool bits = operand->literal->as_bits && parameter.type == Scalar::kUnsignedLong;
    if (!bits && (value < limits.minimum || value > limits.maximum)) {
      const int32_t passed = Truncated(value, parameter.type);
      context_.reporter.Report(Code::kLiteralTruncated, argument.range,
                               context_.Source(argument.range), parameter.name,
                               gtcalls::SpellScalar(parameter.type),
                               parameter.type == Scalar::kUnsignedLong
                                   ? static_cast<int64_t>(static_cast<uint32_t>(value))
                                   : int64_t{passed});
      operand->operand = vm::ImmediateInt(passed);
    }
  }
  instruction.operands.push_back(operand->operand);
  return true;
}

bool Operands::CheckAddress(const Expression& argument, const Expression& call,
                            const gtcalls::Command& command, size_t index,
                            vm::Instruction& instruction) {
  const Parameter& parameter = command.parameters[index];
  const Message wanted =
      parameter.structure != nullptr
          ? MakeMessage("a variable of type {0}", " {0} 类型的变量", parameter.structure->name)
      : gtcalls::ProgramType(parameter.type) == DataType::kDouble
          ? MakeMessage("a double variable", " double 变量")
          : MakeMessage("an int variable", " int 变量");
  if (argument.kind == Expression::Kind::kCast &&
      argument.operands[0]->kind == Expression::Kind::kUnary && argument.operands[0]->op == "&") {
    const SourceRange cast = {argument.range.file, argument.range.begin,
                              argument.operands[0]->range.begin};
    CheckNames(*argument.operands[0]->operands[0]);
    Replace(context_.Fail(Code::kIllegalOperator, argument.range, Trim(context_.Source(cast)),
                          MakeMessage("addresses cannot be cast", "地址须原样传递")),
            cast, "");
    return false;
  }
  const bool has_ampersand = argument.kind == Expression::Kind::kUnary && argument.op == "&";
  const Expression& variable = has_ampersand ? *argument.operands[0] : argument;
  const bool addressable = variable.kind != Expression::Kind::kLiteral && IsLeaf(variable) &&
                           !context_.ConstantOf(variable);
  if (!addressable || !has_ampersand) {
    if (!IsLeaf(variable)) CheckNames(variable);
    if (context_.statement.failed) return false;
    const Entity* entity =
        variable.kind == Expression::Kind::kName ? context_.Lookup(variable.text) : nullptr;
    if (entity != nullptr && entity->invalid) {
      context_.statement.failed = true;
      return false;
    }
    if (addressable && variable.kind == Expression::Kind::kName && entity == nullptr &&
        context_.catalogue.FindConstant(variable.text) == nullptr && variable.text != "NULL") {
      ResolveName(variable);
      return false;
    }
    context_.statement.lesson.reset();
    Diagnostic& diagnostic =
        context_.Fail(Code::kNotAnAddress, argument.range, parameter.name, command.name, wanted);
    if (parameter.nullable && !addressable) {
      AddNote(diagnostic, MakeMessage("a motion program cannot omit it; pass a variable",
                                      "运动程序不能省略该参数；请给出变量"));
    }
    if (addressable && entity != nullptr && entity->kind == Entity::Kind::kVariable) {
      InsertBefore(diagnostic, argument.range, "&");
      if (entity->array_size != 0) InsertAfter(diagnostic, argument.range, "[0]");
    } else if (addressable && variable.kind != Expression::Kind::kName) {
      InsertBefore(diagnostic, argument.range, "&");
    }
    return false;
  }

  CheckWritable(variable);
  if (context_.statement.failed) return false;

  // Structures are passed as a whole: as a variable of that type or, if programs cannot declare the
  // type, as the corresponding number of ints in an array.
  size_t slots = 1;
  if (parameter.structure != nullptr) {
    const Entity* entity =
        variable.kind == Expression::Kind::kName ? ResolveName(variable) : nullptr;
    if (variable.kind == Expression::Kind::kName && entity == nullptr) return false;
    if (entity != nullptr && entity->structure == parameter.structure) {
      instruction.operands.emplace_back(vm::Variable{entity->storage, entity->id});
      return true;
    }
    slots = 0;
    bool all_int = true;
    for (const gtcalls::Member& member : parameter.structure->members) {
      slots += static_cast<size_t>(std::max(1, member.array_size));
      all_int = all_int && !member.pointer && member.structure == nullptr &&
                gtcalls::ProgramType(member.type) == DataType::kInt;
    }
    if (parameter.structure->in_motion_program || !all_int ||
        (entity != nullptr && entity->structure != nullptr)) {
      Message found = ToMessage(fmt::format("'{}'", context_.Source(variable.range)));
      if (entity != nullptr) found = DescribeEntity(*entity);
      context_.Fail(Code::kTypeMismatch, argument.range, found, wanted,
                    StructureAdvice(*parameter.structure));
      return false;
    }
  } else if (variable.kind == Expression::Kind::kName) {
    const Entity* entity = ResolveName(variable);
    if (entity == nullptr) return false;
    if (entity->structure != nullptr) {
      context_.Fail(Code::kTypeMismatch, argument.range, DescribeEntity(*entity), wanted,
                    MakeMessage("pass a variable of that type", "请传入该类型的变量"));
      return false;
    }
  }
  const std::optional<TypedOperand> operand = ResolveOperand(variable);
  if (!operand) return false;
  const DataType type =
      parameter.structure != nullptr ? DataType::kInt : gtcalls::ProgramType(parameter.type);
  if (operand->type != type) {
    const Message found = operand->type == DataType::kDouble
                              ? MakeMessage("a double variable", "double 变量")
                              : MakeMessage("an int variable", "int 变量");
    context_.Fail(Code::kTypeMismatch, argument.range, found, wanted,
                  AddressAdvice(variable, type));
    return false;
  }

  // A literal count is compared with the number of the variable's elements from the one passed on.
  int64_t count = 1;
  const size_t count_index = static_cast<size_t>(parameter.count_parameter);
  if (parameter.count_parameter >= 0 && count_index + 1 < call.operands.size()) {
    const std::optional<Literal> literal = context_.ConstantOf(*call.operands[count_index + 1]);
    const std::optional<int32_t> value = literal ? IntValue(*literal) : std::nullopt;
    if (value && !literal->invalid) count = *value;
  }
  if (const vm::Variable* first = std::get_if<vm::Variable>(&operand->operand)) {
    int64_t available = 1;
    if (variable.kind == Expression::Kind::kIndex) {
      const Entity* array = context_.Lookup(variable.operands[0]->text);
      available = array->id + array->array_size - first->id;
    }
    const int64_t needed = std::max<int64_t>(1, count) * static_cast<int64_t>(slots);
    if (needed > available) {
      context_.Fail(Code::kOutputTooSmall, argument.range, parameter.name, command.name, needed,
                    ToMessage(fmt::format("'{}'", context_.Source(argument.range))), available);
      return false;
    }
  }
  instruction.operands.push_back(operand->operand);
  return true;
}

}  // namespace oncard::compiler
