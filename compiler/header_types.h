// What structured C knows of C's headers: their integer types, and the macros for the limits of
// integers. Tested by tests/lang/structured/header_types.c and bad_header_types.c.
#pragma once

#include <optional>
#include <string_view>

namespace oncard::compiler {

/// The type that `int32_t` and others of `stdint.h` and `stddef.h` are; `long long` for those of 64
/// bits, which do not exist. Empty for any other word.
std::string_view TypeForHeaderType(std::string_view word);

/// The #define lines of a header that a program may include although there is no such file; nullopt
/// for any other header. `gts.h` and `stdbool.h` have none: what they define is known anyway.
std::optional<std::string_view> TextOfKnownHeader(std::string_view name);

}  // namespace oncard::compiler
