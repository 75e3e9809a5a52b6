// Semantic analysis: checks the tree against the rules of the language and translates it, each
// simple statement to one instruction. Declarations are in declarations.cc, statements in
// statements.cc, operands and operations in expressions.cc, GT commands in calls.cc. Constructs of
// C that the language does not have are reported together with edits that rewrite them
// (rewriter.h).
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "compiler/compiler.h"
#include "compiler/constant_folding.h"
#include "compiler/flow_warnings.h"
#include "compiler/name_scopes.h"
#include "compiler/reporter.h"
#include "compiler/symbols.h"
#include "compiler/syntax.h"
#include "compiler/tree_walk.h"

namespace oncard::compiler {

/// The context of a statement that matters for rewriting it.
struct Place {
  /// The statement is the body of an `if` or a loop without braces, so that several statements need
  /// braces.
  bool single = false;
  /// A statement follows it, so that a label may end its rewriting.
  bool followed = true;
  /// Inside a loop or switch, which handles `break` and `continue`.
  bool in_loop = false;
  bool in_switch = false;
  /// At the top level of a function's body.
  bool top = true;
};

/// A value that a statement can use directly.
struct TypedOperand {
  vm::Operand operand;
  vm::DataType type = vm::DataType::kInt;
  /// Set for a literal or macro, which becomes a double beside a double operand.
  std::optional<Literal> literal;
  SourceRange range;
};

/// The right-hand side of an assignment that one instruction can compute.
struct Operation {
  vm::Opcode opcode = vm::Opcode::kUnary;
  uint16_t op = static_cast<uint16_t>(vm::UnaryOperator::kCopy);
  std::vector<TypedOperand> operands;
  vm::DataType type = vm::DataType::kInt;    ///< of the operands
  vm::DataType result = vm::DataType::kInt;  ///< of the value
};

class Checker {
 public:
  /// The files and the tree must outlive the checker.
  Checker(const Options& options, const std::deque<SourceFile>& files, Reporter& reporter,
          const std::vector<Token>& tokens);

  /// Suppresses diagnostics about these names: they were lost in errors that have been reported.
  void AddSkippedNames(const std::unordered_set<std::string_view>& names);
  /// Checks everything. The object is valid only if no error was reported.
  vm::Object Check(const Tree& tree);
  /// The source positions of the statements of the object's functions.
  const std::vector<FunctionPlaces>& places() const { return places_; }

 private:
  friend class Rewriter;

  struct Label {
    SourceRange range;
    int instruction = 0;
    bool defined = true;
  };
  struct Jump {
    size_t instruction;
    std::string_view label;
    SourceRange range;
  };
  struct Goto {
    std::string_view label;
    SourceRange range;
  };
  // A block of C, or a `for` with its counters. Names declared in it end with it.
  struct Block {
    const Statement* statement = nullptr;  ///< nullptr: the body of the function
    struct Name {
      std::string_view name;
      std::optional<size_t> outer;  ///< the block that declares it too
    };
    std::vector<Name> names;
  };
  // What a new name means for others.
  enum class NameUse : uint8_t { kFree, kHidesAnother, kTaken };
  // For the variables at the top of a function.
  struct InitialValues {
    std::vector<const Declarator*> list;
    bool good = true;
    Diagnostic* bearer = nullptr;  // of the edits
  };
  // The function being translated.
  struct FunctionState {
    const Function* syntax = nullptr;
    vm::Function out;
    FunctionPlaces places;
    bool is_void = false;
    Scope locals;
    uint16_t slots = 0;
    std::unordered_map<std::string_view, Label> labels;
    std::vector<std::string_view> label_names;
    std::vector<Jump> jumps;
    std::unordered_set<std::string_view> undeclared;
    /// Where the rewriting of a statement may add declarations and first statements.
    SourceRange declarations_end;
    SourceRange statements_begin;
    bool statements_begun = false;
    std::vector<Block> blocks;                                // those that are open
    std::unordered_map<std::string_view, size_t> open_names;  // and the block that declares each
    std::vector<Goto> gotos;
    std::unordered_map<std::string_view, int> declarations;  // how often a name is declared
    std::optional<NameTable> uses;                           // built at the first use
    InitialValues initial_values;
    bool too_long = false;
    bool too_many_slots = false;
    bool too_many_labels = false;
  };
  // A construct to be rewritten, found while a statement was checked.
  struct Lesson {
    Code code;
    SourceRange range;
    std::vector<Message> arguments;
  };

