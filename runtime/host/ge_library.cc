#include "runtime/host/ge_library.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <string>

#include "runtime/host/services.h"

namespace oncard::runtime {
namespace {

// --- Cards ---------------------------------------------------------------------------------------

bool IsOpen(CardSlot& slot) {
  const std::lock_guard lock(slot.mutex);
  return slot.controller != nullptr;
}

/// GT_Open means the current card if it is closed, else the lowest closed one; all other commands
/// mean the current one.
int CardOf(const gtcalls::Command& command, std::span<const HostArgument>, CardTable& table) {
  const int current = table.selected;
  if (command.name != "GT_Open" || !IsOpen(table.slots[static_cast<size_t>(current)])) {
    return current;
  }
  const auto closed =
      std::ranges::find_if(table.slots, [](CardSlot& slot) { return !IsOpen(slot); });
  return closed == table.slots.end() ? current : static_cast<int>(closed - table.slots.begin());
}

/// The card becomes the current one.
int16_t OpenAndSelect(ServiceCall& call) {
  const int16_t code = OpenCard(call);
  if (code == vm::kOk) call.table.selected = call.card();
  return code;
}

// --- The handler of commands ---------------------------------------------------------------------

/// As TCommandHandle of the headers.
using Handler = void(ONCARD_HANDLER_CALL*)(char* command, short error);

std::atomic<Handler> hooked_handler = nullptr;

int16_t HookCommand(ServiceCall& call) {
  hooked_handler = reinterpret_cast<Handler>(call.arguments[0].host);
  return vm::kOk;
}

/// Assumption: these two have nothing to do with a card, and the handler is not told of them.
bool HostHears(const gtcalls::Command& command) {
  return hooked_handler.load() != nullptr && command.name != "GT_HookCommand" &&
         command.name != "GT_GetCurrentCardNo";
}

void TellHost(std::string inputs, int16_t code) {
  if (const Handler handler = hooked_handler) handler(inputs.data(), code);
}

constexpr HostService kServices[] = {
    // command, before_open, function
    {"GT_Open", true, OpenAndSelect},        {"GT_Close", false, CloseCard},
    {"GT_Reset", false, ResetCard},          {"GT_HardRst", false, ResetCard},
    {"GT_HookCommand", true, HookCommand},   {"GT_GetCurrentCardNo", true, GetSelectedCard},
    {"GT_SwitchtoCardNo", true, SelectCard},
};

}  // namespace

HostLibrary GeLibrary(const gtcalls::Family& family) {
  return {.family = family,
          .services = kServices,
          .card_of = CardOf,
          .host_hears = HostHears,
          .tell_host = TellHost};
}

}  // namespace oncard::runtime
