// The scenarios that `oncard test` is given. Tested by tests/tools/run_command_test.cc.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace oncard::tools {

/// The scenarios (.toml) in a folder and its subfolders, sorted by path; for a file the file
/// itself.
Result<std::vector<std::string>> FindScenarios(const std::string& path);

}  // namespace oncard::tools
