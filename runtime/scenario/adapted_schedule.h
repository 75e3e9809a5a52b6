// A recorded schedule for a program that has been edited since: threads take turns at the same
// source lines as before, as far as the edited program still comes to them.
//
// Lines are told by their text, not by their number: lines that were added or removed elsewhere do
// not matter. Tested by tests/runtime/adapted_schedule_test.cc.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "base/result.h"
#include "runtime/scenario/scenario.h"
#include "vm/object.h"
#include "vm/schedule.h"

namespace oncard::runtime {

/// Adds to the schedule of a run of the scenario where in the source each of its segments stops.
/// Fails when the schedule is not one of this program.
Result<void> AnnotateSchedule(const Scenario& scenario, vm::Object object, std::string_view source,
                              vm::Schedule* schedule);

struct AdaptedSchedule {
  vm::Schedule schedule;              ///< of the edited program, to its end
  size_t followed = 0;                ///< segments of the old one that could be followed
  std::optional<Message> divergence;  ///< what could not
};

/// Follows an annotated schedule with another program. Where it cannot be followed any further,
/// and at its end, the threads run one after the other. Fails when the schedule is not annotated,
/// the scenario has host events, or does not fit the program.
Result<AdaptedSchedule> AdaptSchedule(const Scenario& scenario, vm::Object object,
                                      std::string_view source, const vm::Schedule& old);

}  // namespace oncard::runtime
