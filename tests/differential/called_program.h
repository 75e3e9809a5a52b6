// Random programs of structured C about functions: several with long bodies, called again and again
// by each other and by `f`, in loops, conditions, arguments and results, with values and arrays.
// Each has exactly one meaning in C, as in structured_program.h.
#pragma once

#include "structured_program.h"

namespace oncard::differential {

/// Everything is derived from the seed.
StructuredProgram MakeCalledProgram(uint64_t seed);

}  // namespace oncard::differential
