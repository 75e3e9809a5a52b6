// Text for what a card does by itself (motion/happening.h), for logs:
//
//   axis 1 passed its positive soft limit 2000 at 2012.5 and stops
//
// Axes and coordinate systems count from 1, as in commands.
// Tested by tests/runtime/happening_text_test.cc.
#pragma once

#include "base/message.h"
#include "gtcalls/family.h"
#include "motion/happening.h"

namespace oncard::runtime {

/// What happened, in both languages; `commands` are those of the card's family. Pure.
Message DescribeHappening(const motion::Happening& happening,
                          const gtcalls::AdvisedCommands& commands);

}  // namespace oncard::runtime
