// The axes of tests of slave modes.
#pragma once

#include <cstddef>

namespace oncard::motion {

inline constexpr size_t kMaster = 0;
inline constexpr size_t kSlave = 1;

}  // namespace oncard::motion
