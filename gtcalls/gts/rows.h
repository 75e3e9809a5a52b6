// The rows of the GTS catalogue as constants, for the sources that make tables of them and for the
// test that compares gts.h with them.
#pragma once

#include "gtcalls/gts/words.h"

#define FAMILY_COMMANDS "gtcalls/gts/catalogue.def"
#define FAMILY_STRUCTURES "gtcalls/gts/structures.def"
namespace oncard::gtcalls::gts {
#include "gtcalls/rows/rows.inc"
}  // namespace oncard::gtcalls::gts
#undef FAMILY_COMMANDS
#undef FAMILY_STRUCTURES
