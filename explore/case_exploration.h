// Explores every case of a scenario's choices (runtime/scenario/run/choices.h), and joins what was
// found: the only place that knows the order of the cases and what they mean together. Each case is
// a scenario like any other. Deterministic as the search of a case. Tested by
// tests/explore/case_exploration_test.cc.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "base/result.h"
#include "explore/reports/report.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/choices.h"

namespace oncard::explore {

/// Explores one case.
using CaseExplorer = std::function<Result<Findings>(const runtime::Scenario& scenario,
                                                    const ExploreOptions& options)>;

/// What to do about a case that is incomplete, beginning with what was chosen in it.
WayOut NameCase(const Message& chosen, WayOut way);

/// Fails if there are fewer random runs than cases.
Result<void> CheckRuns(const ExploreOptions& options, int64_t cases);

/// Explores the cases in order, up to the first failure unless ExploreOptions::all is set. All have
/// to be searched for a proof, and otherwise the weakest verdict counts. Limits of states,
/// executions and time are for all cases together; random runs are divided among them. Fails as
/// `explore`, and if there are fewer random runs than cases.
Result<Findings> ExploreCases(const runtime::Scenario& scenario, const runtime::Choices& choices,
                              const ExploreOptions& options, const CaseExplorer& explore);

}  // namespace oncard::explore
