#include "runtime/scenario/run/scenario_run.h"

#include <algorithm>

#include "base/files.h"
#include "base/milliseconds.h"
#include "runtime/observe/supervisor.h"
#include "runtime/observe/thread_status.h"
#include "runtime/scenario/run/choices.h"
#include "runtime/scenario/run/response.h"
#include "runtime/scenario/run/run_course.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_start.h"
#include "runtime/scenario/run/vacuity.h"
#include "runtime/sim/program.h"

namespace oncard::runtime {
namespace {

/// A cycle that is never reached.
constexpr int64_t kNever = INT64_MAX;

/// The number of cycles after which a run checks whether it must stop.
constexpr int64_t kLookCycles = 1000;

class ScenarioRunner {
 public:
  ScenarioRunner(const Scenario& scenario, const RunOptions& options)
      : scenario_(scenario),
        options_(options),
        controller_(CardOptions(scenario)),
        supervisor_(&controller_) {}

  Result<ScenarioResult> Run(vm::Object object) {
    if (options_.log != nullptr) {
      controller_.LogRefusals(options_.log, 0);
      controller_.LogEvents(options_.log, 0);
    }
    controller_.CollectRefusals(&refused_);
    if (options_.trace) KeepEvents();
    auto started = StartScenario(scenario_, std::move(object), &controller_, &errors_);
    if (!started.ok()) return started.error();
    if (const auto policy = SetUpPolicy(); !policy.ok()) {
      const bool of_scenario = options_.replay == nullptr;
      errors_.Add(of_scenario ? PlaceOfText(scenario_, "schedule") : TextPlace{},
                  policy.error().message);
    }
    FindNames();
    if (auto failure = errors_.Failure()) return *std::move(failure);
    BeginTrace();
    BeginWatch();
    BeginHost();
    if (options_.steps) result_.steps.emplace();
    Execute();
    Report();
    return std::move(result_);
  }

  Result<void> Fit(vm::Object object) {
    auto started = StartScenario(scenario_, std::move(object), &controller_, &errors_);
    if (!started.ok()) return started;
    FindNames();
    if (auto failure = errors_.Failure()) return *std::move(failure);
    return {};
  }

 private:
  const vm::Image& image() const { return *controller_.machine().image(); }

  // --- Before the start ------------------------------------------------------------------------

  Result<void> SetUpPolicy() {
    const auto policy = ChosenPolicy();
    if (!policy.ok()) return policy.error();
    replayed_ = policy.value().schedule;
    controller_.machine().SetPolicy(policy.value());
    recording_ = options_.record ? &own_recording_ : options_.recording;
    if (recording_ != nullptr) {
      *recording_ = {};
      recording_->program_hash = image().hash;
      controller_.machine().Record(recording_);
    }
    return {};
  }

  Result<vm::Policy> ChosenPolicy() const {
    if (options_.replay != nullptr) return FollowSchedule(options_.replay, image());
    if (!scenario_.schedule.starts_with(kReplayPrefix)) return vm::ParsePolicy(scenario_.schedule);
    const std::string path =
        PathFromScenario(scenario_, scenario_.schedule.substr(kReplayPrefix.size()));
    auto schedule = vm::LoadSchedule(path);
    if (!schedule.ok()) return schedule.error();
    return FollowSchedule(std::make_shared<const vm::Schedule>(std::move(schedule).value()),
                          image());
  }

  // Resolves all names.
  void FindNames() {
    course_.Read(scenario_, &controller_, &errors_);
    FindShown();
    traced_ = TraceQuantities(scenario_, controller_, &errors_);
    if (options_.watch == nullptr) return;
    CheckTimes(RequirementsOf(scenario_), scenario_, image().object, &errors_);
    options_.watch->Begin(controller_, &errors_);
  }

  void FindShown() {
    if (options_.show.empty()) AddShown({}, GlobalQuantities(controller_));
    for (const std::string& name : options_.show) {
      if (!errors_.CanJudge(name)) continue;
      auto quantities = ResolveQuantity(name, controller_);
      if (quantities.ok()) {
        AddShown(name, std::move(quantities).value());
      } else {
        errors_.Add({}, quantities.error().message);
      }
    }
  }

