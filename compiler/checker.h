// Semantic analysis: checks the tree against the rules of the language and translates it, each
// simple statement to one instruction. Functions and statements are checked here (statements.cc),
// their declarations in declarations.h, operands, operations and GT commands in operands.h; what
// these share is in check_context.h. Constructs of C that the language does not have are reported
// together with edits that rewrite them (rewriter.h).
#pragma once

#include <deque>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "compiler/check_context.h"
#include "compiler/declarations.h"
#include "compiler/operands.h"

namespace oncard::compiler {

class Checker {
 public:
  /// The files and the tree must outlive the checker.
  Checker(const Options& options, const std::deque<SourceFile>& files, Reporter& reporter,
          const std::vector<Token>& tokens)
      : context_(options, files, reporter, tokens) {}

  /// Suppresses diagnostics about these names: they were lost in errors that have been reported.
  void AddSkippedNames(const std::unordered_set<std::string_view>& names);
  /// Checks everything. The object is valid only if no error was reported.
  vm::Object Check(const Tree& tree);
  /// The source positions of the statements of the object's functions.
  const std::vector<FunctionPlaces>& places() const { return context_.places; }

 private:
  void CheckFunction(const Function& syntax);

  // --- statements.cc ---
  void CheckItem(const Statement& statement);
  void CheckOutside(const Statement& statement);
  void CheckBody(const std::vector<StatementPtr>& items, const Place& place);
  void CheckStatement(const Statement& statement, const Place& place);
  void CheckExpressionStatement(const Statement& statement);
  void CheckAssignment(const Expression& assignment);
  void CheckIf(const Statement& statement, const Place& place);
  void CheckBlock(const Statement& statement, const Place& place);
  void OpenBlock(const Statement* statement);
  void CloseBlock();
  void CheckLoop(const Statement& statement, const Place& place);
  const FunctionState::Goto* JumpInto(const Statement& loop) const;
  void CheckCases(const Statement& statement);
  void CheckSwitch(const Statement& statement, const Place& place);
  void CheckReturn(const Statement& statement, vm::Operand condition);
  void CheckGoto(const Statement& statement, vm::Operand condition);
  void CheckLabel(const Statement& statement, bool has_statement);
  void CheckCondition(const Expression& condition, vm::Operand* operand);
  void ResolveJumps();

  void BeginStatement(const Statement& statement);
  void EndStatement(const Statement& statement, const Place& place);

  CheckContext context_;
  Operands operands_{context_};
  Declarations declarations_{context_, operands_};
  size_t function_count_ = 0;
};

}  // namespace oncard::compiler
