// Several cycles of a card at once, as lanes (lanes/lanes.h), with the bits that the parts of the
// card compute one cycle at a time.
//
// A card is *plain* if in every cycle its axes only plan, move their drives and count. Then nothing
// happens between them, and its state is in lanes from Load() to Leave(). It is not plain while
// inputs settle, something is armed, homing, a gantry, a compensation or an input shaper works, or
// an axis has a latched condition, a cause for one, a map to other profiles or encoders, or a
// fault. A bus must be in OP, its drives reached, and each either follows what is planned or is
// off. lane_uses.h says of every member of the state what lanes do with it. What ends a block is
// known before (events, ends of pieces of plans) or found by the kernel in the cycle in which it
// happens.
//
// Lanes hold where the motors of a bus are, not its process image and dictionaries. The state gets
// these by the exchange of the last cycle, which is repeated from the positions before it.
//
// Lanes that plan all profiles stay loaded between the calls that advance a card. Who reads the
// state has the values copied that it reads, who starts a profile has that one loaded again, and
// who changes anything else has the card leave the lanes. Tested by
// tests/motion/cycle_block_test.cc and loaded_lanes_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "motion/lanes/lanes.h"
#include "motion/motion_state.h"
#include "motion/readings.h"

namespace oncard::motion {

class CycleBlock {
 public:
  /// This many cycles are worth the way into lanes and back.
  static constexpr int64_t kWorthwhile = 8;

  CycleBlock(MotionState& state, const MotionConfig& config, LaneKernel run);

  LaneKernel kernel() const { return kernel_; }
  void UseKernel(LaneKernel run) { kernel_ = run; }

  // --- Into lanes and back ---------------------------------------------------------------------

  /// Puts the card into lanes to advance it by `cycles`, unless it is there. False if it is not
  /// plain, if lanes that cannot stay loaded would be used for too few cycles, or if recent ones
  /// were.
  bool Enter(int64_t cycles);
  /// The next Enter() does not wait because of recent ones.
  void Retry();
  /// Puts the lanes back into the state of the card, which then continues without them.
  void Leave() {
    if (loaded_) Unload();
  }
  bool loaded() const { return loaded_; }

  // --- In lanes --------------------------------------------------------------------------------

  /// True if the lanes plan all profiles. Otherwise profiles are planned one cycle at a time, in
  /// the state of the card, before each Run(1).
  bool plans() const { return plans_; }
  /// Takes over profiles that were planned in the state of the card. Masters and paths have read
  /// what they need before.
  void TakeProfiles();
  /// Takes over a profile that has been started in the state of the card, for lanes that plan;
  /// leaves them if they cannot plan it.
  void TakeStart(size_t profile);
  /// The number of cycles before the one in which lanes cannot go on.
  int64_t CyclesAhead();
  /// Advances the lanes by at most `cycles`, which must not exceed CyclesAhead(); returns by how
  /// many. In the cycle after these an axis does something that lanes cannot do.
  int64_t Run(int64_t cycles);

  // --- What the lanes hold, copied to the state ------------------------------------------------

  void Show() {
    if (!shown_) ShowAll();
  }
  void ShowProfile(size_t profile) {
    if (!shown_) StoreProfile(profile);
  }
  void ShowAxis(size_t axis) {
    if (!shown_) StoreAxis(axis);
  }
  void ShowEncoder(size_t encoder) {
    if (!shown_ && encoder < axis_count()) StoreEncoder(encoder);
  }
  /// What masters and paths read of encoders.
  void ShowEncoders();

 private:
  /// How long a card is advanced without lanes after they were of little use, at most.
  static constexpr int64_t kWaitMax = 64;
  static constexpr int64_t kNoEnd = std::numeric_limits<int64_t>::max();

  /// False if the card is not plain in the next cycle.
  bool Load();
  void Unload();
  /// Lets some cycles pass before the next Enter() tries again.
  void Wait();

  bool CardIsPlain() const;
  bool AuxiliaryRests() const;
  bool SwitchesRest() const;
  bool AxisIsPlain(size_t axis) const;
  /// True if lanes can plan all profiles.
  bool FollowPlans() const;
  /// The same of one that moves by itself.
  static bool FollowsPlan(const Profile& profile);
  /// nullopt: lanes cannot do what moves the motor.
  std::optional<LaneKind> KindOf(size_t axis) const;
  std::optional<LaneKind> ServoKind(size_t axis) const;
  std::optional<LaneKind> BusKind(size_t axis) const;
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
  void LoadBusDrive(size_t axis);
  void LoadSwitch(const PositionSwitch& contact);
  void LoadProfile(size_t axis);
  /// Puts the plan that the profile follows into its lane, or no plan if it follows none.
  void LoadPlan(size_t axis);
  /// Puts the piece of a plan that applies in the next cycle into its lane; returns for how many
  /// cycles it applies. 0: the motion ends.
  int64_t LoadPiece(size_t lane, const Plan& plan, Micros begin);
  /// Loads the next piece of each plan of which one has ended.
  void LoadNextPieces();
  void FindEndOfPieces();
  void ShowAll();
  void StoreProfile(size_t profile);
  void StoreAxis(size_t axis);
  void StoreEncoder(size_t encoder);
  void StoreDrive(size_t axis);
  /// Puts the drives where they were at the begin of the last cycle, and has them exchange.
  void StoreBus();
  /// Leaves out groups of lanes that do not change any more; to be called after one cycle.
  void TrimStillGroups();
  bool GroupIsStill(size_t first) const;
  bool still() const { return constants_.begin == constants_.end; }
  /// The cycle that is so many cycles ahead.
  int64_t Ahead(int64_t cycles) const {
    return cycles < kNoEnd - state_.cycle ? state_.cycle + cycles : kNoEnd;
  }

  /// The drive of an axis that is on the bus.
  bus::BusDrive& BusDriveOf(size_t axis) const {
    return *state_.bus->line.slave(static_cast<size_t>(state_.bus->axes[axis].slave)).drive;
  }
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
  std::array<size_t, kLaneKindCount> ends_{};  // of the lanes of each kind, still ones included
  bool loaded_ = false;
  bool plans_ = true;
  bool shown_ = true;       // the state of the card has all that the lanes hold
  bool tick_next_ = false;  // the kernel has ended before its time, and a tick follows
  // Cycles of the card.
  int64_t loaded_at_ = 0;
  int64_t end_ = 0;                             // of what the lanes can do
  std::array<int64_t, kAxisMax> piece_ends_{};  // of each profile
  int64_t pieces_end_ = 0;                      // the first of them
  // Cycles that pass before Enter() tries again, and how many that will be after the next failure.
  int64_t wait_ = 0;
  int64_t next_wait_ = kWorthwhile;
};

}  // namespace oncard::motion
