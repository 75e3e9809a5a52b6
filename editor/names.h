// What the names of a program mean: functions, variables, labels, macros, constants, and commands
// of the catalogue, with every place that uses them. It follows C's scope rules on the tokens, so
// that a mistake in one statement does not hide the names of others, and it does not expand macros:
// a name in the body of a macro means what it means where the macro is used. Tested by
// tests/editor/names_test.cc.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "editor/program_text.h"
#include "gtcalls/catalogue.h"

namespace oncard::editor {

struct Symbol {
  enum class Kind : uint8_t {
    kFunction,
    kGlobal,
    kLocal,
    kParameter,
    kLabel,
    kMacro,
    kMacroParameter,
    kConstant,     ///< of an enum
    kEnumeration,  ///< the name of an enum
    kStructure,    ///< the name of a struct
    kType,         ///< of a typedef
    kCommand,
    kMember  ///< of a structure of the program
  };
  struct Declaration {
    compiler::SourceRange name;
    compiler::SourceRange whole;  ///< with its type and value, or its body
    size_t order = 0;             ///< the index in ProgramText::code()
    bool definition = true;       ///< false: a prototype, or `extern`
  };
  Kind kind = Kind::kGlobal;
  std::string_view name;
  int scope = 0;                          ///< index into Names::scopes()
  std::vector<Declaration> declarations;  ///< in the order of the program; none of a command
  /// Of a variable, function or parameter: the words of its type, and what follows its name in the
  /// declaration, such as `[3]`.
  std::string_view type;
  std::string_view suffix;
  bool pointer = false;
  bool is_const = false;
  /// The value of a variable or constant; the text after a macro's name and parameters.
  std::vector<compiler::Token> value;
  /// Of a function or macro; indices into Names::symbols(). A macro without parentheses has none
  /// and `has_parameters` is false.
  std::vector<int> parameters;
  bool has_parameters = false;
  bool called = false;
  const gtcalls::Structure* structure = nullptr;  ///< the type of a variable
  /// The scope of the members of the structure that it is or has: a variable, a member, a function,
  /// the name of a type; -1 for others.
  int members = -1;
  const gtcalls::Command* command = nullptr;
  int function = -1;  ///< the function that contains it, or -1
};

struct Reference {
  enum class Access : uint8_t {
    kRead,
    kWrite,
    kReadWrite,
    kCall,
    kDeclaration  ///< with a value, it is written as well
  };
  compiler::SourceRange range;
  int symbol = -1;
  Access access = Access::kRead;
};

/// The text in which the names of a scope are known. Scope 0 is the program; that of the members of
/// a structure has no text.
struct Scope {
  int parent = -1;
  int function = -1;  ///< symbol
  size_t begin = 0;   ///< tokens of ProgramText::code(): from here
  size_t end = 0;     ///< to before here
  bool of_function = false;
};

class Names {
 public:
  /// `text` must outlive this object.
  explicit Names(const ProgramText& text);

  const std::deque<Symbol>& symbols() const { return symbols_; }
  const Symbol& symbol(int index) const { return symbols_[static_cast<size_t>(index)]; }
  const std::vector<Scope>& scopes() const { return scopes_; }
  /// By file, then by place. A name in a macro that means different things where the macro is used
  /// is there once for each.
  const std::vector<Reference>& references() const { return references_; }
  /// The reference that touches an offset of a file, the first of several; or nullptr.
  const Reference* At(int file, uint32_t offset) const;
  /// All references with the range of this one.
  std::span<const Reference> Meanings(const Reference& reference) const;

  /// The innermost scope around the token with this index of ProgramText::code().
  int ScopeAt(size_t order) const;
  /// The innermost symbol other than a label that a name refers to at a place, -1 if there is none.
  int Find(std::string_view name, int scope, size_t order) const;
  /// The structure that `struct name` refers to at a place, -1 if there is none.
  int FindStructure(std::string_view name, int scope, size_t order) const;
  /// A member of a structure, by the scope of its members, or -1.
  int FindMember(std::string_view name, int members) const;
  /// The label of the function around a scope, or -1.
  int FindLabel(std::string_view name, int scope) const;
  /// All symbols that can be used at a place, without labels and commands; each name once.
  std::vector<int> VisibleAt(size_t order) const;

 private:
  friend class NameScanner;

  // The present meaning of a name as a macro begins or ends here.
  struct MacroEvent {
    size_t order = 0;
    bool defined = false;
  };

  int FindMacro(std::string_view name, size_t order) const;
  int FunctionScope(int scope) const;

  std::deque<Symbol> symbols_;
  std::vector<Scope> scopes_;
  std::vector<Reference> references_;
  using Key = std::pair<int, std::string_view>;  // scope and name
  std::map<Key, int> by_name_;
  std::map<Key, int> labels_;
  std::map<Key, int> structures_;
  std::map<std::string_view, int> macros_;
  std::map<std::string_view, std::vector<MacroEvent>> macro_events_;
};

}  // namespace oncard::editor
