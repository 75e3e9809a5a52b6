#include "motion/homing.h"

#include "motion/common/state_hash.h"

namespace oncard::motion {
namespace {

static_assert(kFieldsComplete<HomeParameters> && kFieldsComplete<Homing> &&
              kFieldsComplete<HomeBound>);

}  // namespace

bool SearchesLimit(HomeMode mode) {
  return mode >= HomeMode::kLimit && mode <= HomeMode::kLimitHomeIndex;
}

bool SearchesHome(HomeMode mode) {
  return mode == HomeMode::kLimitHome || mode == HomeMode::kLimitHomeIndex ||
         mode == HomeMode::kHome || mode == HomeMode::kHomeIndex || IsForced(mode);
}

bool SearchesIndex(HomeMode mode) {
  return mode == HomeMode::kLimitIndex || mode == HomeMode::kLimitHomeIndex ||
         mode == HomeMode::kHomeIndex || mode == HomeMode::kIndex ||
         mode == HomeMode::kForcedHomeIndex;
}

bool IsForced(HomeMode mode) {
  return mode == HomeMode::kForcedHome || mode == HomeMode::kForcedHomeIndex;
}

HomeError CheckHoming(const Profile& profile, const Axis& axis, HomeMode mode) {
  if (profile.mode != ProfileMode::kTrap) return HomeError::kNotTrap;
  if (!axis.servo_on) return HomeError::kDisabled;
  if ((axis.latched & kAlarmBit) != 0) return HomeError::kAlarm;
  return mode == HomeMode::kNone ? HomeError::kMode : HomeError::kNone;
}

}  // namespace oncard::motion
