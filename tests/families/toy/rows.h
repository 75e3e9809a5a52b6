// The rows of the family as constants.
#pragma once

#include "gtcalls/rows/words.h"

namespace oncard::gtcalls::toy::words {

using namespace gtcalls::words;

inline constexpr std::string_view kSource = "tests/families";

constexpr Spec Axis() {
  Spec spec = Index("axis", 1, 12);
  spec.parameter.axis_number = true;
  return spec;
}

}  // namespace oncard::gtcalls::toy::words

#define FAMILY_COMMANDS "tests/families/toy/catalogue.def"
#define FAMILY_STRUCTURES "tests/families/toy/structures.def"
namespace oncard::gtcalls::toy {
#include "gtcalls/rows/rows.inc"
}  // namespace oncard::gtcalls::toy
#undef FAMILY_COMMANDS
#undef FAMILY_STRUCTURES
