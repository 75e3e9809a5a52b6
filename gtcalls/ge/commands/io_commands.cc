// Inputs and outputs. Source: GE manual chapters 9, 10.2 and 12. Tested by
// tests/gtcalls/ge/io_command_test.cc.
#include <algorithm>

#include "gtcalls/ge/commands/commands.h"
#include "motion/common/rounding.h"

namespace oncard::gtcalls::ge {
namespace {

using motion::DigitalIo;
using motion::DiType;
using motion::DoType;
using motion::MotionState;

/// The converter: 2048 steps for 10 V.
constexpr double kAdcPerVolt = 204.8;
constexpr double kAdcMin = -2048;
constexpr double kAdcTop = 2047;

const DigitalIo& IoOf(const Call& call) { return call.card.motion.part<&MotionState::io>(); }

/// The levels of a word of inputs after their filters, whatever their senses.
uint32_t Levels(const Call& call, DiType type) {
  const uint32_t axes = (1u << call.card.motion.axis_count()) - 1;
  return (IoOf(call).Read(type) ^ IoOf(call).inverted(type)) & axes;
}

}  // namespace

int16_t GT_ExInpt(Call& call) {
  call.Set(0, IoOf(call).Read(DiType::kGpi));
  return vm::kOk;
}

int16_t GT_ExOpt(Call& call) {
  constexpr uint32_t kAll = 0xFFFF;
  call.card.motion.digital_io().Write(DoType::kGpo, kAll, static_cast<uint32_t>(call.integer(0)));
  return vm::kOk;
}

int16_t GT_GetHomeSwt(Call& call) {
  call.Set(0, Levels(call, DiType::kHome));
  return vm::kOk;
}

int16_t GT_GetLmtSwt(Call& call) {
  const uint32_t positive = Levels(call, DiType::kLimitPositive);
  const uint32_t negative = Levels(call, DiType::kLimitNegative);
  uint32_t levels = 0;
  for (int axis = 0; axis < kAxisMax; ++axis) {
    levels |= (positive >> axis & 1) << (2 * axis) | (negative >> axis & 1) << (2 * axis + 1);
  }
  call.Set(0, levels);
  return vm::kOk;
}

/// Assumption: the newest value; the converters of a card are up to a millisecond behind.
int16_t GT_GetAdc(Call& call) {
  const double volts = call.card.motion.part<&MotionState::adcs>()[AxisOf(call)].volts;
  call.Set(1, std::clamp(motion::Whole(volts * kAdcPerVolt), kAdcMin, kAdcTop));
  return vm::kOk;
}

}  // namespace oncard::gtcalls::ge
