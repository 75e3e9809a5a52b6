#include "explore/reports/trail.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "base/milliseconds.h"
#include "explore/reports/race_orders.h"
#include "explore/reports/relevance.h"
#include "explore/reports/starvation.h"
#include "runtime/conditions/card_condition.h"
#include "runtime/observe/quantity.h"
#include "runtime/observe/statement_access.h"
#include "runtime/observe/thread_status.h"
#include "runtime/scenario/file/expectation.h"
#include "runtime/scenario/run/assert_watch.h"
#include "runtime/scenario/run/response.h"
#include "runtime/sim/card_clock.h"

namespace oncard::explore {
namespace {

/// Number of statements shown of a run with its card: the last ones. If threads are still running
/// at the limit, a few are enough to show the loop they are in.
constexpr int64_t kShownMax = 10'000;
constexpr int64_t kShownAtTheLimit = 40;

/// A statement of a schedule and what it accessed.
struct Touch {
  int thread = 0;
  runtime::StatementAccess access;
};

bool Writes(const runtime::StatementAccess& access, const runtime::Touched& touched) {
  return std::ranges::any_of(access, [&](const runtime::Touched& each) {
    return each.write && each.resource == touched.resource &&
           (each.number == touched.number || each.number == runtime::Touched::kAll);
  });
}

/// Pairs a statement with the nearest statement of another thread that depends on it and is
/// accepted: a later one, which would come first in the other order, otherwise an earlier one.
template <typename Accept>
std::optional<RacingPair> NearestPair(const std::vector<Touch>& touches, size_t statement,
                                      const vm::Object& object, const Accept& accepts) {
  const Touch& fatal = touches[statement];
  const auto pair_with = [&](size_t other) -> std::optional<RacingPair> {
    if (touches[other].thread == fatal.thread) return std::nullopt;
    const runtime::Touched* both = FindDependence(fatal.access, touches[other].access);
    if (both == nullptr || !accepts(other, *both)) return std::nullopt;
    const auto [first, second] = std::minmax(statement, other);
    return RacingPair{NameOf(*both, object),
                      {first, Writes(touches[first].access, *both)},
                      {second, Writes(touches[second].access, *both)}};
  };
  for (size_t i = statement + 1; i < touches.size(); ++i) {
    if (auto pair = pair_with(i)) return pair;
  }
  for (size_t i = statement; i-- > 0;) {
    if (auto pair = pair_with(i)) return pair;
  }
  return std::nullopt;
}

std::optional<RacingPair> PairOf(const std::vector<Touch>& touches,
                                 const std::vector<bool>& matters, int64_t last_escape,
                                 const SyncCells& sync, const vm::Object& object) {
  const auto statement = static_cast<size_t>(last_escape);
  if (last_escape < 0 || statement >= touches.size()) return std::nullopt;
  const auto synchronises = [&](const runtime::Touched& touched) {
    return touched.resource == gtcalls::Resource::kVariable && touched.number < sync.size() &&
           sync[touched.number];
  };
  const auto contributes = [&](size_t other, const runtime::Touched& touched) {
    return matters[other] && !synchronises(touched);
  };
  if (auto pair = NearestPair(touches, statement, object, contributes)) return pair;
  return NearestPair(touches, statement, object,
                     [](size_t, const runtime::Touched&) { return true; });
}

/// A card with a program whose variables have the values that they have in a model.
std::unique_ptr<runtime::Controller> CardOf(const Model& model) {
  auto controller = std::make_unique<runtime::Controller>();
  const vm::Object& object = model.image().object;
  static_cast<void>(controller->Load(object));  // it was linked before, so it cannot fail
  vm::Machine& machine = controller->machine();
  const auto copy = [&](const vm::Symbol& symbol, bool global, int page) {
    for (int i = 0; i < symbol.slots(); ++i) {
      const vm::SlotAddress slot = {global, static_cast<uint8_t>(page),
                                    static_cast<uint16_t>(symbol.id + i), symbol.type};
      machine.WriteRaw(slot, model.Read(slot));
    }
  };
  for (const vm::Symbol& symbol : object.globals) copy(symbol, true, 0);
  for (int i = 0; i < model.thread_count(); ++i) {
    const ThreadSetup& setup = model.setup(i);
    machine.Bind(setup.thread, setup.function + 1, setup.page);
    for (const vm::Symbol& symbol :
         object.functions[static_cast<size_t>(setup.function)].variables) {
      copy(symbol, false, setup.page);
    }
  }
  for (int i = 0; i < model.thread_count(); ++i) machine.Run(model.setup(i).thread);
  return controller;
}

/// The statements of a schedule from the beginning on.
std::vector<TrailStep> StepsOf(const Problem& problem, const std::vector<uint8_t>& schedule) {
  const auto controller = CardOf(problem.model);
  vm::Machine& machine = controller->machine();
  runtime::StepWatch watch(*controller);
  std::vector<TrailStep> steps;
  for (const uint8_t thread : schedule) {
    const int number = problem.model.setup(thread).thread;
    watch.Before();
    machine.ExecuteOne(number);
    machine.Execute(0);
    steps.push_back({thread, watch.After(number)});
  }
  return steps;
}

// --- What is, and what should be -----------------------------------------------------------------

/// The comparison sign before the expected number; none if the values should be equal.
std::string_view SignOf(runtime::Condition::Kind comparison) {
  using Kind = runtime::Condition::Kind;
  switch (comparison) {
    case Kind::kNotEqual:
      return "!= ";
    case Kind::kLess:
      return "< ";
    case Kind::kLessEqual:
      return "<= ";
    case Kind::kGreater:
      return "> ";
    case Kind::kGreaterEqual:
      return ">= ";
    default:
      return "";
  }
}

/// The current values of what a violated requirement names: `sum is 3, expected 10` for a
/// comparison with a number that should hold, otherwise `x is 1, y is 0`. Empty if it names
/// nothing.
Message DescribeValues(const Requirement& requirement, const runtime::Controller& controller) {
  auto expectation = runtime::ParseExpectation(requirement.text);
  if (!expectation.ok()) return {};
  const auto bound =
      runtime::CardCondition::Bind(std::move(expectation.value().condition), controller);
  if (!bound.ok()) return {};
  const auto comparison = bound.value().condition().AsComparison();
  const double* number = comparison ? std::get_if<double>(&comparison->right) : nullptr;
  if (number == nullptr || requirement.scope == Scope::kNever) {
    return bound.value().DescribeValues(controller);
  }
  const runtime::Quantity& left = bound.value().quantities()[comparison->left];
  std::string tolerance;
  if (comparison->tolerance != 0) tolerance = fmt::format(" +- {}", comparison->tolerance);
  return MakeMessage("{0} is {1}, expected {2}{3}{4}", "{0} 为 {1}，应为 {2}{3}{4}", left.name,
                     runtime::DescribeQuantity(left, controller), SignOf(comparison->comparison),
                     *number, tolerance);
}

/// The present values of the right side of a response.
Message DescribeRightSide(const Requirement& response, const runtime::Controller& controller) {
  const auto bound = runtime::CardCondition::Read(response.then, controller);
  return bound.ok() ? bound.value().DescribeValues(controller) : Message();
}

/// The response that the failure violates; nullptr: none.
const Requirement* UnansweredBy(const Subject& subject, const Failure& failure) {
  if (failure.fault.kind != Fault::Kind::kRequirement) return nullptr;
  const auto number = static_cast<size_t>(failure.fault.requirement);
  const Requirement& requirement = subject.requirements[number];
  return requirement.IsResponse() ? &requirement : nullptr;
}

Message AfterStep(int64_t step) {
  return step == 0 ? Message{"at the start", "在开始时"}
                   : MakeMessage("after step {0}", "在第 {0} 步之后", step);
}

/// Adds why a response is not given, whose left side held after so many steps of the run.
void AddUnanswered(const Requirement& response, int64_t since, const Message& since_text,
                   const Message& late, const runtime::Controller& controller, Trail* trail) {
  trail->actual = runtime::DescribeUnanswered(response, since_text, late,
                                              DescribeRightSide(response, controller));
  if (since > trail->skipped) trail->unanswered = static_cast<size_t>(since - trail->skipped - 1);
}

/// Follows what a run of a program without its card owes to a response.
class ResponseFollower {
 public:
  ResponseFollower(const Requirement* response, const runtime::Controller& controller)
      : response_(response), controller_(controller) {
    if (response == nullptr) return;
    runtime::ScenarioErrors errors;
    sides_ = runtime::ReadRequirements<runtime::CardCondition>({*response}, controller, &errors);
    Observe();
  }

