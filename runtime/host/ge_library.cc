#include "runtime/host/ge_library.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace oncard::runtime {

// --- Cards ---------------------------------------------------------------------------------------

namespace {

bool IsOpen(CardSlot& slot) {
  const std::lock_guard lock(slot.mutex);
  return slot.controller != nullptr;
}

}  // namespace

int GeCardOf(const gtcalls::Command& command, std::span<const HostArgument>, CardTable& table) {
  const int current = table.selected;
  if (command.name != "GT_Open" || !IsOpen(table.slots[static_cast<size_t>(current)])) {
    return current;
  }
  const auto closed =
      std::ranges::find_if(table.slots, [](CardSlot& slot) { return !IsOpen(slot); });
  return closed == table.slots.end() ? current : static_cast<int>(closed - table.slots.begin());
}

int16_t OpenGeCard(ServiceCall& call) {
  const int16_t code = OpenCard(call);
  if (code == vm::kOk) call.table.selected = call.card();
  return code;
}

// --- The handler of commands ---------------------------------------------------------------------

namespace {

using Handler = void (*)(char* command, short error);

std::atomic<Handler> hooked_handler = nullptr;

}  // namespace

int16_t HookCommand(ServiceCall& call) {
  hooked_handler = reinterpret_cast<Handler>(call.arguments[0].host);
  return vm::kOk;
}

/// Assumption: these two have nothing to do with a card, and the handler is not told of them.
bool HostHearsGe(const gtcalls::Command& command) {
  return hooked_handler.load() != nullptr && command.name != "GT_HookCommand" &&
         command.name != "GT_GetCurrentCardNo";
}

void TellGeHost(std::string inputs, int16_t code) {
  if (const Handler handler = hooked_handler) handler(inputs.data(), code);
}

}  // namespace oncard::runtime
