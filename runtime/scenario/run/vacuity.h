// What a run, or all runs of an exploration, have not put to the test although the scenario speaks
// of it: the right side of a requirement whose left side never came true, and events of the
// surroundings that come after the end. It is said beside a verdict and is no failure. Plain
// values. Tested by tests/runtime/vacuity_test.cc.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "runtime/conditions/condition.h"
#include "runtime/scenario/file/requirement.h"
#include "runtime/scenario/world/world_setup.h"

namespace oncard::runtime {

/// The left side of a requirement whose right side matters only in some states: `a` of
/// `never: a && b` and `leads: a -> b`, and `!a` of `always: !a || b` or `final: !a || b`, which is
/// an implication.
struct Guard {
  Condition matters;     ///< holds where the right side matters
  std::string left;      ///< the left side as written
  bool negated = false;  ///< the right side matters where the left side does not hold
};

/// Empty for a requirement of another form.
std::optional<Guard> GuardOf(const Requirement& requirement);

/// That the right side has mattered nowhere.
Message DescribeVacuous(const Requirement& requirement, const Guard& guard);

/// The events of the surroundings that come later than `end_us`, one text for each kind of them.
/// `of_all`: no run of an exploration lasts longer.
std::vector<Message> DescribeLateEvents(const World& world, int64_t end_us, bool of_all);

/// The reactions of the surroundings that nothing has started, one text each; bit n of `started`
/// says that reaction n has been. `in_any`: in no run of an exploration.
std::vector<Message> DescribeIdleReactions(const World& world, uint64_t started, bool in_any);

}  // namespace oncard::runtime
