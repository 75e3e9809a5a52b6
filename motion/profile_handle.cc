#include "motion/profile_handle.h"

#include "motion/crd_driver.h"
#include "motion/origins.h"

namespace oncard::motion {

void ProfileHandle::Start() const {
  if (const Master* master = profile().SelectedMaster(); master != nullptr) {
    MotionState& state = core_.Changed();
    return state.profiles[index_].StartSlave(core_.readings().ValueOf(*master));
  }
  core_.block.ShowProfile(index_);
  profile().Start(core_.now());
  if (core_.block.loaded()) core_.block.TakeStart(index_);
}

void ProfileHandle::Stop(bool abrupt) const {
  MotionState& state = core_.Changed();
  Profile& stopped = state.profiles[index_];
  for (size_t i = 0; i < kCrdCount && stopped.driven; ++i) {
    if (state.crds[i].Drives(index_)) CrdDriver(core_, i).StopFor(index_, abrupt);
  }
  if (stopped.driven) return;
  if (abrupt) {
    stopped.Stop(core_.now(), stopped.abrupt_stop);
  } else {
    stopped.StopSmoothly(core_.now());
  }
}

void ProfileHandle::StopWith(double deceleration) const {
  core_.Changed().profiles[index_].Stop(core_.now(), deceleration);
}

void ProfileHandle::SelectMode(ProfileMode mode) const {
  MotionState& state = core_.Changed();
  for (size_t i = 0; i < kCrdCount; ++i) {
    if (state.crds[i].map && state.crds[i].HasMember(index_)) CrdDriver(core_, i).LeaveMap(index_);
  }
  state.profiles[index_].mode = mode;
}

void ProfileHandle::SetPosition(double position) const {
  Origins(core_.Changed(), core_.config).SetProfilePosition(index_, position);
}

void ProfileHandle::SetStopDecelerations(double smooth, double abrupt) const {
  profile().smooth_stop = smooth;
  profile().abrupt_stop = abrupt;
}

void ProfileHandle::SetVelocity(double velocity) const {
  Profile& set = profile();
  (set.mode == ProfileMode::kTrap ? set.trap.velocity : set.jog.velocity) = velocity;
}

void ProfileHandle::ReserveReplanning() const { profile().trap.past.reserve(4 * Plan::kPieceMax); }

}  // namespace oncard::motion
