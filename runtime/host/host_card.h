// Which card the host library opens. ONCARD_CARD names it; without it the scenario decides, without
// both it is the default card of the library's family. Thread-safe.
#pragma once

#include "base/result.h"
#include "gtcalls/family.h"

namespace oncard::runtime {

/// The family whose commands this library has.
const gtcalls::Family& LibraryFamily();

/// The type that ONCARD_CARD names; nullptr without it. An error if there is no such card, or not
/// in the library's family.
Result<const gtcalls::CardType*> CardFromEnvironment();

}  // namespace oncard::runtime
