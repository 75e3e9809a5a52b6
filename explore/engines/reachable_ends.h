// Which ends the states of a graph lead to, and whether the order of a race changes them.
// Deterministic. Tested by tests/explore/races_test.cc.
#pragma once

#include <cstdint>
#include <vector>

#include "explore/engines/state_graph.h"
#include "explore/models/races.h"

namespace oncard::explore {

/// Which ends can be reached from each state, as the number of a set: equal sets have equal
/// numbers. `end_of` names the end that each terminal state is.
std::vector<uint32_t> ReachableEnds(const StateGraph& graph, const std::vector<uint32_t>& end_of);

/// True when the two orders of a race in a state lead to different ends.
bool OrderMatters(const StateGraph& graph, const std::vector<uint32_t>& ends, uint32_t state,
                  const Race& race);

}  // namespace oncard::explore
