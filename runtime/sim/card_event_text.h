// Text for what a card does by itself (motion/card_event.h), for logs:
//
//   axis 1 passed its positive soft limit 2000 at 2012.5 and stops
//
// Axes and coordinate systems count from 1, as in commands.
// Tested by tests/runtime/card_event_text_test.cc.
#pragma once

#include "base/message.h"
#include "gtcalls/family.h"
#include "motion/card_event.h"

namespace oncard::runtime {

/// What happened, in both languages; `commands` are those of the card's family. Pure.
Message DescribeCardEvent(const motion::CardEvent& event, const gtcalls::AdvisedCommands& commands);

}  // namespace oncard::runtime
