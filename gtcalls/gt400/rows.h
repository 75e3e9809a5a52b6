// The rows of the GT400 catalogue as constants.
#pragma once

#include "gtcalls/gt400/words.h"

#define FAMILY_COMMANDS "gtcalls/gt400/catalogue.def"
#define FAMILY_STRUCTURES "gtcalls/gt400/structures.def"
namespace oncard::gtcalls::gt400 {
#include "gtcalls/rows/rows.inc"
}  // namespace oncard::gtcalls::gt400
#undef FAMILY_COMMANDS
#undef FAMILY_STRUCTURES