  // Each array and each number of a structure has a value of its own; a number is called as it was
  // asked for.
  void AddShown(const std::string& asked, std::vector<Quantity> quantities) {
    bool first = true;
    for (Quantity& quantity : quantities) {
      std::string name = quantity.is_part || asked.empty() ? quantity.name : asked;
      while (quantity.is_part && name.ends_with(']')) name.resize(name.rfind('['));
      if (first || shown_.back() != name) {
        shown_.push_back(std::move(name));
        shown_quantities_.emplace_back();
      }
      first = false;
      shown_quantities_.back().push_back(std::move(quantity));
    }
  }

  // --- What is looked at -----------------------------------------------------------------------

  void BeginTrace() {
    if (!options_.trace) return;
    std::vector<TraceColumn> columns;
    for (Quantity& quantity : traced_) columns.push_back({std::move(quantity)});
    if (scenario_.trace.empty()) {
      for (const std::vector<Quantity>& quantities : shown_quantities_) {
        for (const Quantity& quantity : quantities) columns.push_back({quantity});
      }
      auto outputs = ResolveQuantity("gpo", controller_);
      if (outputs.ok()) columns.push_back({std::move(outputs).value().front()});
      for (TraceColumn& column : DefaultColumns(controller_)) columns.push_back(std::move(column));
    }
    result_.trace.emplace(std::move(columns));
    for (TraceMark& mark : at_power_on_) result_.trace->Mark(std::move(mark));
  }

  // Adds what the card does by itself to the trace; events before the trace begins are kept for it.
  void KeepEvents() {
    controller_.ListenToEvents([this](int64_t time_us, const Message& what) {
      TraceMark mark = {time_us, what, true};
      if (result_.trace) {
        result_.trace->Mark(std::move(mark));
      } else {
        at_power_on_.push_back(std::move(mark));
      }
    });
  }

  void BeginWatch() {
    RunWatch* watch = options_.watch;
    if (watch == nullptr || !watch->ObservesStates()) return;
    watch->ObserveState(controller_);
    controller_.ObserveStates([this, watch] { watch->ObserveState(controller_); });
  }

  // --- The host --------------------------------------------------------------------------------

  void BeginHost() {
    const auto within = [](const HostEvent& event) { return event.after_statements.has_value(); };
    if (std::ranges::none_of(scenario_.host, within)) return;
    controller_.LetHostAct([this](int64_t executed) {
      const auto mark = [this](const Agenda::Write& write) { Mark(write); };
      if (course_.ActWithin(&controller_, executed, mark)) controller_.ShowState();
      return course_.agenda().NextWithin(controller_.cycle());
    });
  }

  void Mark(const Agenda::Write& write) {
    if (!result_.trace) return;
    result_.trace->Mark(controller_, fmt::format("{} = {}", write.variable.name, write.value));
  }

  // --- The run ---------------------------------------------------------------------------------

  void Execute() {
    const int64_t last = std::min(course_.bounds().last(), CutOfReplay());
    do {
      course_.Act(
          &controller_, [this](const Agenda::Check& check) { EvaluateNow(check); },
          [this](const Agenda::Write& write) { Mark(write); });
      if (result_.trace) result_.trace->Sample(controller_);
    } while (GoesOn(last) && RunOn(last));
    const RunBounds& bounds = course_.bounds();
    result_.reached_until =
        controller_.cycle() >= bounds.last() && bounds.kind_of_last() == RunOver::kUntil;
    const bool over = ended_ || controller_.machine().Quiet();
    const bool cut = bounds.until && controller_.cycle() >= bounds.limit && !result_.reached_until;
    if (!over || (cut && result_.end == RunEnd::kQuiet)) result_.end = RunEnd::kTimeLimit;
    result_.interrupted = result_.interrupted || came_to_cut_;
    if (result_.trace) result_.trace->Finish(controller_);
  }

  // At a boundary of cycles, where the scenario has acted.
  bool GoesOn(int64_t last) {
    if (controller_.cycle() >= last) {
      came_to_cut_ = last == CutOfReplay();
      return false;
    }
    if (options_.stop != nullptr && *options_.stop) {
      result_.interrupted = true;
      return false;
    }
    const auto over = course_.Over(controller_);
    if (over == RunOver::kDeadlock) {
      ended_ = true;
      result_.end = RunEnd::kDeadlock;
    }
    return !over;
  }

