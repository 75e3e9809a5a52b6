// Converts the card's time in microseconds to milliseconds for display.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace oncard::runtime {

inline double ToMs(int64_t microseconds) { return static_cast<double>(microseconds) / 1000; }

/// The shortest decimal number of milliseconds for this instant.
inline std::string FormatMs(int64_t microseconds) { return fmt::format("{}", ToMs(microseconds)); }

}  // namespace oncard::runtime
