// One exploration of a program or a scenario, for Python. Without Python itself. Safe to call from
// several threads. Tested by tests/python/test_explore.py.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "explore/engines/progress.h"
#include "explore/reports/report.h"
#include "python/sources.h"
#include "runtime/scenario/file/requirement.h"

namespace oncard::python {

/// What is asked beyond the scenario; what is missing is as the scenario has it.
struct SearchWish {
  std::vector<runtime::Requirement> requirements;  ///< in addition to those of the scenario
  std::string engine;                              ///< empty: as in the scenario
  std::string races;                               ///< the same
  std::optional<int64_t> max_executions;
  std::optional<int64_t> max_states;
  std::optional<int64_t> runs;
  std::optional<int64_t> seed;
  std::optional<int64_t> depth;
  std::optional<int64_t> preemptions;
  std::optional<bool> merge_private;
  std::optional<bool> dead_locals;
  std::optional<bool> symmetry;
  std::optional<bool> islands;
  std::optional<bool> reductions;
  bool all = false;
  std::vector<std::string> silent;  ///< names of warnings about the card
};

struct SearchOutcome {
  compiler::Compilation compilation;
  std::optional<explore::Findings> findings;  ///< if it was compiled
  bool cut = false;  ///< a limit ended the search, which says nothing of what was asked
  std::vector<Message> warnings;
  std::string schedule;  ///< the text of a schedule file beside the input; empty: nothing failed
};

/// Searches the schedules, as `oncard explore` does. `progress` can end it early. Fails with
/// everything that does not fit the program, and with settings that the engine cannot use.
Result<SearchOutcome> Explore(const Source& source, const SearchWish& wish,
                              explore::SearchProgress* progress);

}  // namespace oncard::python
