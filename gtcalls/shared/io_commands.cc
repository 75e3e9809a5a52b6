#include "gtcalls/shared/io_commands.h"

#include <cstddef>

#include "gtcalls/card.h"

namespace oncard::gtcalls {
namespace {

using motion::DigitalIo;
using motion::DiType;
using motion::DoType;

const DigitalIo& IoOf(const Call& call) {
  return call.card.motion.part<&motion::MotionState::io>();
}

/// A word of inputs that belong to axes, after their filters.
uint32_t Levels(const Call& call, DiType type) {
  const uint32_t axes = (1u << call.card.motion.axis_count()) - 1;
  return (IoOf(call).Read(type) ^ IoOf(call).inverted(type)) & axes;
}

}  // namespace

int16_t ReadGeneralInputs(Call& call) {
  call.Set(0, IoOf(call).Read(DiType::kGpi));
  return vm::kOk;
}

int16_t ReadHomeLevels(Call& call) {
  call.Set(0, Levels(call, DiType::kHome));
  return vm::kOk;
}

int16_t ReadLimitLevels(Call& call) {
  const uint32_t positive = Levels(call, DiType::kLimitPositive);
  const uint32_t negative = Levels(call, DiType::kLimitNegative);
  uint32_t levels = 0;
  for (size_t axis = 0; axis < call.card.motion.axis_count(); ++axis) {
    levels |= (positive >> axis & 1) << (2 * axis) | (negative >> axis & 1) << (2 * axis + 1);
  }
  call.Set(0, levels);
  return vm::kOk;
}

int16_t WriteGeneralOutputs(Call& call) {
  constexpr uint32_t kAll = 0xFFFF;
  call.card.motion.digital_io().Write(DoType::kGpo, kAll, static_cast<uint32_t>(call.integer(0)));
  return vm::kOk;
}

int16_t WriteGeneralOutput(Call& call) {
  const uint32_t bit = 1u << call.integer(0);
  call.card.motion.digital_io().Write(DoType::kGpo, bit, call.integer(1) != 0 ? bit : 0);
  return vm::kOk;
}

int16_t ReadGeneralOutputs(Call& call) {
  call.Set(0, IoOf(call).Register(DoType::kGpo));
  return vm::kOk;
}

}  // namespace oncard::gtcalls
