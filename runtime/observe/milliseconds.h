// Microseconds, in which the card's time is kept, as the milliseconds that people read and write.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace oncard::runtime {

inline double ToMs(int64_t microseconds) { return static_cast<double>(microseconds) / 1000; }

/// The shortest number of milliseconds that is this instant.
inline std::string FormatMs(int64_t microseconds) { return fmt::format("{}", ToMs(microseconds)); }

}  // namespace oncard::runtime
