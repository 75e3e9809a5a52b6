#include "explore/models/host_events.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "runtime/scenario/run/scenario_card.h"

namespace oncard::explore {
namespace {

using Setups = std::vector<ThreadSetup>;

/// True if each bound thread still is what it was; others may have been added.
bool Keeps(const Setups& before, const Setups& now) {
  return std::ranges::includes(now, before, [](const ThreadSetup& a, const ThreadSetup& b) {
    return std::tie(a.thread, a.function, a.page) < std::tie(b.thread, b.function, b.page);
  });
}

void AdvanceTo(int64_t time_us, runtime::Controller* controller) {
  controller->AdvanceUs(time_us - controller->NowUs());
}

void SwitchOn(const runtime::Scenario& scenario, const runtime::HostCalls& calls,
              runtime::Controller* controller) {
  if (!calls.bare()) runtime::ApplyWorld(scenario, controller);
}

}  // namespace

Result<HostEvents> HostEvents::Create(const runtime::Scenario& scenario,
                                      std::shared_ptr<const runtime::HostCalls> calls) {
  HostEvents events(std::move(calls));
  const runtime::HostCalls& host = *events.calls_;
  const size_t count = host.size() - (host.Incomplete() ? 0 : 1);
  runtime::Controller controller(runtime::CardOptions(scenario));
  SwitchOn(scenario, host, &controller);
  const vm::Image* program = nullptr;
  for (size_t i = 0; i < host.size(); ++i) {
    AdvanceTo(host.TimeUs(i), &controller);
    const runtime::HostCalls::Done done = host.ExecuteSilently(i, &controller);
    if (done.deviation) return Error{1, *done.deviation};
    const vm::Machine& machine = controller.machine();
    if (program == nullptr) {
      if (machine.Quiet()) continue;
      events.first_ = i;
      program = machine.image();
    }
    if (i < count) events.cycles_.push_back(controller.cycle());
    Setups setups = BoundThreads(machine);
    const bool same = machine.image() == program && Keeps(events.threads_, setups);
    events.threads_ = std::move(setups);
    if (same) continue;
    return MakeError(
        1,
        "the host changes the program or the function of a thread after it has started "
        "threads: {0}; such a host cannot be explored",
        "主机在启动线程之后更改了程序或线程的函数：{0}；无法探索这样的主机程序", host.Describe(i));
  }
  if (program == nullptr && !controller.family().HasPrograms()) {
    return MakeError(1,
                     "a {0} executes no motion programs: the calls of the host have one order, and "
                     "there is nothing to explore; 'oncard replay' makes them again",
                     "{0} 不执行运动程序：主机调用只有一种顺序，没有可探索的内容；“oncard replay” "
                     "可重放这些调用",
                     scenario.card);
  }
  if (program == nullptr) {
    return MakeError(1, "the host starts no thread of a program: there is nothing to explore",
                     "主机程序未启动任何线程：没有可探索的内容");
  }
  events.end_cycle_ = controller.cycle();
  events.cut_ = !controller.machine().Quiet();
  return events;
}

void HostEvents::Prepare(const runtime::Scenario& scenario, runtime::Controller* controller) const {
  SwitchOn(scenario, *calls_, controller);
  for (size_t i = 0; i < first_; ++i) {
    AdvanceTo(calls_->TimeUs(i), controller);
    calls_->ExecuteSilently(i, controller);
  }
  AdvanceTo(calls_->TimeUs(first_), controller);
}

std::pair<size_t, size_t> HostEvents::CallsIn(int64_t first, int64_t end) const {
  const auto number = [this](int64_t cycle) {
    const auto place = std::lower_bound(cycles_.begin(), cycles_.end(), cycle);
    return first_ + static_cast<size_t>(place - cycles_.begin());
  };
  return {number(first), number(end)};
}

std::optional<HostEvents::Deviation> HostEvents::Act(runtime::Controller* controller) const {
  const auto [begin, end] = CallsIn(controller->cycle(), controller->cycle() + 1);
  for (size_t call = begin; call != end; ++call) {
    const runtime::HostCalls::Done done = calls_->ExecuteSilently(call, controller);
    if (done.deviation) return Deviation{call, done.code};
  }
  return std::nullopt;
}

}  // namespace oncard::explore
