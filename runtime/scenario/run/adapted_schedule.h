// Adapts a recorded schedule to an edited program: threads switch at the same source lines as
// before, as far as the edited program still reaches them.
//
// Lines are identified by their text, not by their number, so that lines added or removed elsewhere
// do not matter. Tested by tests/runtime/adapted_schedule_test.cc.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "base/result.h"
#include "runtime/scenario/file/scenario.h"
#include "vm/object.h"
#include "vm/schedule.h"

namespace oncard::runtime {

/// Annotates the schedule of a run of the scenario with the source line at which each segment
/// stops. Fails if the schedule belongs to another program.
Result<void> AnnotateSchedule(const Scenario& scenario, vm::Object object, std::string_view source,
                              vm::Schedule* schedule);

struct AdaptedSchedule {
  vm::Schedule schedule;  ///< for the edited program, to its end
  size_t followed = 0;    ///< number of segments of the old schedule that could be followed
  std::optional<Message> divergence;  ///< the reason if some could not
};

/// Follows an annotated schedule with another program. After the last segment that can be followed,
/// the threads run one after the other. Fails if the schedule is not annotated, the scenario has
/// host events, or does not fit the program.
Result<AdaptedSchedule> AdaptSchedule(const Scenario& scenario, vm::Object object,
                                      std::string_view source, const vm::Schedule& old);

}  // namespace oncard::runtime
