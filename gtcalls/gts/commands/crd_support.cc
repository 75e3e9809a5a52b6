#include "gtcalls/gts/commands/crd_support.h"

#include "gtcalls/gts/commands/look_ahead_support.h"

namespace oncard::gtcalls::gts {

int16_t CheckCrd(Call& call, size_t crd) {
  if (call.card.motion.part<&motion::MotionState::crds>()[crd].exists()) return vm::kOk;
  return call.Refuse(vm::kRefused,
                     MakeMessage("coordinate system {0} has not been set up, call GT_SetCrdPrm",
                                 "坐标系 {0} 尚未建立，请调用 GT_SetCrdPrm", crd + 1));
}

size_t ArgumentIndex(const Call& call, std::string_view name) {
  size_t index = 0;
  while (call.command.parameters[index].name != name) ++index;
  return index;
}

size_t FifoNumber(const Call& call) {
  return static_cast<size_t>(call.integer(ArgumentIndex(call, "fifo")));
}

motion::Coordinates PathEnd(const Call& call) {
  const motion::CrdFifo& fifo = FifoOf(call);
  return fifo.idle() ? call.card.motion.CrdPosition(NumberOf(call)) : fifo.tail;
}

void MeasureForPlanner(const Call& call, motion::Segment* segment) {
  const motion::CrdFifo& fifo = FifoOf(call);
  if (fifo.plans_axes()) motion::MeasureLength(fifo.planner->limits.length_axes, segment);
}

int16_t CheckNotMixed(Call& call) {
  if (!FifoOf(call).plans_axes() || BufferOf(call).in_pulses) return vm::kOk;
  return call.Refuse(
      kLookAheadParameter,
      MakeMessage("FIFO {0} of coordinate system {1} takes commands in mm since "
                  "GT_InitLookAheadEx: use {2}Ex, or call GT_InitLookAheadPara or "
                  "GT_InitLookAhead for commands in pulses",
                  "调用 GT_InitLookAheadEx 之后，坐标系 {1} 的 FIFO {0} 只接受以毫米为单位的指令："
                  "请使用 {2}Ex；如需使用以脉冲为单位的指令，请调用 GT_InitLookAheadPara 或 "
                  "GT_InitLookAhead",
                  FifoNumber(call), call.integer(0), call.command.name));
}

int16_t AppendSlot(Call& call, const motion::PathSlot& slot) {
  int16_t code = CheckCrd(call, NumberOf(call));
  if (code == vm::kOk) code = CheckNotMixed(call);
  const bool planned = code == vm::kOk && FifoOf(call).plans_axes();
  if (planned && !slot.is_segment) code = CheckAuxiliaries(call);
  if (code == vm::kOk) code = AppendToFifo(call, slot, PathEnd(call));
  if (!planned || code != vm::kOk) return code;
  LookAheadBuffer& buffer = BufferOf(call);
  if (slot.is_segment) {
    buffer.auxiliaries = 0;
  } else {
    ++buffer.auxiliaries;
  }
  return code;
}

int16_t AppendToFifo(Call& call, const motion::PathSlot& slot, const motion::Coordinates& end) {
  if (!CrdAt(call).Append(FifoNumber(call), slot)) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("FIFO {0} of coordinate system {1} is full: wait until "
                                   "GT_CrdSpace gives more than 0, then send the command again",
                                   "坐标系 {1} 的 FIFO {0} 已满：请等到 GT_CrdSpace 大于 0 "
                                   "后重新发送该指令",
                                   FifoNumber(call), call.integer(0)));
  }
  if (!slot.is_segment) CrdAt(call).SetTail(FifoNumber(call), end);
  return vm::kOk;
}

std::vector<size_t> CrdsOf(uint32_t mask) {
  std::vector<size_t> selected;
  for (size_t i = 0; i < motion::kCrdCount; ++i) {
    if ((mask >> i & 1) != 0) selected.push_back(i);
  }
  return selected;
}

uint32_t CrdBitsOf(uint32_t axis_mask, size_t axis_count) {
  const bool small = axis_count <= kFirstCrdBitTo8Axes;
  const uint32_t crds =
      axis_mask >> kFirstCrdBit | (small ? axis_mask >> kFirstCrdBitTo8Axes : uint32_t{0});
  return crds & ((uint32_t{1} << motion::kCrdCount) - 1);
}

}  // namespace oncard::gtcalls::gts
