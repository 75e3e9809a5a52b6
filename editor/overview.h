// A whole file at once: its outline, the kinds of its words, what can be folded, and hints.
// Tested by tests/editor/overview_test.cc.
#pragma once

#include "editor/analysis.h"
#include "vm/object.h"

namespace oncard::editor {

/// What a file declares: functions with their parameters, variables and labels, globals, macros.
Json Outline(const Analysis& analysis, int file);

/// The kind of each word, number and comment of a file, in order.
Json Tokens(const Analysis& analysis, int file);

/// Ranges of more than one line that can be folded.
Json Folds(const Analysis& analysis, int file);

/// What a reader of a file would have to look up: the parameter and unit of each argument of a
/// command, the unit of each member of a structure of the card that gets a value, and the slot of
/// each variable if the program compiles; `object` may be nullptr.
Json Hints(const Analysis& analysis, int file, const vm::Object* object);

}  // namespace oncard::editor
