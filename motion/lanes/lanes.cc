#include "motion/lanes/lanes.h"

#include <array>
#include <cstdint>

#define LANE_SET portable
#define LANE_TARGET
#define LANE_WIDTH 2
#include "motion/lanes/lane_kernel.inc"
#undef LANE_SET
#undef LANE_TARGET
#undef LANE_WIDTH

#if defined(__x86_64__)
#define LANE_SET avx2
#define LANE_TARGET [[gnu::target("avx2")]]
#define LANE_WIDTH 4
#include "motion/lanes/lane_kernel.inc"
#undef LANE_SET
#undef LANE_TARGET
#undef LANE_WIDTH
#endif

namespace oncard::motion {

std::span<const NamedLaneKernel> LaneKernels() {
#if defined(__x86_64__)
  static constexpr std::array<NamedLaneKernel, 2> kKernels = {
      {{"AVX2", avx2::Run}, {"SSE2", portable::Run}}};
  return std::span(kKernels).subspan(__builtin_cpu_supports("avx2") != 0 ? 0 : 1);
#else
  static constexpr std::array<NamedLaneKernel, 1> kKernels = {{{"portable", portable::Run}}};
  return kKernels;
#endif
}

}  // namespace oncard::motion
