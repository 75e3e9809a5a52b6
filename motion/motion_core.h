// The motion core: digital I/O, profiles, coordinate systems, axes, encoders, servo, captures,
// compare outputs, and the mechanics around the card.
//
// All state is plain data in MotionState: a snapshot is a copy. Tick() advances time, always in
// this order:
//
//   1. the world's events of the instant act on the pins; inputs are sampled, timed outputs advance
//   2. profiles, in ascending order: independent modes and the slaves of anything but a coordinate
//      system; coordinate systems; slaves of coordinate systems
//   3. axes: mapping, alarm, stop inputs, limits; a stop replaces what was just planned
//   4. compensation, input shapers; servo and plants; encoders, captures
//   5. following error, in-position band, compare outputs
//
// The instant of a tick is the end of its cycle: a plan that is started between two ticks begins at
// the instant of the earlier one. Advance() computes the same; while nothing but motion happens,
// lanes hold the newest values of the axes (cycle_block.h), and whoever looks at the state gets
// them copied.
//
// Deterministic: integers and IEEE basic operations only. Nothing is allocated in a tick. Not
// thread-safe: one caller at a time. Functions assume valid numbers (indices from 0) and a state
// that permits the action; the commands of gtcalls check both and refuse with a reason. Tested by
// tests/motion/motion_core_test.cc.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "motion/bus_axes.h"
#include "motion/card_event.h"
#include "motion/crd_driver.h"
#include "motion/cycle_block.h"
#include "motion/drive_train.h"
#include "motion/homing.h"
#include "motion/lane_uses.h"
#include "motion/motion_state.h"
#include "motion/origins.h"
#include "motion/readings.h"

namespace oncard::motion {

class MotionCore {
 public:
  explicit MotionCore(const MotionConfig& config);
  MotionCore(const MotionCore& other);
  MotionCore& operator=(const MotionCore&) = delete;
  ~MotionCore() = default;

  const MotionConfig& config() const { return config_; }
  /// The whole state as it is now. References into it show and change the card until Advance().
  const MotionState& state() const {
    block_.Show();
    return state_;
  }
  /// The same to change it. Takes the card out of its lanes: who only reads uses a const core.
  MotionState& state() {
    block_.Leave();
    return state_;
  }
  /// One profile, axis or encoder as it is now, without the way through all others.
  const Profile& profile(size_t index) const {
    block_.ShowProfile(index);
    return state_.profiles[index];
  }
  const Axis& axis(size_t index) const {
    block_.ShowAxis(index);
    return state_.axes[index];
  }
  const Encoder& encoder(size_t index) const {
    block_.ShowEncoder(index);
    return state_.encoders[index];
  }
  /// A part of the state that lanes never hold: `part<&MotionState::io>()`.
  template <auto kMember>
  const auto& part() const {
    static_assert(!kLaned<kMember>, "lanes may hold newer values");
    return state_.*kMember;
  }
  /// A member that lanes never hold of one axis: `part<&MotionState::axes, &Axis::latched>(index)`.
  template <auto kMember, auto kOfEach>
  const auto& part(size_t index) const {
    static_assert(!kLaned<kOfEach>, "lanes may hold newer values");
    return (state_.*kMember)[index].*kOfEach;
  }
  size_t axis_count() const { return static_cast<size_t>(config_.axis_count); }
  /// What follows from the state at this instant.
  Readings readings() const { return {state(), config_}; }
  /// From now on reports to `observer` what the card does by itself; the observer must not change
  /// the card.
  void Observe(CardEventObserver observer) { observer_ = std::move(observer); }
  /// True if the card has auxiliary encoders (sizes.h).
  bool has_auxiliary() const { return HasAuxiliary(config_); }
  /// True if the card has an encoder with this number: that of an axis, or an auxiliary one.
  bool HasEncoder(size_t index) const {
    return index < axis_count() || (has_auxiliary() && index >= kAuxiliaryFirst &&
                                    index < kAuxiliaryFirst + kAuxiliaryCount);
  }

  // --- Time ------------------------------------------------------------------------------------

