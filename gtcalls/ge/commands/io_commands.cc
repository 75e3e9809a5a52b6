// Inputs and outputs. Source: GE manual chapters 9, 10.2 and 12. Tested by
// tests/gtcalls/ge/io_command_test.cc.
#include <algorithm>

#include "gtcalls/ge/commands/commands.h"
#include "gtcalls/shared/io_commands.h"
#include "motion/common/rounding.h"

namespace oncard::gtcalls::ge {
namespace {

/// The converter: 2048 steps for 10 V.
constexpr double kAdcPerVolt = 204.8;
constexpr double kAdcMin = -2048;
constexpr double kAdcTop = 2047;

}  // namespace

int16_t GT_ExInpt(Call& call) { return ReadGeneralInputs(call); }
int16_t GT_ExOpt(Call& call) { return WriteGeneralOutputs(call); }
int16_t GT_GetHomeSwt(Call& call) { return ReadHomeLevels(call); }
int16_t GT_GetLmtSwt(Call& call) { return ReadLimitLevels(call); }

/// Assumption: the newest value; the converters of a card are up to a millisecond behind.
int16_t GT_GetAdc(Call& call) {
  const double volts = call.card.motion.part<&motion::MotionState::adcs>()[AxisOf(call)].volts;
  call.Set(1, std::clamp(motion::Whole(volts * kAdcPerVolt), kAdcMin, kAdcTop));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::ge
