// Reads a program of structured C: included files, macros, tokens, and the syntax tree. What
// remains to be found out needs names and types, and is the business of compiler/lowering.
// Tested by tests/compiler/structured_source_test.cc.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "compiler/asserts.h"
#include "compiler/compiler.h"
#include "compiler/depth_comments.h"
#include "compiler/macro_expander.h"
#include "compiler/reporter.h"
#include "compiler/source_comments.h"
#include "compiler/syntax.h"

namespace oncard::compiler {

/// A program and everything that its tree points into. Nodes from the body of a macro have the
/// range of its use, but the text of the body.
class StructuredSource {
 public:
  /// Reads the program `text`, which diagnostics call `path`; includes go through `reader`. The
  /// tree is complete only if nothing was reported. The options and the reporter are used only
  /// here.
  StructuredSource(const std::string& path, std::string text, const Options& options,
                   const FileReader& reader, Reporter& reporter);
  StructuredSource(StructuredSource&&) noexcept;
  StructuredSource& operator=(StructuredSource&&) noexcept;
  StructuredSource(const StructuredSource&) = delete;
  StructuredSource& operator=(const StructuredSource&) = delete;
  ~StructuredSource();

  const Tree& tree() const { return tree_; }
  /// The files read, the program first; ranges index them.
  const std::deque<SourceFile>& files() const { return files_; }
  /// For each file, where it is included: the offset in the program of the directive.
  const std::vector<uint32_t>& inclusion_points() const { return inclusion_points_; }
  /// Names that stand in skipped text: they may have been declared there, so that nothing more
  /// should be said about them.
  const std::unordered_set<std::string_view>& skipped_names() const { return skipped_names_; }
  const MacroUses& macro_uses() const { return macro_uses_; }
  /// Those in text that is read.
  const std::vector<AssertComment>& asserts() const { return asserts_; }
  const std::vector<DepthComment>& depths() const { return depths_; }
  const std::vector<SourceComment>& comments() const { return comments_; }
  /// Adds to each diagnostic at the use of a macro where the macro is defined. Call once, when
  /// nothing more is reported.
  void AddMacroNotes(Reporter& reporter) const;

 private:
  std::deque<SourceFile> files_;
  std::deque<SourceFile> made_;  // texts of no file
  std::vector<uint32_t> inclusion_points_;
  MacroUses macro_uses_;
  std::vector<AssertComment> asserts_;
  std::vector<DepthComment> depths_;
  std::vector<SourceComment> comments_;
  std::vector<Token> tokens_;
  std::unordered_set<std::string_view> skipped_names_;
  Tree tree_;
};

}  // namespace oncard::compiler
