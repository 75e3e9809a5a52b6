// Random programs of ordinary C: nested blocks, loops and branches, guards and side effects inside
// conditions, nested expressions, initial values, shadowed names, two-dimensional arrays, truth
// values, characters, floats, macros with expressions as bodies. `oncard check --fix` converts such
// programs. Each has exactly one meaning in C: no operand order matters, only ints that wrap
// overflow, guards keep divisors and indices valid, and a global that counts down in conditions
// ends every loop.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace oncard::differential {

struct StructuredProgram {
  uint64_t seed = 0;
  std::string text;                  ///< with one function, `int f()`
  std::vector<std::string> globals;  ///< int scalars, then elements of int arrays: `g0`, `a[3]`
};

/// Whether some numbers are floats, `0.5f`, which the lowering refuses.
enum class Floats { kSuffixed, kNone };

/// Everything is derived from the seed.
StructuredProgram MakeStructuredProgram(uint64_t seed, Floats floats = Floats::kSuffixed);

}  // namespace oncard::differential
