// What a card is after a reset, as far as families of cards differ in it. The values here are
// neutral; each family has its own (gtcalls/family.h). Tested by tests/motion/motion_core_test.cc.
#pragma once

#include <cstdint>

namespace oncard::motion {

struct CardDefaults {
  double smooth_stop = 1;     ///< decelerations of stops, pulse/ms^2
  double abrupt_stop = 1000;  ///< the same
  /// Ticks that a new level of an input must last.
  uint16_t filter_ticks = 3;
  bool alarm_on = true;                   ///< axes react to their alarm inputs
  bool limits_on = true;                  ///< and to their limit switches
  bool encoders_external = true;          ///< false: they count the pulse outputs
  bool encoders_reversed = false;         ///< the sense of the encoders, which matches their wiring
  bool closed_loop = false;               ///< drives are commanded by servo controllers
  int64_t following_error_limit = 32767;  ///< pulses
  /// Exceeding it switches the drive off and stops abruptly; false: only the condition is latched.
  bool following_error_stops = true;
  /// A drive that is enabled in closed loop continues from where its axis is; false: it moves to
  /// the plan.
  bool enabling_aligns = true;
  /// Slaves are computed after all other profiles, so that they do not lag behind; false: in the
  /// order of their numbers, unless a coordinate system plans their masters.
  bool slaves_last = false;
  /// Encoders that belong to no axis, unless there are too many axes.
  bool auxiliary_encoders = true;
  bool spindle = false;  ///< the card has the analogue output of a spindle
};

}  // namespace oncard::motion
