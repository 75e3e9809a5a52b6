#include "gtcalls/card_elements.h"

namespace oncard::gtcalls {

size_t CrdDimension(const Card&, double) { return 0; }

size_t ElementsOnCard(const Parameter& parameter, const Card& card, double first) {
  if (parameter.per_dimension) return CrdDimension(card, first);
  return 1;
}

}  // namespace oncard::gtcalls
