// What of a scenario its program does not have: functions, variables and other names, each with its
// place. The functions below resolve such names.
// Tested by tests/runtime/scenario_errors_test.cc.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "runtime/observe/quantity.h"
#include "runtime/scenario/file/placed_errors.h"
#include "runtime/scenario/file/requirement.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

class ScenarioErrors {
 public:
  /// Adds an error at a place.
  void Add(const TextPlace& place, Message why) { clashes_.Add(place, std::move(why)); }
  /// The same for a text, which is quoted if it has no place.
  void AddText(const TextPlace& place, std::string_view text, const Message& why);
  /// A thread could not be bound, and this has been added: names that refer to threads and pages
  /// cannot be checked from now on.
  void MissThread() { all_bound_ = false; }
  /// False for a text with such a name if a thread is missing: it must not be checked.
  bool CanJudge(std::string_view text) const;
  /// All errors; empty if everything fits.
  std::optional<Error> Failure() const { return clashes_.Failure(); }

 private:
  PlacedErrors clashes_;
  bool all_bound_ = true;
};

/// The quantities in a scenario's `trace`; adds an error for each unknown one.
std::vector<Quantity> TraceQuantities(const Scenario& scenario, const Controller& controller,
                                      ScenarioErrors* errors);

/// The globals that a scenario's `sync` names: element n is true for slot n, missing ones are
/// false. Adds unknown ones to `errors`.
std::vector<bool> SyncGlobals(const Scenario& scenario, const vm::Object& object,
                              ScenarioErrors* errors);

/// The globals that order what threads do: those of `sync`, and those for which statements wait.
std::vector<bool> OrderingGlobals(const Scenario& scenario, const Controller& controller,
                                  ScenarioErrors* errors);

/// The conditions of a requirement, bound to names.
template <typename Bound>
struct BoundSides {
  Bound condition;                 ///< of a response, its left side
  std::optional<Bound> then = {};  ///< of a response, its right side
};

/// Parses requirements and binds their conditions to the names of a card or of a model, each as a
/// `Bound`. Invalid ones are added to `errors` and not included in the result.
template <typename Bound, typename Names>
std::vector<BoundSides<Bound>> ReadRequirements(const std::vector<Requirement>& requirements,
                                                const Names& names, ScenarioErrors* errors) {
  std::vector<BoundSides<Bound>> all;
  for (const Requirement& requirement : requirements) {
    if (!errors->CanJudge(requirement.Expression())) continue;
    if (const auto form = CheckForm(requirement); !form.ok()) {
      errors->AddText(requirement.place, requirement.Title(), form.error().message);
      continue;
    }
    const auto bind = [&](const std::string& text, const TextPlace& place) -> std::optional<Bound> {
      auto condition = ParseCondition(text);
      auto bound = condition.ok() ? Bound::Bind(std::move(condition).value(), names)
                                  : Result<Bound>(condition.error());
      if (bound.ok()) return std::move(bound).value();
      errors->AddText(place, requirement.Title(), bound.error().message);
      return std::nullopt;
    };
    auto condition = bind(requirement.text, requirement.place);
    std::optional<Bound> then;
    if (requirement.IsResponse()) then = bind(requirement.then, requirement.then_place);
    if (!condition || (requirement.IsResponse() && !then)) continue;
    all.push_back({*std::move(condition), std::move(then)});
  }
  return all;
}

}  // namespace oncard::runtime
