#include "tools/absent_command.h"

#include <cstdlib>

namespace oncard::tools {

void AddAbsentCommand(CLI::App& app, Invocation& invocation, const std::string& name,
                      const Message& description, const Message& instead) {
  const auto refuse = [instead, &invocation] { return Fail(invocation, kExitUsage, instead); };
  // Before its arguments are read: whatever they are, the message is the same.
  AddCommand(app, invocation, name, description, refuse)
      ->preparse_callback(
          [refuse, &invocation](size_t) { std::exit(FinishOutput(invocation, refuse())); });
}

}  // namespace oncard::tools
