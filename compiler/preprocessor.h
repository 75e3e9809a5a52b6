// Converts files of structured C to the tokens that the parser reads: obeys the directives,
// inserts included files and expands macros. The card's language has directives.h.
// Tested by tests/compiler/preprocessor_test.cc.
#pragma once

#include <deque>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "compiler/compiler.h"
#include "compiler/macro_expander.h"
#include "compiler/program_files.h"
#include "compiler/reporter.h"
#include "compiler/source_comments.h"
#include "compiler/syntax.h"

namespace oncard::compiler {

class Preprocessor {
 public:
  /// The references must outlive this object and its tokens.
  Preprocessor(const Options& options, const FileReader& reader, Reporter& reporter)
      : options_(options),
        reader_(reader),
        reporter_(reporter),
        macros_(*options.catalogue, reporter, made_),
        files_(options, TextLimits(), reporter, Dialect::kStructured) {}

  /// Reads the program, given as text. Call once.
  void Run(SourceFile program);

  /// The tokens, ending in an end token; their texts are in the files.
  std::vector<Token>& tokens() { return tokens_; }
  /// The files read, the program first, and for each one where the program includes it, directly or
  /// not: the offset of the directive.
  std::deque<SourceFile>& files() { return files_.files(); }
  std::vector<uint32_t>& inclusion_points() { return files_.inclusion_points(); }
  /// Texts of no file, to which tokens may point, too: headers of C, and words that macros made.
  std::deque<SourceFile>& made() { return made_; }
  /// The comments of each file, also those in text that is not read.
  std::vector<SourceComment>& comments() { return comments_; }
  MacroExpander& macros() { return macros_; }
  /// After Run(): true for a place in text that is not read, such as behind `#if 0`.
  bool IsSkipped(const SourceRange& place) const;

 private:
  // An #if that is not closed yet.
  struct Conditional {
    SourceRange place;
    bool around = true;   // the text around it is read
    bool taken = false;   // one of its branches has been read
    bool reading = true;  // the present one is
    bool last = false;    // it is the one of #else
  };
  using Line = std::span<const Token>;

  void AddFile(SourceFile file, uint32_t inclusion_point, int depth);
  bool Reading() const { return conditionals_.empty() || conditionals_.back().reading; }
  void AddText(std::span<const Token> text);
  void Emit(Token token);
  void Directive(Line line, int depth);
  bool ConditionalDirective(Line line, SourceRange whole, std::string_view word);
  void NextBranch(Line line, SourceRange whole, std::string_view word);
  std::optional<bool> Condition(Line line, SourceRange whole, std::string_view word);
  bool NameAfter(Line line, SourceRange whole, const Token** name);
  void Define(Line line, SourceRange whole);
  bool ReadBody(Line words, MacroDefinition* macro);
  bool ReadParameters(Line line, size_t* next, MacroDefinition* macro);
  void DefineKnown(std::string_view text, SourceRange range);
  void Include(Line line, SourceRange whole, int depth);
  void DropReportsOfSkippedText();
  void RemoveAttributes();
  size_t EndOfAttribute(size_t begin);
  void IgnoreAttribute(const Token& word);

  const Options& options_;
  const FileReader& reader_;
  Reporter& reporter_;
  std::deque<SourceFile> made_;
  MacroExpander macros_;
  ProgramFiles files_;
  std::vector<Token> tokens_;
  std::vector<SourceComment> comments_;
  std::vector<Conditional> conditionals_;
  SourceRange program_include_;       // the #include of the program that is being obeyed
  std::vector<SourceRange> skipped_;  // text that is not read; after Run() in its order
  std::set<std::string> once_;        // files with #pragma once
  std::unordered_set<std::string_view> ignored_;  // attributes that were reported
};

}  // namespace oncard::compiler
