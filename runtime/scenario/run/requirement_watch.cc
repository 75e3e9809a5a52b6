#include "runtime/scenario/run/requirement_watch.h"

#include <algorithm>
#include <utility>

#include "runtime/sim/program.h"

namespace oncard::runtime {
namespace {

Message Joined(const Message& first, const Message& values) {
  if (values.en.empty()) return first;
  return {fmt::format("{}: {}", first.en, values.en), fmt::format("{}：{}", first.zh, values.zh)};
}

/// True if a condition names something that only a program has.
bool NamesProgram(const CardCondition& condition) {
  return std::ranges::any_of(condition.quantities(),
                             [](const Quantity& quantity) { return IsOfProgram(quantity.kind); });
}

}  // namespace

RequirementWatch::RequirementWatch(std::vector<Requirement> requirements, std::string program_path)
    : program_path_(std::move(program_path)), asserts_(program_path_) {
  for (Requirement& requirement : requirements) {
    observes_states_ = observes_states_ || requirement.scope != Scope::kFinal;
    auto guard = GuardOf(requirement);
    watched_.push_back({.requirement = std::move(requirement),
                        .condition = std::nullopt,
                        .guard = std::move(guard)});
  }
}

// --- Names ---------------------------------------------------------------------------------------

void RequirementWatch::Begin(const Controller& controller, ScenarioErrors* errors) {
  asserts_.Begin(controller, errors);
  failed_asserts_.assign(asserts_.asserts().size(), false);
  std::vector<Requirement> requirements;
  for (const Watched& watched : watched_) requirements.push_back(watched.requirement);
  auto conditions = ReadRequirements<CardCondition>(requirements, controller, errors);
  if (conditions.size() < watched_.size()) return;
  for (size_t i = 0; i < watched_.size(); ++i) {
    watched_[i].condition = std::move(conditions[i].condition);
    watched_[i].then = std::move(conditions[i].then);
    BindGuard(controller, &watched_[i]);
  }
  RememberThreads(controller);
}

RequirementWatch::Names RequirementWatch::NamesNow(const Controller& controller) const {
  Names names = {ProgramNames::Of(controller)};
  const bool same_program = names_ && names_->program.image == names.program.image;
  names.acts = (same_program && names_->acts) || controller.ProgramActs();
  return names;
}

void RequirementWatch::Follow(const Controller& controller) {
  Names names = NamesNow(controller);
  if (names_ == names) return;
  names_ = std::move(names);
  for (Watched& watched : watched_) Bind(controller, &watched);
  ObserveState(controller);
}

void RequirementWatch::Bind(const Controller& controller, Watched* watched) const {
  watched->condition.reset();
  watched->then.reset();
  const auto bind = [&](const std::string& text) -> std::optional<CardCondition> {
    auto bound = CardCondition::Read(text, controller);
    if (!bound.ok()) {
      watched->missing = bound.error().message;
    } else if (!names_->acts && NamesProgram(bound.value())) {
      watched->missing = {"no thread of a program has been started", "没有启动任何程序的线程"};
    } else {
      return std::move(bound).value();
    }
    return std::nullopt;
  };
  auto condition = bind(watched->requirement.text);
  if (!condition) return;
  if (watched->requirement.IsResponse()) {
    watched->then = bind(watched->requirement.then);
    if (!watched->then) return;
  }
  watched->condition = std::move(condition);
  BindGuard(controller, watched);
}

void RequirementWatch::BindGuard(const Controller& controller, Watched* watched) {
  if (!watched->guard) return;
  auto bound = CardCondition::Bind(watched->guard->matters, controller);
  if (bound.ok()) watched->matters = std::move(bound).value();
}

// --- States --------------------------------------------------------------------------------------

void RequirementWatch::ObserveState(const Controller& controller) {
  ObserveAsserts(controller);
  for (Watched& watched : watched_) {
    const Scope scope = watched.requirement.scope;
    if (watched.settled() || !watched.condition || scope == Scope::kFinal) continue;
    if (watched.states++ == 0) watched.since_ms = controller.NowMs();
    watched.LookForGuard(controller);
    if (watched.then) {
      ObserveResponse(controller, &watched);
      continue;
    }
    const bool holds = watched.condition->Holds(controller);
    if (holds == (scope == Scope::kAlways)) continue;
    if (scope == Scope::kEventually) {
      watched.held_ms = controller.NowMs();
      continue;
    }
    const Message place = Place(controller);
    Fail(&watched, Joined(scope == Scope::kAlways
                              ? MakeMessage("does not hold {0}", "{1}不成立", place.en, place.zh)
                              : MakeMessage("holds {0}", "{1}成立", place.en, place.zh),
                          watched.condition->DescribeValues(controller)));
  }
  RememberThreads(controller);
}

void RequirementWatch::ObserveResponse(const Controller& controller, Watched* watched) {
  const bool waited = watched->owed.pending;
  watched->owed.Observe(
      watched->requirement, watched->condition->Holds(controller), watched->then->Holds(controller),
      controller.clock().NsOf(controller.cycle()), controller.machine().state().executed);
  if (watched->owed.late) {
    Fail(watched, DescribeUnanswered(watched->requirement, watched->since, Place(controller),
                                     watched->then->DescribeValues(controller)));
  } else if (watched->owed.pending && !waited) {
    watched->since = Place(controller);
  }
}

void RequirementWatch::ObserveAsserts(const Controller& controller) {
  for (const FailedAssert& failed : asserts_.AfterStatements(controller)) {
    if (failed_asserts_[failed.number]) continue;
    failed_asserts_[failed.number] = true;
    const Requirement& requirement = asserts_.asserts()[failed.number];
    failures_.push_back({requirement.Title(), Describe(failed, requirement)});
  }
}

void RequirementWatch::End(const Controller& controller) {
  for (Watched& watched : watched_) {
    const Message values =
        watched.condition ? watched.condition->DescribeValues(controller) : Message();
    if (watched.requirement.scope == Scope::kLeads && watched.owed.pending) {
      Fail(&watched,
           DescribeUnanswered(watched.requirement, watched.since, {},
                              watched.then ? watched.then->DescribeValues(controller) : Message()));
    } else if (watched.requirement.scope == Scope::kFinal && watched.condition) {
      ++watched.states;
      watched.LookForGuard(controller);
      if (watched.condition->Holds(controller)) {
        watched.held_ms = controller.NowMs();
      } else {
        Fail(&watched, Joined({"does not hold at the end", "结束时不成立"}, values));
      }
    } else if (watched.requirement.scope == Scope::kEventually && watched.states > 0 &&
               !watched.held_ms) {
      Fail(&watched,
           Joined({"held in no state of the run; at its end", "在整个运行中从未成立；结束时"},
                  values));
    }
  }
}

void RequirementWatch::Fail(Watched* watched, Message message) {
  watched->violated = true;
  failures_.push_back({watched->requirement.Title(), std::move(message)});
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

// --- What has been checked -----------------------------------------------------------------------

void RequirementWatch::AddUnchecked(const Message& prefix, ScenarioErrors* errors) const {
  for (const Watched& watched : watched_) {
    if (watched.states > 0 || watched.condition) continue;
    errors->AddText(watched.requirement.place, watched.requirement.Title(),
                    {fmt::format("{}never checked: {}", prefix.en, watched.missing.en),
                     fmt::format("{}从未检查：{}", prefix.zh, watched.missing.zh)});
  }
}

std::vector<Message> RequirementWatch::DescribeHeld() const {
  std::vector<Message> held;
  for (const Watched& watched : watched_) {
    if (watched.violated || watched.states == 0) continue;
    const std::string title = watched.requirement.Title();
    switch (watched.requirement.scope) {
      case Scope::kAlways:
      case Scope::kLeads:
      case Scope::kWithin:
        held.push_back(MakeMessage("'{0}': held in all {1} states from {2} ms on",
                                   "“{0}”：自 {2} ms 起在全部 {1} 个状态中成立", title,
                                   watched.states, watched.since_ms));
        break;
      case Scope::kNever:
        held.push_back(MakeMessage("'{0}': held in none of {1} states from {2} ms on",
                                   "“{0}”：自 {2} ms 起在全部 {1} 个状态中均不成立", title,
                                   watched.states, watched.since_ms));
        break;
      case Scope::kEventually:
        if (!watched.held_ms) break;
        held.push_back(MakeMessage("'{0}': held at {1} ms", "“{0}”：在 {1} ms 时成立", title,
                                   *watched.held_ms));
        break;
      case Scope::kFinal:
        held.push_back(MakeMessage("'{0}': held at the end, {1} ms",
                                   "“{0}”：在结束时（{1} ms）成立", title, *watched.held_ms));
        break;
      case Scope::kAssert:  // in asserts_
        break;
    }
  }
  return held;
}

std::vector<Message> RequirementWatch::DescribeVacuous() const {
  std::vector<Message> vacuous;
  for (const Watched& watched : watched_) {
    if (watched.violated || watched.mattered || watched.states == 0 || !watched.matters) continue;
    vacuous.push_back(runtime::DescribeVacuous(watched.requirement, *watched.guard));
  }
  for (Message& untested : asserts_.DescribeUntested()) vacuous.push_back(std::move(untested));
  return vacuous;
}

Result<ScenarioResult> RunWithRequirements(const Scenario& scenario, vm::Object object,
                                           RunOptions options) {
  RequirementWatch watch(RequirementsOf(scenario), ProgramPath(scenario));
  options.watch = &watch;
  auto result = RunScenario(scenario, std::move(object), options);
  if (!result.ok()) return result;
  std::vector<ScenarioFailure>& failures = result.value().failures;
  failures.insert(failures.end(), watch.failures().begin(), watch.failures().end());
  for (Message& vacuous : watch.DescribeVacuous()) {
    result.value().warnings.push_back(std::move(vacuous));
  }
  return result;
}

Result<void> CheckWithRequirements(const Scenario& scenario, vm::Object object) {
  RequirementWatch watch(RequirementsOf(scenario), ProgramPath(scenario));
  return CheckScenario(scenario, std::move(object), &watch);
}

}  // namespace oncard::runtime
