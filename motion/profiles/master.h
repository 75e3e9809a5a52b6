// The master of a slave profile (Gear, Follow, HandWheel). Source: GTS manual 7.5, 7.6.
#pragma once

#include <cstdint>

namespace oncard::motion {

enum class MasterType : uint8_t { kEncoder, kProfile, kAxis };

struct Master {
  bool chosen = false;  ///< a master has been set
  MasterType type = MasterType::kProfile;
  uint8_t index = 0;          ///< from 0
  bool encoder_side = false;  ///< of an axis: its encoder position instead of its planned position

  auto Fields(auto visit) const { return visit(chosen, type, index, encoder_side); }
  bool operator==(const Master&) const = default;
};

/// A master at an instant; pulse, pulse/ms, pulse/ms^2.
struct MasterValue {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
};

/// The distance that a master has moved in the directions that a slave follows: 0 both, 1 and -1
/// one of them. Motion in the other direction is not counted.
struct MasterTravel {
  int8_t direction = 0;
  double last = 0;    ///< the master's position at the last reading
  double travel = 0;  ///< pulses, signed, since Restart()

  /// Restarts counting at a position of the master.
  void Restart(double position) {
    last = position;
    travel = 0;
  }
  void MoveTo(double position) {
    const double step = position - last;
    if (step * direction >= 0) travel += step;
    last = position;
  }
  /// True when motion at this velocity is counted.
  bool Counts(double velocity) const { return velocity * direction >= 0; }

  auto Fields(auto visit) const { return visit(direction, last, travel); }
};

}  // namespace oncard::motion
