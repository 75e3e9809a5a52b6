#include "motion/gantry.h"

#include <cmath>

#include "motion/common/state_hash.h"

namespace oncard::motion {

static_assert(kFieldsComplete<Gantry>);

void Gantry::Begin(size_t new_master, size_t new_slave, double new_master_kp, double new_slave_kp,
                   std::span<Axis> axes) {
  const Axis& leader = axes[new_master];
  Axis& follower = axes[new_slave];
  *this = {.on = true,
           .master = static_cast<uint8_t>(new_master),
           .slave = static_cast<uint8_t>(new_slave),
           .master_kp = new_master_kp,
           .slave_kp = new_slave_kp,
           .error_limit = error_limit,
           .skew_origin = follower.encoder.position - leader.encoder.position,
           .slave_map = follower.profile_map,
           .slave_scale = follower.profile_scale};
  follower.profile_map = leader.profile_map;
  follower.profile_scale = leader.profile_scale;
}

void Gantry::End(std::span<Axis> axes) {
  axes[slave].profile_map = slave_map;
  axes[slave].profile_scale = slave_scale;
  on = false;
}

double Gantry::Skew(std::span<const Axis> axes) const {
  return axes[slave].encoder.position - axes[master].encoder.position - skew_origin;
}

double Gantry::Correction(size_t axis, std::span<const Axis> axes) const {
  if (axis == master) return master_kp * Skew(axes);
  return axis == slave ? -slave_kp * Skew(axes) : 0;
}

bool Gantry::Exceeded(std::span<const Axis> axes) const {
  if (!axes[master].servo_on && !axes[slave].servo_on) return false;
  return !(std::fabs(Skew(axes)) <= error_limit);
}

}  // namespace oncard::motion
