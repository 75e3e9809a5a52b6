// Runs a scenario on a controller of its own, in virtual time.
//
// Order: download, bind every thread, set globals and locals, start the threads in the order of the
// scenario. At the boundary of two profile cycles, expectations of that instant are evaluated
// first, then the external events of that instant act, then the host writes its variables. The run
// ends at the scenario's `until_ms`; without one, when no thread is running and every expectation
// with an instant has been evaluated. A run that reaches `limit_ms` before that has failed.
//
// Deterministic: the same scenario and program give the same result, hash included.
// Tested by tests/runtime/scenario_run_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "runtime/observe/card_warnings.h"
#include "runtime/observe/step_log.h"
#include "runtime/observe/trace.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/run_watch.h"
#include "runtime/sim/controller.h"
#include "vm/object.h"
#include "vm/recording.h"
#include "vm/schedule.h"

namespace oncard::runtime {

struct RunOptions {
  /// Replays this schedule instead of using the scenario's policy. It must belong to the same
  /// program.
  std::shared_ptr<const vm::Schedule> replay;
  /// Record the executed schedule in ScenarioResult::schedule.
  bool record = false;
  /// Records the executed schedule here instead, where a long run needs less memory.
  vm::Recording* recording = nullptr;
  /// Names of the values to return at the end (quantity.h); empty: all global variables.
  std::vector<std::string> show;
  /// Record values over time in ScenarioResult::trace: the names in the scenario's `trace` or, if
  /// that is empty, those in `show`, the outputs, and everything that moves (DefaultColumns).
  bool trace = false;
  /// Record the effect of every statement in ScenarioResult::steps.
  bool steps = false;
  /// A refused command of a thread is a failure, not only a warning; so is what the supervisor
  /// warns of.
  bool strict_commands = false;
  /// Warnings of the supervisor (supervisor.h) that are not reported.
  CardWarnings silent = {};
  /// If set from outside, for instance by a signal handler, the run ends early, and the result
  /// contains what was recorded until then.
  const std::atomic<bool>* stop = nullptr;
  /// Of a scenario with choices (choices.h): the case that this seed draws; empty: the first one.
  std::optional<uint64_t> seed = {};
  /// Receives refused commands of threads, and what the card does by itself.
  CardLog* log = nullptr;
  /// Observes the run.
  RunWatch* watch = nullptr;
};

/// How a thread ended.
struct ThreadReport {
  int thread = 0;
  std::string function;
  int page = 0;
  vm::ThreadRun run = vm::ThreadRun::kStopped;
  std::string result;  ///< as FormatNumber()
  int error = 0;       ///< of the last command, or the fault
  std::string place;   ///< `file:line` of the current or last statement
  int64_t statements = 0;
  Message status;  ///< as text, with the values involved in a fault
};

/// A value at the end.
struct ShownValue {
  std::string name;
  std::vector<std::string> elements;  ///< one for a scalar
  bool array = false;
  std::string unit = {};  ///< of an axis that has one: `mm`
};

/// Why a scenario failed: an expectation, a fault, a deadlock, a limit.
struct ScenarioFailure {
  std::string expectation;  ///< as written; empty for other failures
  Message message;
};

struct ScenarioResult {
  /// Of a scenario with choices: what was chosen, and the scenario that was run for that.
  Message choice;
  std::shared_ptr<const Scenario> chosen;
  RunEnd end = RunEnd::kQuiet;
  bool reached_until = false;  ///< ended as RunOver::kUntil (run_course.h)
  /// Ended by RunOptions::stop, or replayed to the point where the recorded run was cut off; the
  /// requirements on the end were not checked.
  bool interrupted = false;
  double end_ms = 0;
  int64_t statements = 0;
  uint64_t hash = 0;  ///< Controller::Hash()
  uint64_t program_hash = 0;
  std::vector<ThreadReport> threads;  ///< bound ones, by number
  std::vector<ShownValue> values;
  std::vector<ScenarioFailure> failures;
  /// Warnings: refused commands of threads, findings of the supervisor, writes of the host and
  /// events of the world after an end that was intended; from RunWithRequirements() also
  /// requirements that no state put to the test (vacuity.h).
  std::vector<Message> warnings;
  std::optional<vm::Schedule> schedule;
  std::optional<Trace> trace;
  std::optional<StepLog> steps;

  bool passed() const { return failures.empty(); }
};

/// Runs the scenario, or one case of its choices. Fails with everything that does not fit the
/// program (an unknown name, a value out of range, a schedule of another program), in the order of
/// the file; as Choices::Of(); if there is a seed and no choice; or if Verify() rejects the object.
/// Failures during the run are in the result.
Result<ScenarioResult> RunScenario(const Scenario& scenario, vm::Object object,
                                   const RunOptions& options = {});

/// Fails if RunScenario() would fail before the first statement in some case of the choices.
Result<void> CheckScenario(const Scenario& scenario, vm::Object object, RunWatch* watch = nullptr);

}  // namespace oncard::runtime
