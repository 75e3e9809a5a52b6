// Handles the lack of memory in a command.
#pragma once

#include "tools/invocation.h"

namespace oncard::tools {

/// From now on, if an allocation fails in any thread, the process reports it on standard error,
/// with advice on what needs less memory, and ends with kExitIncomplete. Unwritten output is lost.
void EndWhenOutOfMemory(const Invocation& invocation);

}  // namespace oncard::tools
