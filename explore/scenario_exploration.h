// Explores a scenario: chooses whether the program is explored alone or together with its card.
// Tested by tests/explore/scenario_exploration_test.cc.
#pragma once

#include <string_view>
#include <vector>

#include "base/result.h"
#include "explore/reports/report.h"
#include "runtime/scenario/scenario.h"
#include "vm/object.h"
#include "vm/schedule.h"

namespace oncard::explore {

/// `final`, `always`, `never` and `eventually` of a scenario.
std::vector<Requirement> RequirementsOf(const runtime::Scenario& scenario);

/// Puts requirements into the keys of a scenario, behind those that it has.
void AddRequirements(const std::vector<Requirement>& requirements, runtime::Scenario* scenario);

/// What the scenario wishes, where it wishes something.
ExploreOptions OptionsOf(const runtime::ExploreWish& wish);

/// True when time or the card matters: the program calls GT commands, a thread is periodic, the
/// scenario ends at an instant, or an expectation has one.
bool NeedsCard(const runtime::Scenario& scenario, const vm::Object& object);

/// A scenario whose program needs no card, with its expectations and the requirements. Fails when
/// the scenario does not fit the program, or a requirement makes no sense.
Result<Problem> ProblemOfScenario(const runtime::Scenario& scenario,
                                  const std::vector<Requirement>& requirements, vm::Object object);

/// Fills in what the scenario says of the subject: names, hash, conditions.
void Describe(const runtime::Scenario& scenario, Subject* subject);

/// What a report of the exploration is made of; Findings::source is left to the caller.
Findings FindingsOf(const runtime::Scenario& scenario, const Problem& problem,
                    Exploration exploration);

/// Looks at one schedule only: follows it as far as the program of today does
/// (runtime/scenario/adapted_schedule.h). The verdict is kPassed, kFailed, or kIncomplete when the
/// run does not come to its end. Fails as ExploreScenario(), and when the schedule cannot be
/// adapted.
Result<Findings> FollowSchedule(const runtime::Scenario& scenario,
                                const std::vector<Requirement>& requirements,
                                const vm::Object& object, std::string_view source,
                                const vm::Schedule& schedule);

/// Explores the scenario with its expectations and the requirements; Findings::source is left to
/// the caller. Fails when the scenario does not fit the program, has host events, or a requirement
/// makes no sense.
Result<Findings> ExploreScenario(const runtime::Scenario& scenario,
                                 const std::vector<Requirement>& requirements, vm::Object object,
                                 const ExploreOptions& options);

/// Explores a scenario as its key `explore` says.
Result<Findings> ExploreAsWished(const runtime::Scenario& scenario, const vm::Object& object,
                                 std::string_view source);

}  // namespace oncard::explore
