// Random programs of C about the values of arrays in braces: globals, `static` locals and locals
// of one to four dimensions, whose lists leave out inner braces, values and the first size. Each
// is valid C without a value too many.
#pragma once

#include <cstdint>

#include "structured_program.h"

namespace oncard::differential {

/// Everything is derived from the seed. The function is `int f()`.
StructuredProgram MakeArrayProgram(uint64_t seed);

}  // namespace oncard::differential
