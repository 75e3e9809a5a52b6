// GT_Home: begins at the next tick, and then is a sequence of the motion core
// (motion/homing_sequence.h). Source: GT manual chapter 11; the stages are an assumption. Tested by
// tests/gtcalls/gt400/home_command_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"

namespace oncard::gtcalls::gt400 {

/// An axis at rest searches its home switch from the next tick on, on the way to `bound`.
void TakeHoming(Card& card, size_t axis, int32_t bound);
/// In the tick: searches that were taken begin.
void BeginTakenHomings(Card& card);

}  // namespace oncard::gtcalls::gt400
