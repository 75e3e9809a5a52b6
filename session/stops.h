// Where a run stops: lines and statements, changes of variables, conditions that become true,
// faults, refused commands, requirements and expectations that do not hold, data races, warnings of
// the card's supervisor. They are checked after every step (rewindable_run.h) in both directions,
// and depend on nothing but the run. Not thread-safe. Tested by tests/session/stops_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/result.h"
#include "runtime/conditions/card_condition.h"
#include "runtime/scenario/run/assert_watch.h"
#include "session/rewindable_run.h"

namespace oncard::session {

/// Before the first statement of a line, or before one card statement of a function.
struct LineStop {
  std::string file;  ///< as in the program's functions; empty: any
  int line = 0;
  std::optional<std::string> function;  ///< then `position` counts, instead of `file` and `line`
  int position = 0;                     ///< of the statement in the function, from 0
  std::optional<int> thread;            ///< empty: every thread
  std::string condition;                ///< empty: always
  int64_t hits = 0;  ///< only from this arrival on, counted since the stop was set
  std::string log;   ///< not empty: this text is logged, `{name}` is a value; no stop
};

/// All places where a run is to stop, as the user names them.
struct StopWishes {
  std::vector<LineStop> lines;
  std::vector<std::string> changes;     ///< names of variables or other values (quantity.h)
  std::vector<std::string> conditions;  ///< stop when one becomes true
  bool faults = true;
  bool refusals = true;  ///< commands of threads and of a recorded host whose code is not 0
  /// `always`, `never`, `within`, asserts, and expectations with an instant.
  bool requirements = true;
  bool races = false;     ///< data races, each pair of statements once
  bool warnings = false;  ///< of the card's supervisor, each once
};

enum class StopReason : uint8_t {
  kGoal,         ///< what was asked for has been reached
  kLine,         ///< a LineStop
  kChange,       ///< a value has changed
  kCondition,    ///< a condition has become true
  kFault,        ///< a thread has faulted
  kRefusal,      ///< a thread was refused a command
  kRace,         ///< a data race
  kWarning,      ///< the card's supervisor warns
  kRequirement,  ///< a requirement or an expectation does not hold
  kDeviation,    ///< the card does not answer a recorded host as it did
  kScheduleEnd,  ///< the schedule that was followed is over
  kEnd,          ///< the scenario's run is over
  kStart,        ///< the first moment
  kBudget        ///< the number of steps of one request is used up
};

struct Stop {
  StopReason reason = StopReason::kGoal;
  int thread = -1;
  int number = -1;  ///< kLine, kChange, kCondition: which of the wishes, from 0
  Message text = {};
  std::vector<Message> failed = {};  ///< kEnd: requirements on the end that do not hold
};

/// A line of a LineStop's log.
struct LogLine {
  int64_t moment = 0;
  int thread = 0;
  std::string text;
};

class Stops {
 public:
  /// No stops but those of a StopWishes without lines, changes and conditions. Fails if a
  /// requirement of the scenario does not fit the program.
  static Result<Stops> Create(const RewindableRun& run);

  /// Replaces all stops. Fails with the first wish that cannot be fulfilled; then nothing changes.
  /// Where a host downloads programs, a wish rests as long as the card has one without its names.
  /// A line without a statement is moved to the next one that has one: lines() says where.
  Result<void> Set(const StopWishes& wishes, const RewindableRun& run);
  /// The line of each LineStop, also of those at a statement.
  std::vector<int> lines() const;

  /// True if every step must be checked: a stop can be anywhere, and not only where a thread
  /// faults, is refused a command, an expectation fails, or the supervisor warns.
  bool CheckEveryStep() const;
  bool faults() const { return faults_; }
  bool refusals() const { return refusals_; }
  bool requirements() const { return checks_requirements_; }
  bool warnings() const { return warnings_; }

  /// To be called before the first step of a walk: remembers the present values.
  void Begin(const RewindableRun& run);
  /// Checks the state after a step. Logged lines are appended to `log` unless it is nullptr.
  std::optional<Stop> Check(const RewindableRun& run, const StepReport& step,
                            std::vector<LogLine>* log);
  /// The expectations without an instant and the `final` requirements that do not hold at the
  /// present, and the `eventually` and `leads` requirements that have not been met up to it, and
  /// why.
  std::vector<Message> FailedAtEnd(const RewindableRun& run) const;
  /// The conditions of the `eventually` requirements, and the responses: for
  /// RewindableRun::Await().
  std::vector<runtime::CardCondition> Awaited() const;
  std::vector<RewindableRun::Response> Responses() const;
  /// After Check(): bit n is set if thread n has arrived at the beginning of a line with this step.
  uint32_t arrivals() const { return arrivals_; }

 private:
  struct Line {
    LineStop asked;
    LineStop wish;        ///< with the line that has a statement
    bool rests = false;   ///< the card has another program
    size_t function = 0;  ///< index of `wish.function`
    std::optional<runtime::CardCondition> condition;
    std::vector<std::variant<std::string, runtime::Quantity>> log;
    std::vector<int64_t> hits;  ///< moments, in order
  };
  struct Value {
    runtime::Quantity quantity;
    double last = 0;
    int number = 0;
  };
  struct Truth {
    runtime::CardCondition condition;
    bool wanted = true;  ///< the value at which to stop
    bool last = false;
    int number = -1;  ///< -1: a requirement of the scenario
    std::string title;
  };

  struct Answer {
    RewindableRun::Response response;
    bool late = false;  ///< a state was too late
  };

  Stops() = default;
  static Result<Line> ReadLine(const LineStop& wish, const runtime::Controller& card);
  /// Resolves all names for the program that the card has. The result says for each line, then each
  /// change, then each condition why it rests, if it does.
  std::vector<std::optional<Error>> Bind(const runtime::Controller& card);
  /// Remembers the present values.
  void Remember(const RewindableRun& run);
  void FindArrivals(const RewindableRun& run, const StepReport& step);
  void FindStarted(const vm::Machine& machine);
  std::optional<Stop> CheckLines(const RewindableRun& run, std::vector<LogLine>* log);
  std::optional<Stop> CheckValues(const RewindableRun& run, const StepReport& step);
  std::optional<Stop> CheckAsserts(const RewindableRun& run);
  std::optional<Stop> CheckTruths(const RewindableRun& run, const StepReport& step);
  std::optional<Stop> CheckIncidents(const RewindableRun& run, const StepReport& step);

  StopWishes wishes_;
  const vm::Image* bound_ = nullptr;  // the program that the names belong to
  std::vector<Line> lines_;
  std::vector<Value> values_;
  std::vector<Truth> conditions_;
  std::vector<Truth> requirements_;  // `always` and `never` of the scenario
  std::vector<Truth> final_;
  std::vector<Truth> eventually_;
  std::vector<Answer> answers_;  // to responses, `leads` and `within`
  runtime::AssertWatch asserts_;
  bool faults_ = true;
  bool refusals_ = true;
  bool checks_requirements_ = true;
  bool races_ = false;
  bool warnings_ = false;

  std::array<uint16_t, vm::kThreadCount> pcs_{};
  uint32_t fresh_ = 0;     // threads that run and have executed nothing
  uint32_t asleep_ = 0;    // threads that will arrive at a statement when they wake up
  uint32_t at_lines_ = 0;  // threads whose statement begins a line for them
  uint32_t reached_ = 0;   // threads that have arrived at a statement with this step
  uint32_t arrivals_ = 0;  // those of them that have arrived at a line
  int64_t fault_count_ = 0;
};

}  // namespace oncard::session
