// Homing by the drive (CiA 402-2, homing methods 1 to 14, 17 to 30, 33 to 35 and 37), each a row of
// a table: which edge of which switch is passed in which direction, and whether the first index
// mark behind it is the home position.
//
//   search   at the speed for switches, until the edge is passed; a limit switch ahead turns the
//            drive round once, a second one is an error
//   leave    at the speed for the index: the edge was passed in the wrong direction, or the drive
//            began on the switch
//   index    at the same speed, to the next index mark
//   return   to the home position, where the drive stands in the end (assumption)
//
// Positions in counts of the motor, speeds in counts/ms. Not thread-safe. Tested by
// tests/motion/bus/homing_methods_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "motion/bus/ramp.h"

namespace oncard::motion::bus {

/// What a drive sees on its way.
enum class Sensor : uint8_t { kNegativeLimit, kPositiveLimit, kHome, kIndex };
inline constexpr size_t kSwitchCount = 3;

/// A switch that changes, or an index mark, where the motor passes it.
struct Passage {
  Sensor sensor = Sensor::kIndex;
  double place = 0;
  bool rises = true;  ///< of a switch: it is operated from here on
};

/// One method.
struct HomingMethod {
  std::optional<Sensor> contact;  ///< the switch; empty: none
  bool left_edge = false;         ///< the edge with the smaller position of the switch
  int8_t direction = 0;           ///< in which the edge, or the index mark, is passed in the end
  int8_t begin = 0;               ///< in which the search begins while the switch is not operated
  bool index = false;             ///< home is the next index mark
};

/// Empty for a number that is not supported.
std::optional<HomingMethod> FindHomingMethod(int64_t number);

enum class HomingPhase : uint8_t { kIdle, kSearch, kLeave, kIndex, kReturn, kDone, kFailed };

struct HomingSpeeds {
  double search = 0;
  double leave = 0;
  double acceleration = 0;
};

/// A homing run.
struct HomingRun {
  HomingPhase phase = HomingPhase::kIdle;
  int8_t method = 0;
  int8_t direction = 0;
  uint8_t limits = 0;  ///< limit switches that have turned the drive round
  double home = 0;     ///< found, from kReturn on

  /// Begins with a supported method and the switches as they are; `at`: where the motor is.
  void Begin(int8_t number, const std::array<bool, kSwitchCount>& operated, double at);
  /// The set-point of the next cycle; true when it rests at the home position.
  bool Advance(Ramp& ramp, const HomingSpeeds& speeds, double ms) const;
  /// What the motor has passed, in order; `forward`: it moves to larger positions.
  void Pass(const std::vector<Passage>& passages, bool forward);

  bool running() const {
    return phase != HomingPhase::kIdle && phase != HomingPhase::kDone &&
           phase != HomingPhase::kFailed;
  }

  auto Fields(auto visit) const { return visit(phase, method, direction, limits, home); }

 private:
  void PassOne(const Passage& passage, const HomingMethod& row);
  void MeetLimit();
};

}  // namespace oncard::motion::bus
