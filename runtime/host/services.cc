#include "runtime/host/services.h"

#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/files.h"
#include "runtime/host/call_log.h"
#include "runtime/host/host_bus.h"
#include "runtime/host/host_card.h"
#include "runtime/host/host_clock.h"
#include "runtime/host/host_memory.h"
#include "runtime/host/host_refusals.h"
#include "runtime/host/host_signals.h"
#include "runtime/host/host_system.h"
#include "runtime/host/host_time.h"
#include "runtime/host/library.h"
#include "runtime/scenario/run/scenario_card.h"

namespace oncard::runtime {
namespace {

/// A card without surroundings: of the named type, or the default one.
Scenario BareCard(const gtcalls::CardType* named) {
  const gtcalls::CardType& type = named != nullptr ? *named : LibraryFamily().default_card;
  Scenario scenario;
  scenario.card = type.name;
  scenario.axis_count = type.axis_count;
  scenario.limit_ms = kTimeMsMax;
  return scenario;
}

/// One entry per command of the catalogue; nullptr for a command that the card executes.
std::vector<const HostService*> ServicesByNumber() {
  const gtcalls::Catalogue& catalogue = LibraryFamily().catalogue;
  std::vector<const HostService*> services(catalogue.commands().size());
  for (const HostService& service : Library().services) {
    const gtcalls::Command* command = catalogue.Find(service.command);
    if (command == nullptr) continue;  // a misspelt name, which a test reports
    services[command->number - 1u] = &service;
  }
  return services;
}

}  // namespace

const HostService* FindHostService(const gtcalls::Command& command) {
  // Never destroyed: objects of the host may make calls while the process exits.
  static const auto& services = *new const std::vector<const HostService*>(ServicesByNumber());
  return services[command.number - 1u];
}

int16_t ExecuteOnCard(ServiceCall& call) {
  call.acted = true;
  return call.slot.controller->Execute(call.command, call.arguments, &call.reason);
}

int16_t OpenCard(ServiceCall& call) {
  CardSlot& slot = call.slot;
  const auto fail = [&call](const Message& why) {
    return call.Refuse(LibraryFamily().open_failed, why);
  };
  if (slot.controller != nullptr) return fail({"the card is already open", "该卡已打开"});
  ReadHostTimeSetting();
  const char* setting = std::getenv("ONCARD_CLOCK");
  const auto clock = ParseClockSetting(setting == nullptr ? "" : setting);
  if (!clock.ok()) return fail(clock.error().message);
  const auto card = CardFromEnvironment(&LibraryFamily());
  if (!card.ok()) return fail(card.error().message);
  const auto scenario = ScenarioFromEnvironment();
  if (!scenario.ok()) return fail(scenario.error().message);
  std::shared_ptr<const Scenario> world = scenario.value();
  std::vector<std::string> trace_files;
  if (call.card() == 0) trace_files = TraceFilesFromEnvironment();
  const Scenario bare = BareCard(card.value());
  if (world == nullptr && !trace_files.empty()) world = std::make_shared<const Scenario>(bare);
  Scenario opened = world == nullptr ? bare : *world;
  TakeEni(FolderOfProgram(), &opened);
  auto memory = TakeMemory(call.card(), &opened);
  if (!memory.ok()) return fail(memory.error().message);
  const bool bare_card = world == nullptr && opened.bus == BusSetup() && opened.memory.empty();
  CallRecorder* const recorder = CallRecorder::Wanted();
  if (recorder != nullptr) {
    const auto recorded = recorder->Open(call.card(), opened, bare_card);
    if (!recorded.ok()) return fail(recorded.error().message);
  }
  slot.controller = std::make_unique<Controller>(CardOptions(opened));
  slot.recorder = recorder;
  slot.memory = std::move(memory).value();
  if (recorder != nullptr) {
    slot.controller->card().read_file = [&slot](const std::string& path) {
      auto text = ReadFile(path, kConfigKind);
      if (text.ok()) slot.files.emplace().config = text.value();
      return text;
    };
  }
  // The log also shows what happens at power-on.
  if (CallLog* log = CallLog::Wanted(); log != nullptr) {
    slot.controller->LogRefusals(log, call.card());
    slot.controller->LogEvents(log, call.card());
  }
  if (world != nullptr) {
    slot.watch.emplace(world, call.card(), std::move(trace_files));
    slot.watch->Listen(slot.controller.get());
  }
  if (!bare_card) ApplyWorld(opened, slot.controller.get());
  slot.clock.emplace(clock.value());
  slot.FindEarliestEnd();
  const bool collects = RefusalReportOfProcess() != RefusalReport::kNothing;
  if (collects) {
    slot.controller->CollectRefusals(&slot.refused);
    slot.supervisor.emplace(slot.controller.get());
  }
  if (slot.watch || slot.memory || collects) WatchHostSignals();
  slot.no_program_code = vm::kRefused;
  return vm::kOk;
}

int16_t CloseCard(ServiceCall& call) {
  call.slot.SwitchOff();
  return vm::kOk;
}

int16_t ResetCard(ServiceCall& call) {
  call.slot.controller->Reset();
  call.slot.no_program_code = vm::kRefused;
  return vm::kOk;
}

int16_t SelectCard(ServiceCall& call) {
  const double number = call.arguments[0].value;
  if (!(number >= 0 && number < kCardCount)) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("parameter {} is {}; the range is [0, {}]", "参数 {} 为 {}；取值范围为 [0, {}]",
                    call.command.parameters[0].name, number, kCardCount - 1));
  }
  call.table.selected = static_cast<int>(number);
  return vm::kOk;
}

int16_t GetSelectedCard(ServiceCall& call) {
  return static_cast<int16_t>(call.table.selected.load());
}

}  // namespace oncard::runtime
