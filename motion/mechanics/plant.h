// The mechanics: a motor with its load and drive for each drive connector of the card. They are
// outside the card, so GT_Reset does not change them.
//
// An ideal drive follows an enabled axis exactly, whether it is commanded by pulses or, in closed
// loop, through the servo controller. A velocity drive converts the voltage of its analogue output
// to a speed with a first-order lag; it receives no pulses. A motor whose drive is off can be
// turned by hand; an enabled drive holds it. Tested by tests/motion/plant_test.cc.
#pragma once

#include <cstdint>

#include "motion/common/sizes.h"

namespace oncard::motion {

enum class DriveKind : uint8_t { kIdeal, kVelocity };

/// A drive, which converts commands to motion. The defaults of a velocity drive are assumptions.
struct Drive {
  DriveKind kind = DriveKind::kIdeal;
  double gain = 100;    ///< pulse/ms at the full output of 32767
  double tau = 2;       ///< ms, >= 0: the lag's time constant
  double friction = 0;  ///< pulse/ms that friction takes from the commanded speed
  // Computed by Prepare(); the last two for one servo sub-step h.
  double unit = 0;   ///< pulse/ms for an output of 1
  double decay = 0;  ///< e^(-h/tau): the remaining fraction of a difference in speed
  double lag = 0;    ///< tau (1 - decay), ms: the distance caused by a difference of 1 pulse/ms

  /// Computes the coefficients of the motion from the parameters and the length of a sub-step.
  void Prepare(double servo_ms);
  /// The speed an output commands, pulse/ms.
  double Commanded(double output) const {
    const double speed = unit * output;
    if (speed > friction) return speed - friction;
    return speed < -friction ? speed + friction : 0;
  }

  auto Fields(auto visit) const { return visit(kind, gain, tau, friction, unit, decay, lag); }
};

/// A velocity drive with its coefficients, for servo sub-steps of this length.
Drive VelocityDrive(double gain, double tau, double friction, double servo_ms);

/// e^-x for x >= 0 by series and squaring: the same bits on every machine, relative error below
/// 1e-12 for x < 100.
double ExpMinus(double x);

/// A motor.
struct Plant {
  double position = 0;  ///< pulses since power-on
  double velocity = 0;  ///< pulse/ms
  /// The axis whose planned position commands it and whose enable output enables it, and the servo
  /// controller between them in closed loop; -1: none. Follows from the configuration.
  int8_t axis = -1;
  int8_t control = -1;
  /// Distance to the commanded position while an ideal drive follows it.
  double lead = 0;
  bool stalled = false;  ///< blocked: stays at rest, whatever the drive does
  double hand = 0;  ///< velocity at which it is turned by hand while its drive is off, pulse/ms

  /// One servo sub-step of a velocity drive at `output`: the lag's exact solution. It has the
  /// length for which the drive was prepared.
  void Advance(const Drive& drive, double output, double servo_ms) {
    if (stalled) return;
    const double commanded = drive.Commanded(output);
    const double difference = velocity - commanded;
    position += commanded * servo_ms + difference * drive.lag;
    velocity = commanded + difference * drive.decay;
  }

  auto Fields(auto visit) const {
    return visit(position, velocity, axis, control, lead, stalled, hand);
  }
};

/// Step::mode.
inline constexpr int16_t kPulseAndDirection = 0;
inline constexpr int16_t kForwardAndBackward = 1;

/// A pulse output.
struct Step {
  bool active = true;  ///< configuration
  int8_t axis = -1;    ///< the axis whose planned position it outputs, from 0; -1: none
  int16_t mode = kPulseAndDirection;
  int16_t parameter = 0;  ///< of the configuration; its meaning is unknown
  bool reversed = false;  ///< the wiring matches it
  double position = 0;    ///< pulses output
  double lead = 0;        ///< distance to the planned axis position

  auto Fields(auto visit) const {
    return visit(active, axis, mode, parameter, reversed, position, lead);
  }
};

}  // namespace oncard::motion