  /// One profile cycle.
  void Tick();
  /// At most `cycles` > 0 profile cycles, with the bits of as many ticks. Stops after a cycle in
  /// which a path has reached commands for the owner of the core. Returns the number of cycles.
  int64_t Advance(int64_t cycles);
  /// Chooses what advances the lanes of Advance(); all kernels compute the same bits.
  void UseKernel(LaneKernel kernel) { block_.UseKernel(kernel); }
  /// GT_Reset: sets every register to its default and the clock to 0. Pins keep their levels, and
  /// the mechanics stay where they are.
  void Reset();
  /// Profile cycles since power-on.
  int64_t cycle() const { return state_.cycle; }
  /// The instant of the last tick.
  Micros now() const { return state_.cycle * config_.cycle_us; }
  /// Milliseconds since the last Reset(), rounded down.
  int64_t ClockMs() const;
  /// The same in microseconds.
  int64_t ClockUs() const { return state_.clock_cycle * config_.cycle_us; }

  // --- Axes and profiles -----------------------------------------------------------------------

  /// Sets the enable output and the condition (GT_AxisOn).
  void ServoOn(size_t axis);
  /// Clears both (GT_AxisOff); profiles of the axis stop abruptly.
  void ServoOff(size_t axis);
  /// The conditions of an axis as they are now, a sum of AxisCondition: kMovingBit follows a start
  /// or stop at once.
  uint32_t Conditions(size_t axis) const;
  /// True if a profile that the axis maps is moving.
  bool AxisMoving(const Axis& axis) const { return unlaned().AxisMoving(axis); }
  /// An encoder's position with fractions of pulses.
  double CountedPosition(size_t encoder) const { return readings().CountedPosition(encoder); }
  /// Begins the run of a profile in its mode (GT_Update, GT_GearStart ...), which must not be Crd.
  void StartProfile(size_t profile);
  /// Sets the velocity of a profile in mode Trap or Jog (GT_SetVel), and the target of mode Trap
  /// (GT_SetPos), for its next start. No cycle reads them, so that the card stays in its lanes.
  void SetVelocity(size_t profile, double velocity);
  void SetTarget(size_t profile, int32_t target) { state_.profiles[profile].trap.target = target; }
  /// The current sample of a master, for a slave that starts or follows.
  MasterValue ReadMaster(const Master& master) const { return readings().ValueOf(master); }
  /// Level of an input as GT_GetDi reads it; false if there is none.
  bool InputActive(const InputChoice& input) const { return unlaned().InputActive(input); }
  /// The enable outputs that follow an axis.
  uint32_t EnableOutputs(size_t axis) const;
  /// Forgets the latched conditions whose cause is gone (GT_ClrSts).
  void ClearStatus(size_t axis);
  /// Stops a profile with the decelerations of its registers, or smoothly as its mode plans it; if
  /// it belongs to a coordinate system, the whole system stops.
  void StopProfile(size_t profile, bool abrupt);
  /// GT_Stop of one axis: stops its profile or, for the slave of a gantry, the master.
  void StopCommanded(size_t profile, bool abrupt);
  /// Sets the position of a profile at rest; the axes keep theirs.
  void SetProfilePosition(size_t profile, double position) {
    origins().SetProfilePosition(profile, position);
  }
  /// Sets an encoder's position; the axes keep theirs.
  void SetEncoderPosition(size_t encoder, double position) {
    origins().SetEncoderPosition(encoder, position);
  }
  /// GT_CtrlMode for an axis whose drive is off: closed loop through the DAC of the same number, or
  /// pulses.
  void SetClosedLoop(size_t axis, bool closed) { drives().SetClosedLoop(axis, closed); }
  /// True if the axis' drive is commanded by a servo controller.
  bool InClosedLoop(size_t axis) const { return unlaned().InClosedLoop(axis); }
  /// True if |planned - measured| exceeds the limit of the axis' controller.
  bool FollowingErrorExceeded(size_t axis) const { return readings().FollowingErrorExceeded(axis); }
  /// Connects motors, pulse outputs and controllers according to the configuration; to be called
  /// after every change of it.
  void Wire() { drives().Wire(); }
  /// The same for a card at rest: enabled drives and pulse outputs continue from their current
  /// positions.
  void RestartDrives();
  /// Makes the encoder count from the current value of its source; to be called after a change of
  /// its configuration.
  void RebaseEncoder(size_t encoder) { drives().Rebase(encoder); }
  /// GT_EncSns, GT_EncOn and GT_EncOff: the encoder continues to count from its position.
  void SetEncoderSense(size_t encoder, bool reversed);
  void SetEncoderExternal(size_t encoder, bool external);
  /// Sets the axis positions to the mapped sums (GT_SynchAxisPos).
  void SynchAxis(size_t axis) { origins().SynchAxis(axis); }
  /// Sets profile, encoder and both positions of an axis to 0 (GT_ZeroPos).
  void ZeroAxis(size_t axis) { origins().ZeroAxis(axis); }
  /// Sets a scale; the axis position is computed again.
  void SetProfileScale(size_t axis, Scale scale) { origins().SetProfileScale(axis, scale); }
  void SetEncoderScale(size_t axis, Scale scale) { origins().SetEncoderScale(axis, scale); }

