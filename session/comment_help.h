// What an editor wants to know of the comments that say what must hold, such as `//@ always: n <
// 5`, while a program is being written: their words, and the values of those that have a choice.
// The answers follow from the line of the place alone. Tested by
// tests/session/comment_help_test.cc.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "base/message.h"
#include "compiler/diagnostic.h"
#include "editor/program_text.h"

namespace oncard::session {

/// Words, or values of the word before the colon; members as in editor/complete.h. nullopt outside
/// of such a comment.
std::optional<nlohmann::ordered_json> CompleteComment(const compiler::SourceFile& file,
                                                      editor::Place place, Language language);

/// The word at the place; nullopt if there is none.
std::optional<nlohmann::ordered_json> DescribeComment(const compiler::SourceFile& file,
                                                      editor::Place place, Language language);

}  // namespace oncard::session
