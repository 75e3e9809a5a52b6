// What the parts of the checker share: the program that is translated, the function and the
// statement that they are in, and what names mean there.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "compiler/compiler.h"
#include "compiler/constant_folding.h"
#include "compiler/flow_warnings.h"
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

/// The function that is translated.
struct FunctionState {
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
  // For the variables at the top of a function.
  struct InitialValues {
    std::vector<const Declarator*> list;
    bool good = true;
    Diagnostic* bearer = nullptr;  // of the edits
  };

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

/// A construct to be rewritten, found while a statement was checked.
struct Lesson {
  Code code;
  SourceRange range;
  std::vector<Message> arguments;
};

/// The statement that is checked. It is examined for all mistakes, and reports at most one.
struct StatementState {
  std::optional<Lesson> lesson;
  bool failed = false;
  bool broken = false;  ///< part of it is missing from the tree: no advice
  uint16_t line = 0;
  SourceRange range;
  /// It uses a multi-dimensional array, whose declaration corrects its uses.
  bool uses_flat_array = false;
};

/// A multi-dimensional array.
struct FlatArray {
  Diagnostic* report = nullptr;  ///< of the declaration, with the edits of all uses
  bool good = true;              ///< no incorrect use
};

class CheckContext {
 public:
  /// The files, the tree and the tokens must outlive this object.
  CheckContext(const Options& all_options, const std::deque<SourceFile>& all_files,
               Reporter& the_reporter, const std::vector<Token>& tokens);

  /// What a name means here; nullptr: nothing.
  const Entity* Lookup(std::string_view name) const;
  /// The number that an expression is: a literal or a macro, with a minus or without.
  std::optional<Literal> ConstantOf(const Expression& expression) const;
  /// The value of an expression of constants, which the card does not compute.
  std::optional<Constant> FoldHere(const Expression& expression) const;
  NameUses UsesInFunction(std::string_view name);
  bool NeedsBraces(const Statement& block) const;
  std::string_view Source(SourceRange range) const;
  int LineOf(SourceRange range) const;
  /// Limit of searches for similar names, because they take time.
  bool MaySuggest() { return suggestions_++ < kSuggestionMax; }

  /// Adds an instruction to the function.
  void Emit(vm::Instruction instruction);

  /// Notes what a fix-it of the statement can correct.
  template <typename... Args>
  void Teach(Code code, SourceRange range, const Args&... args) {
    // A nested expression is reported only if there is nothing more specific to report.
    if (!statement.lesson || statement.lesson->code == Code::kNestedExpression) {
      if (statement.lesson && code == Code::kNestedExpression) return;
      statement.lesson = Lesson{code, range, {ToMessage(args)...}};
    }
  }
  /// Reports an error that no rewriting can correct.
  template <typename... Args>
  Diagnostic& Fail(Code code, SourceRange range, const Args&... args) {
    statement.failed = true;
    return reporter.Report(code, range, args...);
  }

  const Options& options;
  const gtcalls::Catalogue& catalogue;
  const std::deque<SourceFile>& files;
  Reporter& reporter;
  const Tree* tree = nullptr;
  vm::Object object;
  std::vector<FunctionPlaces> places;
  Scope globals;                                                     ///< with macros and functions
  std::unordered_map<std::string_view, SourceRange> function_names;  ///< of the whole program
  std::unordered_set<std::string_view> skipped_names;
  std::unordered_map<std::string_view, FlatArray> flat_arrays;
  FreshNames fresh;
  SourceRange first_item;  ///< where #define lines can go
  FunctionState* function = nullptr;
  StatementState statement;

 private:
  static constexpr int kSuggestionMax = 100;
  int suggestions_ = 0;
};

}  // namespace oncard::compiler
