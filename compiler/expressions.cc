// Operands and operations: what one instruction can compute, and diagnostics for the rest.
#include <algorithm>

#include "compiler/operands.h"

namespace oncard::compiler {

using vm::DataType;

Message DescribeType(DataType type) {
  if (type == DataType::kDouble) return MakeMessage("a double", "double");
  if (type == DataType::kInt) return MakeMessage("an int", "int");
  return MakeMessage("nothing", "无");
}

Message DescribeRange(DataType type, vm::DoubleFormat format, bool upper) {
  if (type == DataType::kInt)
    return ToMessage(std::string_view(upper ? "2147483647" : "-2147483648"));
  const bool wide = format == vm::DoubleFormat::k32_16;
  return ToMessage(std::string_view(upper ? (wide ? "2147483647.99998" : "32767.99998")
                                          : (wide ? "-2147483648" : "-32768")));
}

Message DescribeEntity(const Entity& entity) {
  switch (entity.kind) {
    case Entity::Kind::kMacro:
      return MakeMessage("a macro", "宏");
    case Entity::Kind::kFunction:
      return MakeMessage("a function", "函数");
    case Entity::Kind::kVariable:
      break;
  }
  if (entity.structure != nullptr) {
    return MakeMessage("a structure {0}", "{0} 结构", entity.structure->name);
  }
  if (entity.array_size != 0) return MakeMessage("an array", "数组");
  return MakeMessage("a variable", "变量");
}

Message ConvertAdvice() {
  return MakeMessage("convert it with a cast in a statement of its own",
                     "请用单独的语句做强制类型转换");
}

bool IsLeaf(const Expression& expression) {
  switch (expression.kind) {
    case Expression::Kind::kName:
    case Expression::Kind::kLiteral:
    case Expression::Kind::kIndex:
    case Expression::Kind::kMember:
      return true;
    default:
      return false;
  }
}

// A name that nobody declares is, in this order: a command without its parentheses, a constant of
// gts.h, `true` or `false`, a name that is written wrongly, a macro that is missing. Each name is
// reported once in a function.
void Operands::ReportUndeclared(const Expression& expression) {
  const std::string_view name = expression.text;
  context_.statement.failed = true;
  if (context_.skipped_names.contains(name) || undeclared_macros_.contains(name)) return;
  if (context_.function != nullptr && !context_.function->undeclared.insert(name).second) return;
  if (const gtcalls::Command* command = context_.catalogue.Find(name)) {
    Diagnostic& diagnostic = context_.reporter.Report(
        Code::kMissingOpenParen, expression.range,
        MakeMessage("the command {0} without arguments", "没有参数的指令 {0}", name));
    if (command->parameters.empty()) InsertAfter(diagnostic, expression.range, "()");
    return;
  }
  Diagnostic& diagnostic = context_.reporter.Report(Code::kUndeclared, expression.range, name);
  if (const gtcalls::Constant* constant = context_.catalogue.FindConstant(name)) {
    undeclared_macros_.insert(name);
    const std::string line = fmt::format("#define {} {}", name, constant->value);
    AddNote(diagnostic,
            MakeMessage("the constants of gts.h are not known to motion programs; add '{0}'",
                        "运动程序不识别 gts.h 中的常量；请加上 '{0}'", line));
    InsertBefore(diagnostic, context_.first_item, line + "\n");
    return;
  }
  if (const std::optional<Literal> truth = TruthValue(name)) {
    undeclared_macros_.insert(name);
    const std::string line = fmt::format("#define {} {}", name, truth->magnitude);
    AddNote(diagnostic, MakeMessage("in C a header defines it: '{0}'; add this line",
                                    "C 语言的头文件中有 '{0}'；请加上", line));
    InsertBefore(diagnostic, context_.first_item, line + "\n");
    return;
  }
  if (!context_.MaySuggest()) return;
  Nearest nearest(name);
  if (context_.function != nullptr) {
    for (const Entity& entity : context_.function->locals.entities()) nearest.Add(entity.name);
  }
  for (const Entity& entity : context_.globals.entities()) {
    if (entity.kind != Entity::Kind::kFunction) nearest.Add(entity.name);
  }
  if (nearest.best().empty()) {
    const bool like_a_macro = name.size() > 1 && std::none_of(name.begin(), name.end(), [](char c) {
                                return c >= 'a' && c <= 'z';
                              });
    if (like_a_macro) {
      AddNote(diagnostic,
              MakeMessage("if it is a macro, add '#define {0} number' before the function",
                          "如果是宏，请在函数之前加上 '#define {0} 数值'", name));
    }
    return;
  }
  const Entity* entity = context_.Lookup(nearest.best());
  AddNote(diagnostic, entity->range,
          MakeMessage("did you mean '{0}'?", "您是否想写 '{0}'？", nearest.best()));
  Replace(diagnostic, expression.range, std::string(nearest.best()));
}

const Entity* Operands::ResolveName(const Expression& expression) {
  const Entity* entity = context_.Lookup(expression.text);
  if (entity == nullptr) {
    ReportUndeclared(expression);
    return nullptr;
  }
  if (entity->invalid) {
    context_.statement.failed = true;
    return nullptr;
  }
  return entity;
}

std::optional<TypedOperand> Operands::LiteralOperand(const Literal& literal, SourceRange range) {
  TypedOperand operand;
  operand.range = range;
  operand.literal = literal;
  operand.type = literal.kind == Literal::Kind::kFixed ? DataType::kDouble : DataType::kInt;
  if (!Adapt(operand, operand.type)) return std::nullopt;
  return operand;
}

// Only a literal takes the type that its statement needs: 1 beside a double is 1.0.
bool Operands::Adapt(TypedOperand& operand, DataType type) {
  if (!operand.literal) return operand.type == type;
  if (type == DataType::kInt && operand.literal->kind == Literal::Kind::kFixed) return false;
  std::optional<int64_t> raw;
  if (type == DataType::kInt) {
    if (const std::optional<int32_t> value = IntValue(*operand.literal)) {
      raw = vm::ImmediateInt(*value).raw;
    }
  } else {
    raw = FixedValue(*operand.literal, context_.options.double_format);
  }
  if (!raw) {
    context_.Fail(Code::kLiteralTooLarge, operand.range, context_.Source(operand.range),
                  DescribeType(type), DescribeRange(type, context_.options.double_format, false),
                  DescribeRange(type, context_.options.double_format, true));
    operand.literal->invalid = true;
    raw = 0;
  }
  operand.operand = vm::Immediate{*raw};
  operand.type = type;
  return true;
}

std::optional<TypedOperand> Operands::ResolveOperand(const Expression& expression) {
  if (const std::optional<Literal> constant = context_.ConstantOf(expression)) {
    return LiteralOperand(*constant, expression.range);
  }
  switch (expression.kind) {
    case Expression::Kind::kIndex:
      return ResolveIndex(expression);
    case Expression::Kind::kMember:
      return ResolveMember(expression);
    case Expression::Kind::kName:
      break;
    default:
      return std::nullopt;
  }
  const Entity* entity = ResolveName(expression);
  if (entity == nullptr) return std::nullopt;
  if (entity->kind == Entity::Kind::kFunction || entity->structure != nullptr) {
    Diagnostic& diagnostic =
        context_.Fail(Code::kMisuse, expression.range, expression.text, DescribeEntity(*entity),
                      MakeMessage("a variable or a number", "变量或数"));
    if (entity->structure != nullptr) {
      AddNote(diagnostic, MakeMessage("write a member, such as {0}.{1}", "请写成员，例如 {0}.{1}",
                                      expression.text, entity->structure->members[0].name));
    }
    return std::nullopt;
  }
  if (entity->array_size != 0) {
    InsertAfter(context_.Fail(Code::kArrayWithoutIndex, expression.range, expression.text),
                expression.range, "[0]");
    return std::nullopt;
  }
  TypedOperand operand;
  operand.operand = vm::Variable{entity->storage, entity->id};
  operand.type = entity->type;
  operand.range = expression.range;
  return operand;
}

// A constant index outside the array is an error, however the rest is rewritten.
bool Operands::CheckBounds(const Entity& array, int64_t size, const Expression& index) {
  const std::optional<Constant> value = context_.FoldHere(index);
  if (!value || value->is_double || (value->integer >= 0 && value->integer < size)) return true;
  AddNote(context_.Fail(Code::kIndexOutOfBounds, index.range, value->integer, array.name, size - 1),
          array.range, MakeMessage("'{0}' is declared here", "'{0}' 在此声明", array.name));
  return false;
}

// After an incorrect use of a multi-dimensional array, no fix-it is offered for its declaration.
void Operands::LeaveArray(std::string_view name) {
  const auto flat = context_.flat_arrays.find(name);
  if (flat == context_.flat_arrays.end()) return;
  flat->second.report->fixits.clear();
  flat->second.good = false;
}

// a[i][j] of a multi-dimensional array: the edits of all uses belong to the diagnostic of its
// declaration. They leave one index expression, which a later fix-it can simplify.
void Operands::ResolveManyIndices(const Expression& expression) {
  std::vector<const Expression*> levels;
  const Expression* base = &expression;
  for (; base->kind == Expression::Kind::kIndex; base = base->operands[0].get()) {
    levels.insert(levels.begin(), base);
  }
  const Entity* array =
      base->kind == Expression::Kind::kName ? context_.Lookup(base->text) : nullptr;
  const auto flat = context_.flat_arrays.find(base->text);
  if (array == nullptr || array->dimensions.size() != levels.size() ||
      flat == context_.flat_arrays.end()) {
    context_.Fail(Code::kIllegalOperator, expression.range, std::string_view("[]"),
                  MakeMessage("arrays have one dimension", "数组只能是一维"));
    LeaveArray(base->text);
    return;
  }
  context_.statement.uses_flat_array = true;
  bool good = true;
  std::optional<int64_t> number = 0;
  for (size_t i = 0; i < levels.size(); ++i) {
    const Expression& index = *levels[i]->operands[1];
    CheckNames(index);
    good = CheckBounds(*array, array->dimensions[i], index) && good;
    const std::optional<Constant> value = context_.FoldHere(index);
    number = number && value && !value->is_double
                 ? std::optional(*number * array->dimensions[i] + value->integer)
                 : std::nullopt;
  }
  if (!good) LeaveArray(array->name);
  if (!flat->second.good || !flattened_.insert(&expression).second) return;
  Diagnostic& bearer = *flat->second.report;
  const SourceRange first = levels.front()->operands[1]->range;
  if (number) {
    Replace(bearer, {first.file, first.begin, expression.range.end - 1}, std::to_string(*number));
    return;
  }
  // ((i) * 3 + j) * 4 + k; everything except a name or a number is in parentheses.
  const auto open = [](const Expression& index) { return IsLeaf(index) ? "" : "("; };
  const auto close = [](const Expression& index) { return IsLeaf(index) ? "" : ")"; };
  InsertBefore(bearer, first, std::string(levels.size() - 2, '(') + open(*levels[0]->operands[1]));
  for (size_t i = 1; i < levels.size(); ++i) {
    const Expression& before = *levels[i - 1]->operands[1];
    const Expression& index = *levels[i]->operands[1];
    Replace(bearer, {index.range.file, before.range.end, index.range.begin},
            fmt::format("{}{} * {} + {}", close(before), i > 1 ? ")" : "", array->dimensions[i],
                        open(index)));
  }
  const Expression& last = *levels.back()->operands[1];
  if (!IsLeaf(last)) InsertAfter(bearer, last.range, ")");
}

std::optional<TypedOperand> Operands::ResolveIndex(const Expression& expression) {
  const Expression& array = *expression.operands[0];
  const Expression& index = *expression.operands[1];
  if (array.kind == Expression::Kind::kIndex) {
    ResolveManyIndices(expression);
    return std::nullopt;
  }
  if (array.kind != Expression::Kind::kName) {
    CheckNames(array);
    CheckNames(index);
    if (!context_.statement.failed) {
      context_.Fail(Code::kIllegalOperator, expression.range, std::string_view("[]"),
                    MakeMessage("only an array has elements", "只有数组才有元素"));
    }
    return std::nullopt;
  }
  const Entity* entity = ResolveName(array);
  if (entity == nullptr) {
    CheckNames(index);
    return std::nullopt;
  }
  if (entity->kind != Entity::Kind::kVariable || entity->array_size == 0) {
    context_.Fail(Code::kMisuse, array.range, array.text, DescribeEntity(*entity),
                  MakeMessage("an array", "数组"));
    return std::nullopt;
  }
  if (entity->dimensions.size() > 1) {
    AddNote(context_.Fail(Code::kIllegalOperator, expression.range, std::string_view("[]"),
                          MakeMessage("a row is not an element", "一行不是一个元素")),
            MakeMessage("write an index for each dimension", "请为每一维写一个下标"));
    LeaveArray(entity->name);
    return std::nullopt;
  }
  TypedOperand operand;
  operand.type = entity->type;
  operand.range = expression.range;
  if (const std::optional<Literal> constant = context_.ConstantOf(index)) {
    if (constant->kind == Literal::Kind::kFixed) {
      context_.Fail(Code::kIllegalIndex, index.range, MakeMessage("a double", "double"));
      return std::nullopt;
    }
    const std::optional<TypedOperand> literal = LiteralOperand(*constant, index.range);
    if (!literal || literal->literal->invalid) {
      context_.statement.failed = true;
      return std::nullopt;
    }
    const int32_t value = *IntValue(*constant);
    if (value < 0 || value >= entity->array_size) {
      AddNote(context_.Fail(Code::kIndexOutOfBounds, index.range, int64_t{value}, array.text,
                            int64_t{entity->array_size} - 1),
              entity->range, MakeMessage("'{0}' is declared here", "'{0}' 在此声明", array.text));
      return std::nullopt;
    }
    operand.operand = vm::Variable{entity->storage, static_cast<uint16_t>(entity->id + value)};
    return operand;
  }
  if (index.kind == Expression::Kind::kIndex) {
    const bool failed_before = context_.statement.failed;
    ResolveOperand(index);
    if (context_.statement.failed == failed_before) {
      context_.Teach(Code::kElementIndex, index.range, context_.Source(index.range));
    }
    return std::nullopt;
  }
  if (index.kind != Expression::Kind::kName) {
    CheckNames(index);
    context_.Teach(
        Code::kIllegalIndex, index.range,
        MakeMessage("the expression '{0}'", "表达式 '{0}'", context_.Source(index.range)));
    return std::nullopt;
  }
  const std::optional<TypedOperand> variable = ResolveOperand(index);
  if (!variable) return std::nullopt;
  if (variable->type != DataType::kInt) {
    context_.Teach(Code::kIllegalIndex, index.range,
                   MakeMessage("the double '{0}'", "double 变量 '{0}'", index.text));
    return std::nullopt;
  }
  operand.operand = vm::Element{entity->storage, entity->id, entity->array_size,
                                *std::get_if<vm::Variable>(&variable->operand)};
  return operand;
}

std::optional<TypedOperand> Operands::ResolveMember(const Expression& expression) {
  const Expression& base = *expression.operands[0];
  if (expression.op == "->") {
    if (base.kind == Expression::Kind::kName) {
      ResolveName(base);
    } else {
      CheckNames(base);
    }
    Diagnostic& diagnostic =
        context_.Fail(Code::kIllegalOperator, expression.range, expression.op,
                      MakeMessage("there are no pointers; write '.'", "没有指针；请写 '.'"));
    Replace(diagnostic, {base.range.file, base.range.end, expression.op_range.begin}, ".");
    return std::nullopt;
  }
  if (base.kind != Expression::Kind::kName) {
    CheckNames(base);
    if (!context_.statement.failed) {
      context_.Fail(Code::kNoMember, expression.op_range,
                    ToMessage(fmt::format("'{}'", context_.Source(base.range))), expression.text);
    }
    return std::nullopt;
  }
  const Entity* entity = ResolveName(base);
  if (entity == nullptr) return std::nullopt;
  if (entity->structure == nullptr) {
    context_.Fail(Code::kNoMember, expression.op_range,
                  MakeMessage("'{0}', {1},", "'{0}'（{2}）", base.text, DescribeEntity(*entity).en,
                              DescribeEntity(*entity).zh),
                  expression.text);
    return std::nullopt;
  }
  Nearest nearest(expression.text);
  uint16_t offset = 0;
  for (const gtcalls::Member& member : entity->structure->members) {
    if (member.name == expression.text) {
      TypedOperand operand;
      operand.operand = vm::Variable{entity->storage, static_cast<uint16_t>(entity->id + offset)};
      operand.type = gtcalls::ProgramType(member.type);
      operand.range = expression.range;
      return operand;
    }
    nearest.Add(member.name);
    ++offset;
  }
  Diagnostic& diagnostic =
      context_.Fail(Code::kNoMember, expression.op_range, entity->structure->name, expression.text);
  if (nearest.best().empty()) {
    std::string names;
    for (const gtcalls::Member& member : entity->structure->members) {
      if (!names.empty()) names += ", ";
      names += member.name;
    }
    AddNote(diagnostic, MakeMessage("its members are {0}", "它的成员有 {0}", names));
  } else {
    AddNote(diagnostic, MakeMessage("did you mean '{0}'?", "您是否想写 '{0}'？", nearest.best()));
    Replace(diagnostic, expression.op_range, std::string(nearest.best()));
  }
  return std::nullopt;
}

// Reports an assignment to a const. Other targets are checked where they are used.
void Operands::CheckWritable(const Expression& target) {
  const Entity* entity = context_.Lookup(BaseName(target));
  if (entity == nullptr || !entity->is_const) return;
  AddNote(context_.Fail(Code::kMisuse, target.range, context_.Source(target.range),
                        MakeMessage("const", "常量"),
                        MakeMessage("a variable to assign to", "可赋值的变量")),
          entity->range, MakeMessage("'{0}' is defined here", "'{0}' 在此定义", entity->name));
}

std::optional<TypedOperand> Operands::ResolveTarget(const Expression& expression) {
  const Message wanted = MakeMessage("a variable to assign to", "可赋值的变量");
  const bool failed_before = context_.statement.failed;
  CheckWritable(expression);
  if (context_.statement.failed != failed_before) return std::nullopt;
  if (expression.kind == Expression::Kind::kError || expression.literal.invalid) {
    context_.statement.failed = true;
    return std::nullopt;
  }
  if (expression.kind == Expression::Kind::kParen) {
    CheckNames(expression);
    context_.Teach(Code::kNestedExpression, expression.range);
    return std::nullopt;
  }
  if (expression.kind == Expression::Kind::kUnary && expression.op == "*") {
    CheckNames(expression);
    return std::nullopt;
  }
  if (!IsLeaf(expression) || expression.kind == Expression::Kind::kLiteral) {
    CheckNames(expression);
    if (!context_.statement.failed) {
      const Message what = expression.kind == Expression::Kind::kLiteral
                               ? MakeMessage("a number", "数")
                               : MakeMessage("an expression", "表达式");
      context_.Fail(Code::kMisuse, expression.range, context_.Source(expression.range), what,
                    wanted);
    }
    return std::nullopt;
  }
  if (expression.kind == Expression::Kind::kName) {
    const Entity* entity = context_.Lookup(expression.text);
    if (entity != nullptr && entity->kind == Entity::Kind::kMacro) {
      AddNote(context_.Fail(Code::kMisuse, expression.range, expression.text,
                            DescribeEntity(*entity), wanted),
              entity->range,
              MakeMessage("'{0}' is defined here", "'{0}' 在此定义", expression.text));
      return std::nullopt;
    }
  }
  return ResolveOperand(expression);
}

void Operands::TeachNested(const Expression& expression) {
  context_.Teach(Code::kNestedExpression, expression.range);
  CheckNames(expression);
}

std::optional<Operation> Operands::ResolveOperation(const Expression& expression) {
  if (IsLeaf(expression) || context_.ConstantOf(expression)) {
    std::optional<TypedOperand> operand = ResolveOperand(expression);
    if (!operand) return std::nullopt;
    Operation operation;
    operation.type = operation.result = operand->type;
    operation.operands.push_back(*operand);
    return operation;
  }
  switch (expression.kind) {
    case Expression::Kind::kUnary:
      return ResolveUnary(expression);
    case Expression::Kind::kBinary:
      return ResolveBinary(expression);
    case Expression::Kind::kCast:
      return ResolveCast(expression);
    case Expression::Kind::kCall: {
      const Expression& callee = *expression.operands[0];
      if (callee.kind == Expression::Kind::kName && context_.Lookup(callee.text) == nullptr &&
          (callee.text == "abs" || callee.text == "fabs")) {
        return ResolveMagnitude(expression);
      }
      CheckNames(expression);
      return std::nullopt;
    }
    case Expression::Kind::kParen:
    case Expression::Kind::kAssign:
    case Expression::Kind::kComma:
      TeachNested(expression);
      return std::nullopt;
    default:
      CheckNames(expression);
      return std::nullopt;
  }
}

std::optional<Operation> Operands::ResolveBinary(const Expression& expression) {
  const Expression& left = *expression.operands[0];
  const Expression& right = *expression.operands[1];
  const bool simple =
      (IsLeaf(left) || context_.ConstantOf(left)) && (IsLeaf(right) || context_.ConstantOf(right));
  if (!simple) {
    TeachNested(expression);
    return std::nullopt;
  }
  std::optional<TypedOperand> a = ResolveOperand(left);
  std::optional<TypedOperand> b = ResolveOperand(right);
  if (!a || !b) return std::nullopt;
  const vm::OperatorInfo& info = *vm::FindBinaryOperator(expression.op);
  const bool any_double = a->type == DataType::kDouble || b->type == DataType::kDouble;
  const DataType type = any_double ? DataType::kDouble : DataType::kInt;
  if (any_double && !vm::Accepts(info, type)) {
    context_.Fail(Code::kIllegalOperator, expression.op_range, expression.op,
                  MakeMessage("it takes two ints", "它只能用于两个 int"));
    return std::nullopt;
  }
  for (TypedOperand* operand : {&*a, &*b}) {
    if (!Adapt(*operand, type)) {
      context_.Teach(Code::kTypeMismatch, operand->range,
                     MakeMessage("an int beside a double", "int 与 double 混用"),
                     MakeMessage("two operands of the same type", "两个类型相同的操作数"),
                     ConvertAdvice());
      return std::nullopt;
    }
  }
  Operation operation;
  operation.opcode = vm::Opcode::kBinary;
  operation.op = info.number;
  operation.type = type;
  operation.result = vm::ResultOf(info, type);
  operation.operands = {*a, *b};
  return operation;
}

std::optional<TypedOperand> Operands::ResolveOnlyOperand(const Expression& operand,
                                                         const Expression& operation) {
  if (IsLeaf(operand) || context_.ConstantOf(operand)) return ResolveOperand(operand);
  TeachNested(operation);
  return std::nullopt;
}

std::optional<Operation> Operands::ResolveUnary(const Expression& expression) {
  const Expression& inner = *expression.operands[0];
  const std::string_view op = expression.op;
  const vm::OperatorInfo* info = vm::FindUnaryOperator(op);
  if (info == nullptr && op != "-") {
    CheckNames(expression);
    return std::nullopt;
  }
  const std::optional<TypedOperand> operand = ResolveOnlyOperand(inner, expression);
  if (!operand) return std::nullopt;
  if (info == nullptr) {
    context_.Teach(Code::kUnaryMinus, expression.range);
    return std::nullopt;
  }
  if (!vm::Accepts(*info, operand->type)) {
    context_.Fail(Code::kIllegalOperator, expression.op_range, op,
                  MakeMessage("it takes an int", "它只能用于 int"));
    return std::nullopt;
  }
  Operation operation;
  operation.op = info->number;
  operation.type = operand->type;
  operation.result = vm::ResultOf(*info, operand->type);
  operation.operands.push_back(*operand);
  return operation;
}

std::optional<Operation> Operands::ResolveCast(const Expression& expression) {
  const Expression& inner = *expression.operands[0];
  const bool to_double = expression.text == "double";
  if (!to_double && expression.text != "int" && expression.text != "long" &&
      expression.text != "short") {
    CheckNames(inner);
    context_.Fail(Code::kNotAType, expression.op_range,
                  ToMessage(fmt::format("'{}'", context_.Source(expression.op_range))),
                  std::string_view("int, double"));
    return std::nullopt;
  }
  const std::optional<TypedOperand> operand = ResolveOnlyOperand(inner, expression);
  if (!operand) return std::nullopt;
  Operation operation;
  operation.type = operand->type;
  operation.result = to_double ? DataType::kDouble : DataType::kInt;
  if (operation.type != operation.result) {
    operation.op =
        static_cast<uint16_t>(to_double ? vm::UnaryOperator::kToDouble : vm::UnaryOperator::kToInt);
  }
  operation.operands.push_back(*operand);
  operation.operands[0].literal.reset();  // the result has the type of the cast
  return operation;
}

std::optional<Operation> Operands::ResolveMagnitude(const Expression& expression) {
  const Expression& callee = *expression.operands[0];
  const DataType type = callee.text == "fabs" ? DataType::kDouble : DataType::kInt;
  const size_t count = expression.operands.size() - 1;
  if (count != 1) {
    for (size_t i = 1; i <= count; ++i) CheckNames(*expression.operands[i]);
    if (count == 0) {
      context_.Fail(Code::kTooFewArguments, expression.range, callee.text, int64_t{1}, int64_t{0},
                    MakeMessage("the number", "操作数"));
    } else {
      context_.Fail(Code::kTooManyParameters, expression.range, callee.text, int64_t{1},
                    static_cast<int64_t>(count));
    }
    return std::nullopt;
  }
  const Expression& inner = *expression.operands[1];
  std::optional<TypedOperand> operand = ResolveOnlyOperand(inner, expression);
  if (!operand) return std::nullopt;
  if (!Adapt(*operand, type)) {
    const std::string_view other = type == DataType::kInt ? "fabs" : "abs";
    const Message found = DescribeType(operand->type);
    Diagnostic& diagnostic =
        context_.Fail(Code::kTypeMismatch, inner.range, found, DescribeType(type),
                      MakeMessage("'{0}' takes {1}", "{2} 请用 '{0}'", other, found.en, found.zh));
    Replace(diagnostic, callee.range, std::string(other));
    return std::nullopt;
  }
  Operation operation;
  operation.op = static_cast<uint16_t>(type == DataType::kDouble ? vm::UnaryOperator::kFabs
                                                                 : vm::UnaryOperator::kAbs);
  operation.type = operation.result = type;
  operation.operands.push_back(*operand);
  return operation;
}

// Reports all errors inside an expression that no instruction can compute.
void Operands::CheckNames(const Expression& expression) {
  switch (expression.kind) {
    case Expression::Kind::kError:
      context_.statement.failed = context_.statement.broken = true;
      return;
    case Expression::Kind::kName:
    case Expression::Kind::kLiteral:
    case Expression::Kind::kIndex:
    case Expression::Kind::kMember:
      ResolveOperand(expression);
      return;
    case Expression::Kind::kString: {
      Diagnostic& diagnostic = context_.Fail(Code::kExpectedOperand, expression.range,
                                             context_.Source(expression.range));
      if (const std::optional<int> character = CharacterValue(expression.text)) {
        Replace(diagnostic, expression.range, std::to_string(*character));
        AddNote(diagnostic,
                MakeMessage("in C it is the number {0}", "在 C 语言中它是数 {0}", *character));
      }
      return;
    }
    case Expression::Kind::kBraces:
    case Expression::Kind::kDesignated:
    case Expression::Kind::kCompoundLiteral:
      context_.Fail(Code::kExpectedOperand, expression.range, std::string_view("'{'"));
      return;
    case Expression::Kind::kCall: {
      const Expression& callee = *expression.operands[0];
      for (size_t i = 1; i < expression.operands.size(); ++i) {
        const Expression& argument = *expression.operands[i];
        const bool address = argument.kind == Expression::Kind::kUnary && argument.op == "&";
        CheckNames(address ? *argument.operands[0] : argument);
      }
      if (callee.kind != Expression::Kind::kName) {
        CheckNames(callee);
        if (callee.literal.invalid) {
          context_.statement.failed = true;
        } else {
          context_.Fail(Code::kNotACommand, callee.range, context_.Source(callee.range));
        }
        return;
      }
      const Entity* entity = context_.Lookup(callee.text);
      if (entity == nullptr && (callee.text == "abs" || callee.text == "fabs")) {
        context_.Teach(Code::kNestedExpression, expression.range);
      } else if (context_.catalogue.Find(callee.text) != nullptr) {
        context_.Teach(Code::kRightOfAssign, callee.range, callee.text);
      } else {
        ReportUnknownCall(callee);
      }
      return;
    }
    case Expression::Kind::kUnary:
      if (context_.ConstantOf(expression)) {
        ResolveOperand(expression);
        return;
      }
      if (expression.op == "++" || expression.op == "--") CheckWritable(*expression.operands[0]);
      if (expression.op == "&") {
        CheckNames(*expression.operands[0]);
        context_.Fail(Code::kIllegalOperator, expression.op_range, expression.op,
                      MakeMessage("addresses are only for the outputs of GT commands",
                                  "取地址只能用于 GT 指令的输出参数"));
        return;
      }
      if (expression.op == "*") {
        CheckNames(*expression.operands[0]);
        context_.Fail(Code::kIllegalOperator, expression.op_range, expression.op,
                      MakeMessage("there are no pointers", "没有指针"));
        return;
      }
      [[fallthrough]];
    case Expression::Kind::kPostfix:
      if (expression.kind == Expression::Kind::kPostfix) CheckWritable(*expression.operands[0]);
      if (expression.op == "++" || expression.op == "--") {
        context_.Teach(Code::kIncrement, expression.op_range, expression.op,
                       context_.Source(expression.operands[0]->range), expression.op.substr(1));
      } else if (expression.op == "+") {
        context_.Teach(Code::kIllegalOperator, expression.op_range, expression.op,
                       MakeMessage("remove the sign '+'", "不写正号 '+'"));
      }
      break;
    case Expression::Kind::kAssign:
      CheckWritable(*expression.operands[0]);
      break;
    case Expression::Kind::kCompound:
      CheckWritable(*expression.operands[0]);
      context_.Teach(Code::kCompoundAssignment, expression.op_range, expression.op);
      break;
    case Expression::Kind::kConditional:
      context_.Teach(Code::kIllegalOperator, expression.op_range, std::string_view("?:"),
                     MakeMessage("choose with 'if (variable) goto label;'",
                                 "请用 'if (变量) goto 标号;' 选择"));
      break;
    default:
      break;
  }
  for (const ExpressionPtr& operand : expression.operands) CheckNames(*operand);
}

}  // namespace oncard::compiler
