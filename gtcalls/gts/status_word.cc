#include "gtcalls/gts/status_word.h"

namespace oncard::gtcalls::gts {
namespace {

struct StatusBit {
  motion::AxisCondition condition;
  int bit;
};

constexpr StatusBit kBits[] = {
    {motion::kAlarmBit, 1},         {motion::kFollowingErrorBit, 4}, {motion::kPositiveLimitBit, 5},
    {motion::kNegativeLimitBit, 6}, {motion::kSmoothStopBit, 7},     {motion::kAbruptStopBit, 8},
    {motion::kServoOnBit, 9},       {motion::kMovingBit, 10},        {motion::kInPositionBit, 11},
};

}  // namespace

uint32_t StatusWord(const CardView& card, size_t axis) {
  const uint32_t conditions = card.motion.Conditions(axis);
  uint32_t word = 0;
  for (const StatusBit& row : kBits) {
    if ((conditions & row.condition) != 0) word |= uint32_t{1} << row.bit;
  }
  return word;
}

}  // namespace oncard::gtcalls::gts
