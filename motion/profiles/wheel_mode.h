// Motion that follows a hand wheel (mode HandWheel): a move to where the wheel points, which is
// planned again in every cycle.
//
// The target is the position at the start plus a ratio times what the master has moved since. The
// profile goes there with a velocity and an acceleration at most, unlike a gear, and therefore
// later if the wheel is turned too fast; when the wheel rests, it ends exactly there. Source: GE
// manual 10.3; GTS cards do not have the mode. Tested by tests/motion/wheel_mode_test.cc.
#pragma once

#include "motion/common/sample.h"
#include "motion/profiles/master.h"
#include "motion/profiles/plan.h"

namespace oncard::motion {

struct WheelMode {
  // Registers.
  Master master;
  double ratio = 0;  ///< pulses per pulse of the master, signed
  /// The acceleration and deceleration are assumptions as in TrapParameters.
  MoveLimits limits = {.velocity = 0, .acceleration = 1, .deceleration = 1, .start_velocity = 0};
  double cycle = 0;  ///< ms between two outputs: the card's profile cycle

  // The run.
  bool running = false;
  double base = 0;  ///< the position at the start
  MasterTravel travel;

  /// Begins to follow. The run lasts until something else takes over.
  void Start(const Sample& from, const MasterValue& value);
  /// The output one cycle after `from`.
  Sample At(const Sample& from, const MasterValue& value);
  /// Something else has taken over; the registers stay.
  void Halt() { running = false; }

  /// False on a card without a hand wheel.
  bool in_use() const { return master.chosen || running; }
  auto Fields(auto visit) const {
    return visit(master, ratio, limits, cycle, running, base, travel);
  }
};

}  // namespace oncard::motion
