// The rows of the catalogue of point-to-point cards as constants.
#pragma once

#include "gtcalls/ge/words.h"

namespace oncard::gtcalls::gep {

/// AXIS_NUM.
inline constexpr int kWatchedAxes = 8;

namespace words {

using namespace ge::words;

constexpr Spec WatchWords() { return UShort("config").Input().In(Unit::kBits).Array(kWatchedAxes); }

}  // namespace words
}  // namespace oncard::gtcalls::gep

#define FAMILY_COMMANDS "gtcalls/ge/gep_catalogue.def"
#define FAMILY_STRUCTURES "gtcalls/ge/structures.def"
namespace oncard::gtcalls::gep {
#include "gtcalls/rows/rows.inc"
}  // namespace oncard::gtcalls::gep
#undef FAMILY_COMMANDS
#undef FAMILY_STRUCTURES
