// The motion core's part of a gantry. While the gantry is on, the slave axis is mapped to the
// profiles of the master, so that stops and limits of either axis act on the profiles of both.
// Tested by tests/motion/gantry_test.cc.
#include "motion/gantry.h"

#include <cmath>

#include "motion/common/state_hash.h"
#include "motion/motion_core.h"

namespace oncard::motion {

static_assert(kFieldsComplete<Gantry>);

void MotionCore::EnableGantry(size_t master, size_t slave, double master_kp, double slave_kp) {
  const Axis& leader = state_.axes[master];
  Axis& follower = state_.axes[slave];
  state_.gantry = {.on = true,
                   .master = static_cast<uint8_t>(master),
                   .slave = static_cast<uint8_t>(slave),
                   .master_kp = master_kp,
                   .slave_kp = slave_kp,
                   .error_limit = state_.gantry.error_limit,
                   .skew_origin = follower.encoder.position - leader.encoder.position,
                   .slave_map = follower.profile_map,
                   .slave_scale = follower.profile_scale};
  follower.profile_map = leader.profile_map;
  follower.profile_scale = leader.profile_scale;
  follower.profile.offset = follower.profile.position - MappedProfiles(follower);
}

void MotionCore::DisableGantry() {
  if (!state_.gantry.on) return;
  Axis& follower = state_.axes[state_.gantry.slave];
  follower.profile_map = state_.gantry.slave_map;
  follower.profile_scale = state_.gantry.slave_scale;
  follower.profile.offset = follower.profile.position - MappedProfiles(follower);
  state_.gantry.on = false;
}

void MotionCore::StopCommanded(size_t profile, bool abrupt) {
  StopProfile(profile, abrupt);
  if (IsGantrySlave(profile)) StopAxis(state_.axes[profile], abrupt);
}

double MotionCore::GantrySkew() const {
  const Gantry& gantry = state_.gantry;
  return state_.axes[gantry.slave].encoder.position - state_.axes[gantry.master].encoder.position -
         gantry.skew_origin;
}

double MotionCore::GantryCorrection(size_t axis) const {
  const Gantry& gantry = state_.gantry;
  if (axis == gantry.master) return gantry.master_kp * GantrySkew();
  return axis == gantry.slave ? -gantry.slave_kp * GantrySkew() : 0;
}

void MotionCore::JudgeGantry() {
  const Gantry& gantry = state_.gantry;
  if (!state_.axes[gantry.master].servo_on && !state_.axes[gantry.slave].servo_on) return;
  if (std::fabs(GantrySkew()) <= gantry.error_limit) return;
  Tell(HappeningKind::kGantrySkew, gantry.master, GantrySkew(), gantry.error_limit);
  for (const size_t axis : {size_t{gantry.master}, size_t{gantry.slave}}) {
    state_.axes[axis].latched |= kFollowingErrorBit;
    if (config_.defaults.following_error_stops) ServoOff(axis);
  }
}

}  // namespace oncard::motion
