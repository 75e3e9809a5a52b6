// The motion core: digital I/O, profiles, coordinate systems, axes, encoders, servo, captures,
// compare outputs, and the mechanics around the card.
//
// All state is plain data in MotionState: a snapshot is a copy. Only Tick() advances time, always
// in this order:
//
//   1. the world's events of the instant act on the pins; inputs are sampled, timed outputs advance
//   2. profiles, in ascending order: independent modes and the slaves of anything but a coordinate
//      system; coordinate systems; slaves of coordinate systems
//   3. axes: mapping, alarm, stop inputs, limits; a stop replaces what was just planned
//   4. compensation; servo and plants; encoders, captures
//   5. following error, in-position band, compare outputs
//
// The instant of a tick is the end of its cycle: a plan that is started between two ticks begins at
// the instant of the earlier one.
//
// Deterministic: integers and IEEE basic operations only. Nothing is allocated in a tick. Not
// thread-safe: one caller at a time. Functions assume valid numbers (indices from 0) and a state
// that permits the action; the commands of gtcalls check both and refuse with a reason. Tested by
// tests/motion/motion_core_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "motion/axis.h"
#include "motion/common/card_defaults.h"
#include "motion/common/rounding.h"
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
  int64_t cycle_us = 250;  ///< profile cycle; a multiple of servo_us, at most 4000
  int64_t servo_us = 125;  ///< servo sub-step
  CardDefaults defaults = {};

  double ServoMs() const { return static_cast<double>(servo_us) / 1000; }
};

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
  /// BufferedKind::kOutside commands that paths have reached, in their order. The owner of the core
  /// carries them out after the tick and empties the list; it gives it the capacity of a FIFO
  /// before it appends the first such command, so that a tick allocates nothing.
  std::vector<BufferedCommand> reached;

  auto Fields() const {
    return std::tie(cycle, clock_cycle, io, profiles, pvt_tables, crds, axes, enable_axes,
                    compensations, compensates, encoders, encoder_faults, drives, plants, steps,
                    controls, dacs, adcs, modules, world, switches, index_marks, capture, compare,
                    gantry, homing, homing_runs, reached);
  }
};

class MotionCore {
 public:
  explicit MotionCore(const MotionConfig& config);

  const MotionConfig& config() const { return config_; }
  const MotionState& state() const { return state_; }
  MotionState& state() { return state_; }
  size_t axis_count() const { return static_cast<size_t>(config_.axis_count); }
  /// From now on reports to `observer` what the card does by itself; the observer must not change
  /// the card.
  void Observe(HappeningObserver observer) { observer_ = std::move(observer); }
  /// True if the card has auxiliary encoders (sizes.h).
  bool has_auxiliary() const { return axis_count() <= kAuxiliaryFirst; }
  /// True if the card has an encoder with this number: that of an axis, or an auxiliary one.
  bool HasEncoder(size_t index) const {
    return index < axis_count() || (has_auxiliary() && index >= kAuxiliaryFirst &&
                                    index < kAuxiliaryFirst + kAuxiliaryCount);
  }

  // --- Time ------------------------------------------------------------------------------------

