// What a card keeps for its family alone, beside the motion core and the virtual machine: a value
// of the family's own type. Snapshots copy it, hashes include it; only the functions of the family
// look into it.
#pragma once

#include <variant>

#include "gtcalls/gts/gts_state.h"

namespace oncard::gtcalls {

/// One alternative for each family.
using FamilyState = std::variant<GtsState>;

}  // namespace oncard::gtcalls
