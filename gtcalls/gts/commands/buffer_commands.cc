// Buffered commands: they are entries in a FIFO of a coordinate system and are executed when the
// segment before them has ended. Their arguments are checked when they are appended.
// Source: the public header; the smart-home manual's tool follow examples for GT_BufMove and
// GT_BufGear. Tested by tests/gtcalls/buffer_command_test.cc.
#include "gtcalls/gts/buffered_values.h"
#include "gtcalls/gts/commands/crd_support.h"
#include "gtcalls/gts/defaults.h"
#include "gtcalls/gts/numbers.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::BufferedKind;

/// The time unit of GT_BufEnableDoBitPulse is that of GT_EnableDoBitPulse.
constexpr double kBufferedPulseUnitUs = kTimeUnitUs;

int16_t Append(Call& call, BufferedKind kind, int item, int detail,
               const std::array<double, 4>& values = {}) {
  motion::PathSlot slot;
  slot.command = {kind, item, detail, values};
  return AppendSlot(call, slot);
}

int16_t AppendValue(Call& call, const BufferedValue& value) {
  motion::PathSlot slot;
  slot.command = EncodeValue(value);
  ReserveValues(call.card.motion);
  return AppendSlot(call, slot);
}

int16_t RefuseRange(Call& call, std::string_view name, double value, std::string_view range) {
  return call.Refuse(vm::kBadParameter,
                     MakeMessage("{0} is {1}; the range is {2}", "{0} 为 {1}；取值范围为 {2}", name,
                                 value, range));
}

int ItemOf(motion::DoType type) { return static_cast<int>(type); }

/// The output word of argument 1.
motion::DoType OutputWord(const Call& call) { return *DoTypeOf(call.integer(1)); }

/// 0, or 7 with the reason if output type argument 1 has no output with the number in argument 2.
int16_t CheckOutputBit(Call& call) {
  const int width = DoWidth(OutputWord(call));
  if (call.integer(2) >= 1 && call.integer(2) <= width) return vm::kOk;
  return RefuseRange(call, "doIndex", call.value(2), width == 16 ? "[1, 16]" : "[1, 8]");
}

/// 0, or 1 with the reason when the profile of argument 1 belongs to the coordinate system.
int16_t CheckOutside(Call& call) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code != vm::kOk || !CrdOf(call).HasMember(NumberOf(call, 1))) return code;
  return call.Refuse(
      vm::kRefused,
      MakeMessage("profile {0} belongs to coordinate system {1}; another axis is "
                  "needed",
                  "规划器 {0} 属于坐标系 {1}；应使用其他轴", call.integer(1), call.integer(0)));
}

}  // namespace

int16_t GT_BufIO(Call& call) {
  return Append(call, BufferedKind::kOutputs, ItemOf(OutputWord(call)), 0,
                {call.value(2), call.value(3)});
}

int16_t GT_BufEnableDoBitPulse(Call& call) {
  const int16_t code = CheckOutputBit(call);
  if (code != vm::kOk) return code;
  if (call.integer(3) < 1) return RefuseRange(call, "highLevelTime", call.value(3), "[1, 65535]");
  if (call.integer(4) < 1) return RefuseRange(call, "lowLevelTime", call.value(4), "[1, 65535]");
  if (call.integer(5) < 0) return RefuseRange(call, "pulseNum", call.value(5), "[0, 2147483647]");
  return Append(call, BufferedKind::kPulses, ItemOf(OutputWord(call)), call.integer(2) - 1,
                {call.value(3) * kBufferedPulseUnitUs, call.value(4) * kBufferedPulseUnitUs,
                 call.value(5), call.value(6)});
}

int16_t GT_BufDisableDoBitPulse(Call& call) {
  const int16_t code = CheckOutputBit(call);
  if (code != vm::kOk) return code;
  return Append(call, BufferedKind::kStopPulses, ItemOf(OutputWord(call)), call.integer(2) - 1);
}

