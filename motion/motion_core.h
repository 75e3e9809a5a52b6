// The card's body: digital I/O, profiles, coordinate systems, axes, encoders, servo, captures,
// compare outputs, and the machine around it.
//
// All state is plain data in MotionState: a snapshot is a copy. Tick() is the only function that
// lets time pass; its order is the only order there is:
//
//   1. the world's events of the instant act on the pins; inputs are sampled, timed outputs advance
//   2. profiles, in ascending order: independent modes and the slaves of anything but a coordinate
//      system; coordinate systems; slaves of coordinate systems
//   3. axes: mapping, alarm, stop inputs, limits; a stop replaces what was just planned
//   4. compensation; servo and plants; encoders, captures
//   5. following error, in-position band, compare outputs
//
// The instant of a tick is the end of the cycle it stands for: a plan that starts between two ticks
// starts at the instant of the earlier one.
//
// Deterministic: integers and IEEE basic operations only. Nothing is allocated in a tick. Not
// thread-safe: one caller at a time. Functions assume valid numbers (indices from 0) and a state in
// which they may act; the commands of gtcalls check both and refuse in words.
// Tested by tests/motion/motion_core_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "motion/axis.h"
#include "motion/common/sizes.h"
#include "motion/compensation.h"
#include "motion/control.h"
#include "motion/encoder.h"
#include "motion/gantry.h"
#include "motion/happening.h"
#include "motion/homing.h"
#include "motion/io/analog.h"
#include "motion/io/capture.h"
#include "motion/io/compare.h"
#include "motion/io/digital_io.h"
#include "motion/io/extension.h"
#include "motion/io/mram.h"
#include "motion/mechanics/plant.h"
#include "motion/mechanics/switches_and_marks.h"
#include "motion/mechanics/world_events.h"
#include "motion/paths/crd.h"
#include "motion/profiles/profile.h"
#include "motion/profiles/pvt_table.h"

namespace oncard::motion {

/// Sizes and timing of a card.
struct MotionConfig {
  int axis_count = 8;      ///< 4, 8 or 12
  int64_t cycle_us = 250;  ///< profile cycle; a multiple of 125, 125..4000
};

/// GT_SetLongVar, GT_SetDoubleVar (assumption: 1024 of each, the manuals name no number).
inline constexpr int kUserVariableCount = 1024;

struct MotionState {
  int64_t cycle = 0;        ///< profile cycles since power-on
  int64_t clock_cycle = 0;  ///< profile cycles since the last GT_Reset
  DigitalIo io;
  std::array<Profile, kAxisMax> profiles;
  std::array<PvtTablePointer, kPvtTableCount> pvt_tables;
  std::array<Crd, kCrdCount> crds;
  std::array<Axis, kAxisMax> axes;
  /// Configuration: the axis that an enable output follows, from 0; -1: none.
  std::array<int8_t, kAxisIoWidth> enable_axes{};
  std::array<Compensation, kAxisMax> compensations;
  bool compensates = false;  ///< any of them
  std::array<Encoder, kAxisMax> encoders;
  std::array<EncoderFault, kAxisMax> encoder_faults;
  std::array<Drive, kAxisMax> drives;
  std::array<Plant, kAxisMax> plants;
  std::array<Step, kAxisMax> steps;
  std::array<Control, kAxisMax> controls;
  std::array<Dac, kAxisMax> dacs;
  std::array<Adc, kAdcCount> adcs;
  std::array<ExtensionModule, kModuleCount> modules;
  WorldProgress world;
  std::vector<PositionSwitch> switches;
  std::array<IndexMarks, kAxisMax> index_marks;
  CaptureUnit capture;
  CompareUnit compare;
  Gantry gantry;
  std::array<Homing, kAxisMax> homing;
  bool homing_runs = false;  ///< any of them
  Mram mram;
  std::array<int32_t, kUserVariableCount> long_vars{};
  std::array<double, kUserVariableCount> double_vars{};
  /// What GT_BufSetVarValue has reached in this tick, for the controller to carry out after it. Has
  /// room for a whole FIFO once the command has been used.
  std::vector<BufferedCommand> program_writes;

  auto Fields() const {
    return std::tie(cycle, clock_cycle, io, profiles, pvt_tables, crds, axes, enable_axes,
                    compensations, compensates, encoders, encoder_faults, drives, plants, steps,
                    controls, dacs, adcs, modules, world, switches, index_marks, capture, compare,
                    gantry, homing, homing_runs, mram, long_vars, double_vars, program_writes);
  }
};

class MotionCore {
 public:
  explicit MotionCore(const MotionConfig& config);

