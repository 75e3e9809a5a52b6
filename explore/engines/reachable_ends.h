// Which ends the states of a graph lead to, and whether the order of a race changes them.
// Deterministic. Tested by tests/explore/races_test.cc.
#pragma once

#include <cstdint>
#include <vector>

#include "explore/engines/state_graph.h"
#include "explore/models/races.h"

namespace oncard::explore {

/// For each state the set of ends that can be reached from it, as a number: equal sets have equal
/// numbers. `end_of` gives the end of each terminal state. Empty if `hurried` is set from another
/// thread.
std::vector<uint32_t> ReachableEnds(const StateGraph& graph, const std::vector<uint32_t>& end_of,
                                    const std::atomic<bool>* hurried = nullptr);

/// True if the two orders of a race in a state lead to different ends.
bool OrderMatters(const StateGraph& graph, const std::vector<uint32_t>& ends, uint32_t state,
                  const Race& race);

}  // namespace oncard::explore
