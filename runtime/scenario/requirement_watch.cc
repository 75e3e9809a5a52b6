#include "runtime/scenario/requirement_watch.h"

#include <utility>

#include "runtime/sim/program.h"

namespace oncard::runtime {
namespace {

Message Joined(const Message& first, const Message& values) {
  if (values.en.empty()) return first;
  return {fmt::format("{}: {}", first.en, values.en), fmt::format("{}：{}", first.zh, values.zh)};
}

}  // namespace

void RequirementWatch::Begin(const Controller& controller, ScenarioFit* fit) {
  auto conditions = ReadRequirements<CardCondition>(requirements_, controller, fit);
  if (conditions.size() < requirements_.size()) return;
  for (size_t i = 0; i < requirements_.size(); ++i) {
    looks_at_states_ = looks_at_states_ || requirements_[i].scope != Scope::kFinal;
    watched_.push_back({requirements_[i], std::move(conditions[i])});
  }
  RememberThreads(controller);
}

void RequirementWatch::Look(const Controller& controller) {
  for (Watched& watched : watched_) {
    const Scope scope = watched.requirement.scope;
    if (watched.settled || scope == Scope::kFinal) continue;
    const bool holds = watched.condition.Holds(controller);
    if (holds == (scope == Scope::kAlways)) continue;
    watched.settled = true;
    if (scope == Scope::kEventually) continue;
    const Message place = Place(controller);
    Fail(watched, Joined(scope == Scope::kAlways
                             ? MakeMessage("does not hold {0}", "{1}不成立", place.en, place.zh)
                             : MakeMessage("holds {0}", "{1}成立", place.en, place.zh),
                         watched.condition.DescribeValues(controller)));
  }
  RememberThreads(controller);
}

void RequirementWatch::End(const Controller& controller) {
  for (const Watched& watched : watched_) {
    const Message values = watched.condition.DescribeValues(controller);
    if (watched.requirement.scope == Scope::kFinal && !watched.condition.Holds(controller)) {
      Fail(watched, Joined({"does not hold at the end", "结束时不成立"}, values));
    } else if (watched.requirement.scope == Scope::kEventually && !watched.settled) {
      Fail(watched,
           Joined({"held in no state of the run; at its end", "在整个运行中从未成立；结束时"},
                  values));
    }
  }
}

void RequirementWatch::Fail(const Watched& watched, Message message) {
  failures_.push_back({watched.requirement.Title(), std::move(message)});
}

Message RequirementWatch::Place(const Controller& controller) const {
  const vm::Machine& machine = controller.machine();
  for (int number = 0; number < vm::kThreadCount; ++number) {
    const auto index = static_cast<size_t>(number);
    const vm::ThreadState& thread = machine.thread(number);
    if (thread.executed != executed_[index] + 1) continue;
    const vm::Function& function = machine.image()->object.functions[thread.function];
    return MakeMessage("after thread {0} has executed {1}, at {2} ms",
                       "在线程 {0} 执行 {1} 之后（{2} ms）", number,
                       SourcePlace(program_path_, function, next_[index]), controller.NowMs());
  }
  return MakeMessage("at {0} ms", "在 {0} ms ", controller.NowMs());
}

void RequirementWatch::RememberThreads(const Controller& controller) {
  for (size_t i = 0; i < executed_.size(); ++i) {
    const vm::ThreadState& thread = controller.machine().thread(static_cast<int>(i));
    executed_[i] = thread.executed;
    next_[i] = thread.pc;
  }
}

Result<ScenarioResult> RunWithRequirements(const Scenario& scenario, vm::Object object,
                                           RunOptions options) {
  RequirementWatch watch(RequirementsOf(scenario), ProgramPath(scenario));
  options.watch = &watch;
  auto result = RunScenario(scenario, std::move(object), options);
  if (!result.ok()) return result;
  std::vector<ScenarioFailure>& failures = result.value().failures;
  failures.insert(failures.end(), watch.failures().begin(), watch.failures().end());
  return result;
}

Result<void> FitWithRequirements(const Scenario& scenario, vm::Object object) {
  RequirementWatch watch(RequirementsOf(scenario), ProgramPath(scenario));
  return FitScenario(scenario, std::move(object), &watch);
}

}  // namespace oncard::runtime
