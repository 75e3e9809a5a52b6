// A profile of a card, for those who command it: its registers, its start and its stop.
//
// Selecting a mode, setting a position and the registers of a mode are for a profile at rest unless
// the mode says otherwise. No cycle reads the velocity, the target and the parameters of modes
// Trap, Jog and S, or the decelerations of a stop: they can be set at any time and act with the
// next start or stop, and the card stays in its lanes. Tested by tests/motion/handles_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "motion/core_parts.h"

namespace oncard::motion {

class ProfileHandle {
 public:
  ProfileHandle(CoreParts core, size_t profile) : core_(core), index_(profile) {}

  /// Begins the run of its mode (GT_Update, GT_GearStart ...), which must not be Crd.
  void Start() const;
  /// Stops it with a deceleration of its registers; if it belongs to a coordinate system, the whole
  /// system stops.
  void Stop(bool abrupt) const;
  /// Stops it with this deceleration; it must not belong to a coordinate system that runs.
  void StopWith(double deceleration) const;

  /// Configuration: an inactive profile plans nothing.
  void SetActive(bool active) const { core_.Changed().profiles[index_].active = active; }
  /// Selects a mode. An axis that is mapped to a path leaves the map.
  void SelectMode(ProfileMode mode) const;
  /// Sets its position; the axes keep theirs.
  void SetPosition(double position) const;
  /// GT_SetStopDec, pulse/ms^2 > 0.
  void SetStopDecelerations(double smooth, double abrupt) const;

  /// Sets the velocity of mode Trap or, in any other mode, of mode Jog (GT_SetVel).
  void SetVelocity(double velocity) const;
  /// Sets the target of mode Trap (GT_SetPos).
  void SetTarget(int32_t target) const { profile().trap.target = target; }
  void SetParameters(const TrapParameters& parameters) const {
    profile().trap.parameters = parameters;
  }
  void SetParameters(const JogParameters& parameters) const {
    profile().jog.parameters = parameters;
  }
  /// Sets what mode S keeps within, and its target.
  void SetSCurve(const JerkLimits& limits, int32_t target) const {
    profile().s_curve.limits = limits;
    profile().s_curve.target = target;
  }
  /// Makes room for what a smoothed motion of mode Trap keeps when it is replanned, so that a cycle
  /// can replan it without allocating.
  void ReserveReplanning() const;

  // The registers of the modes that have tables, buffers or masters. Their classes say what may be
  // changed during a run.
  PtMode& pt() const { return core_.Changed().profiles[index_].pt; }
  PvtMode& pvt() const { return core_.Changed().profiles[index_].pvt; }
  GearMode& gear() const { return core_.Changed().profiles[index_].gear; }
  WheelMode& wheel() const { return core_.Changed().profiles[index_].wheel; }
  FollowMode& follow() const { return core_.Changed().profiles[index_].follow; }

 private:
  Profile& profile() const { return core_.state.profiles[index_]; }

  CoreParts core_;
  size_t index_;
};

}  // namespace oncard::motion
