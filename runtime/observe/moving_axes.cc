// Tested by tests/runtime/scenario_run_test.cc and supervisor_test.cc.
#include "runtime/observe/moving_axes.h"

namespace oncard::runtime {

uint32_t MovingAxes(const Controller& controller) {
  const motion::MotionCore& core = controller.motion();
  uint32_t moving = 0;
  for (size_t i = 0; i < core.axis_count(); ++i) {
    motion::ForEachBit(core.state().axes[i].profile_map, core.axis_count(), [&](size_t profile) {
      const motion::Profile& planned = core.state().profiles[profile];
      const bool rests = planned.now.velocity == 0 && planned.FollowedMaster() != nullptr;
      if (planned.now.moving && !rests) moving |= uint32_t{1} << i;
    });
  }
  return moving;
}

Message DescribeMovingAxis(const Controller& controller, size_t axis) {
  const motion::AxisValue& now = controller.motion().state().axes[axis].profile;
  return MakeMessage(
      "axis {0} still moves at the end of the run, at {1} ms: velocity {2:.6g} pulse/ms, "
      "position {3:.6g}",
      "运行在 {1} ms 结束时轴 {0} 仍在运动：速度 {2:.6g} pulse/ms，位置 {3:.6g}", axis + 1,
      controller.NowMs(), now.velocity, now.position);
}

}  // namespace oncard::runtime
