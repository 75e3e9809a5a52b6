#include "gtcalls/gts/buffered_values.h"

#include <algorithm>

namespace oncard::gtcalls::gts {
namespace {

/// In `detail` of a variable of the program: among the globals. Otherwise its data page.
constexpr int32_t kGlobals = -1;

}  // namespace

// item: number of the variable; detail: its page; values: the value, 1 for a variable of type
// double, the target.
motion::BufferedCommand EncodeValue(const BufferedValue& value) {
  motion::BufferedCommand command;
  command.kind = motion::BufferedKind::kOutside;
  command.item = value.index;
  command.values = {value.value, 0, static_cast<double>(value.target)};
  if (value.target == ValueTarget::kProgram) {
    command.item = value.slot.id;
    command.detail = value.slot.global ? kGlobals : value.slot.page;
    command.values[1] = value.slot.type == vm::DataType::kDouble ? 1 : 0;
  }
  return command;
}

BufferedValue DecodeValue(const motion::BufferedCommand& command) {
  BufferedValue value;
  value.target = static_cast<ValueTarget>(command.values[2]);
  value.value = command.values[0];
  if (value.target != ValueTarget::kProgram) {
    value.index = command.item;
    return value;
  }
  const bool global = command.detail == kGlobals;
  value.slot = {.global = global,
                .page = static_cast<uint8_t>(global ? 0 : command.detail),
                .id = static_cast<uint16_t>(command.item),
                .type = command.values[1] != 0 ? vm::DataType::kDouble : vm::DataType::kInt};
  return value;
}

void ReserveValues(motion::MotionCore& motion) { motion.ReserveReached(); }

void WriteReachedValues(Card& card) {
  const auto& reached = card.motion.part<&motion::MotionState::reached>();
  if (reached.empty()) return;
  GtsState& state = card.state<GtsState>();
  for (const motion::BufferedCommand& command : reached) {
    const BufferedValue value = DecodeValue(command);
    const auto index = static_cast<size_t>(value.index);
    switch (value.target) {
      case ValueTarget::kLong:
        state.long_vars[index] = static_cast<int32_t>(value.value);
        break;
      case ValueTarget::kDouble:
        state.double_vars[index] = value.value;
        break;
      case ValueTarget::kProgram:
        card.machine.Write(value.slot, value.value);
        break;
    }
  }
  card.motion.ClearReached();
}

bool WillWriteProgram(const motion::MotionCore& motion) {
  return std::ranges::any_of(motion.part<&motion::MotionState::crds>(), [](const motion::Crd& crd) {
    return crd.WillReach([](const motion::BufferedCommand& command) {
      return command.kind == motion::BufferedKind::kOutside &&
             DecodeValue(command).target == ValueTarget::kProgram;
    });
  });
}

}  // namespace oncard::gtcalls::gts
