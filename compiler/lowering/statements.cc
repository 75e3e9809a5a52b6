// Statements other than loops and `switch`.
#include <fmt/core.h>

#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {

void Lowerer::LowerBody(const std::vector<StatementPtr>& items) {
  for (const StatementPtr& item : items) LowerStatement(*item);
}

void Lowerer::LowerInner(const Statement& body) { LowerStatement(body); }

// Where a `goto`, `break` or `continue` leads, if the statement is nothing else.
std::optional<int> Lowerer::JumpTarget(const Statement& statement) {
  const auto target = [this](int Targets::*label) -> std::optional<int> {
    if (frame_->targets.empty() || frame_->targets.back().*label < 0) return std::nullopt;
    return frame_->targets.back().*label;
  };
  switch (statement.kind) {
    case Statement::Kind::kBlock:
      return statement.items.size() == 1 ? JumpTarget(*statement.items[0]) : std::nullopt;
    case Statement::Kind::kGoto: {
      const auto found = frame_->labels.find(statement.name);
      return found == frame_->labels.end() ? std::nullopt : std::optional(found->second);
    }
    case Statement::Kind::kBreak:
      return target(&Targets::break_label);
    case Statement::Kind::kContinue:
      return target(&Targets::continue_label);
    default:
      return std::nullopt;
  }
}

void Lowerer::LowerLeave(const Statement& statement) {
  if (const std::optional<int> label = JumpTarget(statement)) {
    EmitGoto(*label, statement.range);
  } else if (statement.kind == Statement::Kind::kGoto) {
    Report(Code::kUnknownLabel, statement.name_range, statement.name);
  } else {
    const bool is_break = statement.kind == Statement::Kind::kBreak;
    Report(Code::kStrayLeave, statement.range, is_break ? "break" : "continue");
  }
}

void Lowerer::LowerIf(const Statement& statement) {
  const Expression& condition = *statement.value;
  if (statement.else_body == nullptr) {
    const std::optional<int> label = JumpTarget(*statement.body);
    if (label && !HasAssert(*statement.body)) {
      BranchIf(condition, true, *label);
      return;
    }
    const int end = NewLabel("if", statement.keyword, "end");
    BranchIf(condition, false, end);
    LowerInner(*statement.body);
    EmitLabel(end, statement.range);
    return;
  }
  const int otherwise = NewLabel("if", statement.keyword, "else");
  const int end = NewLabel("if", statement.keyword, "end");
  BranchIf(condition, false, otherwise);
  LowerInner(*statement.body);
  EmitGoto(end, statement.range);
  EmitLabel(otherwise, statement.range);
  LowerInner(*statement.else_body);
  EmitLabel(end, statement.range);
}

void Lowerer::LowerReturn(const Statement& statement) {
  LowerReturnOf(statement.value.get(), statement);
}

// Returns a value, which may be nullptr.
void Lowerer::LowerReturnOf(const Expression* value, const Statement& statement) {
  if (value != nullptr && HasTailCall(*value)) {
    const Expression& inner = WithoutParens(*value);
    if (IsTailCall(inner)) {
      LowerTailCall(inner);
      return;
    }
    const int otherwise = NewLabel("cond", inner.range, "else");
    BranchIf(*inner.operands[0], false, otherwise);
    LowerReturnOf(inner.operands[1].get(), statement);
    EmitLabel(otherwise, inner.range);
    LowerReturnOf(inner.operands[2].get(), statement);
    return;
  }
  const BasicType type = frame_->info->type.basic;
  Instruction instruction;
  instruction.kind = Instruction::Kind::kReturn;
  if (value != nullptr) {
    const Expression& expression = *value;
    if (type == BasicType::kVoid) {
      Report(Code::kReturnValue, expression.range, frame_->info->syntax->name);
      return;
    }
    if (frame_->info->type.own != nullptr) {
      StoreStructure(StructureAt(frame_->result.variable, frame_->info->type), expression);
    } else if (frame_->return_label >= 0) {
      AssignInto({frame_->result, frame_->info->type}, expression);
    } else {
      const std::optional<TypedConstant> constant = Evaluate(expression);
      const std::optional<TypedConstant> converted =
          constant ? ConvertConstant(*constant, type) : std::nullopt;
      Value number = converted ? ConstantValue(*converted, expression) : LowerValue(expression);
      if (!RequireNumber(number, expression)) return;
      instruction.a = Convert(number, type, expression.range).operand;
    }
  }
  if (frame_->return_label >= 0) {
    EmitGoto(frame_->return_label, statement.range);
  } else {
    Emit(std::move(instruction), statement.range);
  }
}

void Lowerer::LowerStatement(const Statement& statement) {
  using Kind = Statement::Kind;
  if (stopped_) return;
  const bool loop =
      statement.kind == Kind::kWhile || statement.kind == Kind::kDo || statement.kind == Kind::kFor;
  if (!loop) EmitAsserts(statement);
  switch (statement.kind) {
    case Kind::kExpression:
      BeginFullExpression(statement.value->range);
      if (IsTailCall(WithoutParens(*statement.value))) {
        LowerTailCall(WithoutParens(*statement.value));
      } else {
        LowerEffect(*statement.value);
      }
      return;
    case Kind::kDeclaration:
      LowerDeclaration(statement);
      return;
    case Kind::kBlock:
      OpenBlock(&statement);
      LowerBody(statement.items);
      CloseBlock();
      return;
    case Kind::kIf:
      BeginFullExpression(statement.value->range);
      LowerIf(statement);
      return;
    case Kind::kWhile:
      LowerWhile(statement);
      return;
    case Kind::kDo:
      LowerDo(statement);
      return;
    case Kind::kFor:
      LowerFor(statement);
      return;
    case Kind::kSwitch:
      LowerSwitch(statement);
      return;
    case Kind::kCase:
    case Kind::kDefault: {
      if (frame_->cases.empty()) {
        Report(Code::kCaseLabel, statement.range,
               MakeMessage("it stands outside a 'switch'", "它不在 'switch' 内"));
        return;
      }
      const auto found = frame_->cases.back().find(&statement);
      if (found != frame_->cases.back().end()) EmitLabel(found->second, statement.range);
      return;
    }
    case Kind::kLabel: {
      const auto found = frame_->labels.find(statement.name);
      if (found != frame_->labels.end()) EmitLabel(found->second, statement.range);
      return;
    }
    case Kind::kGoto:
    case Kind::kBreak:
    case Kind::kContinue:
      BeginFullExpression(statement.range);
      LowerLeave(statement);
      return;
    case Kind::kReturn:
      BeginFullExpression(statement.range);
      LowerReturn(statement);
      return;
    case Kind::kFunction:  // a prototype
    case Kind::kMacro:
    case Kind::kStrayBrace:
    case Kind::kEmpty:
    case Kind::kError:
      return;
  }
}

}  // namespace oncard::compiler::lowering
