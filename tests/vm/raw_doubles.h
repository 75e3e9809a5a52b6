// What tests of the fixed-point double share.
#pragma once

#include <cstdint>

#include "vm/fixed_point.h"

namespace oncard::vm {

inline constexpr int kWide = WrapShift(DoubleFormat::k32_16);
inline constexpr int64_t kOne = 65536;  ///< the raw double 1.0

}  // namespace oncard::vm
