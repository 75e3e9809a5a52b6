// The result of a run as JSON: what `oncard run --format=json` prints.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/message.h"
#include "runtime/scenario/run/scenario_run.h"

namespace oncard::runtime {

/// One document with all results of the run; hashes as 16 hexadecimal digits.
nlohmann::ordered_json ResultJson(const ScenarioResult& result, Language language);

}  // namespace oncard::runtime
