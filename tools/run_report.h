// Prints the result of a run, for run and replay.
#pragma once

#include <string>

#include "runtime/scenario/run/scenario_run.h"
#include "tools/invocation.h"

namespace oncard::tools {

/// `thread 0 add: finished, result 5050`, then `sum = 5050`.
std::string FormatRunText(const runtime::ScenarioResult& result, const Invocation& invocation);

/// Prints the result in a format (`text` or `json`), and its failures always on standard error.
/// Returns the exit code.
int ReportRun(const runtime::ScenarioResult& result, const std::string& format,
              const Invocation& invocation);

/// `sum == 5051: sum is 5050`, or only the message for other failures.
std::string FormatFailure(const runtime::ScenarioFailure& failure, Language language);

}  // namespace oncard::tools
