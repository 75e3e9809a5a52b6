// Internal to gtcalls: where commands of GE cards change the state of the motion core directly.
#pragma once

#include <cstddef>

#include "gtcalls/card.h"

namespace oncard::gtcalls::ge {

inline motion::Axis& ChangeAxis(Card& card, size_t axis) { return card.motion.state().axes[axis]; }
inline motion::Profile& ChangeProfile(Card& card, size_t axis) {
  return card.motion.state().profiles[axis];
}
inline motion::Control& ChangeControl(Card& card, size_t axis) {
  return card.motion.state().controls[axis];
}
inline motion::Dac& ChangeDac(Card& card, size_t axis) { return card.motion.state().dacs[axis]; }
inline motion::Step& ChangeStep(Card& card, size_t axis) { return card.motion.state().steps[axis]; }
inline motion::DigitalIo& ChangeIo(Card& card) { return card.motion.state().io; }
inline motion::CaptureUnit& ChangeCaptures(Card& card) { return card.motion.state().capture; }

}  // namespace oncard::gtcalls::ge
