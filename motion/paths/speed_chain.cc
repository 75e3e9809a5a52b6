#include "motion/paths/speed_chain.h"

#include "motion/common/state_hash.h"

namespace oncard::motion {

static_assert(kFieldsComplete<SpeedChain> && kFieldsComplete<SpeedLink>);

void SpeedChain::Push(const SpeedLink& link) {
  back_total = back.empty() ? link : back_total.After(link);
  back.push_back(link);
}

void SpeedChain::Pop() {
  if (front.empty()) {
    for (size_t i = back.size(); i-- > 0;) {
      front.push_back(front.empty() ? back[i] : back[i].After(front.back()));
    }
    back.clear();
  }
  front.pop_back();
}

double SpeedChain::SpeedSquare() const {
  const double behind = back.empty() ? 0 : back_total.At(0);
  return front.empty() ? behind : front.back().At(behind);
}

}  // namespace oncard::motion
