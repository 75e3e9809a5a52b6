#include "gtcalls/ge/status_words.h"

#include "gtcalls/ge/ge_state.h"

namespace oncard::gtcalls::ge {
namespace {

using motion::CaptureSource;
using motion::MotionState;

struct ConditionBit {
  motion::AxisCondition condition;
  int bit;
};

/// The same in both families.
constexpr ConditionBit kConditionBits[] = {
    {motion::kAlarmBit, 1},         {motion::kFollowingErrorBit, 4}, {motion::kPositiveLimitBit, 5},
    {motion::kNegativeLimitBit, 6}, {motion::kServoOnBit, 9},        {motion::kMovingBit, 10},
};
constexpr uint32_t kLimitsOnBit = 1u << 11;
constexpr uint32_t kHomeArmedBit = 1u << 14;
constexpr uint32_t kIndexArmedBit = 1u << 15;

/// The bits that both families have.
uint32_t CommonStatus(const CardView& card, size_t axis) {
  const uint32_t conditions = card.motion.Conditions(axis);
  uint32_t word = 0;
  for (const ConditionBit& row : kConditionBits) {
    if ((conditions & row.condition) != 0) word |= 1u << row.bit;
  }
  const motion::Capture& capture = card.motion.part<&MotionState::capture>().capture(axis);
  if (capture.captured) word |= kCapturedBit;
  if (capture.armed && capture.source == CaptureSource::kHome) word |= kHomeArmedBit;
  if (capture.armed && capture.source == CaptureSource::kIndex) word |= kIndexArmedBit;
  if (card.motion.axis(axis).positive_limit_on) word |= kLimitsOnBit;
  return word;
}

}  // namespace

uint32_t ConditionsOf(uint32_t bits) {
  uint32_t conditions = 0;
  for (const ConditionBit& row : kConditionBits) {
    if ((bits >> row.bit & 1) != 0) conditions |= row.condition;
  }
  return conditions;
}

}  // namespace oncard::gtcalls::ge

namespace oncard::gtcalls::gep {
namespace {

constexpr uint32_t kLoopClosedBit = 1u << 8;
constexpr uint32_t kEncoderFaultBit = 1u << 27;
constexpr int kAxisShift = 28;

constexpr uint16_t kAutoStopBit = 1u << 7;
constexpr int kModeShift = 11;

}  // namespace

uint32_t StatusWord(const CardView& card, size_t axis) {
  const GeAxis& state = card.state<GeState>().axes[axis];
  uint32_t word = ge::CommonStatus(card, axis) | static_cast<uint32_t>(axis) << kAxisShift;
  if (state.refused) word |= ge::kRefusedBit;
  if (!state.open_loop) word |= kLoopClosedBit;
  // Assumption: a disconnected encoder is noticed while its drive is enabled.
  const bool lost = card.motion.part<&motion::MotionState::encoder_faults>()[axis].held;
  if (lost && card.motion.axis(axis).servo_on) word |= kEncoderFaultBit;
  return word;
}

uint16_t ModeRegister(const CardView& card, size_t axis) {
  const int mode = ModeNumber(card.motion.profile(axis).mode) << kModeShift;
  const bool auto_stop = card.state<GeState>().axes[axis].auto_stop;
  return static_cast<uint16_t>(mode | (auto_stop ? kAutoStopBit : 0));
}

int ModeNumber(motion::ProfileMode mode) {
  switch (mode) {
    case motion::ProfileMode::kJog:
      return 1;
    case motion::ProfileMode::kSCurve:
      return 2;
    default:
      return 0;
  }
}

}  // namespace oncard::gtcalls::gep
