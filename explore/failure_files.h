// What `oncard explore` writes of a failure to be run again: its schedule for `oncard replay`, and
// a scenario for `oncard test` that follows the schedule. Tested by
// tests/tools/explore_command_test.cc.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "explore/reports/report.h"
#include "runtime/scenario/file/requirement.h"
#include "runtime/scenario/file/scenario.h"
#include "vm/object.h"

namespace oncard::explore {

/// A program that was explored, and what was asked about it. Of a scenario with choices the files
/// have the values of the case that failed.
struct Explored {
  const runtime::Scenario& scenario;
  /// Those of the scenario, or of the source's comments.
  const std::vector<runtime::Requirement>& requirements;
  const vm::Object& object;
  std::string_view source;  ///< its text; empty if it was not compiled
};

/// The text of a schedule file at `path`: the statements of the failure with the checkpoints that a
/// run of them records, and the scenario, whose paths are as seen from there.
Result<std::string> FailureSchedule(const Explored& explored, const Findings& findings,
                                    const std::string& path);

/// The text of a scenario file at `path` that follows the schedule in the file `schedule` and
/// expects no failure. Fails for a livelock, which has no end.
Result<std::string> RegressionScenario(const Explored& explored, const Findings& findings,
                                       const std::string& path, const std::string& schedule);

}  // namespace oncard::explore
