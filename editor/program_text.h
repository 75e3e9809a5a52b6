// The text of a program as an editor sees it: the tokens and comments of each file, the directives,
// and which files are included. Unlike the compiler's, it is complete for every text: what is wrong
// is there as well, branches of #if that are not compiled too, and nothing is expanded.
// Tested by tests/editor/.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/compiler.h"
#include "compiler/dialect.h"
#include "compiler/syntax.h"

namespace oncard::editor {

/// A place as diagnostics give it: line and column count from 1, the column in characters, of which
/// a UTF-8 or GBK sequence is one.
struct Place {
  int line = 1;
  int column = 1;
};

/// A line that begins with `#`, with those that continue it.
struct Directive {
  std::string_view word;                    ///< `define`; empty if there is none
  std::span<const compiler::Token> tokens;  ///< from the `#` on
  compiler::SourceRange range;
  size_t order = 0;  ///< how many tokens of code() stand before it
};

/// Everything of one file. Tokens, comments and directives are in the order of the text.
struct FileText {
  explicit FileText(compiler::SourceFile source) : file(std::move(source)) {}

  compiler::SourceFile file;
  std::vector<compiler::Token> tokens;
  std::vector<compiler::SourceRange> comments;
  std::vector<Directive> directives;
  /// For each token, and then for the end of the file: how many tokens of ProgramText::code() stand
  /// before it.
  std::vector<size_t> orders;
};

/// A program with what it includes. A file that is included several times is there once. Programs
/// beyond kSourceKind or kTokenMax are cut off. The catalogue of the options must outlive it.
class ProgramText {
 public:
  /// The program `text` is called `path`; includes go through `reader`, and those that cannot be
  /// read are missing.
  ProgramText(const std::string& path, std::string text, const compiler::Options& options,
              const compiler::FileReader& reader);
  ProgramText(const ProgramText&) = delete;
  ProgramText& operator=(const ProgramText&) = delete;
  ProgramText(ProgramText&&) = default;
  ProgramText& operator=(ProgramText&&) = default;

  compiler::Dialect dialect() const { return dialect_; }
  bool structured() const { return dialect_ == compiler::Dialect::kStructured; }
  const gtcalls::Catalogue& catalogue() const { return *catalogue_; }

  /// The program first, then what it includes; SourceRange::file indexes them.
  const std::deque<FileText>& files() const { return files_; }
  const FileText& file(int index) const { return files_[static_cast<size_t>(index)]; }
  /// The index of a path; empty if the program does not include it.
  std::optional<int> Find(std::string_view path) const;

  /// All tokens outside of directives, those of included files where they are included.
  const std::vector<compiler::Token>& code() const { return code_; }
  /// All directives in the same order.
  const std::vector<Directive>& directives() const { return directives_; }

  std::string_view TextOf(compiler::SourceRange range) const;
  /// How many tokens of code() end before an offset of a file.
  size_t OrderAt(int file, uint32_t offset) const;

 private:
  void Add(compiler::SourceFile file, const compiler::Options& options,
           const compiler::FileReader& reader, int depth);
  void Include(const Directive& directive, const compiler::Options& options,
               const compiler::FileReader& reader, int depth);

  compiler::Dialect dialect_;
  const gtcalls::Catalogue* catalogue_;
  std::deque<FileText> files_;
  std::vector<compiler::Token> code_;
  std::vector<Directive> directives_;
  size_t bytes_ = 0;
  size_t token_count_ = 0;
};

/// The offset of a place, or of the nearest one in the file.
uint32_t OffsetOf(const compiler::SourceFile& file, Place place);

/// The index of the first token that ends after the offset.
size_t TokenAt(std::span<const compiler::Token> tokens, uint32_t offset);

}  // namespace oncard::editor
