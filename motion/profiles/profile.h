// A profile: one profile generator of the card, in its selected mode.
//
// Each mode is a structure of its own (modes.h); all keep their registers when another mode is
// selected. A stop (GT_Stop, a limit, an alarm) replaces the current motion and decelerates from
// the last velocity. Tested by tests/motion/profile_test.cc.
#pragma once

#include <cstdint>
#include <utility>

#include "motion/common/card_defaults.h"
#include "motion/common/sample.h"
#include "motion/common/sizes.h"
#include "motion/profiles/master.h"
#include "motion/profiles/modes.h"
#include "motion/profiles/plan.h"

namespace oncard::motion {

struct Profile {
  bool active = true;  ///< configuration: an inactive profile plans nothing
  ProfileMode mode = ProfileMode::kTrap;
  /// The output of the last tick, as changed by commands since then.
  Sample now;
  /// True if a coordinate system writes the output, of a member or of a BufGear axis.
  bool driven = false;
  double smooth_stop = CardDefaults{}.smooth_stop;
  double abrupt_stop = CardDefaults{}.abrupt_stop;

#define PROFILE_MODE(enumerator, number, name, member, Class) Class member;
#include "motion/profiles/modes.def"

  /// A stop in progress, which replaces the mode's run.
  bool stopping = false;
  double stop_deceleration = 0;
  Micros stop_begin = 0;
  Plan stop_plan;

  /// Begins a run of an independent mode with the values of its registers.
  void Start(Micros instant);
  /// The same of a mode that follows a master.
  void StartSlave(const MasterValue& master);
  /// The master of the selected mode; nullptr if the mode has none.
  const Master* SelectedMaster() const;
  /// The master of the current run; nullptr if it has none.
  const Master* FollowedMaster() const {
    return !now.moving || stopping || driven ? nullptr : SelectedMaster();
  }
  /// The position of the followed master has been changed by `shift` without motion.
  void ShiftMaster(double shift);
  /// Decelerates to rest; with an infinite deceleration it rests at once, in the same cycle. A stop
  /// in progress is only replaced by a faster one. Does nothing at rest.
  void Stop(Micros instant, double deceleration);
  /// Holds a slave that stays engaged at limits (DirectRatio). Returns false for all other motion.
  bool HoldAtLimit();
  /// Stops as the mode plans it (S), or else with the deceleration `smooth_stop`.
  void StopSmoothly(Micros instant);
  /// The output at `instant`, from the stop or from the mode's run.
  void Advance(Micros instant);
  /// The same for a profile with a FollowedMaster().
  void AdvanceSlave(const MasterValue& master);
  /// The plan that the output follows directly from the returned instant on, for a profile that
  /// moves without a master; nullptr if the output is computed otherwise.
  std::pair<const Plan*, Micros> FollowedPlan() const;
  /// Without what is left of stops, and of runs in the mode Trap, that have ended. Nothing reads it
  /// any more, so that profiles which differ only in it go on equally.
  void ForgetRuns();
  /// Sets the position of a profile at rest.
  void SetPosition(double position) { now = AtRest(position); }

  auto Fields(auto visit) const {
    return visit(active, mode, now, driven, smooth_stop, abrupt_stop,
#define PROFILE_MODE(enumerator, number, name, member, Class) member,
#include "motion/profiles/modes.def"
                 stopping, stop_deceleration, stop_begin, stop_plan);
  }
};

/// Calls `visit` with the structure of a profile's selected mode; does nothing if it has none.
template <typename SomeProfile, typename Visit>
void VisitSelected(SomeProfile& profile, Visit visit) {
  switch (profile.mode) {
#define PROFILE_MODE(enumerator, number, name, member, Class) \
  case ProfileMode::enumerator:                               \
    visit(profile.member);                                    \
    break;
#define WRITTEN_MODE(enumerator, ...) \
  case ProfileMode::enumerator:       \
    break;
#include "motion/profiles/modes.def"
  }
}

inline const Master* Profile::SelectedMaster() const {
  const Master* master = nullptr;
  VisitSelected(*this, [&]<typename Mode>(const Mode& selected) {
    if constexpr (SlaveMode<Mode>) master = &selected.master;
  });
  return master;
}

}  // namespace oncard::motion