  // Up to the next boundary at which something is to be done. False if a replay cannot go on.
  bool RunOn(int64_t last) {
    const int64_t cycles = NextLook(last) - controller_.cycle();
    const bool host_is_awaited = course_.agenda().has_writes();
    if (!ended_) ended_ = controller_.machine().Quiet();
    if (ended_ || (host_is_awaited && controller_.Deadlocked())) {
      controller_.RunCycles(cycles);
      return true;
    }
    const RunEnd end = result_.steps ? RunLogged(&controller_, cycles, &*result_.steps)
                                     : controller_.RunUntilQuiet(cycles);
    ended_ = end != RunEnd::kTimeLimit && !(end == RunEnd::kDeadlock && host_is_awaited);
    if (ended_) result_.end = end;
    came_to_cut_ = end == RunEnd::kScheduleEnd && CutOfReplay() != kNever;
    return end != RunEnd::kScheduleEnd && end != RunEnd::kScheduleDiverged;
  }

  // The cycle at which a recorded run was cut off.
  int64_t CutOfReplay() const {
    if (replayed_ == nullptr || !replayed_->cut_us) return kNever;
    return controller_.clock().CycleAt(*replayed_->cut_us);
  }

  // The cycle up to which the run can continue without an action from here.
  int64_t NextLook(int64_t last) const {
    if (result_.trace) return controller_.cycle() + 1;
    return std::min({last, controller_.cycle() + kLookCycles, course_.NextCycle()});
  }

  void EvaluateNow(const Agenda::Check& check) {
    if (check.condition.Holds(controller_)) return;
    Fail(check.text, DescribeFailure(check.condition, controller_));
  }

  void Fail(std::string expectation, Message message) {
    result_.failures.push_back({std::move(expectation), std::move(message)});
  }

  // --- After the run ---------------------------------------------------------------------------

  void Report() {
    const vm::Machine& machine = controller_.machine();
    CheckReplay();
    if (recording_ != nullptr) FinishRecording();
    result_.end_ms = controller_.NowMs();
    result_.statements = machine.state().executed;
    result_.hash = controller_.Hash();
    result_.program_hash = image().hash;
    for (int thread = 0; thread < vm::kThreadCount; ++thread) {
      if (machine.thread(thread).run != vm::ThreadRun::kUnbound) ReportThread(thread);
    }
    ReportRefusedCommands();
    if (!result_.interrupted) supervisor_.JudgeEnd();
    ReportFindings();
    if (!result_.interrupted) JudgeEnd();
    if (came_to_cut_ && result_.interrupted) ReportCut();
    if (!result_.interrupted && InOrder()) {
      WarnOfMissedWrites();
      WarnOfLateEvents();
      WarnOfReactions();
    }
    for (size_t i = 0; i < shown_.size(); ++i) {
      ShownValue value;
      value.name = shown_[i];
      for (const Quantity& quantity : shown_quantities_[i]) {
        value.array = quantity.is_part && quantity.name != shown_[i];
        if (quantity.axis_unit.named()) value.unit = quantity.axis_unit.NameOf(quantity.measure());
        value.elements.push_back(FormatNumber(ReadQuantity(quantity, controller_),
                                              FormOfQuantity(quantity, controller_)));
      }
      result_.values.push_back(std::move(value));
    }
  }

  void JudgeEnd() {
    while (const Agenda::Check* check = course_.TakeMissed()) {
      Fail(check->text, MakeMessage("the run ended before, at {0} ms",
                                    "运行在此之前结束，时刻 {0} ms", result_.end_ms));
    }
    if (course_.bounds().CutsAt(controller_)) {
      WarnOfUncheckedEnd();
    } else {
      for (const Agenda::Check& check : course_.agenda().at_end()) EvaluateNow(check);
      if (options_.watch != nullptr && InOrder()) options_.watch->End(controller_);
    }
    ReportEnd();
  }

  void WarnOfUncheckedEnd() {
    const bool asked = !course_.agenda().at_end().empty() || !scenario_.final.empty() ||
                       !scenario_.eventually.empty();
    if (!asked) return;
    result_.warnings.push_back(
        MakeMessage("threads still run at the time limit of {0} ms, which is allowed here: what "
                    "must hold at the end of the run was not checked",
                    "到时间上限 {0} ms 时仍有线程在运行（此处允许）：未检查运行结束时应成立的条件",
                    scenario_.limit_ms));
  }

  void ReportCut() {
    result_.warnings.push_back(
        MakeMessage("the recording ends at {0} ms, after statement {1}: the recorded run was "
                    "interrupted there, and so is this replay",
                    "录制在 {0} ms、第 {1} 条语句之后结束：录制的运行在此被中断，重放也到此为止",
                    result_.end_ms, result_.statements));
  }