  /// GT_SetBacklash.
  void SetBacklash(size_t axis, const Backlash& backlash);
  /// GT_SetLeadScrewComp; a table in use is replaced.
  void SetPitchTable(size_t axis, PitchTablePointer table);
  /// GT_EnableLeadScrewComp; the axis must have a table to switch it on.
  void EnablePitchCompensation(size_t axis, bool on);

  /// GT_SetAxisInputShaping, for an axis at rest whose shaper has settled: `count` in
  /// [1, kShaperCyclesMax], or 0 to switch it off.
  void SetInputShaper(size_t axis, size_t count, double k);
  /// False while the input shaper of an axis has not yet passed all of a motion.
  bool ShaperSettled(size_t axis) const { return unlaned().ShaperSettled(axis); }

  /// GT_EnableGantry, for two axes at rest without a gantry; GT_DisableGantry ends it.
  void EnableGantry(size_t master, size_t slave, double master_kp, double slave_kp);
  void DisableGantry();
  /// How far the measured slave is ahead of the master since the gantry began, pulses.
  double GantrySkew() const { return state_.gantry.Skew(state().axes); }
  bool IsGantrySlave(size_t axis) const { return unlaned().IsGantrySlave(axis); }

  // --- Coordinate systems ------------------------------------------------------------------------

  /// GT_SetCrdPrm: the profiles change to mode Crd, the FIFOs are emptied. They must be at rest.
  void SetUpCrd(size_t crd, CrdParameters parameters) { driver(crd).SetUp(parameters); }
  /// The positions of the member profiles, relative to the origin.
  Coordinates CrdPosition(size_t crd) const {
    return PositionOf(state().crds[crd], state().profiles);
  }
  /// Appends a slot to a FIFO; false when there is no room.
  bool AppendToCrd(size_t crd, size_t fifo, const PathSlot& slot) {
    return driver(crd).Append(fifo, slot);
  }
  /// Begins or resumes a run; with `single_step` it ends after one segment.
  void StartCrd(size_t crd, size_t fifo, bool single_step) { driver(crd).Start(fifo, single_step); }
  /// Begins a run with a line back to the breakpoint, as `back` says (Crd::Resume).
  void ResumeCrd(size_t crd, size_t fifo, const PathSlot& back) { driver(crd).Resume(fifo, back); }
  /// True if a coordinate system runs.
  bool PathRuns() const { return unlaned().PathRuns(); }
  /// Stops a run along its path.
  void StopCrd(size_t crd, bool abrupt) { driver(crd).Stop(abrupt); }
  /// Opens a FIFO as a list: a run that has come to its end waits for more slots.
  void OpenCrdList(size_t crd, size_t fifo) { driver(crd).OpenList(fifo); }
  /// Closes it; a run that waits for its data ends.
  void CloseCrdList(size_t crd, size_t fifo) { driver(crd).CloseList(fifo); }

  // --- Homing ----------------------------------------------------------------------------------

  /// The reason why smart homing of an axis cannot begin.
  HomeError CheckHoming(size_t index, HomeMode mode) const {
    return motion::CheckHoming(state_.profiles[index], state_.axes[index], mode);
  }
  /// GT_GoHome, for a resting profile.
  void BeginHoming(size_t index, const HomeParameters& parameters);
  /// GT_Home, GT_HomeStop: moves towards `position` until the capture triggers.
  void BeginSimpleHoming(size_t index, HomeKind kind, int32_t position, double velocity,
                         double acceleration, int32_t offset);
  /// GT_Index: searches for the index pulse after the next home switch, or after the one just
  /// found.
  void SetIndexSearch(size_t index, int32_t distance, int32_t offset);

  // --- Axes on a bus ---------------------------------------------------------------------------

