// A profile: what one profile generator of the card plans, in the mode that is chosen for it.
//
// Each mode is a structure of its own with the registers that commands write and the run that
// Start() begins; all keep their registers when another mode is chosen. A stop (GT_Stop, a limit,
// an alarm) takes over from whatever runs, decelerating from the velocity that came out last.
// Tested by tests/motion/profile_test.cc.
#pragma once

#include <cstdint>
#include <tuple>

#include "motion/common/sample.h"
#include "motion/common/sizes.h"
#include "motion/profiles/follow_mode.h"
#include "motion/profiles/gear_mode.h"
#include "motion/profiles/jog_mode.h"
#include "motion/profiles/master.h"
#include "motion/profiles/plan.h"
#include "motion/profiles/pt_mode.h"
#include "motion/profiles/pvt_mode.h"
#include "motion/profiles/trap_mode.h"

namespace oncard::motion {

/// Numbered as GT_GetPrfMode gives them.
enum class ProfileMode : uint8_t { kTrap, kJog, kPt, kGear, kFollow, kCrd, kPvt };

/// GT_SetStopDec, pulse/ms^2 (defaults of the GTS manual 4.4).
inline constexpr double kSmoothStopDefault = 1;
inline constexpr double kAbruptStopDefault = 1000;

struct Profile {
  bool active = true;  ///< configuration: an inactive profile plans nothing
  ProfileMode mode = ProfileMode::kTrap;
  /// What came out at the last tick, and what a command since has made of it.
  Sample now;
  /// A coordinate system writes the output, as a member's or as a BufGear axis'.
  bool driven = false;
  double smooth_stop = kSmoothStopDefault;
  double abrupt_stop = kAbruptStopDefault;

  TrapMode trap;
  JogMode jog;
  GearMode gear;
  FollowMode follow;
  PtMode pt;
  PvtMode pvt;

  /// A stop under way: it replaces the mode's run.
  bool stopping = false;
  double stop_deceleration = 0;
  Micros stop_begin = 0;
  Plan stop_plan;

  /// Begins the run of an independent mode with its registers.
  void Start(Micros instant);
  /// Begins to follow the master of Gear, or of Follow with one of its FIFOs.
  void StartGear(const MasterValue& master);
  void StartFollow(uint8_t fifo, const MasterValue& master);
  /// The master of the mode's run; nullptr when it has none.
  const Master* FollowedMaster() const;
  /// Decelerates to rest; an own stop under way is only replaced by a faster one. Resting profiles
  /// stay as they are.
  void Stop(Micros instant, double deceleration);
  /// The output at `instant`: of the stop, or of the mode's run.
  void Advance(Micros instant);
  /// The same of a profile with a FollowedMaster().
  void AdvanceSlave(const MasterValue& master);
  /// Sets the position of a profile at rest.
  void SetPosition(double position) { now = AtRest(position); }

  auto Fields() const {
    return std::tie(active, mode, now, driven, smooth_stop, abrupt_stop, trap, jog, gear, follow,
                    pt, pvt, stopping, stop_deceleration, stop_begin, stop_plan);
  }

 private:
  void HaltMode();
  Sample SampleMode(Micros instant);
};

}  // namespace oncard::motion