  void ReportRefusedCommands() {
    for (const RefusedCommand& refused : refused_.list()) {
      WarnOfProgram(DescribeRefusedCommand(refused, ProgramPath(scenario_)));
    }
  }

  void ReportFindings() {
    for (const CardFinding& finding : supervisor_.findings()) {
      if (options_.silent.Has(finding.warning)) continue;
      WarnOfProgram(DescribeFinding(finding, ProgramPath(scenario_)));
    }
  }

  // Of what the program does; a failure if the run is strict.
  void WarnOfProgram(Message text) {
    if (options_.strict_commands) {
      Fail({}, std::move(text));
    } else {
      result_.warnings.push_back(std::move(text));
    }
  }

  void WarnOfMissedWrites() {
    if (!course_.agenda().has_writes()) return;
    const Agenda::Write& write = course_.agenda().next_write();
    const int64_t at_us = controller_.clock().UsOf(write.cycle);
    result_.warnings.push_back(
        MakeMessage("the run ended at {0} ms, before the host writes {1} at {2} ms: 'until_ms' "
                    "makes it last longer",
                    "运行在 {0} ms 结束，早于主机在 {2} ms 写入 {1}：可用“until_ms”使运行继续",
                    result_.end_ms, write.variable.name, ToMs(at_us)));
  }

  void WarnOfLateEvents() {
    const int64_t end_us = controller_.clock().UsOf(controller_.cycle());
    for (Message& late : DescribeLateEvents(scenario_.world, end_us, false)) {
      result_.warnings.push_back(std::move(late));
    }
  }

  void WarnOfReactions() {
    const Reactions* reactions = controller_.reactions();
    if (reactions == nullptr) return;
    const World& world = scenario_.world;
    for (Message& idle : DescribeIdleReactions(world, reactions->started(), false)) {
      result_.warnings.push_back(std::move(idle));
    }
    for (const Reactions::Pending& pending : reactions->state().pending) {
      result_.warnings.push_back(MakeMessage(
          "the run ended at {0} ms, before the [[world.react]] of '{1}' acts at {2} ms: "
          "'until_ms' makes it last longer",
          "运行在 {0} ms 结束，早于“{1}”的 [[world.react]] 在 {2} ms "
          "起作用：可用“until_ms”使运行继续",
          result_.end_ms, world.reactions[pending.reaction].when,
          ToMs(pending.at_ns / CardClock::kNsPerUs)));
    }
  }

  // True if the run ended as intended.
  bool InOrder() const {
    return result_.end == RunEnd::kQuiet ||
           (result_.end == RunEnd::kDeadlock && MayDeadlock(scenario_)) ||
           (result_.end == RunEnd::kTimeLimit && result_.reached_until);
  }

  void ReportEnd() {
    switch (result_.end) {
      case RunEnd::kQuiet:
        break;
      case RunEnd::kTimeLimit:
        ReportTimeLimit();
        break;
      case RunEnd::kDeadlock:
        if (MayDeadlock(scenario_)) break;
        Fail({}, MakeMessage("deadlock at {0} ms: every running thread waits for a variable that "
                             "nothing can change any more",
                             "在 {0} ms 时死锁：所有运行中的线程都在等待不会再改变的变量",
                             result_.end_ms));
        break;
      case RunEnd::kScheduleEnd:
        Fail({}, MakeMessage("the schedule ends after statement {0}, but threads can still run",
                             "调度在第 {0} 条语句之后结束，但仍有线程可运行", result_.statements));
        break;
      case RunEnd::kScheduleDiverged:
        Fail({}, MakeMessage("the replay deviates from the recorded run after statement {0}",
                             "重放在第 {0} 条语句之后偏离录制的运行", result_.statements));
        break;
    }
  }

  void ReportTimeLimit() {
    if (result_.reached_until) return;
    if (controller_.machine().Quiet()) {
      Fail({}, MakeMessage("the time limit of {0} ms is before the end required by 'until_ms', {1} "
                           "ms: increase 'limit_ms'",
                           "时间上限 {0} ms 早于“until_ms”要求的结束时刻 {1} ms：应增大“limit_ms”",
                           scenario_.limit_ms, static_cast<double>(*scenario_.until_us) / 1000));
      return;
    }
    Fail({}, MakeMessage("threads still run at the time limit of {0} ms",
                         "到时间上限 {0} ms 时仍有线程在运行", scenario_.limit_ms));
  }

