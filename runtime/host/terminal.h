// The keyboard of a host, where no script replaces it: single keys from standard input, without
// echo. Thread-safe.
#pragma once

namespace oncard::runtime {

/// True if a key has been pressed and not yet read; the end of the input is no key.
bool TerminalHasKey();
/// Waits for a key; -1 at the end of the input.
int ReadTerminalKey();

}  // namespace oncard::runtime
