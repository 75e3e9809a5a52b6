#include "gtcalls/gt400/status_word.h"

#include "gtcalls/gt400/axis_state.h"
#include "gtcalls/gt400/events.h"

namespace oncard::gtcalls::gt400 {
namespace {

constexpr uint32_t kLoopClosedBit = 1u << 8;
constexpr uint32_t kDriveOnBit = 1u << 9;
constexpr uint32_t kMovesBit = 1u << 10;
constexpr uint32_t kLimitsOnBit = 1u << 11;
constexpr int kAxisShift = 12;
constexpr uint32_t kHomeArmedBit = 1u << 14;
constexpr uint32_t kIndexArmedBit = 1u << 15;

constexpr uint16_t kAutoStopBit = 1u << 7;
constexpr uint16_t kAutoUpdateBit = 1u << 10;
constexpr int kModeShift = 11;

}  // namespace

uint32_t StatusWord(const CardView& card, size_t axis) {
  const motion::Axis& state = card.motion.axis(axis);
  uint32_t word = EventsOf(card, axis) | static_cast<uint32_t>(axis) << kAxisShift;
  if (!AxisState(card, axis).open_loop) word |= kLoopClosedBit;
  if (state.servo_on) word |= kDriveOnBit;
  if (Moves(card, axis)) word |= kMovesBit;
  if (state.positive_limit_on) word |= kLimitsOnBit;
  const motion::Capture& capture = card.motion.part<&motion::MotionState::capture>().capture(axis);
  if (capture.armed && capture.source == motion::CaptureSource::kHome) word |= kHomeArmedBit;
  if (capture.armed && capture.source == motion::CaptureSource::kIndex) word |= kIndexArmedBit;
  return word;
}

uint16_t ModeRegister(const CardView& card, size_t axis) {
  const Gt400Axis& state = AxisState(card, axis);
  uint32_t word = static_cast<uint32_t>(ModeNumber(card.motion.profile(axis).mode)) << kModeShift;
  if (state.auto_stop) word |= kAutoStopBit;
  if (state.auto_update) word |= kAutoUpdateBit;
  return static_cast<uint16_t>(word);
}

int ModeNumber(motion::ProfileMode mode) {
  switch (mode) {
    case motion::ProfileMode::kJog:
      return 1;
    case motion::ProfileMode::kSCurve:
      return 2;
    case motion::ProfileMode::kGear:
      return 3;
    case motion::ProfileMode::kCrd:
      return 5;
    default:
      return 0;
  }
}

}  // namespace oncard::gtcalls::gt400
