#include "runtime/host/host_api.h"

#include <atomic>
#include <mutex>
#include <string>
#include <utility>

#include "runtime/host/call_log.h"
#include "runtime/host/call_scope.h"
#include "runtime/host/card_table.h"
#include "runtime/host/host_interrupts.h"
#include "runtime/host/host_refusals.h"
#include "runtime/host/host_system.h"
#include "runtime/host/host_time.h"
#include "runtime/host/library.h"
#include "runtime/host/services.h"
#include "runtime/host/virtual_time.h"

namespace oncard::runtime {
namespace {

/// The host is told of a call and has not returned yet.
constinit thread_local bool telling_host ONCARD_CALL_STATE = false;

bool HostHears(const gtcalls::Command& command) {
  return Library().host_hears != nullptr && !telling_host && Library().host_hears(command);
}

void TellHost(std::string inputs, int16_t code) {
  telling_host = true;
  Library().tell_host(std::move(inputs), code);
  telling_host = false;
}

/// A command waits for the next tick; the scenario may be over before.
void PassTick(CardSlot& slot) {
  slot.PassTick();
  EndHostIfOver(&slot);
}

/// Executes a command whose arguments have been read. The card is locked. `acts`: the card has
/// executed it.
int16_t Dispatch(const gtcalls::Command& command, const HostService* service, CardSlot& slot,
                 std::span<vm::CommandArgument> arguments, Message* reason, bool* acts) {
  if (service == nullptr) {
    *acts = true;
    const int64_t cycle_ns = slot.controller->clock().cycle_ns();
    const int16_t code =
        slot.controller->Execute(command, arguments, reason, [&slot] { PassTick(slot); });
    // The scenario ends with a cycle.
    if (slot.controller->clock().cycle_ns() != cycle_ns) slot.FindEarliestEnd();
    return code;
  }
  ServiceCall call{command, CardTable::OfProcess(), slot, arguments, {}};
  const int16_t code = service->function(call);
  *reason = std::move(call.reason);
  // Of the library's own commands these change the card as well.
  *acts = call.acted || LibraryFamily().Resets(command) || (slot.files && slot.files->program);
  return code;
}

void Record(const LoggedCall& made, bool acts, CardSlot& slot) {
  RecordedFiles files = slot.files ? *std::move(slot.files) : RecordedFiles();
  RecordedCall call = RecordCall(made, acts);
  call.program = std::move(files.program);
  call.sources = std::move(files.sources);
  call.config = std::move(files.config);
  slot.recorder->Write(made.card, call);
}

/// A call that takes this long, and as long as its command waits. `told` gets the inputs as text if
/// the host wants to hear of the call.
int16_t CallLockedCard(const gtcalls::Family& family, int card, CardSlot& slot, int64_t cost_us,
                       const gtcalls::Command& command, std::span<const HostArgument> host,
                       std::string* told) {
  const HostService* service = FindHostService(command);
  const bool open = slot.controller != nullptr;
  int64_t time_us = 0;
  if (open) {
    slot.CatchUp(cost_us);
    EndHostIfOver(&slot);
    time_us = slot.controller->NowUs();
  }
  const auto read =
      ReadArguments(command, host, open ? &slot.controller->card() : nullptr, &slot.call);
  const auto arguments = std::span(slot.call.arguments).first(host.size());
  slot.files.reset();
  Message reason;
  int16_t code = vm::kOk;
  bool acts = false;
  if (!open && (service == nullptr || !service->before_open)) {
    code = family.not_open;
    reason = MakeMessage("card {} is not open, call {} first", "卡 {} 未打开，请先调用 {}", card,
                         family.open_command);
  } else if (!read.ok()) {
    code = static_cast<int16_t>(read.error().code);
    reason = read.error().message;
    if (open && service == nullptr && family.finish != nullptr) {
      gtcalls::Call unread{command, slot.controller->card(), vm::kHostCaller, arguments, {}};
      code = family.finish(unread, code);
    }
  } else {
    code = Dispatch(command, service, slot, arguments, &reason, &acts);
    WriteOutputs(command, slot.call, code);
  }
  const LoggedCall made = {time_us, card, vm::kHostCaller, command, arguments, code, reason};
  // The opening of the card is the beginning of the record, its closing the end.
  if (open && slot.recorder != nullptr) Record(made, acts, slot);
  CallLog* const log = CallLog::Wanted();
  // A code without a reason is an answer.
  const bool refused = code != vm::kOk && !reason.en.empty();
  const bool counts = refused && RefusalReportOfProcess() != RefusalReport::kNothing;
  if (log != nullptr || counts) {
    if (log != nullptr) log->Write(made);
    if (counts) HostRefusals::OfProcess().Add(made);
  }
  if (HostHears(command)) *told = FormatInputs(command, arguments);
  return code;
}

/// A handler has interrupted another call of its thread. It may have interrupted anything, so only
/// what signals allow is used; the call log is not. Says so once.
int16_t RefuseInterruption(const gtcalls::Command& command) {
  static std::atomic<bool> said = false;
  if (said.exchange(true)) return vm::kRefused;
  constexpr std::string_view kReason[] = {
      " is refused: the signal handler that calls it has interrupted another call of its thread\n",
      " 被拒绝：调用它的信号处理函数中断了同一线程的另一次调用\n"};
  const std::string_view parts[] = {
      "oncard: ", command.name, kReason[LanguageFromEnvironment() == Language::kChinese ? 1 : 0]};
  WriteToStandardError(parts);
  return vm::kRefused;
}

/// The index of the card that a call means.
int IndexOf(int card, const gtcalls::Command& command, std::span<const HostArgument> arguments,
            CardTable& table) {
  if (card != kSelectedCard) return card;
  const auto card_of = Library().card_of;
  return card_of != nullptr ? card_of(command, arguments, table) : table.selected.load();
}

/// Lets the time of a call pass before its card is locked, if interrupts can come meanwhile;
/// returns what is left of it. A call of a card that is not open takes none.
int64_t PassCost(int card, const gtcalls::Command& command,
                 std::span<const HostArgument> arguments) {
  const int64_t cost_us = LibraryFamily().cost_us(command);
  HostInterrupts& interrupts = HostInterrupts::OfProcess();
  if (!interrupts.Awaited() || call_state.depth != 0) return cost_us;
  CardTable& table = CardTable::OfProcess();
  const int index = IndexOf(card, command, arguments, table);
  if (index < 0 || index >= kCardCount) return cost_us;
  {
    const CallScope scope;
    CardSlot& slot = table.slots[static_cast<size_t>(index)];
    const std::lock_guard lock(slot.mutex);
    if (slot.controller == nullptr) return cost_us;
  }
  if (!HostTimeIsVirtual()) {
    interrupts.Come();
    return cost_us;
  }
  interrupts.PassUs(cost_us);
  return 0;
}

/// A call up to the release of its card. `cost_us`, `told`: as CallLockedCard().
int16_t CallAndRelease(int card, const gtcalls::Command& command, int64_t cost_us,
                       std::span<const HostArgument> arguments, std::string* told) {
  const CallScope scope;
  const gtcalls::Family& family = LibraryFamily();
  if (CallScope::Interrupts()) return RefuseInterruption(command);
  CardTable& table = CardTable::OfProcess();
  const int index = IndexOf(card, command, arguments, table);
  if (index < 0 || index >= kCardCount) {
    return card == kSelectedCard ? family.not_open : vm::kBadParameter;
  }
  CardSlot& slot = table.slots[static_cast<size_t>(index)];
  // A thread that has the card may wait for the wait that this handler has interrupted.
  if (call_state.waits != 0) VirtualTime::OfProcess().LetOthersPass();
  const std::lock_guard lock(slot.mutex);
  const int16_t code = CallLockedCard(family, index, slot, cost_us, command, arguments, told);
  if (card == kSelectedCard && Library().notice_result != nullptr) {
    Library().notice_result(command, arguments, code);
  }
  return code;
}

}  // namespace

int16_t CallCard(int card, uint16_t number, std::span<const HostArgument> arguments) {
  const gtcalls::Command& command = *LibraryFamily().catalogue.Find(number);
  std::string told;
  const int64_t cost_us = PassCost(card, command, arguments);
  const int16_t code = CallAndRelease(card, command, cost_us, arguments, &told);
  // Those of the tick for which the command waited.
  HostInterrupts::OfProcess().Come();
  if (!told.empty()) TellHost(std::move(told), code);
  return code;
}

}  // namespace oncard::runtime
