// The environment of the generated parser: the tokens, the tree under construction, and the
// diagnosis of syntax errors.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "compiler/dialect.h"
#include "compiler/parser.hh"
#include "compiler/reporter.h"
#include "compiler/syntax.h"

namespace oncard::compiler {

class ParserDriver {
 public:
  /// `tokens` end with an end token and must outlive the tree.
  ParserDriver(std::span<const Token> tokens, Reporter& reporter, Dialect dialect = Dialect::kCard)
      : tokens_(tokens), reporter_(reporter), dialect_(dialect) {}

  Tree tree;

  /// Names inside statements that were skipped: they may have been declarations or labels, so there
  /// are no further diagnostics about them.
  const std::unordered_set<std::string_view>& skipped_names() const { return skipped_names_; }

  // --- For the parser --------------------------------------------------------------------------

  /// Returns the next token. At the end of the file, closes the braces that are still open.
  int Next(Parser::semantic_type* value, SourceRange* location);
  /// Reports a syntax error at the last token from Next().
  void SyntaxError(std::span<const Parser::symbol_kind_type> expected);
  /// Skips the rest of a statement that has a syntax error. Returns false if the last token can
  /// belong to the next statement.
  bool SkipStatement();
  /// Inserts the missing `{` of a function's body. Returns true if the last token was the end of
  /// the file, which now follows a `}`.
  bool OpenMissingBrace();
  /// After a function's head of the old style, `int f(a) int a; {`: reports it, skips the types of
  /// the parameters and the brace, and returns true if there is one.
  bool OpenOldStyle();
  /// True if recovery does not get past a token; the rest of the file is then skipped.
  bool Stalled() const { return errors_here_ > kErrorsHereMax; }

  /// Makes a prototype of a function, with others of its type: `int f(int a), g(int a);`. The
  /// card's language has one function in a declaration.
  void AddPrototypes(Function& first, std::vector<std::unique_ptr<Function>> others);

  // --- Building blocks of the tree that need the reporter -------------------------------------

  /// Replaces a tree that is too deep or too high by an error node.
  ExpressionPtr LimitDepth(ExpressionPtr expression);
  StatementPtr LimitDepth(StatementPtr statement);

  ExpressionPtr Binary(Expression::Kind kind, ExpressionPtr left, const Token* op,
                       ExpressionPtr right, SourceRange range);
  ExpressionPtr Unary(Expression::Kind kind, const Token* op, ExpressionPtr operand,
                      SourceRange range);
  ExpressionPtr Conditional(ExpressionPtr condition, const Token* op, ExpressionPtr yes,
                            ExpressionPtr no, SourceRange range);
  ExpressionPtr Cast(TypeNamePtr type, ExpressionPtr operand, SourceRange range);
  ExpressionPtr CompoundLiteral(TypeNamePtr type, ExpressionPtr values, SourceRange range);
  ExpressionPtr SizeOf(ExpressionPtr operand, SourceRange range);
  ExpressionPtr SizeOfType(TypeNamePtr type, SourceRange range);
  ExpressionPtr Index(ExpressionPtr array, ExpressionPtr index, SourceRange range);
  ExpressionPtr Call(ExpressionPtr callee, std::vector<ExpressionPtr> arguments, SourceRange range);
  ExpressionPtr Member(ExpressionPtr structure, const Token* op, const Token* name,
                       SourceRange range);
  ExpressionPtr Paren(ExpressionPtr inner, SourceRange range);
  ExpressionPtr Braces(std::vector<ExpressionPtr> values, SourceRange range);
  /// A value for the place that the designators name: that of `[1][2] = 3` is one for `[1]`, whose
  /// value is one for `[2]`.
  ExpressionPtr Designated(std::vector<ExpressionPtr> designators, ExpressionPtr value);

  /// `value` may be nullptr for an empty statement.
  StatementPtr ExpressionStatement(ExpressionPtr value, SourceRange range);
  /// An expression after which at least the `;` is missing.
  StatementPtr BrokenStatement(ExpressionPtr value, SourceRange range);
  StatementPtr If(SourceRange keyword, ExpressionPtr condition, StatementPtr body,
                  SourceRange else_keyword, StatementPtr else_body, SourceRange range);
  StatementPtr Loop(Statement::Kind kind, SourceRange keyword, ExpressionPtr condition,
                    StatementPtr body, SourceRange range);
  StatementPtr For(SourceRange keyword, StatementPtr initial, ExpressionPtr condition,
                   ExpressionPtr step, StatementPtr body, SourceRange range);
  StatementPtr Return(SourceRange keyword, ExpressionPtr value, SourceRange range);
  std::unique_ptr<StructSpecifier> DefinedStruct(std::unique_ptr<StructSpecifier> structure,
                                                 std::vector<StatementPtr> members);
  StatementPtr FunctionItem(std::unique_ptr<Function> function, SourceRange range);
  StatementPtr Block(std::vector<StatementPtr> items, SourceRange range);
  /// A statement inside another one with the labels before it, as a block without braces.
  StatementPtr Labelled(std::vector<StatementPtr> labels, StatementPtr statement,
                        SourceRange range);

