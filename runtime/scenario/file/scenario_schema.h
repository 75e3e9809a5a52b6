// The keys of scenario files as a JSON Schema (draft 2020-12), with which editors complete, explain
// and check a file while it is written. It says what key_table.h says of each key by itself; what
// depends on several keys or on the program is found when the file is read. Tested by
// tests/runtime/scenario_schema_test.cc.
#pragma once

#include <string>

#include "base/message.h"

namespace oncard::runtime {

/// The schema, with descriptions in a language; ends in a newline.
std::string ScenarioSchema(Language language);

}  // namespace oncard::runtime
