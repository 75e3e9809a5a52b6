#include "explore/requirement_watch.h"

#include <algorithm>
#include <utility>

#include "explore/scenario_exploration.h"
#include "runtime/sim/program.h"

namespace oncard::explore {
namespace {

Message Joined(const Message& first, const Message& values) {
  if (values.en.empty()) return first;
  return {fmt::format("{}: {}", first.en, values.en), fmt::format("{}：{}", first.zh, values.zh)};
}

}  // namespace

void RequirementWatch::Begin(const runtime::Controller& controller, runtime::ScenarioFit* fit) {
  std::vector<runtime::CardCondition> conditions = ReadRequirements(requirements_, controller, fit);
  if (conditions.size() < requirements_.size()) return;
  for (size_t i = 0; i < requirements_.size(); ++i) {
    looks_at_states_ = looks_at_states_ || requirements_[i].scope != Scope::kFinal;
    watched_.push_back({requirements_[i], std::move(conditions[i])});
  }
  RememberThreads(controller);
}

void RequirementWatch::Look(const runtime::Controller& controller) {
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

void RequirementWatch::End(const runtime::Controller& controller) {
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
  failures_.push_back(
      {fmt::format("{}: {}", ScopeName(watched.requirement.scope), watched.requirement.text),
       std::move(message)});
}

Message RequirementWatch::Place(const runtime::Controller& controller) const {
  const vm::Machine& machine = controller.machine();
  for (int number = 0; number < vm::kThreadCount; ++number) {
    const auto index = static_cast<size_t>(number);
    const vm::ThreadState& thread = machine.thread(number);
    if (thread.executed != executed_[index] + 1) continue;
    const vm::Function& function = machine.image()->object.functions[thread.function];
    return MakeMessage(
        "after thread {0} has executed {1}, at {2} ms", "在线程 {0} 执行 {1} 之后（{2} ms）",
        number, runtime::SourcePlace(program_path_, function, next_[index]), controller.NowMs());
  }
  return MakeMessage("at {0} ms", "在 {0} ms ", controller.NowMs());
}

void RequirementWatch::RememberThreads(const runtime::Controller& controller) {
  for (size_t i = 0; i < executed_.size(); ++i) {
    const vm::ThreadState& thread = controller.machine().thread(static_cast<int>(i));
    executed_[i] = thread.executed;
    next_[i] = thread.pc;
  }
}

Result<runtime::ScenarioResult> RunWithRequirements(const runtime::Scenario& scenario,
                                                    vm::Object object,
                                                    runtime::RunOptions options) {
  RequirementWatch watch(RequirementsOf(scenario), runtime::ProgramPath(scenario));
  options.watch = &watch;
  auto result = runtime::RunScenario(scenario, std::move(object), options);
  if (!result.ok()) return result;
  std::vector<runtime::ScenarioFailure>& failures = result.value().failures;
  failures.insert(failures.end(), watch.failures().begin(), watch.failures().end());
  return result;
}

Result<void> FitWithRequirements(const runtime::Scenario& scenario, vm::Object object) {
  RequirementWatch watch(RequirementsOf(scenario), runtime::ProgramPath(scenario));
  return runtime::FitScenario(scenario, std::move(object), &watch);
}

Result<void> AddComments(const std::string& path, std::string_view source, const vm::Object& object,
                         runtime::Scenario* scenario) {
  if (FirstCommentLine(source) == 0) return {};
  const bool binds =
      scenario->threads.empty() &&
      std::ranges::find(object.functions, "t0", &vm::Function::name) != object.functions.end();
  auto read = binds ? ReadComments(path, source, object) : ReadCommentLines(path, source);
  if (!read.ok()) return read.error();
  runtime::PlacedErrors refused;
  for (const auto& [key, place] : read.value().of_all_schedules) {
    refused.Add(place, runtime::DescribeRefusedKey(key, runtime::ScenarioUse::kRun));
  }
  if (auto failure = refused.Failure()) return *std::move(failure);
  runtime::Scenario& said = read.value().scenario;
  if (binds) scenario->threads = std::move(said.threads);
  scenario->globals.insert(scenario->globals.begin(), said.globals.begin(), said.globals.end());
  AddRequirements(read.value().requirements, scenario);
  return {};
}

std::optional<Message> DescribeUnusedComments(const runtime::Scenario& scenario,
                                              std::string_view source) {
  const int line = FirstCommentLine(source);
  if (line == 0) return std::nullopt;
  return MakeMessage(
      "{0}:{1}: this comment is not checked: the requirements come from the scenario; write it "
      "there",
      "{0}:{1}：未检查该注释：使用场景时由场景说明应成立的条件；应写入场景",
      runtime::ProgramPath(scenario), line);
}

}  // namespace oncard::explore
