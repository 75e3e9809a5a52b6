// The sessions that `oncard debug` and `oncard serve` offer.
#pragma once

#include "session/host.h"

namespace oncard::tools {

/// A new session. It reads the files that a request names without their content, the comments of
/// sources, and records of hosts.
session::SessionHost NewProjectSession();

}  // namespace oncard::tools