  const MotionConfig& config() const { return config_; }
  const MotionState& state() const { return state_; }
  MotionState& state() { return state_; }
  size_t axis_count() const { return static_cast<size_t>(config_.axis_count); }
  /// Tells `observer` from now on what the card does by itself; it must not change the card.
  void Observe(HappeningObserver observer) { observer_ = std::move(observer); }
  /// The card has auxiliary encoders (sizes.h).
  bool has_auxiliary() const { return axis_count() <= kAuxiliaryFirst; }
  /// The card has an encoder of that number: of an axis, or an auxiliary one.
  bool HasEncoder(size_t index) const {
    return index < axis_count() || (has_auxiliary() && index >= kAuxiliaryFirst &&
                                    index < kAuxiliaryFirst + kAuxiliaryCount);
  }

  // --- Time ------------------------------------------------------------------------------------

  /// One profile cycle.
  void Tick();
  /// GT_Reset: every register to its default, the clock to 0; inputs keep their pins' levels, the
  /// machine stays where it is.
  void Reset();
  /// The instant of the last tick.
  Micros now() const { return state_.cycle * config_.cycle_us; }
  /// Milliseconds since GT_Reset, rounded down (GT_GetClock).
  int64_t ClockMs() const;
  /// The same in units of 125 us (GT_GetClockHighPrecision).
  int64_t Clock125us() const;

  // --- Axes and profiles -----------------------------------------------------------------------

  /// The enable output and bit 9.
  void ServoOn(size_t axis);
  /// The same off; profiles of the axis stop abruptly.
  void ServoOff(size_t axis);
  /// The status word as it is now (GT_GetSts): bit 10 follows a start or stop at once.
  uint32_t Status(size_t axis) const;
  /// A profile that the axis maps moves.
  bool AxisMoving(const Axis& axis) const;
  /// An encoder's position with fractions of pulses.
  double CountedPosition(size_t encoder) const;
  /// Begins the run of a profile in an independent mode (GT_Update).
  void StartProfile(size_t profile) { state_.profiles[profile].Start(now()); }
  /// A master now, for a slave that starts or follows.
  MasterValue ReadMaster(const Master& master) const;
  /// Level of an input as GT_GetDi reads it; false for none.
  bool InputActive(const InputChoice& input) const {
    return input.bit >= 0 && (state_.io.Read(input.type) >> input.bit & 1) != 0;
  }
  /// The enable outputs that follow an axis.
  uint32_t EnableOutputs(size_t axis) const;
  /// Latched bits whose cause has gone are cleared (GT_ClrSts).
  void ClearStatus(size_t axis);
  /// Stops a profile as its registers say; one that belongs to a coordinate system stops all of it.
  void StopProfile(size_t profile, bool abrupt);
  /// GT_Stop of one axis: its profile, or what moves it as the slave of a gantry.
  void StopCommanded(size_t profile, bool abrupt);
  /// Sets a resting profile's position; the axes keep theirs.
  void SetProfilePosition(size_t profile, double position);
  /// Sets an encoder's position; the axes keep theirs.
  void SetEncoderPosition(size_t encoder, double position);
  /// GT_CtrlMode for an axis whose drive is off: closed loop through the DAC of the same number, or
  /// pulses.
  void SetClosedLoop(size_t axis, bool closed);
  /// The axis' drive is commanded by a servo controller.
  bool InClosedLoop(size_t axis) const;
  /// |planned - measured| is beyond the limit of the axis' controller.
  bool FollowingErrorExceeded(size_t axis) const;
  /// Joins motors, pulse outputs and controllers as the configuration says; after every change of
  /// it.
  void Wire();
  /// The same for a card at rest: enabled drives and pulse outputs go on from where they are.
  void RestartDrives();
  /// The encoder counts from its source as it is now; after a change of its configuration.
  void RebaseEncoder(size_t index) { state_.encoders[index].source = EncoderSource(index); }
  /// GT_EncSns, GT_EncOn and GT_EncOff: the encoder goes on counting from its position.
  void SetEncoderSense(size_t encoder, bool reversed);
  void SetEncoderExternal(size_t encoder, bool external);
  /// Axis positions := the mapped sums (GT_SynchAxisPos).
  void SynchAxis(size_t axis);
  /// Profile, encoder and both positions of an axis := 0 (GT_ZeroPos).
  void ZeroAxis(size_t axis);
  /// Sets a scale; the axis position is computed anew.
  void SetProfileScale(size_t axis, Scale scale);
  void SetEncoderScale(size_t axis, Scale scale);

  /// GT_SetBacklash.
  void SetBacklash(size_t axis, const Backlash& backlash);
  /// GT_SetLeadScrewComp; a table in use is replaced.
  void SetPitchTable(size_t axis, PitchTablePointer table);
  /// GT_EnableLeadScrewComp; the axis must have a table to switch it on.
  void EnablePitchCompensation(size_t axis, bool on);

