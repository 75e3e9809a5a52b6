// The sessions that `oncard debug` and `oncard serve` offer.
#pragma once

#include <string>

#include "base/result.h"
#include "session/host.h"

namespace oncard::tools {

/// Reads a file that is not given by content: a source, a scenario, a recording, a record, an
/// object. Fails like ReadFile(), with the bound of its kind.
Result<std::string> ReadProjectFile(const std::string& path);

/// A new session. It reads the files that a request names without their content, the comments of
/// sources, and records of hosts.
session::SessionHost NewProjectSession();

}  // namespace oncard::tools
