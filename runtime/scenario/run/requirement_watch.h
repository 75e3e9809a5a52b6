// Checks a scenario's requirements in one run: `always` and `never` in every state of the run,
// `eventually` and `final`, and responses; and the asserts of the program (assert_watch.h). The
// program of a run is there from the beginning (Begin()); that of a host comes when the host
// downloads it, and can change (Follow()): it has no asserts. Tested by
// tests/runtime/requirement_watch_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "runtime/conditions/card_condition.h"
#include "runtime/conditions/program_names.h"
#include "runtime/scenario/file/requirement.h"
#include "runtime/scenario/run/assert_watch.h"
#include "runtime/scenario/run/response.h"
#include "runtime/scenario/run/run_watch.h"
#include "runtime/scenario/run/scenario_run.h"
#include "runtime/scenario/run/vacuity.h"
#include "vm/image.h"

namespace oncard::runtime {

class RequirementWatch : public RunWatch {
 public:
  /// Source names in messages are relative to the program.
  RequirementWatch(std::vector<Requirement> requirements, std::string program_path);

  void Begin(const Controller& controller, ScenarioErrors* errors) override;
  bool ObservesStates() const override { return observes_states_ || !asserts_.empty(); }
  void ObserveState(const Controller& controller) override;
  void End(const Controller& controller) override;

  /// To be called instead of Begin(), and again whenever a host may have changed what the names
  /// stand for: the program, or what its threads are bound to. Observes the state if they have
  /// changed. A requirement is checked while all its names exist; one that names something of a
  /// program only after the program has begun to act, so that a host can set its variables first.
  void Follow(const Controller& controller);
  /// After Follow(): adds the requirements that have never been checked, and why not. To be called
  /// after End(); `prefix` comes before every message.
  void AddUnchecked(const Message& prefix, ScenarioErrors* errors) const;
  /// What has been checked and has held, and in which states, one text for each requirement.
  std::vector<Message> DescribeHeld() const;
  /// Of what has been checked: the requirements whose right side mattered in no state (vacuity.h),
  /// and the asserts whose statements were not executed.
  std::vector<Message> DescribeVacuous() const;

  /// The requirements and asserts that did not hold, in the order in which they failed, each once.
  const std::vector<ScenarioFailure>& failures() const { return failures_; }

 private:
  struct Watched {
    Requirement requirement;
    std::optional<CardCondition> condition;  ///< empty while its names do not exist
    std::optional<CardCondition> then = {};  ///< of a response: its right side, with the condition
    Owed owed = {};                          ///< to a response
    Message since = {};                      ///< where it is owed since
    std::optional<Guard> guard = {};
    std::optional<CardCondition> matters = {};  ///< of the guard, with the condition
    bool mattered = false;
    Message missing = {};  ///< why its names do not exist
    bool violated = false;
    std::optional<double> held_ms = {};  ///< kEventually: when it held; kFinal: the end
    int64_t states = 0;                  ///< in which it has been checked
    double since_ms = 0;                 ///< the first of them

    void LookForGuard(const Controller& controller) {
      mattered = mattered || (matters && matters->Holds(controller));
    }
    bool settled() const { return violated || held_ms.has_value(); }
  };

  /// What the names of conditions depend on.
  struct Names {
    ProgramNames program;
    bool acts = false;  ///< the program has begun to act
    bool operator==(const Names&) const = default;
  };
  Names NamesNow(const Controller& controller) const;
  void Bind(const Controller& controller, Watched* watched) const;

  void ObserveResponse(const Controller& controller, Watched* watched);
  /// Binds the guard of a requirement whose condition is bound.
  static void BindGuard(const Controller& controller, Watched* watched);
  void Fail(Watched* watched, Message message);
  void ObserveAsserts(const Controller& controller);
  /// A description of the current point of the run: after which statement, and when.
  Message Place(const Controller& controller) const;
  void RememberThreads(const Controller& controller);

  std::string program_path_;
  std::vector<Watched> watched_;
  AssertWatch asserts_;
  std::vector<bool> failed_asserts_;  ///< those that are in failures_
  bool observes_states_ = false;
  std::optional<Names> names_;  ///< those that Follow() has seen last
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
Result<void> CheckWithRequirements(const Scenario& scenario, vm::Object object);

}  // namespace oncard::runtime
