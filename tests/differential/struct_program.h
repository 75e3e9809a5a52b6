// Random programs of structured C with structures: nested, with arrays in them and arrays of them,
// values in braces, copies, parameters and results by value, parameters by reference.
#pragma once

#include <cstdint>

#include "structured_program.h"

namespace oncard::differential {

/// Everything is derived from the seed.
StructuredProgram MakeStructProgram(uint64_t seed);

}  // namespace oncard::differential
