// The requirements of a scenario on the states of its runs: conditions
// (runtime/conditions/condition.h) under `final`, `always`, `never` and `eventually`. One run
// checks them in its own states (requirement_watch.h), the explorer in the states of all schedules.
// Tested by tests/runtime/requirement_watch_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/conditions/condition.h"
#include "runtime/scenario/file/placed_errors.h"
#include "runtime/scenario/file/scenario.h"

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

}  // namespace oncard::runtime
