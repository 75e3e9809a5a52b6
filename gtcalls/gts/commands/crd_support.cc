#include "gtcalls/gts/commands/crd_support.h"

namespace oncard::gtcalls {

int16_t CheckCrd(Call& call, size_t crd) {
  if (call.card.motion.state().crds[crd].exists()) return vm::kOk;
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

int16_t AppendSlot(Call& call, const motion::PathSlot& slot) {
  const int16_t code = CheckCrd(call, NumberOf(call));
  if (code != vm::kOk) return code;
  const motion::Coordinates end = PathEnd(call);
  if (!call.card.motion.AppendToCrd(NumberOf(call), FifoNumber(call), slot)) {
    return call.Refuse(vm::kRefused,
                       MakeMessage("FIFO {0} of coordinate system {1} is full: wait until "
                                   "GT_CrdSpace gives more than 0, then send the command again",
                                   "坐标系 {1} 的 FIFO {0} 已满：请等到 GT_CrdSpace 大于 0 "
                                   "后重新发送该指令",
                                   FifoNumber(call), call.integer(0)));
  }
  if (!slot.is_segment) FifoOf(call).tail = end;
  return vm::kOk;
}

std::vector<size_t> CrdsOf(uint32_t mask) {
  std::vector<size_t> selected;
  for (size_t i = 0; i < motion::kCrdCount; ++i) {
    if ((mask >> i & 1) != 0) selected.push_back(i);
  }
  return selected;
}

unsigned FirstCrdBit(const Call& call) { return call.card.motion.axis_count() > 8 ? 12 : 8; }

std::vector<size_t> CrdsOfAxisMask(const Call& call, double mask) {
  return CrdsOf(BitWord(mask) >> FirstCrdBit(call));
}

}  // namespace oncard::gtcalls
