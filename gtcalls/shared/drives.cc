#include "gtcalls/shared/drives.h"

#include <limits>

namespace oncard::gtcalls {

bool HasVoltages(const motion::MotionCore& core) { return core.config().defaults.closed_loop; }

void SwitchOutput(size_t axis, bool analogue, bool open_loop, motion::MotionCore& core) {
  // A drive that follows a voltage takes no pulses.
  core.StepAt(axis).SetActive(!(analogue && open_loop));
  core.AxisAt(axis).SetClosedLoop(analogue && !open_loop);
}

void LimitFollowingError(size_t axis, uint16_t limit, motion::MotionCore& core) {
  constexpr int64_t kNever = std::numeric_limits<int64_t>::max();
  core.ControlAt(axis).SetErrorLimit(core.InClosedLoop(axis) ? limit : kNever);
}

void PlaceAxisAt(size_t axis, int32_t position, motion::MotionCore& core) {
  core.ProfileAt(axis).SetPosition(position);
  core.EncoderAt(axis).SetPosition(position);
  core.AxisAt(axis).SynchPosition();
}

}  // namespace oncard::gtcalls
