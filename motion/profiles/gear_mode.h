// Electronic gear: a profile follows a master at a ratio.
//
// A new ratio takes effect over the clutch, `slope` pulses of the master: the ratio is linear in
// the master's displacement, so the slave's position is a polynomial of it and no rounding
// accumulates. If the master reverses inside the clutch, the ratio decreases again.
//
// A family can give the ratio as one real number instead (DirectRatio). Such a slave stays engaged
// at a limit: it rests there while its master leads on, and follows again when the master turns.
//
// Source: GTS manual 7.5; the linear clutch is an assumption. GT-400 manual 4.1.4 and 7.3. Tested
// by tests/motion/gear_mode_test.cc.
#pragma once

#include <cstdint>

#include "motion/common/sample.h"
#include "motion/profiles/master.h"

namespace oncard::motion {

/// When a started slave begins to follow (GT_SetGearEvent). What the events mean is an assumption:
/// the public header only names them.
enum class GearEvent : uint8_t {
  kStart,  ///< at once
  kPass,   ///< when the master passes a position
  kArea,   ///< when the master is between two positions
};

/// The ratio of a slave that stays engaged at limits.
struct DirectRatio {
  bool given = false;  ///< it replaces the ratio of two integers
  double value = 0;    ///< slave/master
  bool held = false;   ///< the slave rests at a limit, towards which its master leads

  bool in_use() const { return given; }
  auto Fields(auto visit) const { return visit(given, value, held); }
};

struct GearMode {
  // Registers.
  int8_t direction = 0;  ///< GT_PrfGear: 0 both, 1 and -1 one direction of the master
  Master master;
  bool ratio_set = false;
  int32_t master_even = 1;  ///< > 0
  int32_t slave_even = 1;
  int32_t slope = 0;  ///< pulses of the master; not 1
  GearEvent event = GearEvent::kStart;
  int32_t event_first = 0;
  int32_t event_last = 0;
  DirectRatio direct;

  // The run.
  bool running = false;
  bool waiting = false;  ///< for the event
  double base = 0;       ///< the slave's position at the begin of the clutch
  double from_ratio = 0;
  double to_ratio = 0;
  double clutch = 0;  ///< pulses of the master
  MasterTravel travel;

  /// The direction, as a sign, in which a start would move the slave at once; 0: it would not move.
  double Direction(const MasterValue& value) const;
  /// Begins to follow, or waits for the event; the ratio of the registers is reached over the
  /// clutch.
  void Start(const Sample& from, const MasterValue& value);
  /// Applies the ratio of the registers in motion.
  void ChangeRatio(const Sample& now);
  /// The slave's output.
  Sample At(const Sample& now, const MasterValue& value);
  /// Holds the slave where it is: what the master has moved so far does not move it any more.
  void Hold(const Sample& now);
  /// Something else has taken over; the registers stay.
  void Halt() { running = direct.held = false; }

  auto Fields(auto visit) const {
    return visit(direction, master, ratio_set, master_even, slave_even, slope, event, event_first,
                 event_last, running, waiting, base, from_ratio, to_ratio, clutch, travel, direct);
  }

 private:
  double Ratio() const {
    return direct.given ? direct.value : static_cast<double>(slave_even) / master_even;
  }
  /// `engaged`: the distance that the master has moved in the clutch, in either direction.
  double RatioAt(double engaged) const;
  /// The position of the master, between two of its positions, at which the wait ends.
  bool EventBetween(double before, double after, double* position) const;
};

}  // namespace oncard::motion