  /// GT_EnableGantry, for two axes at rest and no gantry yet; ends with GT_DisableGantry.
  void EnableGantry(size_t master, size_t slave, double master_kp, double slave_kp);
  void DisableGantry();
  /// How far the measured slave is ahead of the master since the gantry began, pulses.
  double GantrySkew() const;
  bool IsGantrySlave(size_t axis) const { return state_.gantry.on && state_.gantry.slave == axis; }

  // --- Coordinate systems ------------------------------------------------------------------------

  /// GT_SetCrdPrm: the profiles change to mode Crd, the FIFOs are emptied. They must be at rest.
  void SetUpCrd(size_t crd, CrdParameters parameters);
  /// Where the members are, relative to the origin.
  Coordinates CrdPosition(size_t crd) const;
  /// Appends a slot to a FIFO; false when there is no room.
  bool AppendToCrd(size_t crd, size_t fifo, const PathSlot& slot);
  /// Begins or resumes a run; `single_step` ends it after one segment.
  void StartCrd(size_t crd, size_t fifo, bool single_step);
  /// Stops a run along its path.
  void StopCrd(size_t crd, bool abrupt);

  // --- Homing ----------------------------------------------------------------------------------

  /// Why smart homing of an axis cannot begin.
  HomeError CheckHoming(size_t index, HomeMode mode) const;
  /// GT_GoHome, for a resting profile.
  void BeginHoming(size_t index, const HomeParameters& parameters);
  /// GT_Home, GT_HomeStop: to `position` until the capture answers.
  void BeginSimpleHoming(size_t index, HomeKind kind, int32_t position, double velocity,
                         double acceleration, int32_t offset);
  /// GT_Index: the index pulse after the next home switch, or after the one just found.
  void SetIndexSearch(size_t index, int32_t distance, int32_t offset);

  // --- The world -------------------------------------------------------------------------------

  /// Switches a new card on in a world: what happens there, in order of time. Events of instant 0
  /// have happened, switches stand as their machines do, and filters have settled, so that the
  /// first call sees all of it.
  void PowerOn(std::shared_ptr<const WorldEvents> events);
  /// A place where the machine is put by hand; the encoder does not notice.
  void PlaceMachine(size_t machine, double position);

  /// XXH64 of the whole state.
  uint64_t Hash() const;

