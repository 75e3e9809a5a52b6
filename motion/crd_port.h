// All that a coordinate system may see and do of its card: it writes profiles, and its buffered
// commands act on outputs, inputs and registers. Tested by tests/motion/crd_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/card_event.h"
#include "motion/cycle_block.h"
#include "motion/motion_state.h"

namespace oncard::motion {

class CrdPort {
 public:
  /// `block` may have parts of the state in lanes.
  CrdPort(MotionState& state, const MotionConfig& config, const CardEventObserver& observer,
          size_t index, CycleBlock& block)
      : state_(state), config_(config), observer_(observer), index_(index), block_(block) {}

  const CardDefaults& defaults() const { return config_.defaults; }
  Micros now() const { return state_.cycle * config_.cycle_us; }
  std::array<Profile, kAxisMax>& profiles() const { return state_.profiles; }
  Profile& profile(int32_t index) const { return state_.profiles[static_cast<size_t>(index)]; }
  /// Executes a command that acts outside the path and its profiles: not those that wait, and not
  /// GT_BufMove and GT_BufGear.
  void CarryOut(const BufferedCommand& command);
  /// True if somebody is told what happens.
  bool observed() const { return observer_ != nullptr; }
  void Tell(CardEventKind kind, double value, double bound = 0) const {
    if (observer_) observer_({kind, index_, value, bound});
  }
  /// Tells of an axis that the profile begins to move while the drive is off.
  void TellDriveOff(int32_t profile) const;

 private:
  MotionState& state_;
  const MotionConfig& config_;
  const CardEventObserver& observer_;
  size_t index_;
  CycleBlock& block_;
};

}  // namespace oncard::motion
