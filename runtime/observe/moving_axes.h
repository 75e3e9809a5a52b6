// Axes that are still moving when a run ends.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/message.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// Bit n: axis n + 1 is moving now. A slave that follows a resting master is not.
uint32_t MovingAxes(const Controller& controller);

/// The number of an axis that moves (from 0), the time, its velocity and position.
Message DescribeMovingAxis(const Controller& controller, size_t axis);

}  // namespace oncard::runtime