  // --- declarations.cc ---
  void CheckFunction(const Function& syntax);
  void CheckParameters(const Function& syntax);
  void CheckDeclaration(const Statement& statement, const Place& place);
  void DefineMacro(const Macro& macro);
  struct DeclaredType {
    bool valid = false;
    bool is_void = false;
    vm::DataType type = vm::DataType::kInt;
    const gtcalls::Structure* structure = nullptr;
    bool is_const = false;
    bool is_static = false;  ///< `static` or `extern`
    bool is_parameter = false;
    /// Set if the words are not allowed here: the reported diagnostic, for edits to be added.
    Diagnostic* report = nullptr;
    std::string_view words;  ///< as written
    std::string plain;       ///< the words to write instead
  };
  DeclaredType ResolveType(const Specifiers& specifiers);
  Entity* Declare(const Declarator& declarator, const DeclaredType& type, bool parameter);
  bool CheckArraySizes(const Declarator& declarator, Entity& entity);
  bool ReserveSlots(const Declarator& declarator, Entity& entity);
  void AddSymbols(const Entity& entity);
  NameUse ReportTakenName(std::string_view name, SourceRange range, bool local,
                          const Declarator* declarator);
  void CheckInitialiser(const Declarator& declarator, const Entity* entity,
                        const DeclaredType& type);
  void CorrectInitialValues();
  void OpenName(std::string_view name);
  const Entity* Reopen(const Declarator& declarator, const DeclaredType& type);
  void CheckLateDeclaration(const Statement& statement, const Place& place);

  // --- foreign_declarations.cc ---
  bool CorrectType(const Specifiers& specifiers, const DeclaredType& type,
                   std::span<const Declarator> declarators, SourceRange declaration);
  bool CorrectConst(const DeclaredType& type, std::span<const Declarator> declarators,
                    SourceRange declaration, bool* as_macros);
  bool KeepsMeaning(const Specifiers& specifiers, const DeclaredType& type,
                    std::span<const Declarator> declarators);
  bool KeepsReturns(const Function& function, const DeclaredType& type);
  const NameScopes& Scopes();
  void CorrectGlobalInitialiser(const Declarator& declarator, Diagnostic& diagnostic,
                                SourceRange value);
  void Rename(const Declarator& declarator, Diagnostic& diagnostic);
  const std::vector<StatementPtr>& ScopeOfNames() const;
  NameUses UsesInFunction(std::string_view name);
  NameUses UsesHere(std::string_view name);
  std::optional<Constant> FoldHere(const Expression& expression) const;

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
  const Goto* JumpInto(const Statement& loop) const;
  bool NeedsBraces(const Statement& block) const;
  void CheckCases(const Statement& statement);
  void CheckSwitch(const Statement& statement, const Place& place);
  void CheckReturn(const Statement& statement, vm::Operand condition);
  void CheckGoto(const Statement& statement, vm::Operand condition);
  void CheckLabel(const Statement& statement, bool has_statement);
  void CheckCondition(const Expression& condition, vm::Operand* operand);
  void ResolveJumps();
  void Emit(vm::Instruction instruction);

  // Diagnostics of statements: each statement is examined for all mistakes, and reports at most
  // one.
  void BeginStatement(const Statement& statement);
  void EndStatement(const Statement& statement, const Place& place);
  template <typename... Args>
  void Teach(Code code, SourceRange range, const Args&... args) {
    // A nested expression is reported only if there is nothing more specific to report.
    if (!lesson_ || lesson_->code == Code::kNestedExpression) {
      if (lesson_ && code == Code::kNestedExpression) return;
      lesson_ = Lesson{code, range, {ToMessage(args)...}};
    }
  }
  /// Reports an error that no rewriting can correct.
  template <typename... Args>
  Diagnostic& Fail(Code code, SourceRange range, const Args&... args) {
    failed_ = true;
    return reporter_.Report(code, range, args...);
  }

