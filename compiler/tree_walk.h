// Searches whole trees: their content, and how they use names. A name is the same variable in a
// whole function, or in the whole program if it is a global. Tested by
// tests/compiler/rewriter_test.cc with the fix-its that use it.
#pragma once

#include <functional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/syntax.h"

namespace oncard::compiler {

using StatementVisitor = std::function<void(const Statement&)>;
using ExpressionVisitor = std::function<void(const Expression&)>;

/// Calls `visit` for a statement and all nested ones, in the order of the text.
void ForEachStatement(const Statement& statement, const StatementVisitor& visit);
/// Calls `visit` for an expression and all nested ones, outer ones first.
void ForEachExpression(const Expression& expression, const ExpressionVisitor& visit);
/// Calls `visit` for every expression that is not part of another one, only in the statement
/// itself, not in nested statements.
void ForEachWholeExpression(const Statement& statement, const ExpressionVisitor& visit);

/// The variable name in `a`, `a[i][j]`, `s.m` and `(a)`; empty if there is none.
std::string_view BaseName(const Expression& expression);

/// How a program uses a variable. Passing its address to a command counts as both.
struct NameUses {
  const Expression* first_read = nullptr;
  const Expression* first_write = nullptr;
};

/// The uses of every name.
class NameTable {
 public:
  void Add(const std::vector<StatementPtr>& items);
  /// All empty for a name that does not occur.
  NameUses Find(std::string_view name) const;

 private:
  void Read(const Expression& expression);
  void Write(const Expression& target);

  std::unordered_map<std::string_view, NameUses> uses_;
};

/// True if evaluating the expression has side effects, so that it matters how often it is
/// evaluated.
bool HasEffects(const Expression& expression);

}  // namespace oncard::compiler
