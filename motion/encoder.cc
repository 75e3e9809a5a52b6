#include "motion/encoder.h"

#include "motion/common/state_hash.h"

namespace oncard::motion {

static_assert(kFieldsComplete<Encoder> && kFieldsComplete<EncoderFault>);

int32_t EncoderFault::NextError() {
  random += 0x9E3779B97F4A7C15u;
  uint64_t bits = random;
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
  bits ^= bits >> 31;
  const auto values = 2 * static_cast<uint64_t>(noise) + 1;
  return static_cast<int32_t>((bits >> 32) * values >> 32) - noise;
}

}  // namespace oncard::motion
