// Loops. The condition stands before the body, negated, as one writes it by hand. While a body is
// lowered, the last element of `targets` says where its `break` and its `continue` lead.
#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {

void Lowerer::LowerWhile(const Statement& statement) {
  const int begin = NewLabel("while", statement.keyword);
  const int end = NewLabel("while", statement.keyword, "end");
  BeginFullExpression(statement.value->range);
  EmitLabel(begin, statement.value->range);
  EmitAsserts(statement);
  BranchIf(*statement.value, false, end);
  frame_->targets.push_back({end, begin});
  LowerInner(*statement.body);
  frame_->targets.pop_back();
  BeginFullExpression(statement.value->range);
  EmitGoto(begin, statement.value->range);
  EmitLabel(end, statement.range);
}

void Lowerer::LowerDo(const Statement& statement) {
  const int begin = NewLabel("do", statement.range);
  const int condition = NewLabel("do", statement.range, "while");
  const int end = NewLabel("do", statement.range, "end");
  EmitLabel(begin, statement.range);
  EmitAsserts(statement);
  frame_->targets.push_back({end, condition});
  LowerInner(*statement.body);
  frame_->targets.pop_back();
  EmitLabel(condition, statement.value->range);
  BeginFullExpression(statement.value->range);
  BranchIf(*statement.value, true, begin);
  EmitLabel(end, statement.range);
}

void Lowerer::LowerFor(const Statement& statement) {
  const int begin = NewLabel("for", statement.keyword);
  const int next = NewLabel("for", statement.keyword, "next");
  const int end = NewLabel("for", statement.keyword, "end");
  // The scope of what the head declares.
  OpenBlock(&statement);
  if (statement.initial != nullptr) LowerStatement(*statement.initial);
  SourceRange head = statement.keyword;
  if (statement.value != nullptr) head = statement.value->range;
  BeginFullExpression(head);
  EmitLabel(begin, head);
  EmitAsserts(statement);
  if (statement.value != nullptr) BranchIf(*statement.value, false, end);
  frame_->targets.push_back({end, next});
  LowerInner(*statement.body);
  frame_->targets.pop_back();
  EmitLabel(next, statement.keyword);
  SourceRange last = head;
  if (statement.step != nullptr) {
    last = statement.step->range;
    BeginFullExpression(last);
    LowerEffect(*statement.step);
  }
  EmitGoto(begin, last);
  EmitLabel(end, statement.range);
  CloseBlock();
}

}  // namespace oncard::compiler::lowering
