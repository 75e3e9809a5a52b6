#include "gtcalls/ge/path_state.h"

#include "motion/common/state_hash.h"

namespace oncard::gtcalls::ges {
namespace {

static_assert(motion::kFieldsComplete<Path> && motion::kFieldsComplete<List> &&
              motion::kFieldsComplete<BetweenSegments> && motion::kFieldsComplete<HandWheel> &&
              motion::kFieldsComplete<LookAhead> && motion::kFieldsComplete<VelocityTable>);

}  // namespace

CornerPlanner MakeCornerPlanner(const CornerFigures& figures, size_t capacity) {
  motion::PathLimits limits;
  limits.rule = {motion::JointRule::kCorners, figures.acceleration_max};
  limits.corner_time = figures.time;
  CornerPlanner window;
  window.Emplace({.limits = limits, .capacity = capacity});
  return window;
}

}  // namespace oncard::gtcalls::ges
