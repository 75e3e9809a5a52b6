#include "motion/input_shaper.h"

#include <algorithm>

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<CommandedMotion> && kFieldsComplete<InputShaper>);

}  // namespace

void InputShaper::Set(size_t count, double new_k, const CommandedMotion& command) {
  k = new_k;
  past.assign(count, {command.position, 0, 0});
  last = command;
  unsettled = 0;
  addition = {};
}

void InputShaper::Advance(int64_t cycle, const CommandedMotion& command) {
  if (command != last) {
    unsettled = static_cast<uint32_t>(past.size());
    last = command;
  } else if (unsettled == 0) {
    return;
  } else {
    --unsettled;
  }
  CommandedMotion& delayed = past[static_cast<size_t>(cycle) % past.size()];
  // The difference is exactly 0 when both commands are equal, so that no rounding error remains.
  const double weight = k / (1 + k);
  addition = {weight * (delayed.position - command.position),
              weight * (delayed.velocity - command.velocity),
              weight * (delayed.acceleration - command.acceleration)};
  delayed = command;
}

void InputShaper::Restart(const CommandedMotion& command) {
  if (settled() && command == last) return;
  Set(past.size(), k, command);
}

void InputShaper::Rename(double position) {
  for (CommandedMotion& command : past) {
    // Equal positions stay equal.
    command.position = command.position == last.position
                           ? position
                           : command.position + (position - last.position);
  }
  last.position = position;
}

}  // namespace oncard::motion
