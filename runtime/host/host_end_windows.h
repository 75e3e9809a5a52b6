// The end of a host on Windows: ExitProcess(), which the library replaces, is told the exit code.
#pragma once

namespace oncard::runtime {

/// FinishHost(), the first time.
void FinishOnce();
/// The exit code of a host that ends with this one: ReplaceSuccess().
int ExitCodeFor(int code);

}  // namespace oncard::runtime
