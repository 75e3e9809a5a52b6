#include "session/session.h"

#include <algorithm>
#include <utility>

#include "runtime/observe/moving_axes.h"
#include "runtime/observe/quantity.h"
#include "runtime/scenario/run/choices.h"
#include "runtime/scenario/run/scenario_run.h"

namespace oncard::session {
namespace {

using runtime::Quantity;

/// So long after the end of its threads a card whose axes never rest is no longer watched.
constexpr int64_t kLongestAfterEndUs = 60'000'000;

/// Fails if a walk names a thread that does not exist.
Result<void> CheckThread(const Walk& walk) {
  if (walk.goal != Goal::kStatement && walk.goal != Goal::kLine) return {};
  return RewindableRun::CheckThread(walk.thread);
}

/// Fails if a walk forward waits for a thread that executes nothing.
Result<void> CheckThreadRuns(const Walk& walk, const vm::Machine& machine) {
  if (walk.goal != Goal::kStatement && walk.goal != Goal::kLine) return {};
  if (vm::IsAwake(machine.thread(walk.thread))) return {};
  return MakeError(1, "thread {0} does not run", "线程 {0} 没有运行", walk.thread);
}

/// Fails if a walk to a call is made where there are none.
Result<void> CheckCalls(const Walk& walk, const RewindableRun& run) {
  if (walk.goal != Goal::kCall || run.calls() != nullptr) return {};
  return MakeError(1, "there are no calls of a host: load the record of one",
                   "没有主机调用：请载入主机调用记录");
}

Result<std::vector<Quantity>> ResolveScalars(const std::vector<std::string>& names,
                                             const runtime::Controller& controller) {
  std::vector<Quantity> all;
  for (const std::string& name : names) {
    auto found = runtime::ResolveQuantity(name, controller);
    if (!found.ok()) return found;
    if (found.value().size() != 1) {
      return MakeError(1, "'{0}' is an array: name one of its elements, such as '{0}[0]'",
                       "“{0}”是数组：应写其中一个元素，如“{0}[0]”", name);
    }
    all.push_back(std::move(found).value().front());
  }
  return all;
}

}  // namespace

Result<Session> Session::Create(runtime::Scenario scenario, vm::Object object,
                                std::shared_ptr<const vm::Schedule> schedule) {
  const auto choices = runtime::Choices::Of(scenario);
  if (!choices.ok()) return choices.error();
  Message choice;
  if (!choices.value().empty()) {
    if (auto fits = runtime::CheckScenario(scenario, object); !fits.ok()) return fits.error();
    scenario = choices.value().CaseOf(scenario, 0);
    choice = choices.value().DescribeCase(0);
  }
  auto run = RewindableRun::Create(std::move(scenario), std::move(object), std::move(schedule));
  if (!run.ok()) return run.error();
  auto stops = Stops::Create(*run.value());
  if (!stops.ok()) return stops.error();
  run.value()->Await(stops.value().Awaited(), stops.value().Responses());
  Session session(std::move(run).value(), std::move(stops).value());
  session.choice_ = std::move(choice);
  if (session.ForbidsRaces()) {
    StopWishes wishes;
    wishes.races = true;
    if (auto set = session.SetStops(wishes); !set.ok()) return set.error();
  }
  return session;
}

Result<Session> Session::CreateFromCalls(runtime::Scenario scenario,
                                         std::unique_ptr<const runtime::HostCalls> calls) {
  auto run = RewindableRun::CreateFromCalls(std::move(scenario), std::move(calls));
  auto stops = Stops::Create(*run);
  if (!stops.ok()) return stops.error();
  run->Await(stops.value().Awaited(), stops.value().Responses());
  return Session(std::move(run), std::move(stops).value());
}

bool Session::ForbidsRaces() const { return run_->scenario().races != runtime::Scenario{}.races; }

Result<void> Session::SetStops(const StopWishes& wishes) {
  Stops stops = stops_;
  if (auto set = stops.Set(wishes, *run_); !set.ok()) return set;
  if (auto watching = run_->WatchRaces(wishes.races); !watching.ok()) return watching;
  stops_ = std::move(stops);
  return {};
}

// --- Forward -------------------------------------------------------------------------------------

Result<Stop> Session::Forward(const Walk& walk, std::vector<LogLine>* log) {
  if (const auto valid = CheckThread(walk); !valid.ok()) return valid.error();
  if (const auto runs = CheckThreadRuns(walk, run_->machine()); !runs.ok()) return runs.error();
  if (walk.goal == Goal::kChange) {
    return MakeError(1, "a walk to a change of a value goes back", "到某个量变化处的行走只能后退");
  }
  if (const auto has = CheckCalls(walk, *run_); !has.ok()) return has.error();
  const int64_t start = run_->moment();
  const runtime::CardClock& clock = run_->controller().clock();
  const int64_t goal_cycle = run_->controller().cycle() + clock.CyclesIn(walk.time_us);
  const bool checks_all = stops_.CheckEveryStep() || walk.goal == Goal::kStep ||
                          walk.goal == Goal::kStatement || walk.goal == Goal::kLine;
  const bool followed = run_->follows_schedule();
  stops_.Begin(*run_);
  for (bool look_closely = false;;) {
    if (walk.goal == Goal::kStop && run_->Over()) {
      return Stop{StopReason::kEnd, -1, -1, {}, stops_.FailedAtEnd(*run_)};
    }
    if (walk.goal == Goal::kEnd && HasEnded()) {
      return Stop{StopReason::kEnd, -1, -1, {}, stops_.FailedAtEnd(*run_)};
    }
    if (walk.goal == Goal::kRest && Rests()) return Stop{StopReason::kGoal};
    if (run_->moment() - start >= walk.budget || run_->EndIsWanted())
      return Stop{StopReason::kBudget};
    StepReport step;
    if (checks_all || look_closely) {
      step = run_->Step();
      if (auto stop = stops_.Check(*run_, step, log)) return *std::move(stop);
    } else if (const size_t calls = run_->calls_made(); AdvanceUnchecked(start + walk.budget)) {
      step.kind = StepKind::kCycle;
      step.call = run_->calls_made() != calls;
    } else {
      look_closely = true;
      continue;
    }
    if (followed && !run_->follows_schedule()) return Stop{StopReason::kScheduleEnd};
    if (auto stop = Reached(walk, step, goal_cycle)) return *std::move(stop);
  }
}

std::optional<Stop> Session::Reached(const Walk& walk, const StepReport& step,
                                     int64_t goal_cycle) const {
  const auto reached = [&](bool is) {
    return is ? std::optional(Stop{StopReason::kGoal, step.thread}) : std::nullopt;
  };
  const auto thread_runs = [&] {
    return run_->machine().thread(walk.thread).run == vm::ThreadRun::kRunning;
  };
  const bool between = run_->NextStep() == StepKind::kCycle;
  switch (walk.goal) {
    case Goal::kStep:
      return reached(true);
    case Goal::kStatement:
      return reached(step.thread == walk.thread || run_->Over());
    case Goal::kLine:
      return reached((stops_.arrivals() >> walk.thread & 1) != 0 ||
                     (step.thread == walk.thread && !thread_runs()) || run_->Over());
    case Goal::kCycle:
      return reached(between);
    case Goal::kTime:
    case Goal::kEnd:
      return reached(between && run_->controller().cycle() >= goal_cycle);
    case Goal::kCall:
      if (step.call) return Stop{StopReason::kGoal, -1, -1, *run_->last_call()};
      return reached(run_->Over().has_value());
    case Goal::kStop:
    case Goal::kRest:
    case Goal::kChange:
      break;
  }
  return std::nullopt;
}

bool Session::AdvanceUnchecked(int64_t last) {
  const int64_t from = run_->moment();
  const int64_t faults = run_->machine().state().faults;
  const int64_t refused = run_->refused();
  const int64_t failed = run_->failed();
  const int64_t deviations = run_->deviations();
  const int64_t warned = run_->warned();
  run_->Advance(last);
  const bool stopped = run_->deviations() != deviations ||
                       (stops_.faults() && run_->machine().state().faults != faults) ||
                       (stops_.refusals() && run_->refused() != refused) ||
                       (stops_.requirements() && run_->failed() != failed) ||
                       (stops_.warnings() && run_->warned() != warned);
  if (!stopped) return true;
  run_->GoTo(from);
  stops_.Begin(*run_);
  return false;
}

bool Session::Rests() const {
  const bool still = run_->machine().Quiet() || run_->controller().Deadlocked();
  return still && run_->NextStep() == StepKind::kCycle && !run_->scenario_goes_on() &&
         runtime::MovingAxes(run_->controller()) == 0;
}

bool Session::HasEnded() const {
  const auto over = run_->Over();
  if (over != runtime::RunOver::kQuiet || Rests()) return over.has_value();
  const runtime::CardClock& clock = run_->controller().clock();
  return run_->controller().cycle() >= run_->over_cycle() + clock.CyclesIn(kLongestAfterEndUs);
}

Result<Stop> Session::StepThread(int thread) {
  stops_.Begin(*run_);
  const auto stepped = run_->StepThread(thread);
  if (!stepped.ok()) return stepped.error();
  if (auto stop = stops_.Check(*run_, run_->last_step(), nullptr)) return *std::move(stop);
  return Stop{StopReason::kGoal, thread};
}

// --- Back ----------------------------------------------------------------------------------------

Result<Stop> Session::Back(const Walk& walk) {
  if (const auto valid = CheckThread(walk); !valid.ok()) return valid.error();
  if (const auto has = CheckCalls(walk, *run_); !has.ok()) return has.error();
  switch (walk.goal) {
    case Goal::kStep:
      if (run_->moment() == 0) return Stop{StopReason::kStart};
      run_->GoTo(run_->moment() - 1);
      return Stop{StopReason::kGoal};
    case Goal::kStatement:
    case Goal::kLine:
    case Goal::kCycle:
    case Goal::kStop:
    case Goal::kCall:
      return SearchBack(LookFor(walk), walk.budget);
    case Goal::kChange: {
      auto watched = runtime::ResolveQuantity(walk.name, run_->controller());
      if (!watched.ok()) return watched.error();
      return SearchBack(LookForChange(std::move(watched).value()), walk.budget);
    }
    case Goal::kTime:
    case Goal::kRest:
    case Goal::kEnd:
      break;
  }
  return MakeError(1, "a walk for a time, until everything rests or to the end goes forward",
                   "按时间、直到静止或直到结束的行走只能前进");
}

Session::Look Session::LookFor(const Walk& walk) {
  const auto look = [this, walk](int64_t before, const StepReport& step) -> std::optional<Found> {
    const auto goal = [](int64_t moment, int thread) {
      return Found{moment, {StopReason::kGoal, thread}};
    };
    std::optional<Stop> stop = stops_.Check(*run_, step, nullptr);
    if (walk.goal == Goal::kStop) {
      return stop ? std::optional(Found{run_->moment(), *std::move(stop)}) : std::nullopt;
    }
    if (walk.goal == Goal::kStatement && step.thread == walk.thread) {
      return goal(before, walk.thread);
    }
    if (walk.goal == Goal::kLine && (stops_.arrivals() >> walk.thread & 1) != 0) {
      return goal(run_->moment(), walk.thread);
    }
    if (walk.goal == Goal::kCycle && step.kind == StepKind::kCycle) return goal(before, -1);
    if (walk.goal == Goal::kCall && step.call) return goal(before, -1);
    return std::nullopt;
  };
  return {[this] { stops_.Begin(*run_); }, look};
}

Session::Look Session::LookForChange(std::vector<Quantity> quantities) const {
  const auto read = [this, quantities = std::move(quantities)] {
    std::vector<double> values;
    for (const Quantity& each : quantities) {
      values.push_back(ReadQuantity(each, run_->controller()));
    }
    return values;
  };
  const auto last = std::make_shared<std::vector<double>>();
  const auto look = [read, last](int64_t before, const StepReport& step) -> std::optional<Found> {
    std::vector<double> now = read();
    if (std::exchange(*last, now) == now) return std::nullopt;
    return Found{before, {StopReason::kGoal, step.thread}};
  };
  return {[read, last] { *last = read(); }, look};
}

// Searches the stretches between kept states, the last one first.
Stop Session::SearchBack(const Look& look, int64_t budget) {
  const int64_t present = run_->moment();
  for (int64_t end = present; end > 0;) {
    if (present - end >= budget || run_->EndIsWanted()) {
      run_->GoTo(end);
      return {StopReason::kBudget};
    }
    const int64_t begin = run_->KeptBefore(end);
    run_->GoTo(begin);
    look.begin();
    std::optional<Found> found;
    while (run_->moment() < end) {
      const int64_t before = run_->moment();
      auto here = look.step(before, run_->Step());
      if (here && here->moment < present) found = std::move(here);
    }
    if (found) {
      run_->GoTo(found->moment);
      return std::move(found->stop);
    }
    end = begin;
  }
  run_->GoTo(0);
  return {StopReason::kStart};
}

// --- Values over time ----------------------------------------------------------------------------

Result<std::vector<Session::Channel>> Session::Trace(const std::vector<std::string>& names,
                                                     int64_t from_us, int64_t to_us, int points) {
  auto resolved = ResolveScalars(names, run_->controller());
  if (!resolved.ok()) return resolved.error();
  const std::vector<Quantity>& quantities = resolved.value();
  const int64_t present = run_->moment();
  const runtime::CardClock& clock = run_->controller().clock();
  const int64_t now = clock.UsOf(run_->controller().cycle());
  to_us = std::min(to_us, now);
  const int64_t span = std::max<int64_t>(1, to_us - from_us);
  std::vector<Channel> channels(names.size());
  for (size_t i = 0; i < names.size(); ++i) channels[i].name = names[i];
  int filled = 0;  // parts that have a value
  std::vector<double> last(quantities.size());
  const auto add = [&](int64_t time_us) {
    const auto part =
        static_cast<int>(std::min<int64_t>(points - 1, (time_us - from_us) * points / span));
    for (size_t i = 0; i < quantities.size(); ++i) {
      const double value = ReadQuantity(quantities[i], run_->controller());
      Channel& channel = channels[i];
      // Parts without a cycle continue what was there before.
      const double before = channel.largest.empty() ? value : last[i];
      channel.least.resize(static_cast<size_t>(part) + 1, before);
      channel.largest.resize(static_cast<size_t>(part) + 1, before);
      if (part >= filled) {
        channel.least.back() = channel.largest.back() = value;
      } else {
        channel.least.back() = std::min(channel.least.back(), value);
        channel.largest.back() = std::max(channel.largest.back(), value);
      }
      last[i] = value;
    }
    filled = part + 1;
  };
  run_->GoToCycle(clock.LastEnded(from_us * runtime::CardClock::kNsPerUs));
  for (;;) {
    const int64_t time_us = clock.UsOf(run_->controller().cycle());
    if (time_us > to_us || run_->EndIsWanted()) break;
    if (time_us >= from_us) add(time_us);
    if (run_->moment() >= present) break;
    // To the end of the next cycle.
    do {
      run_->Advance(present);
    } while (run_->statements_left() > 0 && run_->moment() < present);
  }
  run_->GoTo(present);
  return channels;
}

}  // namespace oncard::session
