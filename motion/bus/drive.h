// A drive on the bus: its state machine, modes of operation, homing and touch probes around a motor
// of the world (CiA 402-2). It takes its outputs from its dictionary, advances by one bus cycle and
// puts what it measures back into the dictionary.
//
// Modes (6060h): 0 none, 1 profile position, 3 profile velocity, 4 profile torque, 6 homing, 8, 9
// and 10 cyclic synchronous position, velocity and torque. An ideal motor follows set-points
// exactly; one with a velocity drive is controlled by the drive's position loop. A torque
// accelerates the motor against its lag and friction: the rated torque leads to the speed `gain`
// with the time constant `tau` (assumption; an ideal motor has their standard values).
//
// Units: counts of the motor's encoder and ms inside, those of objects.def in the dictionary.
// Deterministic; not thread-safe. Tested by tests/motion/bus/drive_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/bus/drive_states.h"
#include "motion/bus/homing_methods.h"
#include "motion/bus/objects.h"
#include "motion/bus/ramp.h"
#include "motion/bus/touch_probes.h"
#include "motion/mechanics/plant.h"
#include "motion/mechanics/switches_and_marks.h"

namespace oncard::motion::bus {

/// Assumption: the position loop of a drive multiplies the error by 1 / (4 lag), which is the
/// largest gain that does not overshoot.
inline constexpr double kPositionLoopLags = 4;
/// Assumption: homing ends when the motor rests so near to the home position, counts.
inline constexpr double kHomingWindow = 10;
/// Milliseconds: the dictionary counts seconds.
inline constexpr double kPerSecond = 1000;

/// 6060h.
enum class DriveMode : uint8_t {
  kNone = 0,
  kProfilePosition = 1,
  kProfileVelocity = 3,
  kProfileTorque = 4,
  kHoming = 6,
  kCyclicPosition = 8,
  kCyclicVelocity = 9,
  kCyclicTorque = 10
};
/// True for the modes above.
bool IsSupportedMode(int64_t mode);

/// Counts that a drive does not leave.
struct CountRange {
  double low = 0;
  double high = 0;
};

/// An edge of a probe input inside a cycle.
struct ProbeEdge {
  uint8_t probe = 0;
  bool level = false;
  double fraction = 0;  ///< of the cycle, from 0 to 1
};

/// The surroundings of a drive in one cycle.
struct DriveWorld {
  Plant& motor;
  const motion::Drive& mechanics;
  const IndexMarks& marks;
  /// Switches that the motor operates, of any axis; only those of `axis` count.
  std::span<const PositionSwitch> switches;
  size_t axis = 0;
  /// Levels of the pins at which switches are operated from outside, at the begin of the cycle.
  std::array<bool, kSwitchCount> pins{};
  std::span<const ProbeEdge> probe_edges;
  int64_t cycle_us = 250;
  int64_t servo_us = 125;

  double cycle_ms() const { return static_cast<double>(cycle_us) / kPerSecond; }
};

class BusDrive {
 public:
  ObjectValues& values() { return values_; }
  const ObjectValues& values() const { return values_; }
  DriveState state() const { return state_; }
  bool enabled() const { return state_ == DriveState::kOperationEnabled; }
  const HomingRun& homing() const { return homing_; }
  DriveMode mode() const { return mode_; }
  /// Plant::position at which 6064h is 0.
  double origin() const { return origin_; }
  /// What the motor follows, as Plant::position.
  const Ramp& ramp() const { return ramp_; }
  /// The software limits 607Dh; infinite if there are none.
  CountRange SoftLimits() const;
  /// The gain of the position loop, 1/ms.
  static double LoopGain(const motion::Drive& mechanics, double servo_ms);

  /// Switched on, with the motor there: 6064h is 0.
  void PowerOn(double motor);
  /// One bus cycle.
  void Advance(const DriveWorld& world);
  /// The bus does not reach the drive: it disables itself; a motor that is off can be turned by
  /// hand.
  void AdvanceAlone(const DriveWorld& world);
  /// It has lost the bus while it was operational: a fault.
  void LoseBus();
  /// The bus leaves the operational state: it is disabled.
  void Disable();
  /// True if the cycles from now on only move the motor towards the target position, or leave it
  /// where it is, as long as nothing but the target changes and the motor operates no switch. All
  /// that such a cycle leaves for the next one is where the ramp is.
  bool OnlyMoves(const DriveWorld& world) const;
  /// Such cycles have passed.
  void ContinueFrom(double ramp_position) { ramp_.position = ramp_position; }
  /// The level of a probe input at power-on.
  void SetProbeLevel(size_t probe, bool level) { probes_.levels[probe] = level; }

  auto Fields(auto visit) const {
    return visit(values_, state_, mode_, control_before_, ramp_, origin_, operated_, homing_,
                 homing_done_, probes_, set_point_, positioning_, acknowledged_);
  }

 private:
  // What a mode does in a cycle.
  void AdvanceState(const DriveWorld& world);
  void TakeMode(double motor);
  void MoveEnabled(const DriveWorld& world);
  void AdvanceCyclicPosition(const DriveWorld& world);
  void AdvanceProfilePosition(const DriveWorld& world);
  void AdvanceHoming(const DriveWorld& world);
  void AdvanceTorque(const DriveWorld& world);
  /// Counts within the software limits 607Dh, if there are any.
  double Bounded(double counts) const;
  /// Moves the set-point towards a velocity, counts/ms, within the limits of the dictionary.
  void RampTo(double velocity, ObjectId acceleration, const DriveWorld& world);
  bool BrakeDown(ObjectId deceleration, const DriveWorld& world);
  /// The motor follows the set-point from where it was at the begin of the cycle.
  void Follow(const Ramp& before, const DriveWorld& world);
  void Idle(const DriveWorld& world);

  // What it measures.
  /// The switches that are operated where the motor is.
  static std::array<bool, kSwitchCount> OperatedAt(const DriveWorld& world);
  std::vector<Passage> PassagesOf(double from, const DriveWorld& world);
  void Measure(double from, double velocity_before, const DriveWorld& world);
  void MeasureTorque(double velocity_before, const DriveWorld& world);
  void Capture(double from, const DriveWorld& world);
  uint16_t StatusWord() const;
  int64_t CountsAt(double place) const;
  double PerMs(ObjectId id) const;
  double PerMs2(ObjectId id) const;
  bool commanded(uint16_t bit) const;

  ObjectValues values_;
  DriveState state_ = DriveState::kNotReady;
  DriveMode mode_ = DriveMode::kNone;
  uint16_t control_before_ = 0;
  Ramp ramp_;          ///< the set-point, as Plant::position
  double origin_ = 0;  ///< Plant::position at which 6064h is 0
  std::array<bool, kSwitchCount> operated_{};
  HomingRun homing_;
  bool homing_done_ = false;
  TouchProbes probes_;
  double set_point_ = 0;      ///< of mode 1, as Plant::position
  bool positioning_ = false;  ///< mode 1 moves to it
  bool acknowledged_ = false;
};

}  // namespace oncard::motion::bus
