// All that a coordinate system may see and do of its card: it writes profiles, and its buffered
// commands act on outputs, inputs and registers. Tested by tests/motion/crd_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/card_event.h"
#include "motion/core_parts.h"

namespace oncard::motion {

class CrdPort {
 public:
  CrdPort(CoreParts core, size_t crd) : core_(core), index_(crd) {}

  const CardDefaults& defaults() const { return core_.config.defaults; }
  int64_t cycle_us() const { return core_.config.cycle_us; }
  Micros now() const { return core_.now(); }
  /// Lanes may hold newer values of the profiles until LeaveLanes().
  void LeaveLanes() const { core_.block.Leave(); }
  std::array<Profile, kAxisMax>& profiles() const { return core_.state.profiles; }
  Profile& profile(int32_t index) const { return profiles()[static_cast<size_t>(index)]; }
  /// Executes a command that acts outside the path and its profiles: not those that wait, and not
  /// GT_BufMove and GT_BufGear.
  void CarryOut(const BufferedCommand& command);
  /// True if somebody is told what happens.
  bool observed() const { return core_.observer != nullptr; }
  void Tell(CardEventKind kind, double value, double bound = 0) const {
    if (observed()) core_.observer({kind, index_, value, bound});
  }
  /// Tells of an axis that the profile begins to move while the drive is off; `kind`: kMovedBy...
  void TellDriveOff(CardEventKind kind, int32_t profile) const;

 private:
  CoreParts core_;
  size_t index_;
};

}  // namespace oncard::motion
