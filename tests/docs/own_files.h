// The project's own files, for tests of what pages and sources say.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace oncard::docs {

/// Those whose names have this ending, as in ".md", without those in hidden folders, build trees
/// and packages of others.
std::vector<std::filesystem::path> OwnFiles(const std::string& ending);

}  // namespace oncard::docs
