// In place of a card: the library of the test answers each call with the number of its command, and
// calls of a numbered card with the number below 0.
#include <span>

#include "runtime/host/host_api.h"

namespace oncard::runtime {

int16_t CallCard(int card, uint16_t number, std::span<const HostArgument> arguments) {
  const auto code = static_cast<int16_t>(arguments.size() * 1000 + number);
  return card == kSelectedCard ? code : static_cast<int16_t>(-code);
}

}  // namespace oncard::runtime
