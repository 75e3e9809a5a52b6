// Rewrites unsupported C constructs as core statements of the language, as edits of the user's own
// text: nested expressions with temporaries, loops and branches with goto, as shown in GTS manual
// 10.4.3. One object serves one diagnostic, to which it adds the edits. Bodies of loops and
// branches are not changed, so that their comments are kept and their own diagnostics can be
// corrected separately. Tested by tests/compiler/rewriter_test.cc.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/checker.h"

namespace oncard::compiler {

class Rewriter {
 public:
  Rewriter(Checker& checker, Diagnostic& diagnostic) : checker_(checker), diagnostic_(diagnostic) {}

  /// False if something cannot be rewritten; then nothing may be added.
  bool ok() const { return ok_; }

  /// Collects the statements that give a declared variable its initial value.
  void Initialise(const Declarator& declarator, const Entity& entity);
  /// Puts the collected statements before the first statement of the function.
  void InsertAtFirstStatement();
  /// Puts the collected statements in place of a statement.
  void ReplaceStatement(SourceRange range, const Place& place);
  /// Adds a declaration at the top of the function.
  void AddDeclaration(std::string text);

  /// Rewrites one expression statement, `goto`, `return`, or `if` followed by one of these.
  void RewriteSimple(const Statement& statement, const Place& place);
  void RewriteIf(const Statement& statement, const Place& place);
  void RewriteLoop(const Statement& statement, const Place& place);
  void RewriteSwitch(const Statement& statement, const Place& place);
  void RewriteBlock(const Statement& statement);
  /// Declares a variable for a GT command's output and returns its name.
  std::string OutputVariable(std::string_view base, vm::DataType type);
  /// Adds the edits that declare the temporaries.
  void Finish();

 private:
  /// Cancels the rewriting with a reason and advice. Only the first reason is reported.
  void Refuse(Message reason);
  void Refuse(SourceRange place, Message reason);

  /// An expression in core form: `text` is an operand when `leaf`, otherwise one operation.
  struct Value {
    std::string text;
    vm::DataType type = vm::DataType::kInt;
    bool leaf = true;
    bool literal = false;
    bool variable = false;  ///< a plain variable, usable as an index or a condition
  };
  struct Condition {
    bool constant = false;
    bool truth = false;
    std::string variable;
  };
  struct Jumps {
    bool breaks = false;
    bool continues = false;
  };

  Value Fail();
  Value Leaf(const Expression& expression);
  Value LeafIndex(const Expression& expression);
  std::string IndexText(const Expression& expression);
  Value Lower(const Expression& expression);
  Value LowerUnary(const Expression& expression);
  Value LowerBinary(Value left, std::string_view op, Value right);
  Value LowerLogical(const Expression& expression);
  bool IsSafe(const Expression& expression) const;
  bool IsPlainOperand(const Expression& expression) const;
  vm::DataType TypeOf(const Expression& expression) const;
  Value LowerConditional(const Expression& expression);
  Value LowerCall(const Expression& expression);
  Value LowerAssignment(const Expression& expression);
  Value LowerStep(const Expression& expression, bool value_used);
  void LowerEffect(const Expression& expression);
  void LowerCommand(const Expression& call);
  void DropResult(const Expression& target);
  void InitialiseArray(const std::vector<ExpressionPtr>& values, const Entity& array);
  Value Target(const Expression& expression);
  Value Operand(Value value);
  Value Converted(Value value, vm::DataType type);
  void Assign(const Value& target, Value value);
  Condition LowerCondition(const Expression& expression, bool negate);
  void JumpIf(const Expression& condition, bool negate, const std::string& label);
  std::string Temporary(std::string_view base, vm::DataType type);
  std::string ConditionVariable();
  std::string Label(std::string_view base);
  void Emit(std::string line) { lines_.push_back(std::move(line)); }
  void EmitLabel(const std::string& label) { lines_.push_back(label + ":"); }
  void EmitEndLabel(const std::string& label, const Place& place);

  enum class Comments : uint8_t { kFirst, kLast };
  void KeepComments(SourceRange range, Comments where);
  void Substitute(SourceRange range, const Statement& near, std::string_view before,
                  std::string_view after);
  void SubstituteHead(const Statement& statement, const Statement& body, std::string_view before,
                      std::string_view after);
  void SubstituteTail(const Statement& body, const Statement& statement, std::string_view before,
                      std::string_view after);
  Jumps ReplaceJumps(const Statement& body, const std::string& break_label,
                     const std::string& continue_label);
  void FindJumps(const Statement& statement, const std::string& break_label,
                 const std::string& continue_label, Jumps* jumps);
  SourceRange Head(SourceRange first, const Statement& body);
  SourceRange Tail(const Statement& body, SourceRange last);
  bool HasBothBraces(const Statement& block) const;
  std::string_view Source(SourceRange range) const { return checker_.Source(range); }
  std::string Separator(SourceRange range) const;

  Checker& checker_;
  Diagnostic& diagnostic_;
  bool ok_ = true;
  std::vector<std::string> lines_;
  std::vector<std::string> declarations_;
  std::vector<FixIt> edits_;
  std::string condition_variable_;
};

}  // namespace oncard::compiler
