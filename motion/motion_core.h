// The motion core: digital I/O, profiles, coordinate systems, axes, encoders, servo, captures,
// compare outputs, and the mechanics around the card.
//
// All state is plain data in MotionState: a snapshot is a copy. Everybody may read it; it is
// changed by Tick(), and by commands through the parts of the card: AxisAt(), ProfileAt(), CrdAt()
// ... name the part, and what they return has its verbs and its registers. Tick() advances time,
// always in this order:
//
//   1. the world's events of the instant act on the pins; inputs are sampled, timed outputs advance
//   2. profiles, in ascending order: independent modes and the slaves of anything but a coordinate
//      system; coordinate systems; slaves of coordinate systems. All slaves come last where the
//      family says so (CardDefaults::slaves_last)
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

#include "motion/axis_handle.h"
#include "motion/bus_axes.h"
#include "motion/card_event.h"
#include "motion/core_parts.h"
#include "motion/crd_driver.h"
#include "motion/cycle_block.h"
#include "motion/drive_handles.h"
#include "motion/drive_train.h"
#include "motion/homing_sequence.h"
#include "motion/lane_uses.h"
#include "motion/motion_state.h"
#include "motion/origins.h"
#include "motion/profile_handle.h"
#include "motion/readings.h"

namespace oncard::motion {

class MotionCore {
 public:
  explicit MotionCore(const MotionConfig& config);
  MotionCore(const MotionCore& other);
  MotionCore& operator=(const MotionCore&) = delete;
  ~MotionCore() = default;

  const MotionConfig& config() const { return config_; }
  /// The whole state as it is now. References into it show the card until Advance().
  const MotionState& state() const {
    block_.Show();
    return state_;
  }
  /// Continues from a copy of the state of a card with the same configuration.
  void Restore(const MotionState& copy);
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

  // --- What follows from the state -------------------------------------------------------------

  /// The conditions of an axis as they are now, a sum of AxisCondition: kMovingBit follows a start
  /// or stop at once.
  uint32_t Conditions(size_t axis) const;
  /// True if a profile that the axis maps is moving.
  bool AxisMoving(const Axis& axis) const { return unlaned().AxisMoving(axis); }
  /// Level of an input as GT_GetDi reads it; false if there is none.
  bool InputActive(const InputChoice& input) const { return unlaned().InputActive(input); }
  /// The current sample of a master, for a slave that starts or follows.
  MasterValue ReadMaster(const Master& master) const { return readings().ValueOf(master); }
  /// An encoder's position with fractions of pulses.
  double CountedPosition(size_t encoder) const { return readings().CountedPosition(encoder); }
  /// True if the axis' drive is commanded by a servo controller.
  bool InClosedLoop(size_t axis) const { return unlaned().InClosedLoop(axis); }
  /// True if |planned - measured| exceeds the limit of the axis' controller.
  bool FollowingErrorExceeded(size_t axis) const { return readings().FollowingErrorExceeded(axis); }
  /// False while the input shaper of an axis has not yet passed all of a motion.
  bool ShaperSettled(size_t axis) const { return unlaned().ShaperSettled(axis); }
  /// How far the measured slave is ahead of the master since the gantry began, pulses.
  double GantrySkew() const { return state_.gantry.Skew(state().axes); }
  bool IsGantrySlave(size_t axis) const { return unlaned().IsGantrySlave(axis); }
  /// The positions of the profiles of a coordinate system, relative to the origin.
  Coordinates CrdPosition(size_t crd) const {
    return PositionOf(state().crds[crd], state().profiles);
  }
  /// True if a coordinate system runs.
  bool PathRuns() const { return unlaned().PathRuns(); }
  /// The reason why smart homing of an axis cannot begin.
  HomeError CheckHoming(size_t axis, HomeMode mode) const {
    return motion::CheckHoming(state_.profiles[axis], state_.axes[axis], mode);
  }
  /// True if the axis has a drive on a bus.
  bool OnBus(size_t axis) const { return unlaned().OnBus(axis); }
  /// True if the controller commands the drives of a card with a bus (GT_StartEcatComm).
  bool BusStarted() const { return state_.bus->line.started(); }
  /// The mode of operation of the drive of an axis on the bus, as the drive reports it.
  bus::DriveMode BusMode(size_t axis) const { return unlaned().BusMode(axis); }

  // --- Parts of the card, to command them -------------------------------------------------------

