// Random programs of structured C whose functions call themselves and each other, with numbers,
// structures and arrays of their own, and references to what all of their calls share.
#pragma once

#include <cstdint>

#include "structured_program.h"

namespace oncard::differential {

/// Everything is derived from the seed.
StructuredProgram MakeRecursiveProgram(uint64_t seed);

}  // namespace oncard::differential
