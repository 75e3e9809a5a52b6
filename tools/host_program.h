// The properties of a host program that `oncard exec` needs before it starts the program.
#pragma once

#include <string>

namespace oncard::tools {

/// True for a 32-bit program. `name` is found as execvp() finds it: a name without a slash in PATH.
/// False for any other file, scripts among them, and for none. Reads its first bytes.
bool IsProgramOf32Bits(const std::string& name);

}  // namespace oncard::tools
