// Tested by tests/runtime/scenario_run_test.cc and tests/tools/exec_command_test.cc.
#include "runtime/observe/moving_axes.h"

#include <bit>

namespace oncard::runtime {

uint32_t MovingAxes(const Controller& controller) {
  const auto count = static_cast<size_t>(controller.options().motion.axis_count);
  uint32_t moving = 0;
  for (size_t axis = 0; axis < count; ++axis) {
    if ((controller.motion().Conditions(axis) & motion::kMovingBit) != 0) moving |= 1u << axis;
  }
  return moving;
}

std::vector<Message> DescribeMovingAxes(const Controller& controller) {
  const motion::MotionCore& core = controller.motion();
  std::vector<Message> texts;
  for (uint32_t moving = MovingAxes(controller); moving != 0; moving &= moving - 1) {
    const auto axis = static_cast<size_t>(std::countr_zero(moving));
    const motion::AxisValue& now = core.state().axes[axis].profile;
    texts.push_back(MakeMessage(
        "axis {0} still moves at the end of the run, at {1} ms: velocity {2:.6g} pulse/ms, "
        "position {3:.6g}",
        "运行在 {1} ms 结束时轴 {0} 仍在运动：速度 {2:.6g} pulse/ms，位置 {3:.6g}", axis + 1,
        controller.NowMs(), now.velocity, now.position));
  }
  return texts;
}

}  // namespace oncard::runtime
