// How the result of a run is shown: by run and by replay.
#pragma once

#include <string>

#include "runtime/scenario/scenario_run.h"
#include "tools/session.h"

namespace oncard::tools {

/// `thread 0 add: finished, result 5050`, then `sum = 5050`.
std::string FormatRunText(const runtime::ScenarioResult& result, const Session& session);

/// One JSON document with everything known of the run.
std::string FormatRunJson(const runtime::ScenarioResult& result, const Session& session);

/// Prints the result in a form (`text` or `json`), its failures on standard error in any case, and
/// gives the exit code.
int ReportRun(const runtime::ScenarioResult& result, const std::string& format,
              const Session& session);

/// Word for the end of a run in JSON: quiet, until, time-limit, deadlock, schedule-end, diverged,
/// interrupted.
std::string_view EndName(const runtime::ScenarioResult& result);

/// `sum == 5051: sum is 5050`, or the message alone for what no expectation says.
std::string FormatFailure(const runtime::ScenarioFailure& failure, Language language);

}  // namespace oncard::tools
