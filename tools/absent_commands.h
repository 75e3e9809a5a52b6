// What is said of `exec` and `serve` where the system does not have them, in
// absent_commands_windows.cc and absent_commands_wasi.cc.
#pragma once

#include "base/message.h"

namespace oncard::tools::absent {

/// Stands in brackets behind what such a command does.
Message Note();
/// What to use in its place.
Message InsteadOfExec();
Message InsteadOfServe();

}  // namespace oncard::tools::absent
