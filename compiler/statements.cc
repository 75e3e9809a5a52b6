// Statements and control flow.
#include <algorithm>

#include "compiler/checker.h"
#include "compiler/rewriter.h"
#include "vm/limits.h"

namespace oncard::compiler {
namespace {

using vm::DataType;

// A return value or condition that is constant.
const vm::Operand kOne = vm::ImmediateInt(1);
const vm::Operand kZero = vm::ImmediateInt(0);

bool IsStatement(const Statement& statement) {
  switch (statement.kind) {
    case Statement::Kind::kEmpty:
    case Statement::Kind::kDeclaration:
    case Statement::Kind::kLabel:
    case Statement::Kind::kMacro:
      return false;
    default:
      return true;
  }
}

}  // namespace

void Checker::CheckItem(const Statement& statement) {
  switch (statement.kind) {
    case Statement::Kind::kDeclaration:
      declarations_.CheckDeclaration(statement, {});
      return;
    case Statement::Kind::kFunction:
      CheckFunction(*statement.function);
      return;
    case Statement::Kind::kMacro:
      declarations_.DefineMacro(context_.tree->macros[static_cast<size_t>(statement.macro)]);
      return;
    case Statement::Kind::kEmpty:
    case Statement::Kind::kError:
      return;
    default:
      CheckOutside(statement);
  }
}

// Only definitions are allowed at the top level.
void Checker::CheckOutside(const Statement& statement) {
  switch (statement.kind) {
    case Statement::Kind::kStrayBrace:
      Replace(context_.reporter.Report(Code::kStrayBrace, statement.range), statement.range, "");
      return;
    case Statement::Kind::kLabel:
      context_.reporter.Report(Code::kMisplacedLabel, statement.name_range, statement.name,
                               MakeMessage("outside a function", "函数之外"));
      return;
    case Statement::Kind::kExpression: {
      const Expression& value = *statement.value;
      if (value.kind == Expression::Kind::kError) return;
      if (value.kind == Expression::Kind::kCall &&
          value.operands[0]->kind == Expression::Kind::kName &&
          context_.catalogue.Find(value.operands[0]->text) != nullptr) {
        context_.reporter.Report(Code::kCommandOutside, statement.range, value.operands[0]->text);
        return;
      }
      break;
    }
    default:
      break;
  }
  context_.reporter.Report(Code::kOutsideFunction, statement.keyword);
}

void Checker::CheckBody(const std::vector<StatementPtr>& items, const Place& place) {
  // Position of the last statement; every item before it has a statement after it.
  size_t last = 0;
  for (size_t i = 0; i < items.size(); ++i) {
    if (IsStatement(*items[i])) last = i + 1;
  }
  for (size_t i = 0; i < items.size(); ++i) {
    const Statement& item = *items[i];
    Place here = place;
    here.followed = i + 1 < last || place.followed;
    here.single = false;
    if (item.kind == Statement::Kind::kLabel) {
      // A declaration after a label is moved to the top; then a statement follows the label.
      bool before_declaration = i + 1 < items.size() &&
                                items[i + 1]->kind == Statement::Kind::kDeclaration &&
                                !context_.function->statements_begun;
      if (before_declaration) {
        context_.reporter.Report(Code::kMisplacedLabel, item.name_range, item.name,
                                 MakeMessage("before a declaration", "声明之前"));
      }
      CheckLabel(item, i + 1 < last || !place.top);
      if (!before_declaration) context_.function->statements_begun = true;
      continue;
    }
    CheckStatement(item, here);
  }
}

void Checker::CheckLabel(const Statement& statement, bool has_statement) {
  FunctionState& function = *context_.function;
  const auto found = function.labels.find(statement.name);
  if (found != function.labels.end()) {
    AddNote(context_.reporter.Report(Code::kRedefinition, statement.name_range, statement.name),
            found->second.range, MakeMessage("the first definition is here", "首次定义在此处"));
    return;
  }
  if (function.labels.size() == vm::kLabelMax && !function.too_many_labels) {
    function.too_many_labels = true;
    context_.reporter.Report(Code::kTooManyLabels, statement.name_range, statement.name,
                             int64_t{vm::kLabelMax});
  }
  function.labels[statement.name] = {statement.name_range,
                                     static_cast<int>(function.out.instructions.size()), true};
  function.label_names.push_back(statement.name);
  if (!has_statement) {
    InsertAfter(context_.reporter.Report(Code::kLabelWithoutStatement, statement.name_range,
                                         statement.name),
                statement.range, " return;");
  }
}

void Checker::ResolveJumps() {
  FunctionState& function = *context_.function;
  for (const FunctionState::Jump& jump : function.jumps) {
    const auto label = function.labels.find(jump.label);
    if (label != function.labels.end()) {
      const int distance = label->second.instruction - static_cast<int>(jump.instruction);
      if (jump.instruction < function.out.instructions.size()) {
        function.out.instructions[jump.instruction].displacement = static_cast<int16_t>(distance);
      }
      continue;
    }
    if (context_.skipped_names.contains(jump.label)) continue;
    // Reported once for each label.
    if (!function.labels.emplace(jump.label, FunctionState::Label{jump.range, 0, false}).second) {
      continue;
    }
    Diagnostic& diagnostic = context_.reporter.Report(Code::kUnknownLabel, jump.range, jump.label);
    if (!context_.MaySuggest()) continue;
    Nearest nearest(jump.label);
    for (const std::string_view name : function.label_names) nearest.Add(name);
    if (!nearest.best().empty()) {
      AddNote(diagnostic, function.labels[nearest.best()].range,
              MakeMessage("did you mean '{0}'?", "您是否想写 '{0}'？", nearest.best()));
      Replace(diagnostic, jump.range, std::string(nearest.best()));
    }
  }
}

void Checker::BeginStatement(const Statement& statement) {
  context_.statement = {};
  context_.statement.range = statement.range;
  // Line numbers are words of the object; a larger one is written as unknown (0).
  const int line = context_.LineOf(statement.range);
  context_.statement.line = line <= UINT16_MAX ? static_cast<uint16_t>(line) : uint16_t{0};
}

void Checker::EndStatement(const Statement& statement, const Place& place) {
  // The array is made one-dimensional first.
  if (context_.statement.uses_flat_array && !context_.statement.failed) return;
  if (!context_.statement.lesson || context_.statement.broken) return;
  Diagnostic& diagnostic =
      context_.reporter.Report(context_.statement.lesson->code, context_.statement.lesson->range,
                               context_.statement.lesson->arguments);
  if (context_.statement.lesson->code == Code::kUserCall) {
    AddNote(diagnostic,
            MakeMessage("bind the function to a thread of its own from the host (GT_Bind, "
                        "GT_RunThread), or write its statements here",
                        "请由主机把该函数绑定到单独的线程（GT_Bind、GT_RunThread），"
                        "或把它的语句写在这里"));
  }
  if (!context_.statement.failed) Rewriter(context_, diagnostic).Rewrite(statement, place);
}

void Checker::CheckStatement(const Statement& statement, const Place& place) {
  if (statement.kind != Statement::Kind::kDeclaration &&
      statement.kind != Statement::Kind::kMacro) {
    context_.function->statements_begun = true;
  }
  switch (statement.kind) {
    case Statement::Kind::kEmpty:
    case Statement::Kind::kError:
      return;
    case Statement::Kind::kExpression:
      BeginStatement(statement);
      CheckExpressionStatement(statement);
      EndStatement(statement, place);
      return;
    case Statement::Kind::kDeclaration:
      declarations_.CheckDeclaration(statement, place);
      return;
    case Statement::Kind::kIf:
      CheckIf(statement, place);
      return;
    case Statement::Kind::kWhile:
    case Statement::Kind::kDo:
    case Statement::Kind::kFor:
      CheckLoop(statement, place);
      return;
    case Statement::Kind::kSwitch:
      CheckSwitch(statement, place);
      return;
    case Statement::Kind::kGoto:
      BeginStatement(statement);
      CheckGoto(statement, kOne);
      return;
    case Statement::Kind::kReturn:
      BeginStatement(statement);
      CheckReturn(statement, kOne);
      EndStatement(statement, place);
      return;
    case Statement::Kind::kLabel:
      CheckLabel(statement, true);
      return;
    case Statement::Kind::kCase:
    case Statement::Kind::kDefault:
      if (!place.in_switch) {
        context_.reporter.Report(
            Code::kReservedWord, statement.keyword, context_.Source(statement.keyword),
            MakeMessage("jump to a label with 'goto'", "请用 'goto' 跳转到标号"));
      }
      return;
    case Statement::Kind::kBreak:
    case Statement::Kind::kContinue: {
      const bool is_break = statement.kind == Statement::Kind::kBreak;
      if (place.in_loop || (is_break && place.in_switch)) return;
      context_.reporter.Report(
          Code::kReservedWord, statement.keyword, context_.Source(statement.keyword),
          MakeMessage("jump to a label with 'goto'", "请用 'goto' 跳转到标号"));
      return;
    }
    case Statement::Kind::kBlock: {
      Diagnostic& diagnostic = context_.reporter.Report(Code::kBlock, statement.keyword);
      Rewriter(context_, diagnostic).RewriteBlock(statement);
      Place inside = place;
      inside.top = false;
      CheckBlock(statement, inside);
      return;
    }
    case Statement::Kind::kFunction: {
      Diagnostic& diagnostic =
          context_.reporter.Report(Code::kNestedFunction, statement.function->name_range,
                                   statement.function->name, context_.function->syntax->name);
      AddNote(
          diagnostic, context_.function->syntax->open_brace,
          MakeMessage("'{0}' begins here", "'{0}' 从此处开始", context_.function->syntax->name));
      CheckFunction(*statement.function);
      return;
    }
    case Statement::Kind::kMacro:
      declarations_.DefineMacro(context_.tree->macros[static_cast<size_t>(statement.macro)]);
      return;
    case Statement::Kind::kStrayBrace:
      return;
  }
}

void Checker::CheckExpressionStatement(const Statement& statement) {
  const Expression& value = *statement.value;
  switch (value.kind) {
    case Expression::Kind::kAssign:
      CheckAssignment(value);
      return;
    case Expression::Kind::kCall:
      operands_.CheckCall(value);
      return;
    case Expression::Kind::kCompound:
    case Expression::Kind::kPostfix:
      operands_.CheckNames(value);
      if (!context_.statement.failed) operands_.ResolveTarget(*value.operands[0]);
      return;
    case Expression::Kind::kComma:
      operands_.TeachNested(value);
      return;
    case Expression::Kind::kParen: {
      const Expression* inner = &value;
      while (inner->kind == Expression::Kind::kParen) inner = inner->operands[0].get();
      if (inner->kind == Expression::Kind::kAssign || inner->kind == Expression::Kind::kCall ||
          inner->kind == Expression::Kind::kCompound) {
        operands_.TeachNested(value);
        return;
      }
      break;
    }
    case Expression::Kind::kUnary:
      if (value.op == "++" || value.op == "--") {
        operands_.CheckNames(value);
        return;
      }
      break;
    default:
      break;
  }
  operands_.CheckNames(value);
  if (!context_.statement.failed) {
    context_.statement.lesson.reset();
    context_.Fail(Code::kNoEffect, value.range);
  }
}

void Checker::CheckAssignment(const Expression& assignment) {
  const Expression& value = *assignment.operands[1];
  const std::optional<TypedOperand> target = operands_.ResolveTarget(*assignment.operands[0]);
  std::optional<Operation> operation = operands_.ResolveOperation(value);
  if (!target || !operation) return;
  const bool plain_literal = operation->opcode == vm::Opcode::kUnary &&
                             operation->op == static_cast<uint16_t>(vm::UnaryOperator::kCopy) &&
                             operation->operands[0].literal.has_value();
  if (operation->result != target->type) {
    if (!plain_literal || !operands_.Adapt(operation->operands[0], target->type)) {
      context_.Teach(Code::kTypeMismatch, value.range, DescribeType(operation->result),
                     DescribeType(target->type), ConvertAdvice());
      return;
    }
    operation->type = target->type;
  }
  vm::Instruction instruction;
  instruction.opcode = operation->opcode;
  instruction.op = operation->op;
  instruction.type = operation->type;
  for (const TypedOperand& operand : operation->operands) {
    instruction.operands.push_back(operand.operand);
  }
  instruction.operands.push_back(target->operand);
  context_.Emit(std::move(instruction));
}

void Checker::CheckGoto(const Statement& statement, vm::Operand condition) {
  vm::Instruction instruction;
  instruction.opcode = vm::Opcode::kJump;
  instruction.operands = {condition};
  context_.function->jumps.push_back(
      {context_.function->out.instructions.size(), statement.name, statement.name_range});
  context_.Emit(std::move(instruction));
}

void Checker::CheckReturn(const Statement& statement, vm::Operand condition) {
  vm::Instruction instruction;
  instruction.opcode = vm::Opcode::kReturn;
  instruction.operands = {condition, kZero};
  const DataType wanted = context_.function->out.return_type;
  if (statement.value == nullptr) {
    context_.Emit(std::move(instruction));
    return;
  }
  const Expression& value = *statement.value;
  if (value.kind == Expression::Kind::kError) {
    context_.statement.failed = true;
    return;
  }
  if (context_.function->is_void) {
    operands_.CheckNames(value);
    context_.statement.lesson.reset();
    Diagnostic& diagnostic =
        context_.Fail(Code::kReturnValue, value.range, context_.function->syntax->name);
    Replace(diagnostic, {value.range.file, statement.keyword.end, value.range.end}, "");
    return;
  }
  if (!IsLeaf(value) && !context_.ConstantOf(value)) {
    // Reports what the expression itself is, so that for `return -x;` it is the minus.
    const bool failed_before = context_.statement.failed;
    operands_.ResolveOperation(value);
    if (context_.statement.failed == failed_before) {
      context_.Teach(Code::kNestedExpression, value.range);
    }
    return;
  }
  std::optional<TypedOperand> operand = operands_.ResolveOperand(value);
  if (!operand) return;
  if (!operands_.Adapt(*operand, wanted)) {
    context_.Teach(Code::kTypeMismatch, value.range, DescribeType(operand->type),
                   DescribeType(wanted), ConvertAdvice());
    return;
  }
  instruction.operands[1] = operand->operand;
  context_.Emit(std::move(instruction));
}

// A condition must be an int variable.
void Checker::CheckCondition(const Expression& condition, vm::Operand* operand) {
  if (condition.kind == Expression::Kind::kName || condition.kind == Expression::Kind::kMember) {
    if (!context_.ConstantOf(condition)) {
      const std::optional<TypedOperand> variable = operands_.ResolveOperand(condition);
      if (!variable) {
        context_.statement.failed = true;
        return;
      }
      if (variable->type == DataType::kInt) {
        *operand = variable->operand;
        return;
      }
      context_.Teach(
          Code::kCondition, condition.range,
          MakeMessage("the double '{0}'", "double 变量 '{0}'", context_.Source(condition.range)));
      return;
    }
  }
  operands_.CheckNames(condition);
  context_.statement.lesson.reset();
  context_.Teach(Code::kCondition, condition.range,
                 ToMessage(fmt::format("'{}'", context_.Source(condition.range))));
}

void Checker::CheckIf(const Statement& statement, const Place& place) {
  BeginStatement(statement);
  vm::Operand condition = kOne;
  const Statement& body = *statement.body;
  const bool jumps = body.kind == Statement::Kind::kGoto || body.kind == Statement::Kind::kReturn;
  if (jumps && statement.else_body == nullptr) {
    CheckCondition(*statement.value, &condition);
    if (body.kind == Statement::Kind::kGoto) {
      CheckGoto(body, condition);
    } else {
      CheckReturn(body, condition);
    }
    EndStatement(statement, place);
    return;
  }
  operands_.CheckNames(*statement.value);
  const bool failed = context_.statement.failed;
  context_.statement.lesson.reset();
  Diagnostic* diagnostic = nullptr;
  if (statement.else_body != nullptr) {
    diagnostic = &context_.reporter.Report(Code::kIfElse, statement.other);
  } else if (body.kind != Statement::Kind::kError) {
    const std::string_view text = context_.Source(body.range);
    const size_t word = std::min(text.find_first_of(" \t\r\n;({"), text.size());
    diagnostic = &context_.reporter.Report(
        Code::kIfBody, body.keyword,
        ToMessage(fmt::format("'{}'", text.substr(0, std::max<size_t>(word, 1)))));
  }
  if (diagnostic != nullptr && !failed && !context_.statement.uses_flat_array) {
    Rewriter(context_, *diagnostic).Rewrite(statement, place);
  }
  Place inside = place;
  inside.top = false;
  inside.single = true;
  for (const Statement* branch : {statement.body.get(), statement.else_body.get()}) {
    if (branch == nullptr) continue;
    inside.followed = place.followed || (branch == &body && statement.else_body != nullptr);
    if (branch->kind == Statement::Kind::kBlock) {
      CheckBlock(*branch, inside);
    } else {
      CheckStatement(*branch, inside);
    }
  }
}

void Checker::OpenBlock(const Statement* statement) {
  context_.function->blocks.push_back({statement, {}});
}

void Checker::CloseBlock() {
  for (const auto& [name, outer] : context_.function->blocks.back().names) {
    if (outer) {
      context_.function->open_names[name] = *outer;
    } else {
      context_.function->open_names.erase(name);
    }
    if (context_.function->locals.Find(name)->hides) context_.function->locals.End(name);
  }
  context_.function->blocks.pop_back();
}

void Checker::CheckBlock(const Statement& statement, const Place& place) {
  OpenBlock(&statement);
  CheckBody(statement.items, place);
  CloseBlock();
}

// A jump from outside into the body of a loop, past its condition and first part, or nullptr.
const FunctionState::Goto* Checker::JumpInto(const Statement& loop) const {
  std::unordered_set<std::string_view> labels;
  ForEachStatement(*loop.body, [&labels](const Statement& below) {
    if (below.kind == Statement::Kind::kLabel) labels.insert(below.name);
  });
  if (labels.empty()) return nullptr;
  for (const FunctionState::Goto& jump : context_.function->gotos) {
    const bool inside = jump.range.file == loop.range.file &&
                        jump.range.begin >= loop.range.begin && jump.range.end <= loop.range.end;
    if (!inside && labels.contains(jump.label)) return &jump;
  }
  return nullptr;
}

void Checker::CheckLoop(const Statement& statement, const Place& place) {
  BeginStatement(statement);
  OpenBlock(&statement);
  if (statement.initial != nullptr && statement.initial->value != nullptr) {
    operands_.CheckNames(*statement.initial->value);
  }
  Place inside = place;
  inside.top = false;
  inside.single = true;
  inside.followed = true;
  inside.in_loop = true;
  inside.in_switch = false;
  std::vector<std::string> declarations;
  if (statement.initial != nullptr && statement.initial->kind == Statement::Kind::kDeclaration) {
    const Declarations::DeclaredType type =
        declarations_.ResolveType(statement.initial->specifiers);
    declarations_.CorrectType(statement.initial->specifiers, type, statement.initial->declarators,
                              statement.initial->range);
    if (type.is_static) context_.statement.failed = true;
    for (const Declarator& declarator : statement.initial->declarators) {
      const Entity* entity = declarations_.Reopen(declarator, type);
      if (entity == nullptr) entity = declarations_.Declare(declarator, type, false);
      if (entity == nullptr || entity->invalid || entity->hides) {
        context_.statement.failed = true;
      } else if (entity->late) {
        declarations.push_back(fmt::format("{} {};", type.words, context_.Source(declarator.head)));
      }
      if (declarator.initialiser != nullptr) operands_.CheckNames(*declarator.initialiser);
    }
  }
  if (statement.value != nullptr) operands_.CheckNames(*statement.value);
  if (statement.step != nullptr) operands_.CheckNames(*statement.step);
  context_.statement.lesson.reset();
  const Code code = statement.kind == Statement::Kind::kWhile ? Code::kWhileLoop
                    : statement.kind == Statement::Kind::kFor ? Code::kForLoop
                                                              : Code::kDoLoop;
  Diagnostic& diagnostic = context_.reporter.Report(code, statement.keyword);
  if (const FunctionState::Goto* jump = JumpInto(statement)) {
    context_.statement.failed = true;
    AddNote(diagnostic, jump->range,
            MakeMessage("this jumps into the middle of the loop; move the label '{0}' to the "
                        "beginning of the loop, or after it",
                        "此处跳到循环中间；请把标号 '{0}' 移到循环开头或循环之后", jump->label));
  }
  if (!context_.statement.failed && !context_.statement.uses_flat_array) {
    Rewriter rewriter(context_, diagnostic);
    for (std::string& declaration : declarations) rewriter.AddDeclaration(std::move(declaration));
    rewriter.Rewrite(statement, place);
  }
  if (statement.body->kind == Statement::Kind::kBlock) {
    CheckBlock(*statement.body, inside);
  } else {
    CheckStatement(*statement.body, inside);
  }
  CloseBlock();
}

// Checks that each case has a different number and is in the switch's own block.
void Checker::CheckCases(const Statement& statement) {
  std::unordered_map<int64_t, SourceRange> seen;
  SourceRange default_at;
  for (const StatementPtr& item : statement.body->items) {
    SourceRange* first = nullptr;
    if (item->kind == Statement::Kind::kCase) {
      operands_.CheckNames(*item->value);
      const std::optional<Constant> value = context_.FoldHere(*item->value);
      if (!value || value->is_double) continue;
      first = &seen[value->integer];
    } else if (item->kind == Statement::Kind::kDefault) {
      first = &default_at;
    } else {
      continue;
    }
    if (first->end == 0) {
      *first = item->range;
      continue;
    }
    std::string_view name = context_.Source(item->range);
    name.remove_suffix(1);
    AddNote(context_.Fail(Code::kRedefinition, item->range, name), *first,
            MakeMessage("the first one is here", "第一个在此处"));
  }
}

void Checker::CheckSwitch(const Statement& statement, const Place& place) {
  BeginStatement(statement);
  operands_.CheckNames(*statement.value);
  const bool block = statement.body->kind == Statement::Kind::kBlock;
  if (block) CheckCases(statement);
  context_.statement.lesson.reset();
  Diagnostic& diagnostic = context_.reporter.Report(Code::kSwitch, statement.keyword);
  if (!context_.statement.failed && !context_.statement.uses_flat_array && block) {
    Rewriter(context_, diagnostic).Rewrite(statement, place);
  }
  Place inside = place;
  inside.top = false;
  inside.single = !block;
  inside.in_switch = true;
  if (block) {
    CheckBlock(*statement.body, inside);
  } else {
    CheckStatement(*statement.body, inside);
  }
}

}  // namespace oncard::compiler
