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
