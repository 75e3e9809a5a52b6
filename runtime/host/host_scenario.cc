#include "runtime/host/host_scenario.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <utility>

#include "base/files.h"
#include "base/split.h"
#include "runtime/host/call_log.h"
#include "runtime/host/card_table.h"
#include "runtime/host/host_card.h"
#include "runtime/host/host_refusals.h"
#include "runtime/host/host_report.h"
#include "runtime/host/host_system.h"
#include "runtime/host/library.h"
#include "runtime/host/system_waits.h"
#include "runtime/host/virtual_time.h"
#include "runtime/observe/trace_file.h"
#include "runtime/scenario/file/expectation.h"
#include "runtime/scenario/run/choices.h"
#include "runtime/scenario/run/reaction_conditions.h"
#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/vacuity.h"

namespace oncard::runtime {
namespace {

/// What the watches of the cards have found, and how the host ended.
struct Verdict {
  std::mutex mutex;
  double end_ms = 0;  ///< the latest end of a card's time
  std::vector<Message> failures;
  std::vector<Message> warnings;
  std::vector<Message> held;
  bool card_opened = false;  ///< a card of the scenario
  bool in_child = false;
};

Verdict& VerdictOfProcess() {
  static Verdict& verdict = *new Verdict;
  return verdict;
}

/// What was chosen, if the scenario leaves something open; the scenario is its first case.
Message& ChoiceOfProcess() {
  static Message& choice = *new Message;
  return choice;
}

/// A scenario at `path` has a card of another family than the library.
Error WrongFamily(std::string_view path, const gtcalls::Family& family) {
  std::vector<std::string_view> names;
  for (const gtcalls::CardType& type : LibraryFamily().card_types) names.push_back(type.name);
  return MakeError(1,
                   "{0}: the scenario has a card of the family {1}, and the host uses lib{2}: "
                   "'card' must be one of {3}",
                   "{0}：场景中的控制卡属于系列 {1}，而主机程序使用 lib{2}：“card”应为 {3} 之一",
                   path, family.name, LibraryFamily().name, fmt::to_string(fmt::join(names, ", ")));
}

Result<std::shared_ptr<const Scenario>> ReadScenario() {
  const char* path = std::getenv("ONCARD_SCENARIO");
  if (path == nullptr || *path == '\0') return std::shared_ptr<const Scenario>();
  const auto card = CardFromEnvironment(&LibraryFamily());
  if (!card.ok()) return card.error();
  auto scenario = LoadScenario(path, ScenarioUse::kHost, card.value());
  if (!scenario.ok()) return scenario.error();
  const gtcalls::Family& family = FamilyOf(scenario.value());
  if (&family != &LibraryFamily()) return WrongFamily(path, family);
  const auto choices = Choices::Of(scenario.value());
  if (!choices.ok()) return choices.error();
  if (choices.value().empty()) return std::make_shared<const Scenario>(std::move(scenario).value());
  ChoiceOfProcess() = DescribeChosen(choices.value().DescribeCase(0));
  return std::make_shared<const Scenario>(choices.value().CaseOf(scenario.value(), 0));
}

}  // namespace

Result<std::shared_ptr<const Scenario>> ScenarioFromEnvironment() {
  static const auto& scenario = *new Result<std::shared_ptr<const Scenario>>(ReadScenario());
  return scenario;
}

std::vector<std::string> TraceFilesFromEnvironment() {
  const char* names = std::getenv("ONCARD_TRACE");
  std::vector<std::string> files;
  for (const std::string_view name : Split(names == nullptr ? "" : names, kNameSeparator)) {
    if (!name.empty()) files.emplace_back(name);
  }
  return files;
}

CardWatch::CardWatch(std::shared_ptr<const Scenario> scenario, int card,
                     std::vector<std::string> trace_files)
    : scenario_(std::move(scenario)), card_(card), trace_files_(std::move(trace_files)) {
  {
    const std::lock_guard lock(VerdictOfProcess().mutex);
    VerdictOfProcess().card_opened = true;
  }
  for (const Expectation& expectation : scenario_->expectations) {
    if (expectation.at_us) timed_.push_back(&expectation);
  }
  std::stable_sort(timed_.begin(), timed_.end(), [](const Expectation* a, const Expectation* b) {
    return *a->at_us < *b->at_us;
  });
  if (auto requirements = RequirementsOf(*scenario_); !requirements.empty()) {
    requirements_.emplace(std::move(requirements), std::string());
  }
}

std::optional<int64_t> CardWatch::EndUs(const CardClock& clock) const {
  if (!scenario_->until_us && scenario_->limit_ms >= kTimeMsMax) return std::nullopt;
  return clock.UsAfter(RunBounds::Of(*scenario_, clock).last());
}

void CardWatch::Listen(Controller* controller) {
  if (requirements_ && requirements_->ObservesStates()) {
    controller->ObserveStates([this, controller] { requirements_->ObserveState(*controller); });
  }
  if (trace_files_.empty()) return;
  controller->ListenToEvents([this](int64_t time_us, const Message& what) {
    TraceMark mark = {time_us, what, true};
    if (trace_) {
      trace_->Mark(std::move(mark));
    } else {
      at_power_on_.push_back(std::move(mark));
    }
  });
}

void CardWatch::AdvanceUs(Controller* controller, int64_t microseconds) {
  if (requirements_) requirements_->Follow(*controller);
  int64_t end_us = controller->NowUs() + microseconds;
  if (const auto last_us = EndUs(controller->clock()); last_us && end_us >= *last_us) {
    end_us = *last_us;
    over_ = true;
  }
  const CardClock& clock = controller->clock();
  for (; next_ < timed_.size(); ++next_) {
    const int64_t due_us = clock.UsAfter(clock.CycleAt(*timed_[next_]->at_us));
    if (due_us > end_us) break;
    if (due_us > controller->NowUs()) AdvanceTracedUs(controller, due_us - controller->NowUs());
    Judge(*timed_[next_], *controller);
  }
  AdvanceTracedUs(controller, end_us - controller->NowUs());
}

void CardWatch::AdvanceTracedUs(Controller* controller, int64_t microseconds) {
  if (trace_files_.empty()) {
    controller->AdvanceUs(microseconds);
    return;
  }
  if (!trace_) BeginTrace(*controller);
  const int64_t end_us = controller->NowUs() + microseconds;
  while (controller->NowUs() < end_us) {
    const int64_t cycle = controller->cycle();
    const int64_t rest_us = end_us - controller->NowUs();
    controller->AdvanceUs(std::min(rest_us, controller->UsToNextTick()));
    if (controller->cycle() != cycle) trace_->Sample(*controller);
  }
}

void CardWatch::BeginTrace(const Controller& controller) {
  std::vector<TraceColumn> columns;
  for (Quantity& quantity : TraceQuantities(*scenario_, controller, &errors_)) {
    columns.push_back({std::move(quantity)});
  }
  if (scenario_->trace.empty()) columns = DefaultColumns(controller);
  trace_.emplace(std::move(columns));
  for (TraceMark& mark : at_power_on_) trace_->Mark(std::move(mark));
  trace_->Sample(controller);
}

void CardWatch::WriteTrace(const Controller& controller) {
  if (!trace_ || HostIsJudgedByParent()) return;
  trace_->Finish(controller);
  for (const std::string& file : trace_files_) {
    auto text = TraceText(*trace_, file, TitleOf(*scenario_));
    const auto written =
        text.ok() ? WriteFileAtomically(file, std::move(text).value()) : text.error();
    if (!written.ok()) failures_.push_back(written.error().message);
  }
}

void CardWatch::Finish(Controller* controller) {
  for (; next_ < timed_.size(); ++next_) {
    Fail(*timed_[next_], MakeMessage("the host ended before, at {0} ms",
                                     "主机程序在此之前结束，时刻 {0} ms", controller->NowMs()));
  }
  for (const Expectation& expectation : scenario_->expectations) {
    if (!expectation.at_us) Judge(expectation, *controller);
  }
  const RunBounds bounds = RunBounds::Of(*scenario_, controller->clock());
  const bool in_order = !over_ || bounds.kind_of_last() == RunOver::kUntil;
  if (requirements_) FinishRequirements(*controller, in_order);
  if (const Reactions* reactions = controller->reactions()) {
    FinishReactions(*controller, *reactions);
  }
  if (!in_order) {
    failures_.push_back(MakeMessage("card {0}: the host still runs at the time limit of {1} ms",
                                    "卡 {0}：到时间上限 {1} ms 时主机程序仍在运行", card_,
                                    scenario_->limit_ms));
  }
  WriteTrace(*controller);
  // Names that a trace could not have are wrong without a trace too.
  if (!trace_) TraceQuantities(*scenario_, *controller, &errors_);
  if (auto unfit = errors_.Failure()) {
    failures_.insert(failures_.begin(), std::move(unfit->message));
  }
  Verdict& verdict = VerdictOfProcess();
  const std::lock_guard lock(verdict.mutex);
  verdict.end_ms = std::max(verdict.end_ms, controller->NowMs());
  verdict.failures.insert(verdict.failures.end(), failures_.begin(), failures_.end());
  verdict.warnings.insert(verdict.warnings.end(), warnings_.begin(), warnings_.end());
  verdict.held.insert(verdict.held.end(), held_.begin(), held_.end());
}

void CardWatch::FinishRequirements(const Controller& controller, bool in_order) {
  requirements_->Follow(controller);
  if (in_order) requirements_->End(controller);
  requirements_->AddUnchecked(OfCard({}), &errors_);
  for (const ScenarioFailure& failure : requirements_->failures()) {
    failures_.push_back(OfCard({fmt::format("'{}' {}", failure.expectation, failure.message.en),
                                fmt::format("“{}”{}", failure.expectation, failure.message.zh)}));
  }
  for (const Message& held : requirements_->DescribeHeld()) held_.push_back(OfCard(held));
  for (const Message& vacuous : requirements_->DescribeVacuous()) {
    warnings_.push_back(OfCard(vacuous));
  }
}

void CardWatch::FinishReactions(const Controller& controller, const Reactions& reactions) {
  const uint64_t existed = reactions.existed();
  CheckReactions(*scenario_, controller, existed, OfCard({"never looked at: ", "从未检查："}),
                 &errors_);
  for (const Message& idle :
       DescribeIdleReactions(scenario_->world, reactions.started() | ~existed, false)) {
    warnings_.push_back(OfCard(idle));
  }
}

Message OfCard(int card, const Message& message) {
  return {fmt::format("card {}: {}", card, message.en), fmt::format("卡 {}：{}", card, message.zh)};
}

void CardWatch::Judge(const Expectation& expectation, const Controller& controller) {
  const auto bound = CardCondition::Bind(expectation.condition, controller);
  if (!bound.ok()) {
    errors_.AddText(expectation.place, expectation.text(), OfCard(bound.error().message));
    return;
  }
  if (!bound.value().Holds(controller)) {
    Fail(expectation, DescribeFailure(bound.value(), controller));
  }
}

void CardWatch::Fail(const Expectation& expectation, const Message& why) {
  failures_.push_back(OfCard({fmt::format("'{}' does not hold: {}", expectation.text(), why.en),
                              fmt::format("“{}”不成立：{}", expectation.text(), why.zh)}));
}

void LeaveJudgingToParent() {
  VerdictOfProcess().in_child = true;
  if (CallRecorder* recorder = CallRecorder::Wanted()) recorder->LeaveToParent();
}

bool HostIsJudgedByParent() { return VerdictOfProcess().in_child; }

void FailHost(Message failure) {
  Verdict& verdict = VerdictOfProcess();
  const std::lock_guard lock(verdict.mutex);
  verdict.failures.push_back(std::move(failure));
}

namespace {

void Print(const Message& message) {
  std::fprintf(stderr, "oncard: %s\n", message.In(LanguageFromEnvironment()).c_str());
}

/// Why nothing of the scenario was checked, if it has something to check.
std::optional<Message> NeverChecked(const Verdict& verdict) {
  if (verdict.card_opened) return std::nullopt;
  const auto scenario = ScenarioFromEnvironment();
  if (!scenario.ok()) return scenario.error().message;
  if (scenario.value() == nullptr) return std::nullopt;
  const Scenario& asked = *scenario.value();
  if (asked.expectations.empty() && RequirementsOf(asked).empty()) return std::nullopt;
  return Message{"the host has opened no card: nothing of the scenario was checked",
                 "主机程序没有打开任何卡：场景中的条件均未检查"};
}

/// Reports what was found. True if there are failures.
bool ReportHost() {
  Verdict& verdict = VerdictOfProcess();
  const std::lock_guard lock(verdict.mutex);
  if (auto never = NeverChecked(verdict)) verdict.failures.push_back(*std::move(never));
  if (const Message& choice = ChoiceOfProcess(); !choice.en.empty()) {
    verdict.warnings.push_back(choice);
  }
  const RefusalReport wanted = RefusalReportOfProcess();
  std::vector<Message> refusals;
  if (wanted != RefusalReport::kNothing) refusals = HostRefusals::OfProcess().Describe();
  auto& list = wanted == RefusalReport::kStrict ? verdict.failures : verdict.warnings;
  list.insert(list.end(), refusals.begin(), refusals.end());
  if (CallLog::OfProcess().lost()) {
    verdict.failures.push_back(
        {"the call log could not be written completely; its disk may be full",
         "调用日志未能完整写入；磁盘可能已满"});
  }
  CallRecorder* const recorder = CallRecorder::Wanted();
  if (recorder != nullptr) recorder->Finish();
  if (recorder != nullptr && recorder->lost()) {
    verdict.failures.push_back(
        {"the record of calls could not be written completely; its disk may be full",
         "调用记录未能完整写入；磁盘可能已满"});
  }
  const HostReport report = {verdict.end_ms, verdict.failures, verdict.warnings, verdict.held};
  if (AppendHostReport(report)) return !verdict.failures.empty();
  for (const Message& warning : verdict.warnings) {
    Print({"warning: " + warning.en, "警告：" + warning.zh});
  }
  for (const Message& failure : verdict.failures) Print(failure);
  for (const Message& held : verdict.held) Print(held);
  return !verdict.failures.empty();
}

/// Waits for a lock that is normally held for at most the duration of a command; gives up after a
/// second.
bool LockSoon(std::unique_lock<std::mutex>* lock) {
  for (int look = 0; look < 1000; ++look) {
    if (lock->try_lock()) return true;
    RealSleep(1'000'000);
  }
  return false;
}

}  // namespace

void FinishHost() {
  if (VerdictOfProcess().in_child) return;
  for (CardSlot& slot : CardTable::OfProcess().slots) {
    // A thread that is executing a command now will never complete it.
    const std::unique_lock lock(slot.mutex, std::try_to_lock);
    if (lock.owns_lock()) slot.SwitchOff();
  }
  if (!ReportHost()) return;
  std::fflush(nullptr);
  ReplaceSuccess(kExitNotAsExpected);
}

void ConcludeHost() {
  for (CardSlot& slot : CardTable::OfProcess().slots) {
    std::unique_lock lock(slot.mutex, std::defer_lock);
    if (!LockSoon(&lock)) continue;
    slot.SwitchOff();
    lock.release();
  }
  ReportHost();
  std::fflush(nullptr);
}

void EndHostIfOver(CardSlot* locked) {
  if (!locked->watch || !locked->watch->over() || VerdictOfProcess().in_child) return;
  for (CardSlot& slot : CardTable::OfProcess().slots) {
    std::unique_lock lock(slot.mutex, std::defer_lock);
    if (&slot != locked && !lock.try_lock()) continue;
    slot.SwitchOff();
    lock.release();
  }
  EndProcess(ReportHost() ? kExitNotAsExpected : 0);
}

void LookForEndOfHost() {
  const int64_t now_ns = VirtualTime::OfProcess().NowNs();
  for (CardSlot& slot : CardTable::OfProcess().slots) {
    if (now_ns < slot.earliest_end_ns) continue;
    const std::unique_lock lock(slot.mutex, std::try_to_lock);
    if (!lock.owns_lock() || !slot.watch) continue;
    slot.CatchUp(0);
    EndHostIfOver(&slot);
    slot.FindEarliestEnd();
  }
}

}  // namespace oncard::runtime
