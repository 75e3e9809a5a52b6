// Finds the declarations and uses of names in the tokens of a program, for names.h. One pass over
// the tokens collects declarations, scopes and uses; then the uses are resolved, those in the
// bodies of macros last.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "editor/names.h"

namespace oncard::editor {

class NameScanner {
 public:
  NameScanner(const ProgramText& text, Names& names);
  void Run();

 private:
  using Token = compiler::Token;
  using Declared = Symbol::Declaration;

  // A name that is used.
  struct Use {
    size_t order = 0;
    int scope = 0;
    enum class Kind : uint8_t { kPlain, kLabel, kMember };
    Kind kind = Kind::kPlain;
    Reference::Access access = Reference::Access::kRead;
  };
  // A parenthesis that is open, with the command before it.
  struct Call {
    const gtcalls::Command* command = nullptr;
    size_t argument = 0;
  };
  // The words before a declared name.
  struct Type {
    std::string_view text;
    const gtcalls::Structure* structure = nullptr;
    int members = -1;
    bool is_const = false;
    bool external = false;
    bool is_typedef = false;
    size_t begin = 0;
  };
  struct Open {
    int scope = 0;
    size_t end = 0;     // the scope ends here; 0: at its brace
    bool body = false;  // its `}` ends a function
  };

  int KindAt(size_t at) const;
  bool BeginsType(size_t at) const;
  void MatchBrackets();
  size_t StatementEnd(size_t at, int depth) const;
  bool BeginsDeclaration() const;
  bool BeginsStatement() const;

  void ScanDirectives();
  void Define(const Directive& directive);
  void ScanToken();
  void ScanName();
  void ScanDeclaration();
  Type ScanType();
  void ScanEnumeration(size_t last);
  void ScanStructureName(Type* type, size_t* last);
  int ScanMembers(size_t last);
  int ScanMembersUpTo(size_t close, size_t last);
  void ScanMember(const Type& type, int members);
  bool ScanDeclarator(const Type& type, bool first);
  void ScanDimensions();
  void ScanInitialiser(std::vector<Token>* value);
  void ScanFunction(const Type& type, bool pointer, size_t name);
  void ScanParameters(int function, size_t close);
  Reference::Access AccessOf(std::span<const Token> tokens, size_t at, const Call* call) const;
  size_t SkipPlace(std::span<const Token> tokens, size_t at) const;

  int OpenScope(size_t end, bool of_function, int function);
  void CloseScope(size_t end);
  void CloseFinishedScopes();
  int Declare(Symbol::Kind kind, const Token& name, int scope, Declared declared);
  void AddReference(const Token& token, int symbol, Reference::Access access);
  compiler::SourceRange RangeOf(size_t begin, size_t end) const;

  void ResolveUses();
  int MembersBefore(size_t dot) const;
  void ResolveBodies();
  void ResolveBody(int macro);
  void ResolveConditions();
  int CommandOf(std::string_view name);

  const ProgramText& text_;
  Names& names_;
  const std::vector<Token>& code_;
  std::vector<size_t> match_;      // of a bracket, its partner, or the number of tokens
  std::vector<size_t> semicolon_;  // the next `;` or `}`
  std::vector<size_t> stop_;       // the next `;`, `{` or `}`
  size_t at_ = 0;
  int structures_ = 0;  // those that at_ is in
  std::vector<Open> open_;
  std::vector<Call> calls_;
  std::vector<Use> uses_;
  std::map<size_t, int> meanings_;  // symbols of uses by the index of the token
  std::map<std::string_view, int> commands_;
  // For each macro the scopes in which it is used, with one place in each.
  std::map<int, std::map<int, size_t>> places_;
};

}  // namespace oncard::editor
