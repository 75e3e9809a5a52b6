// Events outside the card over time: a list that the motion core processes at the begin of its
// ticks. An event takes effect in the first cycle that begins at or after its instant; events at 0
// have already happened when the card is switched on. Tested by tests/motion/world_test.cc.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "motion/common/sizes.h"

namespace oncard::motion {

enum class WorldEventKind : uint8_t {
  kPin,              ///< item: DiType, index: bit, value: level
  kAdc,              ///< item: channel, value: volts
  kModuleInputs,     ///< item: module, value: word
  kModuleVoltage,    ///< item: module, index: channel, value: volts
  kStall,            ///< item: motor, value: 1 stalled, 0 free
  kHand,             ///< item: motor, value: velocity at which it is turned by hand, pulse/ms
  kEncoderHeld,      ///< item: encoder, value: 1 held, 0 working
  kEncoderNoise,     ///< item: encoder, index: seed, value: largest error in pulses
  kEncoderDrift,     ///< item: encoder, value: pulse/ms
  kSwitchConnected,  ///< index: of MotionState::switches, value: 1 connected, 0 cut
  kSwitchFirst,      ///< the same, value: PositionSwitch::first
  kSwitchLast,       ///< the same, value: PositionSwitch::last
  // Of a bus; item: slave.
  kBusProbe,     ///< index: touch probe, value: level of its input
  kBusTerminal,  ///< index: of a drive the ObjectId, else the entry of its inputs; value: its own
  kBusLost,      ///< value 1: it does not answer any more
  kBusSilent     ///< value 1: it does not answer to process data any more
};

/// Everything counts from 0.
struct WorldEvent {
  Micros at = 0;  ///< since power-on
  WorldEventKind kind = WorldEventKind::kPin;
  uint8_t item = 0;
  uint16_t index = 0;
  double value = 0;

  auto Fields(auto visit) const { return visit(at, kind, item, index, value); }
  bool operator==(const WorldEvent&) const = default;
};

/// In order of time; events of one instant act in the order of the list.
using WorldEvents = std::vector<WorldEvent>;

/// Number of events already processed.
struct WorldProgress {
  std::shared_ptr<const WorldEvents> events;
  uint64_t next = 0;

  auto Fields(auto visit) const { return visit(events, next); }
};

}  // namespace oncard::motion
