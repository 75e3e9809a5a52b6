#include "gtcalls/ge/path_state.h"

#include "motion/common/state_hash.h"

namespace oncard::gtcalls::ges {
namespace {

static_assert(motion::kFieldsComplete<Path> && motion::kFieldsComplete<List> &&
              motion::kFieldsComplete<ListWords> && motion::kFieldsComplete<BetweenSegments> &&
              motion::kFieldsComplete<HandWheel> && motion::kFieldsComplete<LookAhead> &&
              motion::kFieldsComplete<VelocityTable>);

}  // namespace

void ListWords::Free(int32_t done) {
  for (; freed < done && !segments.empty(); ++freed) {
    used -= segments.front();
    segments.Pop();
  }
}

void ListWords::AddCommand(uint32_t words) {
  used += words;
  since_segment += words;
}

void ListWords::AddSegment(uint32_t words) {
  used += words;
  segments.Push(since_segment + words);
  since_segment = 0;
}

CornerPlanner MakeCornerPlanner(const CornerFigures& figures, size_t capacity) {
  motion::PathLimits limits;
  limits.rule = {motion::JointRule::kCorners, figures.acceleration_max};
  limits.corner_time = figures.time;
  CornerPlanner window;
  window.Emplace({.limits = limits, .capacity = capacity});
  return window;
}

}  // namespace oncard::gtcalls::ges
