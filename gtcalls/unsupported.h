// Why a command of the catalogue is not executed (unsupported.def). Commands that the host library
// answers itself have no reason either. Tested by tests/runtime/supported_commands_test.cc.
#pragma once

#include "base/message.h"
#include "gtcalls/catalogue.h"

namespace oncard::gtcalls {

/// The reason, or NULL when the table has none for the command.
const Message* WhyUnsupported(const Command& command);

}  // namespace oncard::gtcalls
