// What the family keeps of an axis of a card.
#pragma once

#include <cstddef>

#include "gtcalls/card.h"
#include "gtcalls/gt400/gt400_state.h"

namespace oncard::gtcalls::gt400 {

inline Gt400Axis& AxisState(const Card& card, size_t axis) {
  return card.state<Gt400State>().axes[axis];
}
inline const Gt400Axis& AxisState(const CardView& card, size_t axis) {
  return card.state<Gt400State>().axes[axis];
}

}  // namespace oncard::gtcalls::gt400
