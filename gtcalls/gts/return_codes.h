// What the return codes of GT commands mean, for people. Read-only data, safe to use from any
// thread. Tested by tests/gtcalls/return_codes_test.cc.
#pragma once

#include <optional>
#include <string>

#include "base/message.h"

namespace oncard::gtcalls::gts {

/// The page of a return code, or of the error of a thread, in plain text: each of its meanings,
/// with what to do. Empty for a number that has none. Sources: GTS manual table 3-1 and the pages
/// of the commands, the manual of the look-ahead (003), docs/host-api.md.
std::optional<Message> ReturnCodePage(int code);

}  // namespace oncard::gtcalls::gts
