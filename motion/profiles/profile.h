// A profile: one profile generator of the card, in its selected mode.
//
// Each mode is a structure of its own with the registers that commands write and the run that
// Start() begins; all keep their registers when another mode is selected. A stop (GT_Stop, a limit,
// an alarm) replaces the current motion and decelerates from the last velocity. Tested by
// tests/motion/profile_test.cc.
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
  /// The output of the last tick, as changed by commands since then.
  Sample now;
  /// True if a coordinate system writes the output, of a member or of a BufGear axis.
  bool driven = false;
  double smooth_stop = kSmoothStopDefault;
  double abrupt_stop = kAbruptStopDefault;

  TrapMode trap;
  JogMode jog;
  GearMode gear;
  FollowMode follow;
  PtMode pt;
  PvtMode pvt;

  /// A stop in progress, which replaces the mode's run.
  bool stopping = false;
  double stop_deceleration = 0;
  Micros stop_begin = 0;
  Plan stop_plan;

  /// Begins a run of an independent mode with the values of its registers.
  void Start(Micros instant);
  /// Begins to follow the master of Gear, or of Follow with one of its FIFOs.
  void StartGear(const MasterValue& master);
  void StartFollow(uint8_t fifo, const MasterValue& master);
  /// The master of the current run; nullptr if it has none.
  const Master* FollowedMaster() const {
    if (mode != ProfileMode::kGear && mode != ProfileMode::kFollow) return nullptr;
    if (!now.moving || stopping || driven) return nullptr;
    return mode == ProfileMode::kGear ? &gear.master : &follow.master;
  }
  /// Decelerates to rest; a stop in progress is only replaced by a faster one. Does nothing at
  /// rest.
  void Stop(Micros instant, double deceleration);
  /// The output at `instant`, from the stop or from the mode's run.
  void Advance(Micros instant);
  /// The same for a profile with a FollowedMaster().
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