 private:
  bool Fits(const Levels& levels, SourceRange range);
  int KindOf(const Token& token);
  bool BeginsValues() const;
  bool BeginsValue() const;
  bool BeginsMembers() const;
  bool AfterTypeInParens() const;
  bool AfterTag(int keyword) const;
  bool ContinuesAfterBrace(const Token& error, const Token& next) const;
  bool InForHeader() const;
  void RememberNames(size_t begin, size_t end);
  void ReportReservedWord(const Token& token);
  bool ReportUntranslatable(bool operand);
  bool ReportSlip(const std::function<bool(Parser::symbol_kind_type)>& expects);
  const Token* UntypedFunction() const;
  bool IsAfterPointer() const;
  bool AfterUntypedParameters() const;
  void ReportOldStyle(size_t end);

  std::span<const Token> tokens_;
  Reporter& reporter_;
  const Dialect dialect_;
  size_t next_ = 0;
  int questions_ = 0;  // `?` whose `:` is still to come
  static constexpr int kErrorsHereMax = 8;
  // How many tokens back the head of a statement is searched.
  static constexpr size_t kLookBack = 64;
  const Token* error_at_ = nullptr;  // the token of the last syntax error
  int errors_here_ = 0;              // number of errors at this token
  size_t stuck_at_ = 0;              // where SkipStatement() last found nothing to skip
  const Token* last_ = nullptr;      // the last token from Next()
  const Token* previous_ = nullptr;  // the token before that
  Token end_brace_;                  // used for a `}` that is missing at the end
  struct Brace {
    SourceRange place;
    bool initialiser = false;
    bool members = false;  // of a structure
  };
  std::vector<Brace> braces_;  // those that are open
  bool end_reported_ = false;
  bool resume_ = false;
  bool too_deep_reported_ = false;
  std::unordered_set<std::string_view> skipped_names_;
};

/// Whether a word alone names a type.
bool NamesType(int kind);
/// Whether a word can be part of a type.
bool IsTypeWord(int kind);

/// The empty range after a range.
SourceRange EndOf(SourceRange range);
/// The range from the first to the last; only the last if they are in different files.
SourceRange Join(SourceRange first, SourceRange last);

void Append(std::vector<StatementPtr>& items, StatementPtr item);
StatementPtr MakeStatement(Statement::Kind kind, SourceRange range);
StatementPtr MakeNamed(Statement::Kind kind, const Token* name, SourceRange name_range,
                       SourceRange range);
StatementPtr MakeDeclaration(Specifiers specifiers, std::vector<Declarator> declarators,
                             SourceRange range);
/// An enum without its constants; `name` may be nullptr.
std::unique_ptr<Enumeration> MakeEnumeration(const Token* name, SourceRange range);
/// A struct without its members; `name` may be nullptr.
std::unique_ptr<StructSpecifier> MakeStruct(const Token* name, SourceRange range);
/// `last` is nullptr unless the case is a range.
StatementPtr MakeCase(SourceRange keyword, ExpressionPtr value, ExpressionPtr last,
                      SourceRange range);
TypeNamePtr MakeTypeName(Specifiers specifiers, bool pointer, std::vector<ExpressionPtr> sizes,
                         SourceRange range);
/// The parameter `(*name)[4]`, as `name[][4]`; without a size, as `*name`. The name may be absent.
Declarator MakeRows(const Token* name, std::vector<ExpressionPtr> sizes, SourceRange range);
std::vector<ExpressionPtr> PutFirst(ExpressionPtr first, std::vector<ExpressionPtr> others);
ExpressionPtr MakeExpression(Expression::Kind kind, SourceRange range);
ExpressionPtr MakeLiteral(const Token* token, SourceRange range);
/// Designators without a value: `[first]`, or `[first ... last]` unless `last` is nullptr; `.name`.
ExpressionPtr MakeDesignator(ExpressionPtr first, ExpressionPtr last, SourceRange range);
ExpressionPtr MakeDesignator(const Token* name, SourceRange range);
std::unique_ptr<Function> MakeFunction(Specifiers specifiers, bool pointer, const Token* name,
                                       std::vector<ParameterDeclaration> parameters,
                                       SourceRange range);
void CloseFunction(Function& function, SourceRange open_brace, std::vector<StatementPtr> body,
                   SourceRange close_brace);

}  // namespace oncard::compiler
