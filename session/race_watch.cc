#include "session/race_watch.h"

#include <algorithm>
#include <utility>

#include "runtime/observe/race_steps.h"
#include "runtime/scenario/run/scenario_errors.h"

namespace oncard::session {

Result<RaceWatch> RaceWatch::Create(const runtime::Scenario& scenario,
                                    const runtime::Controller& controller) {
  runtime::ScenarioErrors errors;
  std::vector<bool> sync = runtime::OrderingGlobals(scenario, controller, &errors);
  if (auto failure = errors.Failure()) return *std::move(failure);
  RaceWatch watch;
  watch.sync_ = std::make_shared<const std::vector<bool>>(std::move(sync));
  return watch;
}

std::optional<Message> RaceWatch::BeforeStatement(const runtime::Controller& controller,
                                                  int thread) {
  if (auto& awaited = awaited_[static_cast<size_t>(thread)]) {
    clocks_.Acquire(thread, *awaited);
    awaited.reset();
  }
  const vm::Machine& machine = controller.machine();
  const vm::ThreadState& state = machine.thread(thread);
  std::optional<Message> race;
  for (const auto& [kind, cell] : NextRaceSteps(controller, thread, *sync_)) {
    if (kind == runtime::RaceStep::Kind::kAcquire) {
      clocks_.Acquire(thread, cell);
      continue;
    }
    if (kind == runtime::RaceStep::Kind::kRelease) {
      clocks_.Release(thread, cell);
      continue;
    }
    const bool writes = kind == runtime::RaceStep::Kind::kWrite;
    const auto earlier =
        writes ? clocks_.Write(thread, state.pc, cell) : clocks_.Read(thread, state.pc, cell);
    if (!earlier) continue;
    const int function = machine.thread(earlier->thread).function;
    Pair pair = {{{function, earlier->position}, {state.function, state.pc}}};
    std::ranges::sort(pair);
    if (!told_.insert(pair).second || race) continue;
    race = Describe(controller, cell, *earlier, {thread, state.pc, writes});
  }
  return race;
}

Message RaceWatch::Describe(const runtime::Controller& controller, uint32_t cell,
                            const vm::RacingAccess& first, const vm::RacingAccess& second) {
  const vm::Object& object = controller.machine().image()->object;
  const auto line_of = [&](const vm::RacingAccess& access) -> int {
    const vm::Function& function =
        object.functions[controller.machine().thread(access.thread).function];
    return function.lines[static_cast<size_t>(access.position)];
  };
  if (runtime::IsSetByCommands(cell)) {
    const auto command = [&](const vm::RacingAccess& access) -> runtime::PlacedCommand {
      return {access.thread, line_of(access),
              CommandAt(controller, access.thread, access.position)};
    };
    return runtime::DescribeTwoOwners(cell, object, command(first), command(second));
  }
  return runtime::DescribeDataRace(runtime::NameOfCell(cell, object).en,
                                   {first.thread, line_of(first), first.writes},
                                   {second.thread, line_of(second), second.writes});
}

void RaceWatch::AfterStatement(const runtime::Controller& controller, int thread) {
  const vm::ThreadState& state = controller.machine().thread(thread);
  if (state.waiting && state.wait_slot.global) {
    awaited_[static_cast<size_t>(thread)] = state.wait_slot.id;
  }
}

}  // namespace oncard::session
