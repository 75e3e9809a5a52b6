// Axes that still move when a run ends.
#pragma once

#include <vector>

#include "base/message.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// A text for each axis that moves now: which, when, how fast, where.
std::vector<Message> DescribeMovingAxes(const Controller& controller);

}  // namespace oncard::runtime
