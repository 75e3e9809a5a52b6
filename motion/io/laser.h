// The laser signals of the high-speed outputs: on or off, and how strong. The card records them;
// what a laser makes of them is not simulated.
//
// The strength, in the unit of its mode, is a command's, or follows the velocity along a path. It
// is always within the bounds of its mode. Source: public header; public laser demonstration
// programs. Tested by tests/gtcalls/laser_command_test.cc.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace oncard::motion {

inline constexpr size_t kLaserCount = 2;

/// What the strength of a laser is.
enum class LaserMode : uint8_t {
  kDuty,       ///< of pulses of a fixed frequency: percent
  kFrequency,  ///< of pulses of a fixed width: kHz
  kVoltage     ///< of an analogue output: V
};

/// What a strength that follows a path follows.
enum class LaserSource : uint8_t {
  kPlanned,  ///< the planned velocity along the path
  kMeasured  ///< the velocity that the encoders of the path's axes count
};

struct LaserBounds {
  double least = 0;
  double most = 0;

  double Within(double value) const { return std::clamp(value, least, most); }
  auto Fields(auto visit) const { return visit(least, most); }
  bool operator==(const LaserBounds&) const = default;
};

struct Laser {
  /// Of kDuty at power-on (assumption).
  static constexpr LaserBounds kFullDuty = {0, 100};

  bool on = false;
  LaserMode mode = LaserMode::kDuty;
  LaserBounds bounds = kFullDuty;  ///< of the mode
  double power = 0;                ///< of the last command, in the unit of the mode
  double pulse_frequency = 0;      ///< kHz, for kDuty
  double pulse_width = 0;          ///< us, for kFrequency
  // A strength that follows is proportional to a velocity.
  bool follows = false;
  uint8_t crd = 0;  ///< whose path it follows
  LaserSource source = LaserSource::kPlanned;
  double ratio = 0;  ///< unit of the mode per pulse/ms
  LaserBounds follow_bounds;

  /// The strength while the path has a velocity, pulse/ms.
  double Power(double velocity) const {
    return bounds.Within(follows ? follow_bounds.Within(ratio * velocity) : power);
  }

  auto Fields(auto visit) const {
    return visit(on, mode, bounds, power, pulse_frequency, pulse_width, follows, crd, source, ratio,
                 follow_bounds);
  }
  bool operator==(const Laser&) const = default;
};

struct Lasers {
  std::array<Laser, kLaserCount> channels;

  /// False as long as no laser command has changed anything since GT_Reset.
  bool in_use() const { return channels != std::array<Laser, kLaserCount>{}; }
  auto Fields(auto visit) const { return visit(channels); }
};

}  // namespace oncard::motion
