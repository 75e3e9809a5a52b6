// A failure of an island (models/islands.h) in the program that it is a part of. The island was
// searched with any timing of the others; here they are given the statements that this timing
// needs. Deterministic; not thread-safe. Tested by tests/explore/island_search_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "explore/models/card_model.h"

namespace oncard::explore {

/// In the way through an island: the others take what is left of the cycle.
inline constexpr uint8_t kOthersEndCycle = 0xff;

/// The threads of a schedule of the whole program that fails, numbered by it: that of the way
/// through the island, whose threads are the bits of `threads`. Empty if the others cannot cause
/// this timing, or not as they were tried: each cycle the one with the lowest number first. `stop`
/// as for StateLimits.
std::vector<uint8_t> FailInWhole(CardModel* whole, CardModel* island, uint32_t threads,
                                 const std::vector<uint8_t>& way, const std::atomic<bool>* stop);

}  // namespace oncard::explore
