// What folders.cc and scenario_folder.cc do with the folders of a system: folder_steps.cc, or
// folder_steps_wasi.cc in WebAssembly, whose standard library knows none.
#pragma once

#include <string>
#include <system_error>
#include <vector>

namespace oncard::tools::folder_steps {

/// Makes a folder, and those around it that are missing.
std::error_code MakeAll(const std::string& path);

/// Adds the paths of all that is in a folder and its subfolders, in any order. Links to folders are
/// not followed.
std::error_code AddPathsIn(const std::string& folder, std::vector<std::string>* paths);

}  // namespace oncard::tools::folder_steps
