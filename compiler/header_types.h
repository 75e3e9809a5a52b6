// The integer types that C's headers define, and what structured C has instead.
// Tested by tests/lang/structured/bad_header_types.c.
#pragma once

#include <string_view>

namespace oncard::compiler {

/// The type to write instead of `int32_t` and others of `stdint.h` and `stddef.h`; `long long` for
/// those of 64 bits, which do not exist. Empty for any other word.
std::string_view TypeForHeaderType(std::string_view word);

}  // namespace oncard::compiler
