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

#include "compiler/check_context.h"
#include "compiler/name_scopes.h"

namespace oncard::compiler {

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
          const std::vector<Token>& tokens)
      : context_(options, files, reporter, tokens) {}

  /// Suppresses diagnostics about these names: they were lost in errors that have been reported.
  void AddSkippedNames(const std::unordered_set<std::string_view>& names);
  /// Checks everything. The object is valid only if no error was reported.
  vm::Object Check(const Tree& tree);
  /// The source positions of the statements of the object's functions.
  const std::vector<FunctionPlaces>& places() const { return context_.places; }

 private:
  // What a new name means for others.
  enum class NameUse : uint8_t { kFree, kHidesAnother, kTaken };
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
  NameUses UsesHere(std::string_view name);

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

  // --- expressions.cc ---
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
  static bool IsLeaf(const Expression& expression);

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

  CheckContext context_;
  uint16_t global_slots_ = 0;
  bool too_many_globals_ = false;
  size_t function_count_ = 0;
  std::unordered_set<std::string_view> undeclared_macros_;
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
