// What `oncard exec` has to know about a host program before it starts it.
#pragma once

#include <string>

namespace oncard::tools {

/// True for a 32-bit program. `name` is found as execvp() finds it: a name without a slash in PATH.
/// False for any other file, scripts among them, and for none. Reads its first bytes.
bool IsProgramOf32Bits(const std::string& name);

}  // namespace oncard::tools
