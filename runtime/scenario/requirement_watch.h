// Checks a scenario's requirements on all schedules in one run: `always` and `never` in every state
// of the run, `eventually` and `final`. Tested by tests/runtime/requirement_watch_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "runtime/scenario/requirement.h"
#include "runtime/scenario/run_watch.h"
#include "runtime/scenario/scenario_run.h"

namespace oncard::runtime {

class RequirementWatch : public RunWatch {
 public:
  /// Source names in messages are relative to the program.
  RequirementWatch(std::vector<Requirement> requirements, std::string program_path)
      : requirements_(std::move(requirements)), program_path_(std::move(program_path)) {}

  void Begin(const Controller& controller, ScenarioFit* fit) override;
  bool LooksAtStates() const override { return looks_at_states_; }
  void Look(const Controller& controller) override;
  void End(const Controller& controller) override;

  /// The requirements that did not hold, in the order in which they failed, each once.
  const std::vector<ScenarioFailure>& failures() const { return failures_; }

 private:
  struct Watched {
    Requirement requirement;
    CardCondition condition;
    bool settled = false;  ///< has been violated, or reached
  };

  void Fail(const Watched& watched, Message message);
  /// A description of the current point of the run: after which statement, and when.
  Message Place(const Controller& controller) const;
  void RememberThreads(const Controller& controller);

  std::vector<Requirement> requirements_;
  std::string program_path_;
  std::vector<Watched> watched_;
  bool looks_at_states_ = false;
  /// For every thread at the last check: the number of statements executed, and the next statement.
  std::array<int64_t, vm::kThreadCount> executed_{};
  std::array<uint16_t, vm::kThreadCount> next_{};
  std::vector<ScenarioFailure> failures_;
};

/// Runs the scenario and checks its requirements (RequirementsOf()) during the run: those that do
/// not hold are failures in the result. Fails like RunScenario(), and if a requirement is not a
/// valid expression.
Result<ScenarioResult> RunWithRequirements(const Scenario& scenario, vm::Object object,
                                           RunOptions options);

/// Fails if RunWithRequirements() would fail before the first statement.
Result<void> FitWithRequirements(const Scenario& scenario, vm::Object object);

}  // namespace oncard::runtime
