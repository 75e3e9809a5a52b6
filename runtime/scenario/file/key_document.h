// The tables of docs/scenarios.md that follow from key_table.h. Each stands between two comments,
// `<!-- begin keys of world.axis -->` (`keys of the file` for the top level, `uses` for the table
// of uses) and `<!-- end -->`. Tested by tests/runtime/key_table_test.cc.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace oncard::runtime {

/// The document with its tables made anew; the rest stays as it is. Fails if a section has no place
/// in it.
Result<std::string> UpdateKeyTables(std::string document);

}  // namespace oncard::runtime