  AxisHandle AxisAt(size_t axis) { return {parts(), axis}; }
  ProfileHandle ProfileAt(size_t profile) { return {parts(), profile}; }
  CrdDriver CrdAt(size_t crd) { return {parts(), crd}; }
  HomingSequence HomingAt(size_t axis) { return {parts(), axis}; }
  EncoderHandle EncoderAt(size_t encoder) { return {parts(), encoder}; }
  ControlHandle ControlAt(size_t control) { return {parts(), control}; }
  DacHandle DacAt(size_t dac) { return {parts(), dac}; }
  StepHandle StepAt(size_t step) { return {parts(), step}; }
  // References last until Advance().
  /// Inputs and outputs. An input that settles keeps the card out of its lanes.
  DigitalIo& digital_io() { return parts().Changed().io; }
  /// What is armed, or runs, keeps the card out of its lanes.
  CaptureUnit& capture() { return parts().Changed().capture; }
  CompareUnit& compare() { return parts().Changed().compare; }
  /// Lanes know nothing of these: a card stays in its lanes.
  Laser& laser(size_t channel) { return state_.lasers.channels[channel]; }
  ExtensionModule& module(size_t module) { return state_.modules[module]; }
  /// The axes on a bus, for a card with a bus.
  BusAxes bus_axes() { return {parts().Changed(), config_}; }
  /// The bus; nullptr: the card has none.
  bus::Bus* bus_line() { return state_.bus ? &parts().Changed().bus->line : nullptr; }
  /// GT_TerminateEcatComm: its axes stop abruptly, and their drives are switched off.
  void TerminateBus();

  /// GT_EnableGantry, for two axes at rest without a gantry; GT_DisableGantry ends it.
  void EnableGantry(size_t master, size_t slave, double master_kp, double slave_kp);
  void DisableGantry();
  /// The skew that switches the drives off, pulses.
  void SetGantryErrorLimit(int32_t limit) { state_.gantry.error_limit = limit; }
  /// Fills a PVT table. A motion in progress keeps the one with which it started.
  void SetPvtTable(size_t table, PvtTablePointer content) {
    state_.pvt_tables[table] = std::move(content);
  }
  /// The value of the analogue output of a spindle, on a card that has one.
  void SetSpindle(double value) { state_.spindle->value = value; }
  /// GT_SetAdcFilter.
  void SetAdcFilter(size_t adc, int16_t filter) { state_.adcs[adc].filter = filter; }
  /// Configuration: the axis that an enable output follows; -1: none.
  void SetEnableAxis(size_t output, int8_t axis) { state_.enable_axes[output] = axis; }
  /// Connects motors, pulse outputs and controllers according to the configuration, for a card at
  /// rest: enabled drives and pulse outputs continue from their current positions. To be called
  /// after every change of the configuration.
  void RestartDrives();

  /// Makes room for as many BufferedKind::kOutside commands as can wait in a FIFO.
  void ReserveReached() { state_.reached.reserve(kCrdFifoSize); }
  /// The commands that paths have reached have been carried out.
  void ClearReached() { state_.reached.clear(); }

  // --- Outside the card ------------------------------------------------------------------------

  // The mechanics of a card, to be set up before PowerOn().
  void ConnectDrive(size_t motor, const Drive& drive) { parts().Changed().drives[motor] = drive; }
  void SetIndexMarks(size_t encoder, const IndexMarks& marks) {
    parts().Changed().index_marks[encoder] = marks;
  }
  void AddSwitch(const PositionSwitch& contact) { parts().Changed().switches.push_back(contact); }
  /// Gives the card a bus: what an ENI file describes (nullptr: there is none), and what is
  /// connected.
  void ConnectBus(bus::SlavesPointer configured, bus::SlavesPointer connected);
  /// Switches a new card on, given the events outside the card in order of time. Events at instant
  /// 0 have already happened, switches match the positions of their motors, and the filters have
  /// accepted all levels, so that the first call sees them.
  void PowerOn(std::shared_ptr<const WorldEvents> events);
  /// Replaces the events by others of which as many have already happened; from now on hands move
  /// motors, and encoders drift, as fast as the new ones say.
  void SetEvents(std::shared_ptr<const WorldEvents> events);
  /// Lets an event that is not among these happen now; its own instant does not matter. The next
  /// tick applies those of this instant after it.
  void Happen(const WorldEvent& event);
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
  /// What its handles work on.
  CoreParts parts() { return {state_, config_, observer_, block_}; }
  DriveTrain drives() { return {parts().Changed(), config_}; }
  Origins origins() { return {parts().Changed(), config_}; }
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

  /// Latches the conditions whose causes exist before the first tick, as that tick would.
  void LatchCauses();
  void Tell(CardEventKind kind, size_t item, double value, double bound = 0) const;
  /// Reports new causes of stops of an axis.
  void TellCauses(size_t index, uint32_t causes) const;

  MotionConfig config_;
  // The steps of a tick use it as it is, after the lanes have been left. All else leaves them, or
  // says what it knows of them.
  MotionState state_;
  CardEventObserver observer_;
  // Reading the state copies what the lanes hold.
  mutable CycleBlock block_;
};

}  // namespace oncard::motion
