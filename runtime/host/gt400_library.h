// What others need of the host library for GT400 cards: how many cards there are. Tested by
// tests/families/gt400/gt400_family_test.cc.
#pragma once

namespace oncard::runtime {

/// The number of open cards; they are numbered from 0. The caller holds the lock of card 0.
int OpenGt400Cards();

}  // namespace oncard::runtime
