// Responses in one run: each state with the left side of a requirement under `leads` or `within`
// must be followed by this or a later one with its right side. Only the first state that waits for
// one is remembered: what answers it answers those after it, too, and it is the first to be late.
// Plain values. Tested by tests/runtime/response_test.cc.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/message.h"
#include "runtime/scenario/file/requirement.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/scenario_errors.h"
#include "vm/object.h"

namespace oncard::runtime {

/// What a run owes to a response.
struct Owed {
  bool pending = false;
  bool late = false;        ///< a state was too late: the response is violated
  int64_t since_ns = 0;     ///< if pending or late: the clock of the first state that waits
  int64_t since_count = 0;  ///< the statements before it
  /// `within`: the last clock that is in time.
  int64_t due_ns = std::numeric_limits<int64_t>::max();

  /// Goes on to the next state of the run, in which the sides hold or not. A state is late even if
  /// the right side holds in it.
  void Observe(const Requirement& response, bool left, bool right, int64_t now_ns, int64_t count);
};

/// Why a response does not hold: its left side held `since` (`at 10 ms`), its right side not until
/// a state was too late or, for `leads`, until the end. `values` are those of the right side.
Message DescribeUnanswered(const Requirement& response, const Message& since, const Message& late,
                           const Message& values);

/// Adds an error for each `within` that the run cannot check: no time passes in it (`has_time`), or
/// it ends after `end_us`, before anything could be late.
void CheckTimes(const std::vector<Requirement>& requirements, bool has_time, int64_t end_us,
                ScenarioErrors* errors);
/// The same for a run of the scenario.
void CheckTimes(const std::vector<Requirement>& requirements, const Scenario& scenario,
                const vm::Object& object, ScenarioErrors* errors);

}  // namespace oncard::runtime
