// libgt400: the services of the host library for GT400 cards. One call opens all cards of the
// computer. A card is switched on when the host chooses it for the first time, and its time has
// begun with that of card 0: only cards that a host uses have a log, a record, and a scenario to
// meet. Tested by tests/families/gt400/gt400_family_test.cc.
#include <algorithm>
#include <bitset>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

#include "base/number.h"
#include "gtcalls/gt400/family.h"
#include "gtcalls/gt400/gt400_state.h"
#include "runtime/host/call_scope.h"
#include "runtime/host/host_interrupts.h"
#include "runtime/host/library.h"

namespace oncard::runtime {
namespace {

static_assert(kCardCount == gtcalls::gt400::kCardMax);

/// The base address of the card of a computer with ISA cards.
constexpr uint16_t kIsaAddress = 0x300;

/// The cards of the computer. The lock of card 0 guards them.
struct Gt400Cards {
  int count = 0;                    ///< of open ones
  std::bitset<kCardCount> used;     ///< switched on
  std::optional<HostClock> opened;  ///< the clock of all cards when they were opened
  uint16_t address = kIsaAddress;
};

Gt400Cards& Cards() {
  // Never destroyed: other threads of the host may still make calls while the process exits.
  static Gt400Cards& cards = *new Gt400Cards;
  return cards;
}

/// Commands that mean no card but the computer, which has card 0.
constexpr std::string_view kOfComputer[] = {
    "GT_Open", "GT_Close", "GT_SwitchtoCardNo", "GT_GetCurrentCardNo", "GT_SetAddr", "GT_GetAddr"};

/// GT_ClearInt means the card that it names.
int Gt400CardOf(const gtcalls::Command& command, std::span<const HostArgument> arguments,
                CardTable& table) {
  if (command.name == "GT_ClearInt") return static_cast<int>(arguments[0].integer);
  const bool of_computer = command.cost == gtcalls::Cost::kNone &&
                           std::ranges::find(kOfComputer, command.name) != std::end(kOfComputer);
  return of_computer ? 0 : table.selected.load();
}

/// How many cards the computer has: ONCARD_CARDS says it.
Result<int> CardsOfComputer() {
  const char* setting = std::getenv("ONCARD_CARDS");
  if (setting == nullptr || *setting == '\0') return kCardCount;
  const auto count = ReadWhole<int>(setting);
  if (count && *count >= 1 && *count <= kCardCount) return *count;
  return MakeError(1, "ONCARD_CARDS is '{}', expected a number from 1 to {}",
                   "ONCARD_CARDS 的值为 '{}'，应为 1 到 {} 的整数", setting, kCardCount);
}

int16_t OpenCards(ServiceCall& call, int count) {
  const int16_t code = OpenCard(call);
  if (code != vm::kOk) return code;
  Gt400Cards& cards = Cards();
  cards.count = count;
  cards.used.reset().set(0);
  cards.opened.emplace(*call.slot.clock);
  return vm::kOk;
}

/// Without effect for cards that are open.
int16_t OpenComputer(ServiceCall& call) {
  if (call.slot.controller != nullptr) return vm::kOk;
  const auto count = CardsOfComputer();
  if (!count.ok()) return call.Refuse(LibraryFamily().open_failed, count.error().message);
  return OpenCards(call, count.value());
}

int16_t CloseComputer(ServiceCall& call) {
  Gt400Cards& cards = Cards();
  for (size_t i = 1; i < call.table.slots.size(); ++i) {
    if (!cards.used[i]) continue;
    const std::lock_guard lock(call.table.slots[i].mutex);
    call.table.slots[i].SwitchOff();
  }
  call.slot.SwitchOff();
  cards.count = 0;
  call.table.selected = 0;
  return vm::kOk;
}

/// Switches a card on that has been open since card 0 was opened.
int16_t SwitchOn(CardSlot& slot, ServiceCall& call) {
  const std::lock_guard lock(slot.mutex);
  ServiceCall opening{call.command, call.table, slot, call.arguments, {}};
  const int16_t code = OpenCard(opening);
  if (code != vm::kOk) return call.Refuse(code, std::move(opening.reason));
  slot.clock.emplace(*Cards().opened);
  slot.FindEarliestEnd();
  return vm::kOk;
}

int16_t SwitchToCard(ServiceCall& call) {
  Gt400Cards& cards = Cards();
  const double number = call.arguments[0].value;
  if (!(number >= 0 && number < cards.count)) {
    return call.Refuse(
        LibraryFamily().not_open,
        MakeMessage("there is no card {}; the computer has cards 0 to {}",
                    "没有 {} 号卡；计算机中有 0 到 {} 号卡", number, cards.count - 1));
  }
  const auto index = static_cast<size_t>(number);
  if (!cards.used[index]) {
    const int16_t code = SwitchOn(call.table.slots[index], call);
    if (code != vm::kOk) return code;
    cards.used.set(index);
  }
  call.table.selected = static_cast<int>(index);
  return vm::kOk;
}

/// Hosts in DOS open their card with its address. Assumption: there is only this card.
int16_t SetAddress(ServiceCall& call) {
  Cards().address = static_cast<uint16_t>(call.arguments[0].value);
  if (Cards().address != kIsaAddress) {
    return call.Refuse(LibraryFamily().not_open,
                       MakeMessage("no card answers at address 0x{:X}; the card is at 0x{:X}",
                                   "地址 0x{:X} 处没有控制卡响应；控制卡位于 0x{:X}",
                                   Cards().address, kIsaAddress));
  }
  return call.slot.controller != nullptr ? int16_t{vm::kOk} : OpenCards(call, 1);
}

int16_t GetAddress(ServiceCall& call) {
  call.arguments[0].cells[0] = Cards().address;
  return vm::kOk;
}

// --- Interrupts ----------------------------------------------------------------------------------

/// A handler of the host, as GT400.h has it.
using Handler = void (*)();

/// The handler that is hooked from now on.
void SetHandler(ServiceCall& call) {
  HostInterrupts& interrupts = HostInterrupts::OfProcess();
  InterruptAnswer answer = interrupts.AnswerOf(call.card());
  answer.handler = reinterpret_cast<Handler>(call.arguments[0].host);
  interrupts.Answer(call.card(), std::move(answer));
  // What nobody has answered is requested anew.
  call.slot.controller->TakeInterrupt();
}

int16_t HookHandler(ServiceCall& call) {
  const int16_t code = ExecuteOnCard(call);
  if (code != vm::kOk) return code;
  *static_cast<Handler*>(call.arguments[1].host) =
      HostInterrupts::OfProcess().AnswerOf(call.card()).handler;
  SetHandler(call);
  return vm::kOk;
}

int16_t UnhookHandler(ServiceCall& call) {
  const int16_t code = ExecuteOnCard(call);
  if (code == vm::kOk) SetHandler(call);
  return code;
}

int16_t SetSyncEvent(ServiceCall& call) {
  void* const handle = call.arguments[0].host;
  const bool removes = call.arguments[0].null;
  auto event = removes ? nullptr : InterruptEventOf(handle);
  if (!removes && event == nullptr) {
    return call.Refuse(LibraryFamily().not_open,
                       {"the handle is not one that CreateEvent has returned and that is open",
                        "该句柄不是 CreateEvent 返回的有效句柄"});
  }
  const int16_t code = ExecuteOnCard(call);
  if (code != vm::kOk) return code;
  HostInterrupts& interrupts = HostInterrupts::OfProcess();
  InterruptAnswer answer = interrupts.AnswerOf(call.card());
  answer.event = std::move(event);
  interrupts.Answer(call.card(), std::move(answer));
  call.slot.controller->TakeInterrupt();
  return vm::kOk;
}

/// A handler that has returned without GT_ClearInt has handled a time interrupt; an event interrupt
/// needs GT_RstIntr.
void HandlerReturned(int card) {
  CardSlot& slot = CardTable::OfProcess().slots[static_cast<size_t>(card)];
  {
    const CallScope scope;
    const std::lock_guard lock(slot.mutex);
    if (slot.controller == nullptr) return;
    const auto& state = slot.controller->view().state<gtcalls::Gt400State>();
    if (state.interrupts.service != gtcalls::gt400::InterruptKind::kTime) return;
  }
  static const uint16_t clear = LibraryFamily().catalogue.Find("GT_ClearInt")->number;
  const HostArgument number = ToHostArgument(card);
  CallCard(card, clear, std::span(&number, 1));
}

constexpr HostService kServices[] = {
    // command, before_open, function
    {"GT_Open", true, OpenComputer},
    {"GT_Close", false, CloseComputer},
    {"GT_Reset", false, ResetCard},
    {"GT_HardRst", false, ResetCard},
    {"GT_SwitchtoCardNo", false, SwitchToCard},
    {"GT_GetCurrentCardNo", false, GetSelectedCard},
    {"GT_SetAddr", true, SetAddress},
    {"GT_GetAddr", true, GetAddress},
    {"GT_HookIsr", false, HookHandler},
    {"GT_UnhookIsr", false, UnhookHandler},
    {"GT_SetIntSyncEvent", false, SetSyncEvent},
};

}  // namespace

const HostLibrary& Library() {
  static const HostLibrary kLibrary = {.family = gtcalls::Gt400Family(),
                                       .services = kServices,
                                       .card_of = Gt400CardOf,
                                       .handler_returned = HandlerReturned};
  return kLibrary;
}

}  // namespace oncard::runtime
