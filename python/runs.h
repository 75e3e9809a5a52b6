// One run of a program or a scenario, for Python. Without Python itself. Safe to call from several
// threads. Tested by tests/python/test_run.py.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "python/sources.h"
#include "runtime/scenario/run/scenario_run.h"

namespace oncard::python {

struct RunWish {
  std::vector<std::string> show;  ///< values at the end; empty: all global variables
  bool trace = false;
  /// Columns of the trace instead of those of the scenario; empty: those of the scenario.
  std::vector<std::string> columns;
  bool strict_commands = false;
  std::vector<std::string> silent;  ///< names of warnings about the card
};

struct RunOutcome {
  compiler::Compilation compilation;
  std::optional<runtime::ScenarioResult> result;  ///< if it was compiled
  std::string title;                              ///< of a picture
};

/// Runs it in virtual time, as `oncard run` does, or replays a recording. `stop` ends the run
/// early. Fails with everything that does not fit the program.
Result<RunOutcome> Run(const Source& source, const RunWish& wish, const std::atomic<bool>* stop);

}  // namespace oncard::python