int16_t GT_BufDelay(Call& call) {
  return Append(call, BufferedKind::kDelay, 0, 0, {call.value(1)});
}

int16_t GT_BufDA(Call& call) {
  if (call.value(2) < -motion::kDacFull) {
    return RefuseRange(call, "daValue", call.value(2), "[-32767, 32767]");
  }
  return Append(call, BufferedKind::kAnalogOutput, call.integer(1) - 1, 0, {call.value(2)});
}

int16_t GT_BufLmtsOn(Call& call) {
  return Append(call, BufferedKind::kLimits, call.integer(1) - 1, call.integer(2), {1});
}

int16_t GT_BufLmtsOff(Call& call) {
  return Append(call, BufferedKind::kLimits, call.integer(1) - 1, call.integer(2), {0});
}

int16_t GT_BufSetStopIo(Call& call) {
  const int index = call.integer(4);
  const motion::DiType type = *DiTypeOf(call.integer(3));
  const int width = DiWidth(type);
  if (index != kNoInput && (index < 1 || index > width)) {
    return RefuseRange(call, "inputIndex", index, width == 16 ? "-1, [1, 16]" : "-1, [1, 8]");
  }
  const int bit = index == kNoInput ? -1 : index - 1;
  return Append(call, BufferedKind::kStopInput, call.integer(1) - 1,
                call.integer(2) == kAbruptStopType ? 1 : 0,
                {static_cast<double>(type), static_cast<double>(bit)});
}

int16_t GT_BufMove(Call& call) {
  if (!(call.value(3) >= kAboveZero && call.value(3) < kRateBound)) {
    return RefuseRange(call, "vel", call.value(3), "[1e-09, 32767)");
  }
  if (!(call.value(4) >= kAboveZero && call.value(4) < kRateBound)) {
    return RefuseRange(call, "acc", call.value(4), "[1e-09, 32767)");
  }
  int16_t code = CheckOutside(call);
  if (code == vm::kOk) code = CheckMode(call, NumberOf(call, 1), motion::ProfileMode::kTrap);
  if (code != vm::kOk) return code;
  return Append(call, BufferedKind::kMove, call.integer(1) - 1, call.integer(5),
                {call.value(2), call.value(3), call.value(4)});
}

int16_t GT_BufGear(Call& call) {
  const int16_t code = CheckOutside(call);
  if (code != vm::kOk) return code;
  return Append(call, BufferedKind::kGear, call.integer(1) - 1, 0, {call.value(2)});
}

int16_t GT_BufGearPercent(Call& call) {
  if (call.integer(3) + call.integer(4) > 100) {
    return RefuseRange(call, "accPercent + decPercent", call.value(3) + call.value(4), "[0, 100]");
  }
  const int16_t code = CheckOutside(call);
  if (code != vm::kOk) return code;
  return Append(call, BufferedKind::kGear, call.integer(1) - 1, 0,
                {call.value(2), call.value(3) / 100, call.value(4) / 100});
}

int16_t GT_BufStopMotion(Call& call) { return Append(call, BufferedKind::kHold, 0, 0); }

int16_t GT_BufSynchPrfPos(Call& call) {
  return Append(call, BufferedKind::kSynchronise, call.integer(2) - 1, call.integer(1) - 1);
}

int16_t GT_BufSetLongVar(Call& call) {
  return AppendValue(call, {ValueTarget::kLong, call.integer(1), call.value(2)});
}

int16_t GT_BufSetDoubleVar(Call& call) {
  return AppendValue(call, {ValueTarget::kDouble, call.integer(1), call.value(2)});
}

/// The name is resolved when the command is appended.
int16_t GT_BufSetVarValue(Call& call) {
  const std::optional<vm::SlotAddress> slot =
      FindVariable(call, call.integer(1), call.cells(2), call.value(3));
  if (!slot) return vm::kBadParameter;
  return AppendValue(call, {ValueTarget::kProgram, 0, call.value(3), *slot});
}

}  // namespace oncard::gtcalls::gts
