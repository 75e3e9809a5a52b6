// The page that `oncard explain structured` prints: what structured C is, in a few words.
// docs/structured.md shows every construct with what it becomes.
#pragma once

#include <string_view>

#include "base/message.h"

namespace oncard::compiler {

/// What `oncard explain` calls the page.
inline constexpr std::string_view kStructuredTopic = "structured";

/// Plain text of at most 80 columns that ends in a line end.
std::string_view StructuredOverview(Language language);

}  // namespace oncard::compiler
