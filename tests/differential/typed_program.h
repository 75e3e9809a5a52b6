// Random programs of structured C about C's types and functions: variables and parameters of every
// integer type, expressions that mix them, calls with values and arrays, static locals. Each has
// exactly one meaning in C, as in structured_program.h.
#pragma once

#include "structured_program.h"

namespace oncard::differential {

/// Everything is derived from the seed.
StructuredProgram MakeTypedProgram(uint64_t seed);

}  // namespace oncard::differential
