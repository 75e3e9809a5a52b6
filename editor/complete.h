// What can be written at a place. Tested by tests/editor/complete_test.cc.
#pragma once

#include "editor/analysis.h"

namespace oncard::editor {

/// Candidates at a place, the most likely first, and the range of the word that they replace. They
/// are not filtered by what has been typed of the word. Inside the parentheses of a GT command also
/// the parameter that is written.
Json Complete(const Analysis& analysis, Cursor cursor, Language language);

}  // namespace oncard::editor
