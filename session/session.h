// Drives a run (rewindable_run.h) forward and back, to the goals and stops of a user who looks at
// it. Every walk has a budget of steps, so that its owner stays responsive: it ends there with
// StopReason::kBudget, and the same request goes on from there.
//
// Deterministic: the same requests give the same answers. Not thread-safe.
// Tested by tests/session/session_test.cc and tests/session/random_walks_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "runtime/observe/quantity.h"
#include "session/rewindable_run.h"
#include "session/stops.h"

namespace oncard::session {

/// How far a walk goes.
enum class Goal : uint8_t {
  kStep,       ///< one step
  kStatement,  ///< one statement of a thread; the others take their turns
  kLine,       ///< until a thread is at the beginning of another line, or has ended
  kCycle,      ///< forward: to the end of the cycle; back: to its beginning
  kTime,       ///< for a time, rounded up to the end of a cycle; forward only
  kStop,       ///< until something stops it; forward also: until the scenario's run is over
  kRest,       ///< until no thread runs and no axis moves; forward only
  kChange,     ///< back to where a value last changed
  kCall,       ///< one call of a recorded host
  kEnd         ///< until a run that is watched has ended (Session::Forward); forward only
};

struct Walk {
  Goal goal = Goal::kStop;
  int thread = 0;       ///< kStatement, kLine
  int64_t time_us = 0;  ///< kTime; kEnd: at most so long
  std::string name;     ///< kChange: a value (quantity.h)
  int64_t budget = 1'000'000;
};

class Session {
 public:
  /// Stops as StopWishes has them, and at data races if the scenario does not allow all of them.
  /// Fails with everything that does not fit the program.
  static Result<Session> Create(runtime::Scenario scenario, vm::Object object,
                                std::shared_ptr<const vm::Schedule> schedule = nullptr);

  /// The card of a recorded host.
  static Result<Session> CreateFromCalls(runtime::Scenario scenario,
                                         std::unique_ptr<const runtime::HostCalls> calls);

  /// What was chosen, if the scenario leaves something open: its first case is run. Empty: nothing.
  const Message& choice() const { return choice_; }
  RewindableRun& run() { return *run_; }
  const RewindableRun& run() const { return *run_; }
  const Stops& stops() const { return stops_; }
  /// True if the scenario does not allow all data races.
  bool ForbidsRaces() const;
  /// While it is true, walks end with StopReason::kBudget, and whatever executes a part of the run
  /// again ends early (RewindableRun::EndEarly).
  void EndEarly(const std::atomic<bool>* wanted) { run_->EndEarly(wanted); }

  /// Replaces all stops (Stops::Set). Fails with the first wish that cannot be fulfilled; then
  /// nothing changes.
  Result<void> SetStops(const StopWishes& wishes);

  /// Walks forward. Lines that LineStop::log asks for are appended to `log`. Fails if there is no
  /// such thread.
  Result<Stop> Forward(const Walk& walk, std::vector<LogLine>* log);
  /// One statement of a thread that the user chooses (RewindableRun::StepThread); the result says
  /// what else it did.
  Result<Stop> StepThread(int thread);
  /// Walks back. A stop lies strictly before the present; without one the walk ends at the first
  /// moment. Fails if there is no such thread or name.
  Result<Stop> Back(const Walk& walk);

  /// What Trace() returns for one value: the smallest and the largest value in each of the parts
  /// of the time.
  struct Channel {
    std::string name;
    std::vector<double> least;
    std::vector<double> largest;
  };
  /// Values over a time that has passed, up to the present, in at most `points` parts of equal
  /// length; a part without a cycle continues the value before. Any value can be asked for after
  /// the fact: the run is executed again. Fails for an unknown name, or an array.
  Result<std::vector<Channel>> Trace(const std::vector<std::string>& names, int64_t from_us,
                                     int64_t to_us, int points);

 private:
  Session(std::unique_ptr<RewindableRun> run, Stops stops)
      : run_(std::move(run)), stops_(std::move(stops)) {}

  /// Whether the goal of a walk forward is reached, and how.
  std::optional<Stop> Reached(const Walk& walk, const StepReport& step, int64_t goal_cycle) const;
  /// Takes steps of one cycle without checking each of them. False: something happened in them that
  /// is a stop; the present is where it was.
  bool AdvanceUnchecked(int64_t last);
  bool Rests() const;
  bool HasEnded() const;

  struct Found {
    int64_t moment = 0;
    Stop stop;
  };
  /// Looks at the steps of a stretch of the run that is executed again.
  struct Look {
    std::function<void()> begin;
    /// After a step from the moment `before`: the moment that it finds, if any.
    std::function<std::optional<Found>(int64_t before, const StepReport& step)> step;
  };
  /// Goes back to the last moment that `look` finds.
  Stop SearchBack(const Look& look, int64_t budget);
  Look LookFor(const Walk& walk);
  Look LookForChange(std::vector<runtime::Quantity> quantities) const;

  std::unique_ptr<RewindableRun> run_;
  Stops stops_;
  Message choice_;
};

}  // namespace oncard::session
