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

/// Why an Update of the axis would be refused now; nothing if it would not.
std::optional<Message> WhyNoUpdate(const CardView& card, size_t axis);
/// Forgets the waiting commands after a refusal, or every later Update would be refused, too.
void DropWaitingCommands(Card& card, size_t axis);
/// The Update of an axis takes effect at the next tick, with what waits now.
void TakeUpdate(Card& card, size_t axis);
/// In the tick: Updates that were taken take effect.
void ApplyTakenUpdates(Card& card);
/// An Update by the card itself takes effect at this instant, or is refused.
void UpdateAtOnce(Card& card, size_t axis);

}  // namespace oncard::gtcalls::gt400
