// The macros of structured C and their expansion, as C defines it: arguments are expanded once,
// before they replace a parameter, `#` makes text and `##` one word, the result is read again, and
// a macro is not expanded inside itself. Tested by tests/compiler/preprocessor_test.cc.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <span>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "compiler/reporter.h"
#include "compiler/syntax.h"
#include "gtcalls/catalogue.h"

namespace oncard::compiler {

struct MacroDefinition {
  std::string_view name;
  SourceRange name_range;
  bool has_parameters = false;  ///< also with none in its parentheses
  std::vector<std::string_view> parameters;
  bool is_variadic = false;       ///< the last parameter takes all further arguments
  std::vector<Token> body;        ///< `##` is one token
  std::vector<int> parameter_of;  ///< for each token of the body: the parameter it names, or -1
};

/// Whether a token of a body is `##`.
bool IsJoining(const Token& token);

/// Which macros a text uses, and where.
class MacroUses {
 public:
  struct Macro {
    std::string_view name;
    SourceRange name_range;  ///< in its #define
  };

  /// The macro whose use has this range, or nullptr; of several, the outermost one.
  const Macro* Find(SourceRange range) const;
  void Add(SourceRange range, const MacroDefinition& macro);

 private:
  std::map<std::pair<int, uint64_t>, Macro> macros_;  // by file, and by begin and end
};

class MacroExpander {
 public:
  /// The references must outlive this object, and the text of all tokens what is expanded. `made`
  /// gets the texts that macros make, to which tokens may point.
  MacroExpander(const gtcalls::Catalogue& catalogue, Reporter& reporter,
                std::deque<SourceFile>& made)
      : catalogue_(catalogue), reporter_(reporter), made_(made) {}

  /// The macro of a name, or nullptr.
  const MacroDefinition* Find(std::string_view name) const;
  void Define(MacroDefinition definition);
  void Undefine(std::string_view name) { macros_.erase(name); }

  /// Appends the tokens of a text to `out`, with macros expanded. Tokens from the body of a macro
  /// get the range of its use. False if it took more than kTokenMax tokens to expand the texts so
  /// far: those of the texts, and what macros were replaced by.
  bool Expand(std::span<const Token> text, std::vector<Token>* out);

  MacroUses& uses() { return uses_; }

 private:
  struct Piece {
    Token token;
    bool final = false;  ///< the name of a macro that is not expanded any more
  };
  using Pieces = std::span<const Piece>;
  // Tokens that are read next, of the macro that they come from.
  struct Source {
    std::vector<Piece> own;  // what `pieces` are, unless they are in another source
    Pieces pieces;
    size_t next = 0;
    const MacroDefinition* macro = nullptr;
  };
  // Arguments stand in a source, unless they are in several.
  struct Arguments {
    std::vector<Pieces> pieces;
    std::deque<std::vector<Piece>> own;
  };
  struct Expansion {
    std::vector<Source> sources;  // the innermost is the last
    int depth = 0;
  };

  void Run(Expansion& expansion, std::vector<Piece>* out);
  const Piece* Peek(Expansion& expansion);
  void Enter(Expansion& expansion, const MacroDefinition& macro, std::vector<Piece> body);
  bool ReadArguments(Expansion& expansion, const MacroDefinition& macro, SourceRange* use,
                     Arguments* arguments);
  static bool FindArguments(const MacroDefinition& macro, Source& source, SourceRange* use,
                            Arguments* arguments);
  bool CollectArguments(const MacroDefinition& macro, Expansion& expansion, SourceRange* use,
                        Arguments* arguments);
  bool Substitute(const Expansion& expansion, const MacroDefinition& macro,
                  const Arguments& arguments, SourceRange use, std::vector<Piece>* body);
  Piece MakeText(Pieces argument, SourceRange range);
  Piece Join(const MacroDefinition& macro, const Piece& left, const Piece& right);
  static Piece Invalid(SourceRange range);
  bool Count(size_t tokens);

  const gtcalls::Catalogue& catalogue_;
  Reporter& reporter_;
  std::deque<SourceFile>& made_;
  std::deque<MacroDefinition> definitions_;
  std::unordered_map<std::string_view, const MacroDefinition*> macros_;
  std::unordered_set<const MacroDefinition*> open_;  // those whose bodies are being read
  MacroUses uses_;
  size_t count_ = 0;  // tokens that were copied
};

}  // namespace oncard::compiler
