// Registers that wait for an Update, and what an Update does: the values become valid together, a
// waiting command acts, and the motion is planned anew. GT_Update and GT_MltiUpdt act at the next
// tick; breakpoints and background commands in the tick that they belong to. Source: GT manual
// 4.1, 4.3. Tested by tests/gtcalls/gt400/update_command_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/message.h"
#include "gtcalls/card.h"

namespace oncard::gtcalls::gt400 {

enum class RegisterKind : uint8_t {
  kMotion,  ///< an Update begins or replans a motion because it has been written
  kServo,   ///< of the servo controller, which only SV cards have
  kOther
};

/// The bits of UpdateRequest::written.
enum class Register : uint8_t {
#define REGISTER(name, ...) k##name,
#include "gtcalls/gt400/registers.def"
};

constexpr uint16_t BitOf(Register which) {
  return static_cast<uint16_t>(1u << static_cast<unsigned>(which));
}

/// The Update of the axes of a mask takes effect at the next tick, with what waits now. If one axis
/// cannot be updated, none is: returns why, and the waiting commands of all of them are forgotten,
/// or every later Update would be refused, too.
std::optional<Message> TakeUpdate(Card& card, uint32_t axes);
/// The same for an Update by the card itself, which takes effect at this instant.
std::optional<Message> UpdateAtOnce(Card& card, uint32_t axes);
/// In the tick: Updates that were taken take effect.
void ApplyTakenUpdates(Card& card);

}  // namespace oncard::gtcalls::gt400
