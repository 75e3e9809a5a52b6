// Interrupts. Source: GT manual chapters 8 and 11. Tested by
// tests/gtcalls/gt400/interrupt_command_test.cc and background_test.cc.
#include "gtcalls/gt400/interrupts.h"
#include "gtcalls/gt400/status_word.h"

#include <algorithm>
#include <vector>

#include "gtcalls/gt400/background.h"
#include "gtcalls/gt400/commands/commands.h"
#include "gtcalls/gt400/events.h"

namespace oncard::gtcalls::gt400 {
namespace {

/// What the driver on the host's computer refuses, and not the card.
constexpr int16_t kDriverRefuses = -1;

InterruptUnit& UnitOf(const Call& call) { return call.card.state<Gt400State>().interrupts; }

/// 0, or 1 unless an event interrupt is in service.
int16_t CheckService(Call& call) {
  const InterruptUnit& unit = UnitOf(call);
  if (unit.service == InterruptKind::kEvent) return vm::kOk;
  if (unit.answers.by_driver()) {
    return RefuseFor(
        call, kNoInterrupt,
        {"no interrupt is in service: with a synchronisation event or a background set "
         "the driver has ended it",
         "没有正在处理的中断：使用同步事件或后台命令集时，中断已由驱动程序结束"});
  }
  return RefuseFor(call, kNoInterrupt,
                   {"no event interrupt is in service", "没有正在处理的事件中断"});
}

/// An interrupt of the other kind ends without an answer.
int16_t ChooseKind(Call& call, bool timed) {
  InterruptUnit& unit = UnitOf(call);
  if (unit.timed != timed) unit.service = InterruptKind::kNone;
  unit.timed = timed;
  unit.elapsed = 0;
  return vm::kOk;
}

}  // namespace

int16_t GT_EvntIntr(Call& call) { return ChooseKind(call, false); }
int16_t GT_TmrIntr(Call& call) { return ChooseKind(call, true); }

int16_t GT_SetIntrMsk(Call& call) {
  UnitOf(call).masks[CurrentAxis(call)] = static_cast<uint16_t>(call.integer(0));
  return vm::kOk;
}

int16_t GT_GetIntrMsk(Call& call) {
  call.Set(0, UnitOf(call).masks[CurrentAxis(call)]);
  return vm::kOk;
}

/// Assumption: the period begins anew.
int16_t GT_SetIntrTm(Call& call) {
  UnitOf(call).period = static_cast<uint16_t>(call.integer(0));
  UnitOf(call).elapsed = 0;
  return vm::kOk;
}

int16_t GT_GetIntrTm(Call& call) {
  call.Set(0, UnitOf(call).period);
  return vm::kOk;
}

// --- The interrupt in service ----------------------------------------------------------------

int16_t GT_GetIntr(Call& call) {
  const InterruptUnit& unit = UnitOf(call);
  const bool has_word = unit.answers.by_driver() || unit.service == InterruptKind::kEvent;
  call.Set(0, has_word ? unit.word : StatusWord(call.card.view(), CurrentAxis(call)));
  return vm::kOk;
}

int16_t GT_RstIntr(Call& call) {
  const int16_t code = CheckService(call);
  if (code != vm::kOk) return code;
  InterruptUnit& unit = UnitOf(call);
  ClearEvents(call.card, unit.axis, static_cast<uint32_t>(call.integer(0)) | kRefusedBit);
  unit.service = InterruptKind::kNone;
  return vm::kOk;
}

int16_t GT_AxisI(Call& call) {
  const int16_t code = CheckService(call);
  if (code == vm::kOk) StateOf(call).current = UnitOf(call).axis;
  return code;
}

/// Event interrupts need GT_RstIntr.
int16_t GT_ClearInt(Call& call) {
  const auto card = static_cast<int>(call.integer(0));
  if (card >= kCardMax) {
    return call.Refuse(kDriverRefuses,
                       MakeMessage("there is no card {}; the range is [0, {}]",
                                   "没有 {} 号卡；取值范围为 [0, {}]", card, kCardMax - 1));
  }
  InterruptUnit& unit = UnitOf(call);
  if (unit.service == InterruptKind::kTime) unit.service = InterruptKind::kNone;
  return vm::kOk;
}

// --- Answers of the host -----------------------------------------------------------------------

int16_t GT_HookIsr(Call& call) {
  ChangeAnswers(&UnitOf(call));
  UnitOf(call).answers.handler = call.given(0);
  return vm::kOk;
}

int16_t GT_UnhookIsr(Call& call) {
  if (!UnitOf(call).answers.handler) {
    return call.Refuse(kDriverRefuses, {"no handler is hooked, call GT_HookIsr first",
                                        "没有挂接中断函数，请先调用 GT_HookIsr"});
  }
  UnitOf(call).answers.handler = call.given(0);
  return vm::kOk;
}

int16_t GT_SetIntSyncEvent(Call& call) {
  ChangeAnswers(&UnitOf(call));
  UnitOf(call).answers.event = call.given(0);
  return vm::kOk;
}

int16_t GT_SetBgCommandSet(Call& call) {
  auto& background = UnitOf(call).answers.background;
  if (!call.given(0)) {
    background.Reset();
    return vm::kOk;
  }
  const std::span<const double> cells = call.cells(0);
  std::vector<uint8_t> memory(cells.size());
  std::ranges::transform(cells, memory.begin(),
                         [](double cell) { return static_cast<uint8_t>(cell); });
  size_t size = 0;
  if (auto why = CheckBackgroundSet(memory, &size)) {
    return call.Refuse(kDriverRefuses, *std::move(why));
  }
  memory.resize(size);
  ChangeAnswers(&UnitOf(call));
  background.Emplace({std::move(memory)});
  return vm::kOk;
}

int16_t GT_GetBgCommandResult(Call& call) {
  const auto& background = UnitOf(call).answers.background;
  if (!background) {
    return call.Refuse(kDriverRefuses, {"there is no background set, call GT_SetBgCommandSet first",
                                        "没有后台命令集，请先调用 GT_SetBgCommandSet"});
  }
  const std::vector<uint8_t>& memory = background->bytes;
  if (call.cells(0).size() < memory.size()) {
    return call.Refuse(kDriverRefuses, MakeMessage("the size is {} bytes; the set has {}",
                                                   "长度为 {} 字节；后台命令集有 {} 字节",
                                                   call.cells(0).size(), memory.size()));
  }
  for (size_t i = 0; i < memory.size(); ++i) call.Set(0, memory[i], i);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gt400
