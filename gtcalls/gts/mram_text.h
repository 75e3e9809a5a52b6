// The contents of the ferroelectric memory as the text of a file, which keeps them while the card
// is off (docs/host-api.md). Tested by tests/gtcalls/mram_text_test.cc.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "gtcalls/gts/mram.h"

namespace oncard::gtcalls::gts {

/// The words that differ from 0, in the order of their addresses.
std::string FormatMram(const Mram& mram);

/// Reads such a text, from any source. The buffer of the result is clear. Fails with the first line
/// that is not as it must be; `path` is the file's name in the message.
Result<Mram> ParseMram(std::string_view text, std::string_view path);

}  // namespace oncard::gtcalls::gts
