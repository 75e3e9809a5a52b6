// The state that a card has for its family, in addition to the motion core and the virtual machine:
// a value of the family's own type. Snapshots copy it, hashes include it; only the family's
// functions use its content.
#pragma once

#include <cstdint>
#include <variant>

#include "gtcalls/ge/ge_state.h"
#include "gtcalls/gt400/gt400_state.h"
#include "gtcalls/gts/gts_state.h"

namespace oncard::gtcalls {

/// One alternative for each kind of state; hashes contain its number.
using FamilyState = std::variant<GtsState, GeState, Gt400State>;

/// Of everything that the family lists.
uint64_t HashOf(const FamilyState& state);

}  // namespace oncard::gtcalls