  /// Gives the card a bus, to be called before PowerOn(): what an ENI file describes (nullptr:
  /// there is none), and what is connected.
  void ConnectBus(bus::SlavesPointer configured, bus::SlavesPointer connected);
  /// The axes on it, for a card with a bus.
  BusAxes bus_axes() { return {state(), config_}; }
  /// True if the axis has a drive on a bus.
  bool OnBus(size_t axis) const { return unlaned().OnBus(axis); }
  /// True if the controller commands the drives of a card with a bus (GT_StartEcatComm).
  bool BusStarted() const { return state_.bus->line.started(); }
  /// The mode of operation of the drive of an axis on the bus, as the drive reports it.
  bus::DriveMode BusMode(size_t axis) const { return unlaned().BusMode(axis); }
  /// GT_TerminateEcatComm: its axes stop abruptly, and their drives are switched off.
  void TerminateBus();

  // --- Outside the card ------------------------------------------------------------------------

  /// Switches a new card on, given the events outside the card in order of time. Events at instant
  /// 0 have already happened, switches match the positions of their motors, and the filters have
  /// accepted all levels, so that the first call sees them.
  void PowerOn(std::shared_ptr<const WorldEvents> events);
  /// Sets the position of a motor by hand; the encoder does not count this.
  void PlaceMotor(size_t motor, double position);
  /// Reports from now on what the axis is planned to do beyond these limits, which it does all the
  /// same.
  void WatchLimits(size_t axis, const DriveLimits& limits) {
    block_.Leave();
    config_.drive_limits[axis] = limits;
  }

  /// XXH64 of the whole state.
  uint64_t Hash() const;

 private:
  // The parts of the core that work on its state.
  DriveTrain drives() { return {state(), config_}; }
  Origins origins() { return {state(), config_}; }
  CrdDriver driver(size_t crd) { return driver(state(), crd); }
  HomingSequence homing(size_t axis) { return {state().homing[axis], AxisPort(*this, axis)}; }
  /// The same for a path beside which lanes move the drives.
  CrdDriver driver(MotionState& state, size_t crd) {
    return {state.crds[crd], CrdPort(state, config_, observer_, crd, block_)};
  }
  /// Readings of what lanes never hold.
  Readings unlaned() const { return {state_, config_}; }

  void ResetAxes();

  /// Advances a plain card as lanes, by at most `cycles`; returns by how many, 0 if the card is not
  /// plain.
  int64_t AdvanceBlock(int64_t cycles);
  /// The same with profiles that are planned here, one cycle at a time.
  int64_t AdvanceBesideProfiles(int64_t cycles);
  /// True if a profile or a path may read an encoder.
  bool EncodersAreRead() const;

  // The steps of a tick.
  void BeginTick();
  void AdvanceProfiles();
  /// All that follows the planning of profiles.
  void FinishTick();
  /// One that moves and is not driven.
  void AdvanceProfile(size_t index);
  /// The sample of the profile now, according to its mode.
  void SampleProfile(size_t index);
  /// The same for a profile at rest, which must not begin to move towards a latched limit.
  void BeginProfile(size_t index);
  void MapProfiles();
  /// Reports that an axis begins to exceed what it can follow with what is planned for this cycle.
  void JudgeLimits(size_t index, const MasterValue& planned) const;
  void GuardAxis(size_t index);
  void AdvanceCompensations();
  void AdvanceShapers();
  /// Drives and encoders, with all that they pass inside the cycle if something depends on it.
  void AdvanceDrives();
  /// The same with the drives on a bus.
  void AdvanceDrivesWithBus();
  void JudgeControl(Control& control);
  /// Stops an axis whose following error exceeds its limit, or whose encoder is silent.
  void FailControl(const Control& control, double error);
  void JudgeGantry();
  void JudgeAxis(size_t index);
  void AdvanceHomings();

  void EnableDrive(size_t axis);
  /// Stops every profile that an axis maps.
  void StopAxis(const Axis& axis, bool abrupt);
  /// The same at a limit: abruptly, unless its coordinate system stops smoothly there.
  void StopAxisAtLimit(const Axis& axis);
  /// Latches the conditions whose causes exist before the first tick, as that tick would.
  void LatchCauses();
  void Tell(CardEventKind kind, size_t item, double value, double bound = 0) const;
  /// Reports new causes of stops of an axis.
  void TellCauses(size_t index, uint32_t causes) const;

  MotionConfig config_;
  // The steps of a tick use it as it is, after the lanes have been left. All else begins with
  // state(), or says what it knows of lanes.
  MotionState state_;
  CardEventObserver observer_;
  // Reading the state copies what the lanes hold.
  mutable CycleBlock block_;
};

}  // namespace oncard::motion
