// What becomes of the command when there is no more memory.
#pragma once

#include "tools/session.h"

namespace oncard::tools {

/// From now on a process that gets no more memory, in whichever thread, says so on standard error,
/// with what needs less, and ends with kExitIncomplete. What it has not written is lost.
void EndWhenOutOfMemory(const Session& session);

}  // namespace oncard::tools
