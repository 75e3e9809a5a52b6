// The output of a profile at one instant.
#pragma once

namespace oncard::motion {

/// Position [pulse], velocity [pulse/ms], acceleration [pulse/ms^2] of a profile at an instant.
struct Sample {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
  /// Bit 10 of the status word: the run is not over. A slave that waits for its master counts as
  /// moving.
  bool moving = false;

  auto Fields(auto visit) const { return visit(position, velocity, acceleration, moving); }
  bool operator==(const Sample&) const = default;
};

/// A sample at rest.
constexpr Sample AtRest(double position) { return {position, 0, 0, false}; }

}  // namespace oncard::motion
