// The card's time is whole microseconds; people and files say milliseconds.
#pragma once

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace oncard {

inline double ToMs(int64_t microseconds) { return static_cast<double>(microseconds) / 1000; }

/// The nearest microsecond. The time must be finite and fit.
inline int64_t FromMs(double milliseconds) { return std::llround(milliseconds * 1000); }

/// The shortest decimal number of milliseconds for this instant.
inline std::string FormatMs(int64_t microseconds) { return fmt::format("{}", ToMs(microseconds)); }

}  // namespace oncard
