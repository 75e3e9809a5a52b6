#include "gtcalls/family_state.h"

#include "motion/common/state_hash.h"

namespace oncard::gtcalls {

uint64_t HashOf(const FamilyState& state) { return motion::StateHash().Add(state).value(); }

}  // namespace oncard::gtcalls
