// Which card the host library opens. ONCARD_CARD names it; without it the scenario decides, without
// both it is the default card of the library's family. Thread-safe.
#pragma once

#include "base/result.h"
#include "gtcalls/family.h"

namespace oncard::runtime {

/// The type that ONCARD_CARD names; nullptr without it. An error if there is no such card in
/// `family`; nullptr: in any family.
Result<const gtcalls::CardType*> CardFromEnvironment(const gtcalls::Family* family);

}  // namespace oncard::runtime
