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

/// The codes of the diagnostics that match a text: the one with that number; or the one with that
/// slug, where blanks count as hyphens; otherwise those in which every word of the text is the
/// beginning of a word, in either language, ignoring case. Matches in slugs and messages come
/// first, then matches in explanations, each sorted by code.
std::vector<int> SearchDiagnostics(std::string_view text);

/// The advice if SearchDiagnostics() finds nothing.
Message AdviseSearch(std::string_view text);

}  // namespace oncard::compiler
