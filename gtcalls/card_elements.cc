#include "gtcalls/card_elements.h"

namespace oncard::gtcalls {

size_t CrdDimension(const Card& card, double crd) {
  for (size_t i = 0; i < motion::kCrdCount; ++i) {
    if (crd == static_cast<double>(i + 1)) return card.motion.state().crds[i].dimension();
  }
  return 0;
}

size_t ElementsOnCard(const Parameter& parameter, const Card& card, double first) {
  if (parameter.per_dimension) return CrdDimension(card, first);
  return 1;
}

}  // namespace oncard::gtcalls
