// What the buffers of a coordinate system hold: segments, and commands that act between them.
// Tested by tests/motion/crd_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "motion/paths/item_queue.h"
#include "motion/paths/segment.h"

namespace oncard::motion {

/// What a buffered command does; `item` and `detail` number things from 0.
enum class BufferedKind : uint8_t {
  kDelay,         ///< values[0]: ms
  kOutputs,       ///< item: DoType; values: mask, value
  kPulses,        ///< item: DoType, detail: bit; values: high us, low us, pulses, first level
  kStopPulses,    ///< item: DoType, detail: bit
  kAnalogOutput,  ///< item: DAC; values[0]: value
  kLimits,        ///< item: axis; detail: -1 both, 0 positive, 1 negative; values[0]: on
  kStopInput,     ///< item: axis; detail: 1 abrupt, 0 smooth; values: DiType, bit
  kMove,          ///< item: profile; detail: 1 waits; values: position, velocity, acceleration
  kGear,          ///< item: profile; values: displacement, part of ramp up, part of ramp down
  kHold,          ///< the run pauses here until it is started again
  kSynchronise,   ///< item: profile; detail: encoder that gives its position
  kComparePulse,  ///< item: 0 pulse, 1 level; values: level, us. At both high-speed outputs
  kLaserSwitch,   ///< item: laser; detail: 1 on, 0 off
  kLaserPower,    ///< item: laser; values[0]: power
  kLaserFollow,   ///< item: laser; detail: coordinate system; values: ratio, least, most power
  kLaserSource,   ///< item: laser; detail: LaserSource
  kOutside        ///< outside the motion core, whose owner carries it out (MotionState::reached)
                  ///< and gives the members their meaning
};

struct BufferedCommand {
  BufferedKind kind = BufferedKind::kDelay;
  int32_t item = 0;
  int32_t detail = 0;
  std::array<double, 4> values{};

  /// True if the path must be at rest before the command.
  bool NeedsRest() const {
    return kind == BufferedKind::kDelay || kind == BufferedKind::kHold ||
           (kind == BufferedKind::kMove && detail == 1);
  }

  auto Fields(auto visit) const { return visit(kind, item, detail, values); }
};

/// What the path planner has decided about a segment (path_planner.h), besides its velocities.
struct PlannedMotion {
  bool planned = false;
  /// The axes' limits change along the segment, an arc; its motion is planned piece by piece.
  bool curved = false;
  /// The largest velocity and acceleration of each coordinate, if curved.
  Coordinates axis_velocity{};
  Coordinates axis_acceleration{};

  bool in_use() const { return planned; }
  auto Fields(auto visit) const { return visit(curved, axis_velocity, axis_acceleration); }
};

/// A segment that begins wherever the path is when it is reached.
struct PathApproach {
  /// Bit n: coordinate n goes along a line to Segment::end, the others stay. 0: the segment begins
  /// where the one before it ends.
  uint8_t axes = 0;

  bool in_use() const { return axes != 0; }
  auto Fields(auto visit) const { return visit(axes); }
};

/// One element of a buffer.
struct PathSlot {
  bool is_segment = false;
  BufferedCommand command;  ///< unless it is a segment
  // A segment with its velocities and acceleration, pulse/ms and pulse/ms^2.
  Segment segment;
  double velocity = 0;  ///< as commanded
  double acceleration = 0;
  double end_velocity = 0;
  /// The velocity that the axes' own limits and the curvature allow; no override exceeds it.
  double velocity_limit = std::numeric_limits<double>::max();
  bool ends_at_rest = false;     ///< G0, or followed by a command that needs rest
  bool second_override = false;  ///< scaled by GT_SetOverride2
  int32_t user_number = 0;       ///< GT_SetUserSegNum
  int32_t given_number = 0;      ///< of the WN forms
  PlannedMotion planned;
  PathApproach approach;  ///< if in use, it must rest at its end

  /// Where an approach that begins at a point ends.
  Coordinates ApproachEnd(const Coordinates& from) const {
    Coordinates end = from;
    for (size_t i = 0; i < end.size(); ++i) {
      if ((approach.axes >> i & 1) != 0) end[i] = segment.end[i];
    }
    return end;
  }

  auto Fields(auto visit) const {
    return visit(is_segment, command, segment, velocity, acceleration, end_velocity, velocity_limit,
                 ends_at_rest, second_override, user_number, given_number, planned, approach);
  }
};

/// The slots of a buffer.
struct SlotQueue : ItemQueue<PathSlot> {
  size_t CountSegments() const {
    size_t count = 0;
    for (size_t i = head; i < slots.size(); ++i) count += slots[i].is_segment ? 1 : 0;
    return count;
  }
  /// The last segment if only commands follow it; nullptr if there is none.
  PathSlot* LastSegment() {
    for (size_t i = slots.size(); i > head; --i) {
      if (slots[i - 1].is_segment) return &slots[i - 1];
    }
    return nullptr;
  }
};

inline const SlotQueue kNoSlots;

}  // namespace oncard::motion
