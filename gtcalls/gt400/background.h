// Background commands: what a driver lets a GT400 card do at an event interrupt, in the same tick,
// before the host hears of it. Source: GT manual 8.2.2; public header. Tested by
// tests/gtcalls/gt400/background_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/message.h"
#include "gtcalls/card.h"

namespace oncard::gtcalls::gt400 {

/// Why the memory is no set of background commands; nothing if it is one. `size` receives how much
/// of the memory the set has.
std::optional<Message> CheckBackgroundSet(std::span<const uint8_t> memory, size_t* size);

/// Executes the commands of the kinds that share an event with the word, if there is a set. The
/// axis that interrupts is the current one meanwhile.
void RunBackgroundSet(Card& card, size_t axis, uint16_t word);

}  // namespace oncard::gtcalls::gt400
