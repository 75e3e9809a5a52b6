// The unit in which people measure an axis, such as mm. Commands and the state of the card count
// pulses and milliseconds; numbers are converted where they are read from a file or shown.
// Velocities are per second then, accelerations per second squared. A plain value. Tested by
// tests/runtime/axis_units_test.cc.
#pragma once

#include <cstdint>
#include <string>

namespace oncard::runtime {

/// What is measured along an axis.
enum class AxisMeasure : uint8_t { kPosition, kVelocity, kAcceleration };

struct AxisUnit {
  std::string name;   ///< `mm`; empty: pulses and milliseconds
  double pulses = 1;  ///< in one of them, > 0

  bool named() const { return !name.empty(); }
  /// From the unit to pulses, pulse/ms or pulse/ms^2.
  double ToPulses(double value, AxisMeasure measure) const {
    return named() ? value * pulses / PartsOfSecond(measure) : value;
  }
  /// The reverse.
  double FromPulses(double value, AxisMeasure measure) const {
    return named() ? value * PartsOfSecond(measure) / pulses : value;
  }
  /// `mm`, `mm/s` or `mm/s²`.
  std::string NameOf(AxisMeasure measure) const {
    constexpr const char* kEnds[] = {"", "/s", "/s²"};
    return name + kEnds[static_cast<int>(measure)];
  }

 private:
  /// What a quantity that is counted in milliseconds is multiplied by.
  static double PartsOfSecond(AxisMeasure measure) {
    constexpr double kParts[] = {1, 1000, 1000 * 1000};
    return kParts[static_cast<int>(measure)];
  }
};

}  // namespace oncard::runtime
