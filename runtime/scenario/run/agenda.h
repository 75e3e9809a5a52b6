// What a scenario has to do while its program runs: at the boundaries of profile cycles it
// evaluates the expectations with an instant, then the host writes its variables; and the host can
// write in the middle of a cycle. A run takes the items that are due, in the order of time. Tested
// by tests/runtime/agenda_test.cc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/conditions/card_condition.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/scenario_errors.h"

namespace oncard::runtime {

class Agenda {
 public:
  static constexpr int64_t kAtEnd = INT64_MAX;

  /// An expectation with its names resolved.
  struct Check {
    std::string text;
    CardCondition condition;
    int64_t cycle = 0;  ///< with an instant: evaluated at the end of this cycle
  };
  /// The host writes one variable.
  struct Write {
    int64_t cycle = 0;
    /// In the middle of the cycle, after so many of its statements; kAtEnd: at its end.
    int64_t after_statements = kAtEnd;
    Quantity variable;
    double value = 0;
  };
  /// How much has been taken. A value: with it a run that was put back goes on.
  struct Position {
    size_t check = 0;
    size_t write = 0;
  };

  /// Resolves all names for the controller, in which the scenario has been started. Whatever does
  /// not fit the program is added to `errors` and left out. The controller is unchanged.
  void Read(const Scenario& scenario, Controller* controller, ScenarioErrors* errors);

  /// The expectations without an instant, in the order of the file.
  const std::vector<Check>& at_end() const { return at_end_; }
  /// True if an expectation names the error of the thread, so that a fault is no failure.
  bool ExpectsFault(int thread) const;

  /// The next item that is due at the end of the cycle; nullptr: there is none. Writes in the
  /// middle of it that have not been taken there are due, too.
  const Check* TakeCheck(int64_t cycle);
  const Write* TakeWrite(int64_t cycle);
  /// The next write that is due in the middle of the cycle, `executed` statements after its
  /// beginning; nullptr: there is none.
  const Write* TakeWriteWithin(int64_t cycle, int64_t executed);
  /// After how many statements of the cycle the next write in the middle of it is due; kAtEnd:
  /// there is none.
  int64_t NextWithin(int64_t cycle) const;
  /// True if items are left.
  bool has_checks() const { return taken_.check < timed_.size(); }
  bool has_writes() const { return taken_.write < writes_.size(); }
  /// The next write; only if has_writes().
  const Write& next_write() const { return writes_[taken_.write]; }
  /// The first cycle at which an item is due; INT64_MAX: no item is left.
  int64_t NextCycle() const;

  Position position() const { return taken_; }
  void GoTo(Position position) { taken_ = position; }

 private:
  void ReadExpectations(const Scenario& scenario, const Controller& controller,
                        ScenarioErrors* errors);
  void ReadWrites(const Scenario& scenario, Controller* controller, ScenarioErrors* errors);

  std::vector<Check> timed_;  // in order of time
  std::vector<Check> at_end_;
  std::vector<Write> writes_;  // in order of time
  std::vector<int> fault_expected_;
  Position taken_;
};

}  // namespace oncard::runtime