  /// To be called in the first state, and after each statement.
  void Observe() {
    for (const auto& [condition, then] : sides_) {
      owed_.Observe(*response_, condition.Holds(controller_), then->Holds(controller_), 0,
                    controller_.machine().state().executed);
    }
  }
  int64_t since() const { return owed_.since_count; }

 private:
  const Requirement* response_;
  const runtime::Controller& controller_;
  std::vector<runtime::BoundSides<runtime::CardCondition>> sides_;
  runtime::Owed owed_;
};

/// The thread's fault and its cause.
Message DescribeFault(const vm::ThreadState& thread, const vm::Image& program, int line) {
  if (const auto depth = runtime::DescribeDepth(thread, program)) {
    return {fmt::format("in line {} {}", line, depth->en),
            fmt::format("第 {} 行：{}", line, depth->zh)};
  }
  switch (static_cast<vm::Fault>(thread.error)) {
    case vm::Fault::kDivisionByZero:
      return MakeMessage("division by zero in line {0}", "第 {0} 行除以零", line);
    case vm::Fault::kIndexOutOfBounds:
      return MakeMessage("in line {0} the index is {1}, the array has {2} elements",
                         "第 {0} 行的下标为 {1}，而数组有 {2} 个元素", line, thread.fault_value,
                         thread.fault_limit);
    case vm::Fault::kOutputBeyondStorage:
      return MakeMessage("in line {0} the command covers {1} variables, but only {2} are there",
                         "第 {0} 行的指令涉及 {1} 个变量，而此处只有 {2} 个", line,
                         thread.fault_value, thread.fault_limit);
    case vm::Fault::kNone:
      break;
  }
  return {};
}

/// What every waiting thread waits for.
Message DescribeWaiting(const runtime::Controller& controller) {
  Message text;
  const vm::Machine& machine = controller.machine();
  for (int number = 0; number < vm::kThreadCount; ++number) {
    const vm::ThreadState& thread = machine.thread(number);
    if (thread.run != vm::ThreadRun::kRunning || !thread.waiting) continue;
    runtime::LoggedStep step;
    step.function = thread.function;
    const vm::Object& object = machine.image()->object;
    const int64_t present = machine.ReadRaw(thread.wait_slot);
    const Message waits =
        MakeMessage("thread {0} waits in line {1} until {2} is {3}, but it is {4}",
                    "线程 {0} 在第 {1} 行等待 {2} 变为 {3}，而其值为 {4}", number,
                    machine.Line(number), runtime::NameOf(step, thread.wait_slot, object),
                    runtime::ValueText(step, thread.wait_slot, thread.wait_value, object),
                    runtime::ValueText(step, thread.wait_slot, present, object));
    text.en += (text.en.empty() ? "" : "; ") + waits.en;
    text.zh += (text.zh.empty() ? "" : "；") + waits.zh;
  }
  return text;
}

/// True for a requirement that has failed before the last statement of the failure.
bool IsAssert(const Subject& subject, const Failure& failure) {
  return failure.fault.kind == Fault::Kind::kRequirement &&
         subject.requirements[static_cast<size_t>(failure.fault.requirement)].scope ==
             Scope::kAssert;
}

Message DescribeActual(const Subject& subject, const Failure& failure,
                       const runtime::Controller& controller) {
  const vm::Machine& machine = controller.machine();
  switch (failure.fault.kind) {
    case Fault::Kind::kRequirement: {
      const auto requirement = static_cast<size_t>(failure.fault.requirement);
      return DescribeValues(subject.requirements[requirement], controller);
    }
    case Fault::Kind::kThread: {
      const int number = subject.threads[static_cast<size_t>(failure.fault.thread)].thread;
      return DescribeFault(machine.thread(number), *machine.image(), machine.Line(number));
    }
    case Fault::Kind::kDeadlock:
      return DescribeWaiting(controller);
    case Fault::Kind::kHostCall:
      return MakeMessage("it returns {0}", "返回 {0}", failure.fault.code);
    case Fault::Kind::kTimeLimit:
    case Fault::Kind::kRace:
    case Fault::Kind::kNone:
      break;
  }
  return {};
}

/// The calls of a host beside a run of its threads.
class HostFollower {
 public:
  /// From a run's beginning on, or from where a loaded state is.
  HostFollower(const CardModel& model, const Fault& fault, bool from_beginning)
      : model_(model),
        fault_(fault),
        done_(from_beginning ? std::numeric_limits<int64_t>::min() : model.host_acted_until()) {}

