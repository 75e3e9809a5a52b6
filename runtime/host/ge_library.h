// What the host libraries of both GE families are: up to 16 cards of which one is current, and the
// handler of commands. Tested by tests/families/ge/ge_family_test.cc.
#pragma once

#include "runtime/host/library.h"

namespace oncard::runtime {

/// The library of one of them.
HostLibrary GeLibrary(const gtcalls::Family& family);

}  // namespace oncard::runtime
