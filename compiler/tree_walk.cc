#include "compiler/tree_walk.h"

#include <algorithm>

namespace oncard::compiler {
namespace {

bool IsStep(const Expression& expression) { return expression.op == "++" || expression.op == "--"; }

}  // namespace

void ForEachStatement(const Statement& statement, const StatementVisitor& visit) {
  visit(statement);
  for (const Statement* below :
       {statement.initial.get(), statement.body.get(), statement.else_body.get()}) {
    if (below != nullptr) ForEachStatement(*below, visit);
  }
  for (const StatementPtr& item : statement.items) ForEachStatement(*item, visit);
  if (statement.function != nullptr) {
    for (const StatementPtr& item : statement.function->body) ForEachStatement(*item, visit);
  }
}

void ForEachExpression(const Expression& expression, const ExpressionVisitor& visit) {
  visit(expression);
  for (const ExpressionPtr& operand : expression.operands) ForEachExpression(*operand, visit);
  if (expression.type == nullptr) return;
  for (const ExpressionPtr& size : expression.type->sizes) {
    if (size != nullptr) ForEachExpression(*size, visit);
  }
}

void ForEachWholeExpression(const Statement& statement, const ExpressionVisitor& visit) {
  if (statement.specifiers.enumeration != nullptr) {
    for (const Enumerator& constant : statement.specifiers.enumeration->enumerators) {
      if (constant.value != nullptr) visit(*constant.value);
    }
  }
  for (const Declarator& declarator : statement.declarators) {
    for (const ExpressionPtr& size : declarator.sizes) {
      if (size != nullptr) visit(*size);
    }
    if (declarator.initialiser != nullptr) visit(*declarator.initialiser);
  }
  if (statement.value != nullptr) visit(*statement.value);
  if (statement.last != nullptr) visit(*statement.last);
  if (statement.step != nullptr) visit(*statement.step);
}

std::string_view BaseName(const Expression& expression) {
  switch (expression.kind) {
    case Expression::Kind::kName:
      return expression.text;
    case Expression::Kind::kIndex:
    case Expression::Kind::kMember:
    case Expression::Kind::kParen:
      return BaseName(*expression.operands[0]);
    default:
      return {};
  }
}

void NameTable::Add(const std::vector<StatementPtr>& items) {
  for (const StatementPtr& item : items) {
    ForEachStatement(*item, [this](const Statement& statement) {
      ForEachWholeExpression(statement, [this](const Expression& whole) { Read(whole); });
    });
  }
}

NameUses NameTable::Find(std::string_view name) const {
  const auto found = uses_.find(name);
  return found == uses_.end() ? NameUses{} : found->second;
}

void NameTable::Write(const Expression& target) {
  const std::string_view name = BaseName(target);
  if (name.empty()) {
    Read(target);
    return;
  }
  const Expression*& first = uses_[name].first_write;
  if (first == nullptr) first = &target;
  // The indices of an assignment's target are read.
  for (const Expression* level = &target; level->kind != Expression::Kind::kName;
       level = level->operands[0].get()) {
    if (level->kind == Expression::Kind::kIndex) Read(*level->operands[1]);
  }
}

void NameTable::Read(const Expression& expression) {
  switch (expression.kind) {
    case Expression::Kind::kName: {
      const Expression*& first = uses_[expression.text].first_read;
      if (first == nullptr) first = &expression;
      return;
    }
    case Expression::Kind::kAssign:
      Write(*expression.operands[0]);
      Read(*expression.operands[1]);
      return;
    case Expression::Kind::kCompound:
      Write(*expression.operands[0]);
      break;
    case Expression::Kind::kPostfix:
    case Expression::Kind::kUnary:
      if (IsStep(expression) || expression.op == "&") Write(*expression.operands[0]);
      break;
    default:
      break;
  }
  for (const ExpressionPtr& operand : expression.operands) Read(*operand);
}

bool HasEffects(const Expression& expression) {
  const bool changes = expression.kind == Expression::Kind::kAssign ||
                       expression.kind == Expression::Kind::kCompound ||
                       expression.kind == Expression::Kind::kPostfix ||
                       (expression.kind == Expression::Kind::kUnary && IsStep(expression));
  const bool calls = expression.kind == Expression::Kind::kCall &&
                     expression.operands[0]->text != "abs" &&
                     expression.operands[0]->text != "fabs";
  return changes || calls ||
         std::any_of(expression.operands.begin(), expression.operands.end(),
                     [](const ExpressionPtr& operand) { return HasEffects(*operand); });
}

}  // namespace oncard::compiler