  /// One profile cycle.
  void Tick();
  /// GT_Reset: sets every register to its default and the clock to 0. Pins keep their levels, and
  /// the mechanics stay where they are.
  void Reset();
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
  bool AxisMoving(const Axis& axis) const;
  /// An encoder's position with fractions of pulses.
  double CountedPosition(size_t encoder) const;
  /// Begins the run of a profile in its mode (GT_Update, GT_GearStart ...), which must not be Crd.
  void StartProfile(size_t profile);
  /// The current sample of a master, for a slave that starts or follows.
  MasterValue ReadMaster(const Master& master) const;
  /// Level of an input as GT_GetDi reads it; false if there is none.
  bool InputActive(const InputChoice& input) const {
    return input.bit >= 0 && (state_.io.Read(input.type) >> input.bit & 1) != 0;
  }
  /// The enable outputs that follow an axis.
  uint32_t EnableOutputs(size_t axis) const;
  /// Forgets the latched conditions whose cause is gone (GT_ClrSts).
  void ClearStatus(size_t axis);
  /// Stops a profile with the decelerations of its registers; if it belongs to a coordinate system,
  /// the whole system stops.
  void StopProfile(size_t profile, bool abrupt);
  /// GT_Stop of one axis: stops its profile or, for the slave of a gantry, the master.
  void StopCommanded(size_t profile, bool abrupt);
  /// Sets the position of a profile at rest; the axes keep theirs.
  void SetProfilePosition(size_t profile, double position);
  /// Sets an encoder's position; the axes keep theirs.
  void SetEncoderPosition(size_t encoder, double position);
  /// GT_CtrlMode for an axis whose drive is off: closed loop through the DAC of the same number, or
  /// pulses.
  void SetClosedLoop(size_t axis, bool closed);
  /// True if the axis' drive is commanded by a servo controller.
  bool InClosedLoop(size_t axis) const;
  /// True if |planned - measured| exceeds the limit of the axis' controller.
  bool FollowingErrorExceeded(size_t axis) const;
  /// Connects motors, pulse outputs and controllers according to the configuration; to be called
  /// after every change of it.
  void Wire();
  /// The same for a card at rest: enabled drives and pulse outputs continue from their current
  /// positions.
  void RestartDrives();
  /// Makes the encoder count from the current value of its source; to be called after a change of
  /// its configuration.
  void RebaseEncoder(size_t index) { state_.encoders[index].source = EncoderSource(index); }
  /// GT_EncSns, GT_EncOn and GT_EncOff: the encoder continues to count from its position.
  void SetEncoderSense(size_t encoder, bool reversed);
  void SetEncoderExternal(size_t encoder, bool external);
  /// Sets the axis positions to the mapped sums (GT_SynchAxisPos).
  void SynchAxis(size_t axis);
  /// Sets profile, encoder and both positions of an axis to 0 (GT_ZeroPos).
  void ZeroAxis(size_t axis);
  /// Sets a scale; the axis position is computed again.
  void SetProfileScale(size_t axis, Scale scale);
  void SetEncoderScale(size_t axis, Scale scale);

  /// GT_SetBacklash.
  void SetBacklash(size_t axis, const Backlash& backlash);
  /// GT_SetLeadScrewComp; a table in use is replaced.
  void SetPitchTable(size_t axis, PitchTablePointer table);
  /// GT_EnableLeadScrewComp; the axis must have a table to switch it on.
  void EnablePitchCompensation(size_t axis, bool on);

  /// GT_EnableGantry, for two axes at rest without a gantry; GT_DisableGantry ends it.
  void EnableGantry(size_t master, size_t slave, double master_kp, double slave_kp);
  void DisableGantry();
  /// How far the measured slave is ahead of the master since the gantry began, pulses.
  double GantrySkew() const;
  bool IsGantrySlave(size_t axis) const { return state_.gantry.on && state_.gantry.slave == axis; }

  // --- Coordinate systems ------------------------------------------------------------------------

  /// GT_SetCrdPrm: the profiles change to mode Crd, the FIFOs are emptied. They must be at rest.
  void SetUpCrd(size_t crd, CrdParameters parameters);
  /// The positions of the member profiles, relative to the origin.
  Coordinates CrdPosition(size_t crd) const;
  /// Appends a slot to a FIFO; false when there is no room.
  bool AppendToCrd(size_t crd, size_t fifo, const PathSlot& slot);
  /// Begins or resumes a run; with `single_step` it ends after one segment.
  void StartCrd(size_t crd, size_t fifo, bool single_step);
  /// Stops a run along its path.
  void StopCrd(size_t crd, bool abrupt);

  // --- Homing ----------------------------------------------------------------------------------

  /// The reason why smart homing of an axis cannot begin.
  HomeError CheckHoming(size_t index, HomeMode mode) const;
  /// GT_GoHome, for a resting profile.
  void BeginHoming(size_t index, const HomeParameters& parameters);
  /// GT_Home, GT_HomeStop: moves towards `position` until the capture triggers.
  void BeginSimpleHoming(size_t index, HomeKind kind, int32_t position, double velocity,
                         double acceleration, int32_t offset);
  /// GT_Index: searches for the index pulse after the next home switch, or after the one just
  /// found.
  void SetIndexSearch(size_t index, int32_t distance, int32_t offset);

  // --- Outside the card ------------------------------------------------------------------------

