// What acts on a card from outside: levels of pins, voltages, hands on motors, faults of encoders
// and switches. Tested by tests/motion/world_test.cc.
#pragma once

#include <memory>

#include "motion/motion_state.h"
#include "motion/readings.h"

namespace oncard::motion {

class World {
 public:
  World(MotionState& state, const MotionConfig& config)
      : state_(state), readings_(state, config), now_(state.cycle * config.cycle_us) {}

  /// The surroundings of a card that is switched on: events at instant 0 have already happened,
  /// switches match the positions of their motors, and the filters have accepted all levels.
  void PowerOn(std::shared_ptr<const WorldEvents> events);
  /// Other events, of which as many have happened; what lasts acts as the new ones say.
  void Replace(std::shared_ptr<const WorldEvents> events);
  /// Applies the events up to now.
  void ApplyEvents();
  /// Lets an event happen now that is not among these; its own instant does not matter.
  void Happen(WorldEvent event);

 private:
  /// Applies an event of the current instant.
  void Apply(const WorldEvent& event);
  /// Applies one that concerns a slave of the card's bus.
  void ApplyToBus(const WorldEvent& event);
  void DrivePin(const WorldEvent& event);
  Micros now() const { return now_; }

  MotionState& state_;
  Readings readings_;
  Micros now_;
};

}  // namespace oncard::motion
