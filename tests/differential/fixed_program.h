// Random programs of C with doubles, for which fixed point and gcc's floating point give the same
// numbers: every value is a multiple of 1/1024 below 2^21, and what is kept in a variable one of
// 1/8 below 512. Doubles and ints are mixed in sums, products, comparisons, conversions,
// conditions, parameters and results of functions, arrays and compound assignments.
#pragma once

#include <cstdint>

#include "structured_program.h"

namespace oncard::differential {

/// Everything is derived from the seed. The function is `int f()`.
StructuredProgram MakeFixedProgram(uint64_t seed);

}  // namespace oncard::differential