  // The last checkpoint of a recording is the state at the end of the run.
  void CheckReplay() {
    if (replayed_ == nullptr || replayed_->checkpoints.empty()) return;
    if (result_.end == RunEnd::kScheduleDiverged) return;
    if (result_.end == RunEnd::kScheduleEnd && !came_to_cut_) return;
    const vm::Machine& machine = controller_.machine();
    const vm::ScheduleCheckpoint& last = replayed_->checkpoints.back();
    if (last.statement % vm::kCheckpointInterval == 0) return;  // the machine has compared it
    if (machine.state().executed == last.statement && machine.Hash() == last.hash) return;
    result_.end = RunEnd::kScheduleDiverged;
    result_.interrupted = false;
  }

  void FinishRecording() {
    controller_.machine().EndRecording();
    if (result_.interrupted || result_.end == RunEnd::kScheduleEnd) {
      recording_->cut_us = controller_.clock().UsOf(controller_.cycle());
    }
    if (options_.record) result_.schedule = vm::ScheduleOf(own_recording_);
  }

  void ReportThread(int number) {
    const vm::Machine& machine = controller_.machine();
    const vm::ThreadState& thread = machine.thread(number);
    const vm::Function& function = image().object.functions[thread.function];
    ThreadReport report;
    report.thread = number;
    report.function = function.name;
    report.page = thread.page;
    report.run = thread.run;
    report.error = thread.error;
    report.statements = thread.executed;
    report.result = ResultText(thread);
    report.place = SourcePlace(ProgramPath(scenario_), function, thread.pc);
    report.status = DescribeStatus(thread, image(), report.place);
    if (thread.run == vm::ThreadRun::kFaulted && !course_.agenda().ExpectsFault(number)) {
      Fail({}, {fmt::format("thread {} {}: {}", number, function.name, report.status.en),
                fmt::format("线程 {} {}：{}", number, function.name, report.status.zh)});
    }
    result_.threads.push_back(std::move(report));
  }

  const Scenario& scenario_;
  const RunOptions& options_;
  RefusedCommands refused_;
  Controller controller_;
  Supervisor supervisor_;
  ScenarioErrors errors_;
  std::shared_ptr<const vm::Schedule> replayed_;
  RunCourse course_;
  bool ended_ = false;  // no thread can execute a statement any more, whatever the host writes
  std::vector<TraceMark> at_power_on_;
  bool came_to_cut_ = false;  // the recorded run was cut off, and this one is there
  std::vector<std::string> shown_;
  std::vector<std::vector<Quantity>> shown_quantities_;
  std::vector<Quantity> traced_;  // from the scenario's `trace`
  ScenarioResult result_;
  vm::Recording own_recording_;
  vm::Recording* recording_ = nullptr;  // where the run is recorded
};

Error NothingToDraw() {
  return MakeError(1,
                   "the seed draws choices, and the scenario has none: remove the seed, or leave "
                   "something open, as in 'between_ms = [10, 40]'",
                   "种子用于抽取选择，而场景没有选择：应去掉种子，或留出选择，如 "
                   "“between_ms = [10, 40]”");
}

}  // namespace

Result<ScenarioResult> RunScenario(const Scenario& scenario, vm::Object object,
                                   const RunOptions& options) {
  const auto choices = Choices::Of(scenario);
  if (!choices.ok()) return choices.error();
  if (choices.value().empty()) {
    if (options.seed) return NothingToDraw();
    return ScenarioRunner(scenario, options).Run(std::move(object));
  }
  // Every case must fit the program, whichever is run.
  if (auto fits = CheckScenario(scenario, object); !fits.ok()) return fits.error();
  const int64_t number = options.seed ? choices.value().Draw(*options.seed) : 0;
  const auto chosen = std::make_shared<const Scenario>(choices.value().CaseOf(scenario, number));
  auto result = ScenarioRunner(*chosen, options).Run(std::move(object));
  if (!result.ok()) return result;
  result.value().choice = choices.value().DescribeCase(number);
  result.value().chosen = chosen;
  return result;
}

Result<void> CheckScenario(const Scenario& scenario, vm::Object object, RunWatch* watch) {
  if (const auto choices = Choices::Of(scenario); !choices.ok()) return choices.error();
  RunOptions options;
  options.watch = watch;
  return ScenarioRunner(scenario, options).Fit(std::move(object));
}

}  // namespace oncard::runtime