  /// Switches a new card on, given the events outside the card in order of time. Events at instant
  /// 0 have already happened, switches match the positions of their motors, and the filters have
  /// accepted all levels, so that the first call sees them.
  void PowerOn(std::shared_ptr<const WorldEvents> events);
  /// Sets the position of a motor by hand; the encoder does not count this.
  void PlaceMachine(size_t machine, double position);

  /// XXH64 of the whole state.
  uint64_t Hash() const;

 private:
  void Tell(HappeningKind kind, size_t item, double value, double bound = 0) const;
  /// Reports new causes of stops of an axis.
  void TellCauses(size_t index, uint32_t causes) const;
  size_t IndexOf(const Crd& crd) const { return static_cast<size_t>(&crd - state_.crds.data()); }
  void ApplyWorldEvents();
  /// Applies an event of the current instant.
  void Apply(const WorldEvent& event);
  void DrivePin(const WorldEvent& event);
  void AdvanceProfiles();
  /// One that moves and is not driven.
  void AdvanceProfile(size_t index);
  /// The sample of the profile now, according to its mode.
  void SampleProfile(size_t index);
  /// The same for a profile at rest, which must not begin to move towards a latched limit.
  void BeginProfile(size_t index);
  /// True if an axis of the profile has a latched limit in a direction, given by its sign.
  bool LimitForbids(size_t profile, double direction) const;
  /// True for a slave whose master is planned by a coordinate system.
  bool FollowsCrd(const Profile& profile) const;
  void AdvanceCrd(Crd& crd);
  /// Reports that a run ended because its FIFO was empty.
  void TellRunEnd(const Crd& crd) const;
  /// Executes a buffered command, at the tick in which the segment before it ended.
  void CarryOut(Crd& crd, const BufferedCommand& command);
  void StartBufferedMove(Crd& crd, const BufferedCommand& command);
  /// True if the profile that a path waits for is still moving.
  bool AwaitedMoveUnderWay(const Crd& crd) const;
  /// Ends the wait if the profile has arrived, and pauses the run if the profile was stopped before
  /// its target.
  void JudgeAwaitedMove(Crd& crd);
  void StartGear(Crd& crd, const BufferedCommand& command);
  /// Writes the outputs of the member profiles and of GT_BufGear profiles for the current point of
  /// the path.
  void WriteCrd(Crd& crd);
  void MapProfiles();
  void GuardAxis(size_t index);
  void AdvanceMachine();
  void AdvanceAuxiliary();
  void AdvanceCompensations();
  /// Positions of motors and encoders before the motion of a cycle, and of the encoders after it.
  struct CycleWay {
    std::array<double, kAxisMax> machines{};
    EncoderWay encoders;
  };
  /// True if something depends on the positions that a motor passes inside a cycle.
  bool Observed() const;
  /// AdvanceMachine() and the marks that are passed meanwhile.
  void AdvanceObserved();
  /// Applies the input edges that occur inside the cycle.
  void PassWorldEdges(const CycleWay& way);
  void PassComparePoints(const CycleWay& way);
  void OperateSwitch(const PositionSwitch& contact, const CycleWay& way);
  void PassIndexMarks(const CycleWay& way);
  /// An encoder's position at a fraction of the cycle, and at a position on a motor's way.
  double PositionAt(size_t encoder, double fraction, const CycleWay& way) const;
  double PositionWhere(size_t encoder, size_t machine, double place, const CycleWay& way) const;
  void AdvanceHomings();
  void AdvanceHoming(size_t index);
  void BeginHomingSearch(size_t index);
  void SearchHome(size_t index);
  void SearchIndex(size_t index);
  void ArmHoming(size_t trigger, CaptureSource source, bool rising);
  void SearchIndexSimply(size_t index);
  /// Planned minus measured position of an axis at rest, without its compensation.
  double PlannedAhead(size_t index) const;
  /// The profile position that corresponds to a captured position.
  double ProfilePositionOf(size_t index, double captured) const;
  /// Next steps of homing: after a capture, after a stop by homing, after a move.
  void TakeHomingCapture(size_t index);
  void ContinueHoming(size_t index);
  void ArriveHoming(size_t index);
  void EndHoming(size_t index);
  void FailHoming(size_t index, HomeError error);
  /// Starts a move by `distance` from the current position.
  void MoveHoming(size_t index, HomeStage stage, double distance, double velocity);
  /// The capture that an axis' homing uses.
  size_t HomingTrigger(size_t index) const;
  /// The limit input in a direction, and the same with the latched status bit.
  bool LimitActive(size_t index, int direction) const;
  bool LimitReached(size_t index, int direction) const;
  /// Clears the latched limit bit of a direction if its cause is gone.
  void ForgetLimit(size_t index, int direction);
  void AdvancePlant(size_t index);
  /// The axis whose enable output enables a motor's drive; the axis with the same number if no axis
  /// commands it.
  size_t EnablingAxis(size_t plant) const {
    const int8_t axis = state_.plants[plant].axis;
    return axis >= 0 ? static_cast<size_t>(axis) : plant;
  }
  bool Enabled(size_t plant) const { return state_.axes[EnablingAxis(plant)].servo_on; }
  /// One cycle of a motor that is turned by hand, without a drive or with the drive off.
  void TurnByHand(Plant& plant);
  void AdvanceClosedLoop(size_t index);
  void ResetAxes();
  void ResetMachine();
  void EnableMachine(size_t axis);
  void DisableMachine(size_t axis);
  /// Adapts to a planned position that was changed by -difference without motion.
  void KeepMachine(size_t axis, double difference);
  void JudgeAxis(size_t index);
  void JudgeControl(Control& control);
  /// Stops an axis whose following error exceeds its limit, or whose encoder is silent.
  void FailControl(const Control& control, double error);
  /// True if the skew of the gantry exceeds its limit.
  void JudgeGantry();
  /// The part of an axis' controller output that the gantry adds, DAC units.
  double GantryCorrection(size_t axis) const;
  /// True if the controlled encoder has not counted for too long while its motor was driven.
  bool EncoderSilent(Control& control);

