#include "runtime/scenario/run/run_course.h"

namespace oncard::runtime {

RunBounds RunBounds::Of(const Scenario& scenario, const CardClock& clock) {
  RunBounds bounds = {clock.CycleAt(scenario.limit_ms * 1000), std::nullopt,
                      MayLastForEver(scenario)};
  if (scenario.until_us) bounds.until = clock.CycleAt(*scenario.until_us);
  return bounds;
}

void RunCourse::Read(const Scenario& scenario, Controller* controller, ScenarioErrors* errors) {
  bounds_ = RunBounds::Of(scenario, controller->clock());
  agenda_.Read(scenario, controller, errors);
}

std::optional<RunOver> RunCourse::Over(const Controller& controller) const {
  if (controller.cycle() >= bounds_.last()) return bounds_.kind_of_last();
  if (agenda_.has_checks() || bounds_.until) return std::nullopt;
  if (controller.machine().Quiet()) return RunOver::kQuiet;
  if (!agenda_.has_writes() && controller.Deadlocked()) return RunOver::kDeadlock;
  return std::nullopt;
}

}  // namespace oncard::runtime
