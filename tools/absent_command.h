// A command that this build of oncard does not have: it says what to use in its place.
#pragma once

#include <string>

#include "tools/commands.h"

namespace oncard::tools {

/// Adds it with its description for the help; its answer to any arguments is `instead`, and the
/// exit code kExitUsage.
void AddAbsentCommand(CLI::App& app, Invocation& invocation, const std::string& name,
                      const Message& description, const Message& instead);

}  // namespace oncard::tools
