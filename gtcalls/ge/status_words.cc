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

namespace oncard::gtcalls::ges {
namespace {

constexpr uint32_t kAxisMovesBit = 1u << 10;
constexpr int kPathAxisShift = 12;

// GE manual table 4-5.
constexpr uint32_t kNoPathBit = 1u << 0;
constexpr uint32_t kListClosedBit = 1u << 1;
constexpr uint32_t kNoSegmentBit = 1u << 4;
constexpr uint32_t kImmediateBit = 1u << 7;
constexpr uint32_t kHeldBit = 1u << 9;
constexpr uint32_t kListEmptyBit = 1u << 13;

/// True while a segment is in motion, or about to be.
bool InSegment(const motion::Crd& crd) {
  const motion::CrdFifo& fifo = crd.active();
  const bool waits = crd.run.wait == motion::CrdWait::kDelay;
  return crd.run.running && !waits &&
         (fifo.executing || (!fifo.slots.empty() && fifo.slots.front().is_segment));
}

}  // namespace

uint32_t StatusWord(const CardView& card, size_t axis) {
  uint32_t word = ge::CommonStatus(card, axis) | static_cast<uint32_t>(axis) << kPathAxisShift;
  // A path moves all axes, from its first cycle on.
  const motion::CrdRun& run = card.motion.part<&motion::MotionState::crds>().front().run;
  if (run.running && run.begin == card.motion.now()) word &= ~kAxisMovesBit;
  return word;
}

uint16_t PathStatusWord(const CardView& card) {
  const motion::Crd& crd = card.motion.part<&motion::MotionState::crds>().front();
  const Path& path = *card.state<GeState>().path;
  const bool list_runs = crd.run.running && crd.run.fifo == kListFifo;
  uint32_t word = 0;
  if (!crd.run.running) word |= kNoPathBit;
  if (!path.list.open) word |= kListClosedBit;
  if (!InSegment(crd)) word |= kNoSegmentBit;
  if (!path.list.open && !list_runs) word |= kImmediateBit;
  if (path.held) word |= kHeldBit;
  if (crd.fifos[kListFifo].idle()) word |= kListEmptyBit;
  return static_cast<uint16_t>(word);
}

}  // namespace oncard::gtcalls::ges
