// The set-point that a drive makes by itself: in a profile or homing mode, and while it stops.
// Velocity changes with a constant acceleration. Positions in counts, velocities in counts/ms,
// accelerations in counts/ms^2. Tested by tests/motion/bus/drive_test.cc.
#pragma once

namespace oncard::motion::bus {

struct Ramp {
  double position = 0;
  double velocity = 0;

  /// One cycle of `ms` towards a velocity; acceleration > 0.
  void TowardsVelocity(double target, double acceleration, double ms);
  /// One cycle towards a position, at most at `speed`; true when it is reached, at rest.
  bool TowardsPosition(double target, double speed, double acceleration, double ms);
  /// At rest there.
  void Rest(double at) { *this = {at, 0}; }

  auto Fields(auto visit) const { return visit(position, velocity); }
};

}  // namespace oncard::motion::bus
