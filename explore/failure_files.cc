#include "explore/failure_files.h"

#include <memory>
#include <utility>

#include "runtime/scenario/run/adapted_schedule.h"
#include "runtime/scenario/run/scenario_run.h"
#include "vm/schedule.h"

namespace oncard::explore {
namespace {

/// The scenario that failed: of choices, the case.
const runtime::Scenario& FailingScenario(const Explored& explored, const Findings& findings) {
  return findings.cases ? *findings.cases->scenario : explored.scenario;
}

/// The same with all requirements, also those of the source's comments.
runtime::Scenario WithRequirements(const Explored& explored, const Findings& findings) {
  runtime::Scenario scenario = FailingScenario(explored, findings);
  runtime::ClearRequirements(&scenario);
  runtime::AddRequirements(explored.requirements, &scenario);
  return scenario;
}

}  // namespace

Result<std::string> FailureSchedule(const Explored& explored, const Findings& findings,
                                    const std::string& path) {
  const runtime::Scenario& failing = FailingScenario(explored, findings);
  const runtime::Scenario moved = runtime::MoveScenario(WithRequirements(explored, findings), path);
  runtime::RunOptions options;
  options.record = true;
  options.replay = std::make_shared<const vm::Schedule>(
      ScheduleOf(findings.subject, *findings.exploration.failure));
  auto run = runtime::RunScenario(failing, explored.object, options);
  if (!run.ok()) return run.error();
  vm::Schedule schedule = std::move(*run.value().schedule);
  schedule.scenario = runtime::FormatScenario(runtime::ScenarioOfOneRun(moved));
  auto annotated = runtime::AnnotateSchedule(failing, explored.object, explored.source, &schedule);
  if (!annotated.ok()) return annotated.error();
  return vm::FormatSchedule(schedule);
}

Result<std::string> RegressionScenario(const Explored& explored, const Findings& findings,
                                       const std::string& path, const std::string& schedule) {
  if (findings.exploration.failure->livelock) {
    return MakeError(1,
                     "a livelock has no end, so its run cannot become a regression test: keep a "
                     "scenario with explore = \"prove\"",
                     "活锁不是可以重复到底的一次运行：请保留带 explore = \"prove\" 的场景");
  }
  runtime::Scenario scenario = runtime::MoveScenario(WithRequirements(explored, findings), path);
  runtime::ExploreWish wish;
  wish.verdict = VerdictName(Verdict::kPassed);
  wish.follow = runtime::PathToScenario(scenario, schedule);
  scenario.explore = std::move(wish);
  return runtime::FormatScenario(scenario);
}

}  // namespace oncard::explore
