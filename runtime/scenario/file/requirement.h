// The requirements of a scenario on the states of its runs: conditions
// (runtime/conditions/condition.h) under `final`, `always`, `never` and `eventually`, and
// responses, two conditions under `leads` and `within`. One run checks them in its own states
// (requirement_watch.h), the explorer in the states of all schedules.
// Tested by tests/runtime/requirement_watch_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "base/trim.h"
#include "runtime/conditions/condition.h"
#include "runtime/scenario/file/placed_errors.h"
#include "runtime/scenario/file/scenario.h"

namespace oncard::runtime {

/// The states that a requirement applies to.
enum class Scope : uint8_t {
  kFinal,
  kAlways,
  kNever,
  kEventually,  ///< some state of every run
  // Responses: a state with the left side, then this or a later one with the right side.
  kLeads,
  kWithin,  ///< whose clock is at most `within_us` greater
  kAssert   ///< those in which a thread executes the statement behind the comment
};

/// `p -> q`: the condition of a response, and the one that must follow.
inline constexpr std::string_view kArrow = "->";

/// `final`, `always`, `never`, `eventually`, `leads`, `within`, `assert`.
std::string_view ScopeName(Scope scope);
/// The scope that scenarios and comments for the explorer give that name.
std::optional<Scope> ScopeNamed(std::string_view name);

/// A requirement as written.
struct Requirement {
  Scope scope = Scope::kFinal;
  std::string text;  ///< of a response, its left side
  TextPlace place = {};
  // Of a response:
  std::string then = {};  ///< its right side
  TextPlace then_place = {};
  int64_t within_us = 0;  ///< kWithin
  TextPlace time_place = {};
  std::string at = {};       ///< kAssert: the statement, `pick.c:31`
  std::string written = {};  ///< kAssert of structured C: its text there; empty: `text`

  bool IsResponse() const { return scope == Scope::kLeads || scope == Scope::kWithin; }
  /// `x < 3`, `p -> q`.
  std::string Expression() const;
  /// `always: x < 3`, `within 5 ms: p -> q`.
  std::string Title() const;
};

/// A response from its text `p -> q`; `place_of` gives the place of a part of the text. What is not
/// of this form is kept, for CheckForm() to refuse.
template <typename PlaceOf>
Requirement ReadResponse(Scope scope, std::string_view text, PlaceOf place_of);

/// Fails for a response that does not have one `->` between two conditions.
Result<void> CheckForm(const Requirement& requirement);

/// The requirements of a scenario.
std::vector<Requirement> RequirementsOf(const Scenario& scenario);

/// What an endless program never comes to, each with its place and why: requirements on the end of
/// runs, and expectations without an instant. Empty unless the scenario is `endless`.
std::vector<std::pair<TextPlace, Message>> ClashesWithEndless(
    const Scenario& scenario, const std::vector<Requirement>& requirements);

/// Appends requirements to the keys of a scenario.
void AddRequirements(const std::vector<Requirement>& requirements, Scenario* scenario);

/// Removes all of them.
void ClearRequirements(Scenario* scenario);

template <typename PlaceOf>
Requirement ReadResponse(Scope scope, std::string_view text, PlaceOf place_of) {
  const size_t arrow = text.find(kArrow);
  const std::string_view left = Trim(text.substr(0, arrow));
  const std::string_view right =
      arrow == std::string_view::npos ? left.substr(left.size()) : Trim(text.substr(arrow + 2));
  return {scope, std::string(left), place_of(left), std::string(right), place_of(right)};
}

}  // namespace oncard::runtime
