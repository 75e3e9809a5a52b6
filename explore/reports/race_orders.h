// What comes of a data race's two orders.
// Deterministic. Tested by tests/explore/failure_test.cc.
#pragma once

#include <vector>

#include "explore/engines/failure.h"
#include "explore/reports/trail.h"

namespace oncard::explore {

/// Takes the two statements of a data race in both orders, and then lets the threads run to their
/// ends, one after the other. First the order of the failing run. Empty for what is no data race,
/// and when the other order cannot be taken.
std::vector<RaceOrder> BothOrders(const Problem& problem, const Failure& failure);

}  // namespace oncard::explore
