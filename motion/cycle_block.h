// Several cycles of a card at once, as lanes (lanes/lanes.h), with the bits that the parts of the
// card compute one cycle at a time.
//
// A card is *plain* if in every cycle its axes only plan, move their drives and count. Then nothing
// happens between them, and its state is in lanes from Load() to Store(). It is not plain while
// inputs settle, something is armed, homing, a gantry, a compensation or an input shaper works, or
// an axis has a latched condition, a cause for one, a map to other profiles or encoders, or a
// fault; a card with a bus never is. lane_uses.h says of every member of the state what lanes do
// with it. What ends a block is known before (events, ends of pieces of
// plans) or found by the kernel in the cycle in which it happens. Tested by
// tests/motion/cycle_block_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "motion/lanes/lanes.h"
#include "motion/motion_state.h"
#include "motion/readings.h"

namespace oncard::motion {

class CycleBlock {
 public:
  CycleBlock(MotionState& state, const MotionConfig& config, LaneKernel kernel);

  /// Puts the card into lanes. Returns the number of cycles, at most `limit`, after which it must
  /// be loaded again; 0 if it is not plain.
  int64_t Load(int64_t limit);
  /// True if the lanes plan all profiles. Otherwise profiles are planned one cycle at a time, in
  /// the state of the card, before each Run(1).
  bool plans() const { return plans_; }
  /// Takes over profiles that were planned in the state of the card. Masters and paths have read
  /// what they need before.
  void TakeProfiles();
  /// Advances the lanes by at most `cycles`; returns by how many. In the cycle after these an axis
  /// does something that lanes cannot do.
  int64_t Run(int64_t cycles);
  /// Puts the lanes back into the state of the card, which then continues without them.
  void Store();
  /// Puts back what masters and paths read of encoders.
  void StoreEncoders();
  bool stored() const { return stored_; }

 private:
  static constexpr size_t kUnused = kLaneMax;

  bool CardIsPlain() const;
  bool AuxiliaryRests() const;
  bool SwitchesRest() const;
  bool AxisIsPlain(size_t axis) const;
  /// nullopt: lanes cannot do what moves the motor.
  std::optional<LaneKind> KindOf(size_t axis) const;
  std::optional<LaneKind> ServoKind(size_t axis) const;
  /// Cycles before the next event outside the card.
  int64_t CyclesBeforeEvent() const;
  /// Cycles in which the in-position condition of an axis does not change.
  int64_t CyclesInBand(const Axis& axis) const;
  /// Gives each axis a lane, moving axes of a kind first.
  void AssignLanes(const std::array<LaneKind, kAxisMax>& kinds);
  void LoadTiming();
  void LoadAxis(size_t axis);
  void LoadControl(size_t axis);
  void LoadDrive(size_t axis);
  void LoadEncoder(size_t axis);
  void LoadSwitch(const PositionSwitch& contact);
  void LoadProfile(size_t axis);
  /// Puts the plan of a moving profile into its lane; returns the number of cycles for which the
  /// same piece applies.
  int64_t LoadPlan(size_t axis, const Plan& plan, Micros begin);
  void StoreAxis(size_t axis);
  /// Leaves out groups of lanes that do not change any more; to be called after one cycle.
  void TrimStillGroups();
  bool GroupIsStill(size_t first) const;

  size_t axis_count() const { return static_cast<size_t>(config_.axis_count); }
  Micros now() const { return state_.cycle * config_.cycle_us; }

  MotionState& state_;
  const MotionConfig& config_;
  LaneKernel kernel_;
  Readings readings_;
  LaneConstants constants_;
  LaneStates lanes_;
  std::array<size_t, kAxisMax> lane_of_{};
  std::array<LaneKind, kAxisMax> kind_of_{};
  bool plans_ = true;
  bool stored_ = true;
};

}  // namespace oncard::motion
