// Explores a scenario: chooses whether the program is explored alone or together with its card.
// Tested by tests/explore/failure_test.cc and problem_test.cc.
#pragma once

#include <string_view>
#include <vector>

#include "base/result.h"
#include "explore/reports/report.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/choices.h"
#include "vm/object.h"
#include "vm/schedule.h"

namespace oncard::explore {

/// The options given by the scenario's key `explore`; the rest is unchanged.
ExploreOptions OptionsOf(const runtime::ExploreWish& wish);

/// True if a test of the scenario can fail for another reason than that its threads do not end
/// well.
bool ChecksSomething(const runtime::Scenario& scenario);

/// A scenario whose program needs no card, with its expectations and the requirements. Fails if the
/// scenario does not fit the program, or a requirement is invalid.
Result<Problem> ProblemOfScenario(const runtime::Scenario& scenario,
                                  const std::vector<Requirement>& requirements, vm::Object object);

/// Fills in the subject from the scenario: names, hash, conditions.
void Describe(const runtime::Scenario& scenario, Subject* subject);

/// The data of a report of the exploration; the caller fills in Findings::source.
Findings FindingsOf(const runtime::Scenario& scenario, const Problem& problem,
                    Exploration exploration);

/// The same with a card; `model` is used up.
Findings FindingsOf(const runtime::Scenario& scenario, CardModel* model, Exploration exploration);

/// Adds what the card does in the failing run, by running its schedule. A run that fails before its
/// end has only the values up to there.
void AddTrace(const runtime::Scenario& scenario, const vm::Object& object, Findings* findings);

/// The card of a scenario, for Subject::card.
CardConditions CardConditionsOf(const runtime::Scenario& scenario);

/// What an exploration with a card cannot do: engines, merged statements; CardModel refuses races.
void CheckCardSearch(const runtime::Scenario& scenario, const ExploreOptions& options,
                     runtime::ScenarioErrors* errors);

/// Checks only one schedule: follows it as far as the current program can
/// (runtime/scenario/run/adapted_schedule.h). The verdict is kPassed, kFailed, or kIncomplete if
/// the run does not end. Fails as ExploreScenario(), for a scenario with choices, and when the
/// schedule cannot be adapted.
Result<Findings> FollowSchedule(const runtime::Scenario& scenario,
                                const std::vector<Requirement>& requirements,
                                const vm::Object& object, std::string_view source,
                                const vm::Schedule& schedule);

/// The choices of a scenario that can be explored. Fails as ExploreScenario(), except for what does
/// not fit the program where nothing is open.
Result<runtime::Choices> ChoicesToExplore(const runtime::Scenario& scenario,
                                          const std::vector<Requirement>& requirements,
                                          const vm::Object& object);

/// Explores one case of these, in which nothing is open. Fails as ExploreScenario().
Result<Findings> ExploreCase(const runtime::Scenario& chosen,
                             const std::vector<Requirement>& requirements, const vm::Object& object,
                             const ExploreOptions& options);

/// Explores the scenario, in every case of its choices, with its expectations and the requirements;
/// the caller fills in Findings::source. Fails if the scenario does not fit the program or has host
/// events, if a requirement is invalid, or as Choices::Of().
Result<Findings> ExploreScenario(const runtime::Scenario& scenario,
                                 const std::vector<Requirement>& requirements,
                                 const vm::Object& object, const ExploreOptions& options);

/// Explores a scenario according to its key `explore`. `progress` can stop it.
Result<Findings> ExploreAsWished(const runtime::Scenario& scenario, const vm::Object& object,
                                 std::string_view source, SearchProgress* progress = nullptr);

}  // namespace oncard::explore
