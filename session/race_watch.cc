#include "session/race_watch.h"

#include <algorithm>
#include <utility>

#include "runtime/observe/statement_access.h"
#include "runtime/observe/step_log.h"
#include "runtime/scenario/run/scenario_errors.h"

namespace oncard::session {

Result<RaceWatch> RaceWatch::Create(const runtime::Scenario& scenario,
                                    const runtime::Controller& controller) {
  const vm::Object& object = controller.machine().image()->object;
  runtime::ScenarioErrors errors;
  std::vector<bool> sync = runtime::SyncGlobals(scenario, object, &errors);
  if (auto failure = errors.Failure()) return *std::move(failure);
  const std::vector<bool> awaited = runtime::AwaitedGlobals(object, controller.family().catalogue);
  sync.resize(std::max(sync.size(), awaited.size()));
  for (size_t slot = 0; slot < awaited.size(); ++slot) {
    if (awaited[slot]) sync[slot] = true;
  }
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
  runtime::StatementAccess accesses = NextAccess(controller, thread);
  std::erase_if(accesses, [](const runtime::Touched& touched) {
    return touched.resource != gtcalls::Resource::kVariable;
  });
  // A statement reads before it writes.
  std::stable_partition(accesses.begin(), accesses.end(),
                        [](const runtime::Touched& touched) { return !touched.write; });
  for (const runtime::Touched& touched : accesses) {
    if (!touched.write && Synchronises(touched.number)) clocks_.Acquire(thread, touched.number);
  }
  const vm::Machine& machine = controller.machine();
  const vm::Object& object = machine.image()->object;
  const vm::ThreadState& state = machine.thread(thread);
  std::optional<Message> race;
  for (const runtime::Touched& touched : accesses) {
    if (Synchronises(touched.number)) {
      if (touched.write) clocks_.Release(thread, touched.number);
      continue;
    }
    const auto earlier = touched.write ? clocks_.Write(thread, state.pc, touched.number)
                                       : clocks_.Read(thread, state.pc, touched.number);
    if (!earlier) continue;
    const int function = machine.thread(earlier->thread).function;
    Pair pair = {{{function, earlier->position}, {state.function, state.pc}}};
    std::ranges::sort(pair);
    if (!told_.insert(pair).second || race) continue;
    const auto place = [&](int number, int of, int position, bool writes) {
      const auto& lines = object.functions[static_cast<size_t>(of)].lines;
      return runtime::PlacedAccess{number, lines[static_cast<size_t>(position)], writes};
    };
    race = runtime::DescribeDataRace(
        NameOf(touched, object),
        place(earlier->thread, function, earlier->position, earlier->writes),
        place(thread, state.function, state.pc, touched.write));
  }
  return race;
}

void RaceWatch::AfterStatement(const runtime::Controller& controller, int thread) {
  const vm::ThreadState& state = controller.machine().thread(thread);
  if (state.waiting && state.wait_slot.global) {
    awaited_[static_cast<size_t>(thread)] = state.wait_slot.id;
  }
}

}  // namespace oncard::session
