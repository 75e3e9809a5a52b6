// Converts files of the card's language to the sequence of tokens that the parser reads: inserts
// included files and removes #define lines.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "compiler/compiler.h"
#include "compiler/constant_folding.h"
#include "compiler/program_files.h"
#include "compiler/reporter.h"
#include "compiler/syntax.h"

namespace oncard::compiler {

class Directives {
 public:
  /// The references must outlive this object and its tokens.
  Directives(const Options& options, const FileReader& reader, const TextLimits& limits,
             Reporter& reporter)
      : options_(options),
        reader_(reader),
        reporter_(reporter),
        files_(options, limits, reporter, Dialect::kCard) {}

  /// Reads the program, given as text. Call once.
  void Run(SourceFile program);

  /// The tokens, ending in an end token. #define lines are kMacroDefinition tokens.
  const std::vector<Token>& tokens() const { return tokens_; }
  std::vector<Macro>& macros() { return macros_; }
  /// The files read, the program first, and where each is included: the offset of the directive.
  std::deque<SourceFile>& files() { return files_.files(); }
  const std::vector<uint32_t>& inclusion_points() { return files_.inclusion_points(); }
  /// Names whose definitions were wrong: no further diagnostics about them.
  const std::unordered_set<std::string_view>& skipped_names() const { return skipped_names_; }

 private:
  void AddFile(SourceFile file, uint32_t inclusion_point);
  void Directive(const std::vector<Token>& line);
  void Define(const std::vector<Token>& line, SourceRange whole);
  /// Reports a macro body that the language does not allow, and replaces it by its value if it has
  /// one.
  void ReportBody(std::span<const Token> line, SourceRange whole, bool parameters, Macro& macro);
  /// Checks macros whose value is not equivalent to their body in every place.
  void CorrectOpenMacros();
  void Include(const std::vector<Token>& line, SourceRange whole);
  void CorrectAngles(Diagnostic& diagnostic, SourceRange range, SourceRange whole) const;

  const Options& options_;
  const FileReader& reader_;
  Reporter& reporter_;
  ProgramFiles files_;
  std::vector<Token> tokens_;
  std::vector<Macro> macros_;
  std::unordered_map<std::string_view, size_t> macro_by_name_;
  std::unordered_set<std::string_view> skipped_names_;
  struct OpenMacro {
    std::string_view name;
    Diagnostic* report = nullptr;
    SourceRange body;
    Constant value;
  };
  std::vector<OpenMacro> open_macros_;
  std::unordered_map<std::string_view, SourceRange> names_in_bodies_;
  bool too_many_ = false;
  std::vector<SourceRange> open_braces_;
  SourceRange external_;  // start of the definition that is being read
};

}  // namespace oncard::compiler
