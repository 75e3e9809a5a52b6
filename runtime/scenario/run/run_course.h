// The course of a scenario's run: what happens at the boundary of two profile cycles, in which
// order, and when the run is over. A run and a session take their course from here; the search of
// interleavings and the watch of a host's card, which have checks of their own, the bounds.
//
// At a boundary the expectations with this instant are evaluated, then the host writes its
// variables. Then the run is over
// - with `until_ms` or with `limit_ms`, whichever is first; a run that may last for ever
//   (`endless`, `livelock`) is cut by `limit_ms` without a failure,
// - without `until_ms`, and when no expectation with an instant is left: if no thread runs any
// more,
//   or if all that run wait for values that nothing changes any more.
// A write that is left prolongs no run, but may resolve such a wait.
//
// A course is a value: a copy of it, with the state of the card, goes on by itself.
// Tested by tests/runtime/run_course_test.cc.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/agenda.h"
#include "runtime/scenario/run/scenario_errors.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

/// Why a run is over.
enum class RunOver : uint8_t {
  kQuiet,     ///< no thread runs any more
  kUntil,     ///< `until_ms`; without it `limit_ms`, if the run may last for ever
  kLimit,     ///< `limit_ms`
  kDeadlock,  ///< all running threads wait for values that nothing changes any more
  kHostEnd,   ///< the record of a host has no more calls
};

/// The cycles with whose end a run is over.
struct RunBounds {
  int64_t limit = INT64_MAX;     ///< `limit_ms`
  std::optional<int64_t> until;  ///< `until_ms`
  bool may_last = false;         ///< a run that lasts for ever is no failure

  static RunBounds Of(const Scenario& scenario, const CardClock& clock);

  /// The first of them.
  int64_t last() const { return std::min(limit, until.value_or(INT64_MAX)); }
  /// Whether the last cycle is the end that the scenario asks for, or a limit that cuts the run.
  RunOver kind_of_last() const {
    const bool asked = until ? *until <= limit : may_last;
    return asked ? RunOver::kUntil : RunOver::kLimit;
  }
  /// True where a run that may last for ever is cut: this is not the end that requirements on the
  /// end speak of.
  bool CutsAt(const Controller& controller) const {
    return may_last && !until && controller.cycle() >= limit && !controller.machine().Quiet();
  }
};

class RunCourse {
 public:
  /// Resolves all names for the controller, in which the scenario has been started. Whatever does
  /// not fit the program is added to `errors` and left out. The controller is unchanged.
  void Read(const Scenario& scenario, Controller* controller, ScenarioErrors* errors);

  const RunBounds& bounds() const { return bounds_; }
  const Agenda& agenda() const { return agenda_; }

  /// Evaluates and writes what is due at this boundary. `judge` gets each check, `wrote` each write
  /// that has been done.
  template <typename Judge, typename Wrote>
  void Act(Controller* controller, Judge judge, Wrote wrote) {
    const int64_t cycle = controller->cycle();
    while (const Agenda::Check* check = agenda_.TakeCheck(cycle)) judge(*check);
    while (const Agenda::Write* write = agenda_.TakeWrite(cycle)) {
      controller->machine().Write(write->variable.slot, write->value);
      wrote(*write);
    }
  }
  /// The same in the middle of a cycle, `executed` statements after its beginning: threads that
  /// waited for the value at the end of their function finish. True if something was written.
  template <typename Wrote>
  bool ActWithin(Controller* controller, int64_t executed, Wrote wrote) {
    bool acted = false;
    while (const Agenda::Write* write = agenda_.TakeWriteWithin(controller->cycle(), executed)) {
      controller->machine().Write(write->variable.slot, write->value);
      wrote(*write);
      controller->machine().Execute(0);
      acted = true;
    }
    return acted;
  }
  /// After the run: the next expectation whose instant has not been reached; nullptr: there is
  /// none.
  const Agenda::Check* TakeMissed() { return agenda_.TakeCheck(INT64_MAX); }

  /// Set if the run is over at this boundary, at which Act() has been called.
  std::optional<RunOver> Over(const Controller& controller) const;
  /// The first boundary at which Act() or Over() has something to say, unless no thread runs.
  int64_t NextCycle() const { return std::min(bounds_.last(), agenda_.NextCycle()); }

  /// How much it has done: with it a run that was put back goes on.
  using Position = Agenda::Position;
  Position position() const { return agenda_.position(); }
  void GoTo(Position position) { agenda_.GoTo(position); }

 private:
  RunBounds bounds_;
  Agenda agenda_;
};

}  // namespace oncard::runtime