  /// The planned values of an axis from its profiles now.
  MasterValue PlannedAxis(const Axis& axis) const;
  /// The mapped sum of an axis' profiles or encoders, without the offset.
  double MappedProfiles(const Axis& axis) const;
  double MappedEncoders(const Axis& axis) const;
  /// The count of an encoder's source, with fractions of pulses.
  double SourcePosition(size_t index) const {
    const Encoder& encoder = state_.encoders[index];
    if (!encoder.external) return state_.steps[index].position;
    const double direction = encoder.reversed == encoder.wired_reversed ? 1 : -1;
    return direction * state_.plants[index].position + state_.encoder_faults[index].slip;
  }
  /// The same in whole pulses, with the reading error.
  double EncoderSource(size_t index) const {
    const double whole = Whole(SourcePosition(index));
    return state_.encoders[index].external ? whole + state_.encoder_faults[index].error : whole;
  }
  /// The planned axis position that is sent to the drive.
  double CommandedPosition(size_t axis) const {
    return state_.axes[axis].profile.position + state_.compensations[axis].Amount();
  }
  /// The axis position from the controller's encoder now, between two ticks.
  double MeasuredPosition(const Control& control) const;
  /// Sets the planned position to the measured position, without motion.
  void AlignWithEncoder(size_t index);
  /// Applies the fault of an encoder for one cycle.
  void AdvanceEncoderFault(size_t index);
  /// What its source has done in the cycle, after AdvanceEncoderFault().
  void CountEncoder(size_t index);
  /// The conditions to latch whose causes exist now; following errors are handled separately.
  uint32_t ActiveCauses(const Axis& axis) const;
  /// Latches the conditions whose causes exist before the first tick, as that tick would.
  void LatchCauses();
  /// Keeps the slaves of a master still whose position was changed without motion.
  void ShiftSlaves(const Master& master, double shift);
  /// Changes the measured position of an axis without motion.
  void MoveEncoderOrigin(size_t index, double position);
  /// Changes the planned position of an axis without motion; the second function also changes it
  /// relative to the profiles.
  void MoveAxisOrigin(size_t index, double position);
  void RenamePlanned(size_t index, double position);
  /// Stops every profile that an axis maps.
  void StopAxis(const Axis& axis, bool abrupt);

  MotionConfig config_;
  MotionState state_;
  HappeningObserver observer_;
};

}  // namespace oncard::motion
