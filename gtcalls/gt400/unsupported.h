// The reason why GT400 cards do not support a command (unsupported.def). Commands that the host
// library executes itself have no entry. Tested by tests/runtime/supported_commands_test.cc.
#pragma once

#include <string_view>

#include "base/message.h"
#include "gtcalls/catalogue.h"

namespace oncard::gtcalls::gt400 {

/// True for the commands of the table.
constexpr bool IsUnsupported(std::string_view command) {
#define UNSUPPORTED(name, id) \
  if (command == #name) return true;
#include "gtcalls/gt400/unsupported.def"
  return false;
}

/// The reason, or NULL when the table has none for the command.
const Message* WhyUnsupported(const Command& command);

}  // namespace oncard::gtcalls::gt400
