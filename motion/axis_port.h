// All that a sequence such as homing may see and do of one axis: it moves the profile of the same
// number in mode Trap, and uses limits, inputs and captures. Lanes must have been left. Tested by
// tests/motion/homing_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "motion/common/sample.h"
#include "motion/core_parts.h"
#include "motion/io/capture.h"
#include "motion/profiles/trap_mode.h"

namespace oncard::motion {

class AxisPort {
 public:
  AxisPort(CoreParts core, size_t axis) : core_(core), index_(axis) {}

  size_t axis() const { return index_; }
  bool enabled() const;
  /// The profile's output, which moves until the axis' input shaper has settled.
  Sample now() const;
  /// True if the profile is being stopped.
  bool stopping() const;

  /// The parameters of the moves that follow. Replanning allocates nothing later.
  void SetRamps(const TrapParameters& parameters);
  /// Starts a move to a position of the profile.
  void Move(int32_t target, double velocity);
  /// Stops it, abruptly or with a deceleration.
  void Stop();
  void Stop(double deceleration);

  /// The level of the home input.
  bool HomeActive() const;
  /// True if the pin of the home input is connected and has the level that follows the edge for
  /// which its capture waits.
  bool AtHome() const;
  /// The limit input in a direction, given by its sign, and the same or the latched condition.
  bool LimitActive(int direction) const;
  bool LimitReached(int direction) const;
  /// Forgets the latched limit of a direction if its cause is gone.
  void ForgetLimit(int direction);

  /// Arms a capture, as its registers say or for one edge of a direction.
  void Arm(size_t capture, CaptureSource source);
  void ArmOnce(size_t capture, CaptureSource source, bool rising);
  void Disarm(size_t capture);
  /// The position that was captured; empty while there is none.
  std::optional<double> Captured(size_t capture) const;
  /// True if the encoder of that number is active.
  bool HasEncoder(size_t encoder) const;

  /// Planned minus measured position of the axis at rest, without its compensation.
  double PlannedAhead() const;
  /// The profile position that corresponds to a position of an encoder, if the plan is `ahead`.
  double ProfilePositionOf(size_t encoder, double position, double ahead) const;

 private:
  const Axis& registers() const { return core_.state.axes[index_]; }

  CoreParts core_;
  size_t index_;
};

}  // namespace oncard::motion
