// What an editor wants to know of a scenario file (TOML) while it is being written: keys, values,
// tables. The answers follow from the schema (runtime/scenario/file/scenario_schema.h) and the line
// of the place with the last table head before it, so that mistakes elsewhere do not matter. Tables
// in braces are not looked into. Tested by tests/session/scenario_help_test.cc.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/message.h"
#include "editor/program_text.h"

namespace oncard::session {

/// A place in a scenario.
struct ScenarioPlace {
  std::string path;
  std::string text;
  editor::Place place;
};

/// Keys of the table, values of the key, or tables; members as in editor/complete.h.
nlohmann::ordered_json CompleteScenario(const ScenarioPlace& where, Language language);

/// The key or table of the line; null if there is none.
nlohmann::ordered_json DescribeScenario(const ScenarioPlace& where, Language language);

}  // namespace oncard::session
