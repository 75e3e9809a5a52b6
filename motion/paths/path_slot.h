// What the buffers of a coordinate system hold: segments, and commands that act between them.
// Tested by tests/motion/crd_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

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

  auto Fields() const { return std::tie(kind, item, detail, values); }
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

  auto Fields() const {
    return std::tie(is_segment, command, segment, velocity, acceleration, end_velocity,
                    velocity_limit, ends_at_rest, second_override, user_number, given_number);
  }
};

/// A queue that does not allocate when elements are removed.
struct SlotQueue {
  std::vector<PathSlot> slots;
  size_t head = 0;

  size_t size() const { return slots.size() - head; }
  bool empty() const { return head == slots.size(); }
  PathSlot& front() { return slots[head]; }
  PathSlot& back() { return slots.back(); }
  PathSlot& At(size_t index) { return slots[head + index]; }
  const PathSlot& At(size_t index) const { return slots[head + index]; }
  void Push(const PathSlot& slot) {
    // Removed elements are erased once they are half of all, so that each slot moves rarely.
    if (head > 0 && head >= slots.size() / 2) {
      slots.erase(slots.begin(), slots.begin() + static_cast<std::ptrdiff_t>(head));
      head = 0;
    }
    slots.push_back(slot);
  }
  void Pop() {
    if (++head < slots.size()) return;
    Clear();
  }
  void Clear() {
    slots.clear();
    head = 0;
  }
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

  /// Removed elements are not part of the value.
  auto Fields() const { return std::tuple(std::span(slots).subspan(head)); }
};

}  // namespace oncard::motion
