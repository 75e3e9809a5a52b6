// Finds diagnostics by number, by slug, or by the words of their texts: what `oncard explain`
// takes. Tested by tests/compiler/explain_search_test.cc.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace oncard::compiler {

/// The number in `MP027`, `mp27` or `27`; nothing for any other text.
std::optional<int> ParseDiagnosticCode(std::string_view text);

/// The codes of the diagnostics that a text asks for: the one that it numbers; or the one whose
/// slug it is, blanks taken for hyphens; or else those of which every word of the text begins a
/// word, in either language, upper and lower case alike. Those that have all words in their slugs
/// and messages come first, then those that have them in their explanations, each part by code.
std::vector<int> SearchDiagnostics(std::string_view text);

/// What to try when SearchDiagnostics() finds nothing.
Message AdviseSearch(std::string_view text);

}  // namespace oncard::compiler
