// Random programs of structured C with structures, also those of the card: nested, with arrays in
// them and arrays of them, values in braces, copies, parameters and results by value, parameters by
// reference, commands that keep structures and give them back.
#pragma once

#include <cstdint>

#include "structured_program.h"

namespace oncard::differential {

/// Everything is derived from the seed.
StructuredProgram MakeStructProgram(uint64_t seed);

}  // namespace oncard::differential
