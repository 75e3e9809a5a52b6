// Threads of a livelock that wait for one variable. Deterministic. Tested by
// tests/explore/starvation_test.cc.
#pragma once

#include <vector>

#include "base/message.h"
#include "explore/reports/trail.h"
#include "vm/object.h"

namespace oncard::explore {

/// `starvation: thread 0 finds m taken each time it looks`: the threads that do nothing in the
/// cycle but look at one global, which always has the same value. Empty if there are none.
Message DescribeStarvation(const std::vector<TrailStep>& cycle, const vm::Object& object);

}  // namespace oncard::explore
