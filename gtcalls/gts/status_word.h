// The status word of a GTS axis, as GT_GetSts, results and traces show it. The only place that
// knows its bits. Source: GTS manual chapter 6 and the description of GT_GetSts in its chapter 13.
// Tested by tests/gtcalls/status_word_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gtcalls/card.h"

namespace oncard::gtcalls::gts {

/// The status word now; the axis counts from 0.
uint32_t StatusWord(const CardView& card, size_t axis);

}  // namespace oncard::gtcalls::gts
