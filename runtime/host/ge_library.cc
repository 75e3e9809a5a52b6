#include "runtime/host/ge_library.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <span>
#include <utility>

#include "gtcalls/ge/command_register.h"
#include "gtcalls/ge/ge_state.h"

namespace oncard::runtime {

// --- Cards ---------------------------------------------------------------------------------------

namespace {

bool IsOpen(CardSlot& slot) {
  const std::lock_guard lock(slot.mutex);
  return slot.controller != nullptr;
}

}  // namespace

int GeCardOf(const gtcalls::Command& command, CardTable& table) {
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

int16_t GetCurrentCard(ServiceCall& call) {
  return static_cast<int16_t>(call.table.selected.load());
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

// --- The watch -----------------------------------------------------------------------------------

namespace {

using gtcalls::ge::Watch;
using gtcalls::ge::WatchedValue;

/// The array for a value of an axis.
void* ArrayOf(const WatchedAxis& axis, WatchedValue value) {
  switch (value) {
    case gtcalls::ge::kWatchPrfPos:
      return axis.prf_pos;
    case gtcalls::ge::kWatchAtlPos:
      return axis.atl_pos;
    case gtcalls::ge::kWatchPrfVel:
      return axis.prf_vel;
    case gtcalls::ge::kWatchAtlVel:
      return axis.atl_vel;
    case gtcalls::ge::kWatchVoltage:
      break;
  }
  return axis.voltage;
}

void Store(void* array, WatchedValue value, size_t index, double sample) {
  switch (value) {
    case gtcalls::ge::kWatchPrfPos:
    case gtcalls::ge::kWatchAtlPos:
      static_cast<long*>(array)[index] = static_cast<long>(sample);
      return;
    case gtcalls::ge::kWatchPrfVel:
    case gtcalls::ge::kWatchAtlVel:
      static_cast<double*>(array)[index] = sample;
      return;
    case gtcalls::ge::kWatchVoltage:
      break;
  }
  static_cast<short*>(array)[index] = static_cast<short>(sample);
}

/// Calls `visit(axis, value)` for each watched value, in the order of a sample.
template <typename Visit>
void ForEachWatched(const Watch& watch, const Visit& visit) {
  for (size_t axis = 0; axis < watch.config.size(); ++axis) {
    for (const WatchedValue value : gtcalls::ge::kWatchedValues) {
      if ((watch.config[axis] & value) != 0) visit(axis, value);
    }
  }
}

}  // namespace

int16_t GetWatch(ServiceCall& call) {
  Controller& controller = *call.slot.controller;
  auto& state = controller.card().state<gtcalls::GeState>();
  const Watch& watch = state.watch;
  const auto* axes = static_cast<const WatchedAxis*>(call.arguments[0].host);
  bool missing = false;
  ForEachWatched(watch, [&](size_t axis, WatchedValue value) {
    missing = missing || !IsAddress(ArrayOf(axes[axis], value));
  });
  if (watch.started && missing) {
    state.command_register = gtcalls::ge::kIllegal;
    return call.Refuse(vm::kBadParameter, {"buffer has no array for a watched value",
                                           "buffer 中没有某个监测数据的数组"});
  }
  const std::span<const double> batch = watch.batches.FullBank();
  for (size_t i = 0; i < watch.size && !batch.empty(); ++i) {
    auto sample = batch.begin() + static_cast<std::ptrdiff_t>(i * batch.size() / watch.size);
    ForEachWatched(watch, [&](size_t axis, WatchedValue value) {
      Store(ArrayOf(axes[axis], value), value, i, *sample++);
    });
  }
  call.acts = true;
  return controller.Execute(call.command, call.arguments, &call.reason);
}

}  // namespace oncard::runtime
