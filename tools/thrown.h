// Exceptions end at the command: CLI11 throws for mistakes, and for --help and --version.
#pragma once

#include <exception>

namespace oncard::tools {

/// Reports what has ended the command in progress. Returns the exit code.
int ReportThrown(const std::exception& thrown);

}  // namespace oncard::tools
