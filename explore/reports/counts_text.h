// What the engines of a search have counted, and the races that were found, in words. Depends only
// on its arguments. Tested by tests/explore/report_test.cc.
#pragma once

#include <vector>

#include "base/message.h"
#include "explore/reports/report.h"

namespace oncard::explore {

/// One line for each engine that ran, then one for each race.
std::vector<Message> DescribeCounts(const Findings& findings);

/// The same for what is filed, which does not depend on the clock: of two engines that ran beside
/// each other the number of ends, which both find, or with a failure the states, which are then
/// searched to their end.
std::vector<Message> DescribeLastingCounts(const Findings& findings);

}  // namespace oncard::explore