  /// Adds the calls that have been made since the last time, before the step with that index.
  void AddTo(std::vector<HostStep>* steps, size_t before) {
    if (model_.host() == nullptr) return;
    const runtime::HostCalls& calls = model_.host()->calls();
    auto [call, end] = model_.host()->CallsIn(done_, model_.host_acted_until());
    done_ = model_.host_acted_until();
    // What follows a call that fails is not made.
    if (fault_.kind == Fault::Kind::kHostCall) end = std::min(end, fault_.call + 1);
    for (; call < end; ++call) {
      if (!calls.ChangesCard(call)) continue;
      steps->push_back(
          {before, static_cast<double>(calls.TimeUs(call)) / 1000, calls.Describe(call)});
    }
  }

 private:
  const CardModel& model_;
  const Fault& fault_;
  int64_t done_;
};

}  // namespace

Subject SubjectOf(const Problem& problem) {
  Subject subject;
  for (int i = 0; i < problem.model.thread_count(); ++i) {
    subject.threads.push_back(problem.model.setup(i));
  }
  subject.image = problem.model.shared_image();
  for (const BoundRequirement& bound : problem.requirements) {
    subject.requirements.push_back(bound.AsRequirement());
  }
  subject.races = problem.races;
  return subject;
}

Subject SubjectOf(const CardModel& model) {
  Subject subject;
  subject.threads = model.setups();
  subject.image = model.image();
  subject.requirements = model.Requirements();
  subject.host = model.host();
  return subject;
}

Trail Follow(const Problem& problem, const Failure& failure) {
  Trail trail;
  const Subject subject = SubjectOf(problem);
  const auto controller = CardOf(problem.model);
  vm::Machine& machine = controller->machine();
  runtime::StepWatch watch(*controller);
  std::vector<Touch> touches;
  const Requirement* response = UnansweredBy(subject, failure);
  ResponseFollower follower(response, *controller);
  runtime::ScenarioErrors none;
  runtime::AssertWatch asserts;
  asserts.Begin(*controller, &none);
  const bool fails_before = IsAssert(subject, failure);
  const auto follow = [&](const std::vector<uint8_t>& threads, std::vector<TrailStep>* steps) {
    for (const uint8_t thread : threads) {
      const int number = subject.threads[thread].thread;
      if (fails_before && steps->size() + 1 == threads.size()) {
        if (auto failed = asserts.BeforeStatement(*controller, number)) {
          trail.actual = std::move(failed->values);
        }
      }
      touches.push_back({thread, NextAccess(*controller, number)});
      watch.Before();
      machine.ExecuteOne(number);
      machine.Execute(0);
      steps->push_back({thread, watch.After(number)});
      follower.Observe();
    }
  };
  follow(failure.steps, &trail.steps);
  trail.matters = StepsThatMatter(subject, failure, *controller, trail.steps);
  trail.pair =
      PairOf(touches, trail.matters, failure.last_escape, problem.sync, subject.image->object);
  if (response != nullptr) {
    AddUnanswered(*response, follower.since(), AfterStep(follower.since()), {}, *controller,
                  &trail);
  } else if (!failure.livelock && !fails_before) {
    trail.actual = DescribeActual(subject, failure, *controller);
  }
  follow(failure.cycle, &trail.cycle);
  trail.starvation = DescribeStarvation(trail.cycle, subject.image->object);
  trail.orders = BothOrders(problem, failure);
  for (RaceOrder& order : trail.orders) order.steps = StepsOf(problem, order.schedule);
  return trail;
}

Trail Follow(CardModel* model, const Failure& failure) {
  Trail trail;
  trail.with_card = true;
  std::vector<Touch> touches;
  const auto shown = static_cast<size_t>(
      failure.fault.kind == Fault::Kind::kTimeLimit ? kShownAtTheLimit : kShownMax);
  const size_t skipped = failure.steps.size() - std::min(failure.steps.size(), shown);
  trail.skipped = static_cast<int64_t>(skipped);
  CardModel::State state;
  auto at = static_cast<size_t>(failure.late_steps);
  if (failure.late != nullptr && at <= skipped) {
    state = *failure.late;
    model->Load(state);
  } else {
    state = model->Begin();
    at = 0;
  }
  for (; at < skipped; ++at) model->Advance(&state, failure.steps[at]);
  HostFollower host(*model, failure.fault, skipped == 0);
  host.AddTo(&trail.host, 0);
  runtime::StepWatch watch(model->controller());
  for (size_t i = skipped; i < failure.steps.size(); ++i) {
    const uint8_t thread = failure.steps[i];
    const int number = model->setup(thread).thread;
    touches.push_back({thread, NextAccess(model->controller(), number)});
    watch.Before();
    model->Advance(&state, thread);
    trail.steps.push_back({thread, watch.After(number)});
    host.AddTo(&trail.host, trail.steps.size());
  }
  const Subject subject = SubjectOf(*model);
  trail.matters = StepsThatMatter(subject, failure, model->controller(), trail.steps);
  trail.pair = PairOf(touches, trail.matters, failure.last_escape - trail.skipped, {},
                      subject.image->object);
  if (const Requirement* response = UnansweredBy(subject, failure)) {
    const runtime::Owed& owed = model->OwedTo(state, failure.fault.requirement);
    const int64_t since = owed.since_count - model->executed_before();
    const auto in_time = [](const Message& step, int64_t ns) {
      const double ms = ToMs(ns / runtime::CardClock::kNsPerUs);
      return MakeMessage("{0}, at {2} ms", "{1}（{2} ms）", step.en, step.zh, ms);
    };
    const runtime::Controller& card = model->controller();
    const auto steps = static_cast<int64_t>(failure.steps.size());
    AddUnanswered(*response, since, in_time(AfterStep(since), owed.since_ns),
                  in_time(AfterStep(steps), card.clock().NsOf(card.cycle())), card, &trail);
  } else if (IsAssert(subject, failure)) {
    trail.actual = model->assert_values();
  } else {
    trail.actual = DescribeActual(subject, failure, model->controller());
  }
  return trail;
}

}  // namespace oncard::explore