  // --- expressions.cc ---
  const Entity* Lookup(std::string_view name) const;
  const Entity* ResolveName(const Expression& expression);
  std::optional<TypedOperand> ResolveOperand(const Expression& expression);
  std::optional<TypedOperand> ResolveIndex(const Expression& expression);
  void ResolveManyIndices(const Expression& expression);
  void LeaveArray(std::string_view name);
  bool CheckBounds(const Entity& array, int64_t size, const Expression& index);
  void CheckWritable(const Expression& target);
  std::optional<TypedOperand> ResolveMember(const Expression& expression);
  std::optional<TypedOperand> ResolveTarget(const Expression& expression);
  std::optional<Operation> ResolveOperation(const Expression& expression);
  std::optional<Operation> ResolveBinary(const Expression& expression);
  /// The operand of an operation that has no other; it must not be an operation itself.
  std::optional<TypedOperand> ResolveOnlyOperand(const Expression& operand,
                                                 const Expression& operation);
  std::optional<Operation> ResolveUnary(const Expression& expression);
  std::optional<Operation> ResolveCast(const Expression& expression);
  std::optional<Operation> ResolveMagnitude(const Expression& expression);
  void CheckNames(const Expression& expression);
  void TeachNested(const Expression& expression);
  /// Converts a literal to the type of the other operand.
  bool Adapt(TypedOperand& operand, vm::DataType type);
  std::optional<TypedOperand> LiteralOperand(const Literal& literal, SourceRange range);
  void ReportUndeclared(const Expression& expression);
  /// Limit of searches for similar names, because they take time.
  bool MaySuggest() { return suggestions_++ < kSuggestionMax; }
  static bool IsLeaf(const Expression& expression);
  std::optional<Literal> ConstantOf(const Expression& expression) const;

  // --- calls.cc ---
  void CheckCall(const Expression& call);
  void CheckCommand(const Expression& call, const gtcalls::Command& command);
  void ReportMissingArguments(const Expression& call, const gtcalls::Command& command);
  bool CheckInput(const Expression& argument, const gtcalls::Command& command, size_t index,
                  vm::Instruction& instruction);
  bool CheckAddress(const Expression& argument, const Expression& call,
                    const gtcalls::Command& command, size_t index, vm::Instruction& instruction);
  void ReportFraction(const Expression& argument, const Literal& literal,
                      std::string_view parameter);
  void ReportUnknownCall(const Expression& callee);

  std::string_view Source(SourceRange range) const;
  int LineOf(SourceRange range) const;

  const Options& options_;
  const gtcalls::Catalogue& catalogue_;
  const std::deque<SourceFile>& files_;
  Reporter& reporter_;
  vm::Object object_;
  std::vector<FunctionPlaces> places_;
  Scope globals_;  // with macros and functions
  uint16_t global_slots_ = 0;
  bool too_many_globals_ = false;
  size_t function_count_ = 0;
  std::unordered_map<std::string_view, SourceRange> function_names_;  // of the whole program
  std::unordered_set<std::string_view> skipped_names_;
  std::unordered_set<std::string_view> undeclared_macros_;
  static constexpr int kSuggestionMax = 100;
  int suggestions_ = 0;
  FreshNames fresh_;
  SourceRange first_item_;  // where #define lines can go
  FunctionState* function_ = nullptr;
  const Tree* tree_ = nullptr;

  // Of the statement being checked.
  std::optional<Lesson> lesson_;
  bool failed_ = false;
  bool broken_ = false;  // part of it is missing from the tree: no advice
  uint16_t line_ = 0;
  SourceRange statement_range_;
  bool uses_flat_array_ = false;  // a multi-dimensional array, whose declaration corrects its uses
  struct FlatArray {
    Diagnostic* report = nullptr;  ///< of the declaration, with the edits of all uses
    bool good = true;              ///< no incorrect use
  };
  std::unordered_map<std::string_view, FlatArray> flat_arrays_;
  std::unordered_set<const Expression*> flattened_;
  std::optional<NameTable> program_uses_;
  std::optional<NameScopes> scopes_;  // built at the first use
};

/// How messages name things.
Message DescribeType(vm::DataType type);
/// The smallest or the largest value.
Message DescribeRange(vm::DataType type, vm::DoubleFormat format, bool upper);
Message DescribeEntity(const Entity& entity);
/// Advice for a value of the other type.
Message ConvertAdvice();

}  // namespace oncard::compiler
