// Makes the edits that replace unsupported C constructs by statements of the language, as shown in
// GTS manual 10.4.3. lowering/fragment.h translates them; what is done here is text: what is
// replaced by which lines, where temporaries are declared, how lines are indented, and that
// comments are kept. Bodies of loops and branches are not changed, so that their comments are kept
// and their own diagnostics can be corrected separately. One object serves one diagnostic, to which
// it adds the edits. Tested by tests/compiler/rewriter_test.cc.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/check_context.h"
#include "compiler/lowering/fragment.h"

namespace oncard::compiler {

class Rewriter {
 public:
  Rewriter(CheckContext& context, Diagnostic& diagnostic)
      : context_(context), diagnostic_(diagnostic) {}

  /// Puts statements that give variables their initial values before the first statement of the
  /// function. False if there are none for one of the values.
  bool InitialiseFirst(const std::vector<const Declarator*>& declarators);
  /// Puts them in place of a declaration.
  void ReplaceDeclaration(const Statement& statement,
                          const std::vector<const Declarator*>& declarators, const Place& place);
  /// Replaces an expression, a `return`, a branch, a loop or a `switch`, but not its bodies. Does
  /// nothing if it has no equivalent.
  void Rewrite(const Statement& statement, const Place& place);
  /// Removes the braces of a block.
  void RewriteBlock(const Statement& statement);
  /// Adds a declaration at the top of the function.
  void AddDeclaration(std::string text) { declarations_.push_back(std::move(text)); }
  /// Declares a variable for a GT command's output and returns its name.
  std::string OutputVariable(std::string_view base, vm::DataType type);
  /// Adds the edits that declare the variables.
  void Finish();

 private:
  enum class Comments : uint8_t { kFirst, kLast };
  using Lines = std::vector<std::string>;

  lowering::FragmentContext Around() const;
  bool DropResults(const Statement& statement);
  bool DropResult(const Expression& target);
  void Declare(lowering::Fragment& fragment);
  std::optional<lowering::Fragment> Initialise(const std::vector<const Declarator*>& declarators);
  void ReplaceWhole(SourceRange range, Lines lines, const Place& place);
  void ReplaceAround(const Statement& statement, lowering::Fragment fragment, const Place& place);
  void KeepComments(SourceRange range, Comments where, Lines* lines) const;
  void Substitute(SourceRange range, const Lines& lines, const std::string& separator,
                  std::string_view before, std::string_view after);
  bool CanOpen(const Statement* body) const;
  bool HasBothBraces(const Statement& block) const;
  std::string_view Source(SourceRange range) const { return context_.Source(range); }
  std::string Separator(SourceRange range) const;

  CheckContext& context_;
  Diagnostic& diagnostic_;
  std::vector<std::string> declarations_;
  std::vector<FixIt> edits_;
};

}  // namespace oncard::compiler