 private:
  void Tell(HappeningKind kind, size_t item, double value, double bound = 0) const {
    if (observer_) observer_({kind, item, value, bound});
  }
  /// Tells of causes that an axis has just met.
  void TellCauses(size_t index, uint32_t causes) const;
  size_t IndexOf(const Crd& crd) const { return static_cast<size_t>(&crd - state_.crds.data()); }
  void ApplyWorldEvents();
  /// An event of the present instant.
  void Apply(const WorldEvent& event);
  void DrivePin(const WorldEvent& event);
  void AdvanceProfiles();
  void AdvanceProfile(size_t index);
  /// Where the profile is now, by its mode.
  void SampleProfile(size_t index);
  /// The same for one at rest, which must not begin to move into a latched limit.
  void BeginProfile(size_t index);
  /// A limit that is latched for an axis of the profile lies in a direction, given by its sign.
  bool LimitForbids(size_t profile, double direction) const;
  /// A slave whose master is planned by a coordinate system.
  bool FollowsCrd(const Profile& profile) const;
  void AdvanceCrd(Crd& crd);
  /// Tells of a run that ended because its FIFO was empty.
  void TellRunEnd(const Crd& crd) const;
  /// A buffered command, at the tick in which the segment before it ended.
  void CarryOut(Crd& crd, const BufferedCommand& command);
  void StartBufferedMove(Crd& crd, const BufferedCommand& command);
  /// The profile that a path waits for is on its way.
  bool AwaitedMoveUnderWay(const Crd& crd) const;
  /// Ends the wait when the profile has arrived, and the run when it has been stopped short.
  void JudgeAwaitedMove(Crd& crd);
  void StartGear(Crd& crd, const BufferedCommand& command);
  /// Members and geared profiles to where the path has come.
  void WriteCrd(Crd& crd);
  void MapProfiles();
  void GuardAxis(size_t index);
  void AdvanceMachine();
  void AdvanceAuxiliary();
  void AdvanceCompensations();
  /// Where machines and encoders were before a cycle's motion, and the encoders after it.
  struct CycleWay {
    std::array<double, kAxisMax> machines{};
    EncoderWay encoders;
  };
  /// Something has to know what the machine passes inside a cycle.
  bool Observed() const;
  /// AdvanceMachine() and what is passed meanwhile.
  void AdvanceObserved();
  /// Edges that the world makes inside the cycle.
  void PassWorldEdges(const CycleWay& way);
  void PassComparePoints(const CycleWay& way);
  void OperateSwitch(const PositionSwitch& contact, const CycleWay& way);
  void PassIndexMarks(const CycleWay& way);
  /// An encoder's position at a fraction of the cycle, and where a machine is at a place on its
  /// way.
  double PositionAt(size_t encoder, double fraction, const CycleWay& way) const;
  double PositionWhere(size_t encoder, size_t machine, double place, const CycleWay& way) const;
  void AdvanceHomings();
  void AdvanceHoming(size_t index);
  void BeginHomingSearch(size_t index);
  void SearchHome(size_t index);
  void SearchIndex(size_t index);
  void ArmHoming(size_t trigger, CaptureSource source, bool rising);
  void SearchIndexSimply(size_t index);
  /// Planned minus measured position of a resting axis, without its compensation.
  double PlannedAhead(size_t index) const;
  /// The profile position of a captured one.
  double ProfilePositionOf(size_t index, double captured) const;
  /// What has been searched was captured; a stop of homing's own is over; a move is over.
  void TakeHomingCapture(size_t index);
  void ContinueHoming(size_t index);
  void ArriveHoming(size_t index);
  void EndHoming(size_t index);
  void FailHoming(size_t index, HomeError error);
  /// Starts a move by `distance` from here.
  void MoveHoming(size_t index, HomeStage stage, double distance, double velocity);
  /// The capture that an axis' homing uses.
  size_t HomingTrigger(size_t index) const;
  /// The limit input in a direction, and the same with the latched status bit.
  bool LimitActive(size_t index, int direction) const;
  bool LimitReached(size_t index, int direction) const;
  /// Clears the latched limit bit of a direction if its cause has gone.
  void ForgetLimit(size_t index, int direction);
  void AdvancePlant(size_t index);
  /// The axis whose enable output enables a machine's drive; that of its own number when no axis
  /// commands it.
  size_t EnablingAxis(size_t plant) const {
    const int8_t axis = state_.plants[plant].axis;
    return axis >= 0 ? static_cast<size_t>(axis) : plant;
  }
  bool Enabled(size_t plant) const { return state_.axes[EnablingAxis(plant)].servo_on; }
  /// One cycle of a machine without a drive, or with one that is off, that somebody turns.
  void TurnByHand(Plant& plant);
  void AdvanceClosedLoop(size_t index);
  void ResetMachine();
  void EnableMachine(size_t axis);
  void DisableMachine(size_t axis);
  /// The planned position of an axis has been renamed by -difference; the machine does not move.
  void KeepMachine(size_t axis, double difference);
  void JudgeAxis(size_t index);
  void JudgeControl(Control& control);
  /// The skew of the gantry is beyond its limit.
  void JudgeGantry();
  /// What the gantry adds to the output of an axis' controller, DAC units.
  double GantryCorrection(size_t axis) const;
  /// The controlled encoder has been silent for too long while its motor was driven.
  bool EncoderSilent(Control& control);

  /// What the profiles of an axis make of it now.
  MasterValue PlannedAxis(const Axis& axis) const;
  /// The mapped sum of an axis' profiles or encoders, without the offset.
  double MappedProfiles(const Axis& axis) const;
  double MappedEncoders(const Axis& axis) const;
  /// What an encoder counts, with fractions of pulses.
  double SourcePosition(size_t index) const;
  /// The same in whole pulses, with the error of reading.
  double EncoderSource(size_t index) const;
  /// The planned axis position as the drive is told it.
  double CommandedPosition(size_t axis) const {
    return state_.axes[axis].profile.position + state_.compensations[axis].Amount();
  }
  /// The position the controller's encoder gives its axis right now, between two ticks.
  double MeasuredPosition(const Control& control) const;
  /// Planned position := measured position, without motion.
  void AlignWithEncoder(size_t index);
  /// One cycle of what is wrong with an encoder.
  void AdvanceEncoderFault(size_t index);
  void CountEncoder(size_t index);
  /// Bits of kLatchedBits whose causes exist now; following errors are judged apart.
  uint32_t ActiveCauses(const Axis& axis) const;
  /// Status bits whose causes exist before the first tick are set, as that one would set them.
  void LatchCauses();
  /// Slaves of a master whose position has been changed without motion take no notice.
  void ShiftSlaves(const Master& master, double shift);
  /// Gives an axis another measured position without motion.
  void MoveEncoderOrigin(size_t index, double position);
  /// Gives an axis another planned position without motion; the second, against its profiles.
  void MoveAxisOrigin(size_t index, double position);
  void RenamePlanned(size_t index, double position);
  /// Stops every profile that an axis maps.
  void StopAxis(const Axis& axis, bool abrupt);

  MotionConfig config_;
  MotionState state_;
  HappeningObserver observer_;
};

}  // namespace oncard::motion
