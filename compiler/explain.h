// The page that `oncard explain MP027` prints: what a diagnostic means, the reason for the rule, a
// program that causes it and the corrected program. The texts are the rows of explain_pages.def.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace oncard::compiler {

/// A row of explain_pages.def. The programs are complete sources, the same in both languages.
struct Explanation {
  int code;
  /// What is wrong and why: one paragraph of full sentences, without line ends.
  std::string_view en;
  std::string_view zh;
  /// Causes this diagnostic and no other, except for undeclared names from a file that could not be
  /// included. Empty if no short program causes it.
  std::string_view failing;
  /// Compiles without a diagnostic; empty when `failing` is.
  std::string_view fixed;
};

/// A file beside the programs of an explanation, which they include.
struct ExplanationFile {
  int code;
  std::string_view name;
  std::string_view text;
};

/// The row of a code, or nullptr.
const Explanation* FindExplanation(int code);
/// The files that the programs of a code include; most need none.
std::vector<ExplanationFile> ExplanationFiles(int code);
/// The message of a code with `...` where the compiler fills in what it found; empty for an unknown
/// code.
Message MessagePattern(int code);

/// The whole page, plain text of at most 80 columns that ends in a line end; nothing for an unknown
/// code.
std::optional<std::string> ExplainPage(int code, Language language);
/// Appends a paragraph to a page, in lines of at most 80 columns that begin with the indent.
void AppendWrapped(std::string& page, std::string_view text, std::string_view indent);
/// Number, slug and message of each of the codes, which exist; text as of ExplainPage().
std::string ExplainList(std::span<const int> codes, Language language);

}  // namespace oncard::compiler
