#include "runtime/host_scenario.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "runtime/card_table.h"
#include "runtime/expectation.h"

namespace oncard::runtime {
namespace {

/// What the cards' watches have found, and how the host ended.
struct Verdict {
  std::mutex mutex;
  std::vector<Message> failures;
  int exit_status = 0;
};

Verdict& VerdictOfProcess() {
  static Verdict& verdict = *new Verdict;
  return verdict;
}

void KeepExitStatus(int status, void*) { VerdictOfProcess().exit_status = status; }

Result<std::shared_ptr<const Scenario>> ReadScenario() {
  const char* path = std::getenv("ONCARD_SCENARIO");
  if (path == nullptr || *path == '\0') return std::shared_ptr<const Scenario>();
  auto scenario = LoadWorld(path);
  if (!scenario.ok()) return scenario.error();
  ::on_exit(KeepExitStatus, nullptr);
  return std::make_shared<const Scenario>(std::move(scenario).value());
}

}  // namespace

Result<std::shared_ptr<const Scenario>> ScenarioFromEnvironment() {
  static const auto& scenario = *new Result<std::shared_ptr<const Scenario>>(ReadScenario());
  return scenario;
}

CardWatch::CardWatch(std::shared_ptr<const Scenario> scenario, int card)
    : scenario_(std::move(scenario)), card_(card) {
  for (const Expectation& expectation : scenario_->expectations) {
    if (expectation.at_us) timed_.push_back(&expectation);
  }
  std::stable_sort(timed_.begin(), timed_.end(), [](const Expectation* a, const Expectation* b) {
    return *a->at_us < *b->at_us;
  });
}

int64_t CardWatch::CycleOf(const Expectation& expectation) const {
  return (*expectation.at_us + scenario_->cycle_us - 1) / scenario_->cycle_us;
}

void CardWatch::AdvanceUs(Controller* controller, int64_t microseconds) {
  const int64_t end_us = controller->NowUs() + microseconds;
  for (; next_ < timed_.size(); ++next_) {
    const int64_t due_us = CycleOf(*timed_[next_]) * scenario_->cycle_us;
    if (due_us > end_us) break;
    if (due_us > controller->NowUs()) controller->AdvanceUs(due_us - controller->NowUs());
    Judge(*timed_[next_], *controller);
  }
  controller->AdvanceUs(end_us - controller->NowUs());
}

void CardWatch::Finish(Controller* controller) {
  for (; next_ < timed_.size(); ++next_) {
    Fail(*timed_[next_], MakeMessage("the host ended before, at {0} ms",
                                     "主机程序在此之前结束，时刻 {0} ms", controller->NowMs()));
  }
  for (const Expectation& expectation : scenario_->expectations) {
    if (!expectation.at_us) Judge(expectation, *controller);
  }
  Verdict& verdict = VerdictOfProcess();
  const std::lock_guard lock(verdict.mutex);
  verdict.failures.insert(verdict.failures.end(), failures_.begin(), failures_.end());
}

void CardWatch::Judge(const Expectation& expectation, const Controller& controller) {
  const auto bound = BindExpectation(expectation, controller);
  if (!bound.ok()) {
    Fail(expectation, bound.error().message);
    return;
  }
  const ExpectationResult outcome = Evaluate(bound.value(), controller);
  if (!outcome.holds) Fail(expectation, DescribeFailure(bound.value(), outcome));
}

void CardWatch::Fail(const Expectation& expectation, const Message& why) {
  Message failure = MakeMessage("card {0}: '{1}' does not hold: ", "卡 {0}：“{1}”不成立：", card_,
                                expectation.text);
  failure.en += why.en;
  failure.zh += why.zh;
  failures_.push_back(std::move(failure));
}

void FinishHost() {
  for (CardSlot& slot : CardTable::OfProcess().slots) {
    // A thread that is inside a command now will not come back from it.
    const std::unique_lock lock(slot.mutex, std::try_to_lock);
    if (lock.owns_lock()) slot.SwitchOff();
  }
  Verdict& verdict = VerdictOfProcess();
  const std::lock_guard lock(verdict.mutex);
  if (verdict.failures.empty()) return;
  for (const Message& failure : verdict.failures) {
    std::fprintf(stderr, "oncard: %s\n", failure.In(LanguageFromEnvironment()).c_str());
  }
  std::fflush(nullptr);
  if (verdict.exit_status == 0) ::_exit(1);
}

}  // namespace oncard::runtime
