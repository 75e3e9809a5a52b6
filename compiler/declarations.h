// Declarations of macros, variables and parameters (declarations.cc), and those that C has and the
// card has not, such as `unsigned`, `const` and names that hide others (foreign_declarations.cc).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/check_context.h"
#include "compiler/name_scopes.h"
#include "compiler/operands.h"

namespace oncard::compiler {

class Declarations {
 public:
  /// The type of a declaration.
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
  /// What a new name means for others.
  enum class NameUse : uint8_t { kFree, kHidesAnother, kTaken };

  /// Both must outlive this object.
  Declarations(CheckContext& context, Operands& operands)
      : context_(context), operands_(operands) {}

  void DefineMacro(const Macro& macro);
  /// Checks a declaration and reserves its variables, at the top of a function or anywhere else.
  void CheckDeclaration(const Statement& statement, const Place& place);
  void CheckParameters(const Function& syntax);
  /// Corrects the initial values of a function whose statements have been checked.
  void CorrectInitialValues();
  /// The type that the words before a name mean.
  DeclaredType ResolveType(const Specifiers& specifiers);
  /// Adds the edits for words that are not allowed. True if the variables become macros.
  bool CorrectType(const Specifiers& specifiers, const DeclaredType& type,
                   std::span<const Declarator> declarators, SourceRange declaration);
  /// True if what a function returns means the same with the type that the card has.
  bool KeepsReturns(const Function& function, const DeclaredType& type);
  /// Adds a variable; nullptr if its name is taken.
  Entity* Declare(const Declarator& declarator, const DeclaredType& type, bool parameter);
  /// A variable that the function has already and that can be used again, or nullptr.
  const Entity* Reopen(const Declarator& declarator, const DeclaredType& type);
  /// Reports a name that is in use.
  NameUse ReportTakenName(std::string_view name, SourceRange range, bool local,
                          const Declarator* declarator);

 private:
  // --- declarations.cc ---
  bool CheckArraySizes(const Declarator& declarator, Entity& entity);
  bool ReserveSlots(const Declarator& declarator, Entity& entity);
  void AddSymbols(const Entity& entity);
  void CheckInitialiser(const Declarator& declarator, const Entity* entity,
                        const DeclaredType& type);
  void OpenName(std::string_view name);
  void CheckLateDeclaration(const Statement& statement, const Place& place);

  // --- foreign_declarations.cc ---
  bool CorrectConst(const DeclaredType& type, std::span<const Declarator> declarators,
                    SourceRange declaration, bool* as_macros);
  bool KeepsMeaning(const Specifiers& specifiers, const DeclaredType& type,
                    std::span<const Declarator> declarators);
  const NameScopes& Scopes();
  void CorrectGlobalInitialiser(const Declarator& declarator, Diagnostic& diagnostic,
                                SourceRange value);
  void Rename(const Declarator& declarator, Diagnostic& diagnostic);
  const std::vector<StatementPtr>& ScopeOfNames() const;
  NameUses UsesHere(std::string_view name);

  CheckContext& context_;
  Operands& operands_;
  uint16_t global_slots_ = 0;
  bool too_many_globals_ = false;
  std::optional<NameTable> program_uses_;
  std::optional<NameScopes> scopes_;  // built at the first use
};

}  // namespace oncard::compiler
