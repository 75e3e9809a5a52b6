// Homing: state machines that drive a profile in mode Trap and the capture of the same number, one
// for each axis, all independent. They write the registers of the mode, and start and stop it, as a
// program would.
//
// Smart homing (GT_GoHome) has nine modes. A limit search moves at the high velocity until the
// limit; kLimit then leaves it by the escape step and returns at the low velocity: the position
// where the limit becomes active again is the origin. In other modes the axis then reverses to
// search for the home switch, or searches for the index pulse. A home switch is searched at the
// high velocity with its capture armed; an index pulse at the low one. The end is at the captured
// position plus the offset; no position is set to 0.
//
// Simple homing (GT_Home, GT_HomeStop) moves towards a position until the capture triggers.
// GT_Index before it adds a search for the index pulse, from where GT_Home would end. A search
// within a bound leaves the switch first, returns to where it has found it, and searches the index
// pulse from there on the same way, all at one velocity.
//
// A captured position is one of an encoder. The profile position that returns to it is computed
// from the distance between it and the current encoder position, so that scales and set positions
// do not matter.
//
// Assumptions: the forced modes search in the other direction if a limit is reached before the home
// switch; the limit search ends after the longest distance; a limit still active after the escape
// step is a stage error. Source: application notes on smart homing, GE manual.
// Tested by tests/motion/homing_test.cc and tests/gtcalls/home_command_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>

#include "motion/axis_port.h"
#include "motion/core_parts.h"
#include "motion/homing.h"

namespace oncard::motion {

/// Homing of one axis, which advances itself. The card leaves its lanes: an axis that is homing
/// keeps it out of them.
class HomingSequence {
 public:
  HomingSequence(CoreParts core, size_t axis)
      : homing_(core.Changed().homing[axis]),
        any_runs_(core.state.homing_runs),
        axis_(core, axis) {}

  /// Begins smart homing of a resting profile.
  void Begin(const HomeParameters& parameters);
  /// Moves towards `position` until the capture triggers.
  void BeginSimple(HomeKind kind, int32_t position, double velocity, double acceleration,
                   int32_t offset);
  /// Searches for the home switch, then for the index pulse if `index`, on the way to `bound`.
  void BeginWithin(int32_t bound, double velocity, double acceleration, bool index);
  /// The axis has been given another motion.
  void Abandon();
  /// Searches for the index pulse after the next home switch, or after the one just found.
  void SetIndexSearch(int32_t distance, int32_t offset);
  /// GT_HomeInit: forgets the result of simple homing and the search for an index pulse.
  void Prepare();
  /// The reason why it could not begin; a sequence that is running keeps its own.
  void Refuse(HomeError error);
  /// One cycle of a sequence that is running, in the cycle of the core.
  void Advance();

 private:
  void BeginSearch();
  void SearchHome();
  void SearchIndex();
  void SearchIndexSimply();
  /// Prepares simple homing from the present position.
  void SetUpSimple(HomeKind kind, double velocity, double acceleration, int32_t offset);
  /// Searches on the way to the bound, with the capture armed for one of its sources.
  void SearchWithin(HomeStage stage, CaptureSource source);
  /// Next steps: after a capture, after a stop by homing, after a move.
  void TakeCapture(double captured);
  void Continue();
  void Arrive();
  void End();
  void Fail(HomeError error);
  /// Starts a move by `distance` from the current position.
  void Move(HomeStage stage, double distance, double velocity);
  /// The capture that it uses.
  size_t trigger() const;

  Homing& homing_;
  bool& any_runs_;
  AxisPort axis_;
};

}  // namespace oncard::motion
