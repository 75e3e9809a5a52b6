// Where names are declared and used, and how to give one another name.
// Tested by tests/editor/places_test.cc.
#pragma once

#include <string>

#include "base/result.h"
#include "editor/analysis.h"

namespace oncard::editor {

/// The declarations of the name at a place; of a function that has one, the definition. Empty for a
/// command, and if there is no name.
Json Definition(const Analysis& analysis, Cursor cursor);

/// All places of the name, each with its `access`.
Json References(const Analysis& analysis, Cursor cursor, bool declarations);

/// What is needed to compile a program again.
struct ProgramFiles {
  std::string path;
  std::string text;
  compiler::Options options;
  compiler::FileReader reader;
};

/// Edits that give the name at a place another one, in all files of the program. Fails if the
/// program would then mean something else, or have an error that it does not have now.
Result<Json> Rename(const Analysis& analysis, const ProgramFiles& program, Cursor cursor,
                    const std::string& name);

}  // namespace oncard::editor
