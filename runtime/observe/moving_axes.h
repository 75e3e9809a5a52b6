// Axes that are still moving when a run ends.
#pragma once

#include <cstdint>
#include <vector>

#include "base/message.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// Bit n: axis n + 1 is moving now.
uint32_t MovingAxes(const Controller& controller);

/// A text for each moving axis: its number, the time, its velocity and position.
std::vector<Message> DescribeMovingAxes(const Controller& controller);

}  // namespace oncard::runtime
