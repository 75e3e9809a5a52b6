// The requirements of a scenario on the states of its runs: conditions
// (runtime/conditions/condition.h) under `final`, `always`, `never` and `eventually`. One run
// checks them in its own states (requirement_watch.h), the explorer in the states of all schedules.
// Tested by tests/runtime/requirement_watch_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/conditions/condition.h"
#include "runtime/scenario/placed_errors.h"
#include "runtime/scenario/scenario.h"
#include "runtime/scenario/scenario_errors.h"

namespace oncard::runtime {

/// The states that a requirement applies to.
enum class Scope : uint8_t {
  kFinal,
  kAlways,
  kNever,
  kEventually  ///< some state of every run
};

/// `final`, `always`, `never`, `eventually`.
std::string_view ScopeName(Scope scope);
/// The scope with that name.
std::optional<Scope> ScopeNamed(std::string_view name);

/// A requirement as written.
struct Requirement {
  Scope scope = Scope::kFinal;
  std::string text;
  TextPlace place = {};

  /// `always: x < 3`.
  std::string Title() const;
};

/// `final`, `always`, `never` and `eventually` of a scenario.
std::vector<Requirement> RequirementsOf(const Scenario& scenario);

/// Appends requirements to the keys of a scenario.
void AddRequirements(const std::vector<Requirement>& requirements, Scenario* scenario);

/// Parses requirements and binds each as a `Bound` to the names of a card or of a model. Invalid
/// ones are added to `errors` and not included in the result.
template <typename Bound, typename Names>
std::vector<Bound> ReadRequirements(const std::vector<Requirement>& requirements,
                                    const Names& names, ScenarioErrors* errors) {
  std::vector<Bound> all;
  for (const Requirement& requirement : requirements) {
    if (!errors->CanJudge(requirement.text)) continue;
    auto condition = ParseCondition(requirement.text);
    auto one = condition.ok() ? Bound::Bind(std::move(condition).value(), names)
                              : Result<Bound>(condition.error());
    if (one.ok()) {
      all.push_back(std::move(one).value());
    } else {
      errors->AddText(requirement.place, requirement.Title(), one.error().message);
    }
  }
  return all;
}

}  // namespace oncard::runtime
