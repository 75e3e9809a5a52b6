// The scenario that ONCARD_SCENARIO names for a host program: every card that is opened gets its
// world, and its expectations are judged while the host runs. There is no program in it: the host
// downloads one, or none. Tested by tests/tools/exec_command_test.cc.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "runtime/observe/trace.h"
#include "runtime/scenario/scenario.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

struct CardSlot;

/// The scenario, read at the first question; NULL when the environment names none.
Result<std::shared_ptr<const Scenario>> ScenarioFromEnvironment();

/// The names of the files that ONCARD_TRACE names, between colons: what a trace of the first card
/// that is opened is written to (trace_file.h).
std::vector<std::string> TraceFilesFromEnvironment();

/// The expectations of a scenario on one card, from its opening on, and the trace of the card.
class CardWatch {
 public:
  CardWatch(std::shared_ptr<const Scenario> scenario, int card,
            std::vector<std::string> trace_files = {});

  /// To be called before the card is switched on: what it does by itself goes to the trace. The
  /// watch outlives the card's running.
  void Listen(Controller* controller);
  /// Lets time pass on the card, at most until the scenario's end, and judges what is due on the
  /// way.
  void AdvanceUs(Controller* controller, int64_t microseconds);
  /// The card has come to `until_ms` or `limit_ms` of the scenario.
  bool over() const { return over_; }
  /// True when the scenario has such an end.
  bool HasEnd() const { return end_us_.has_value(); }
  /// The card is closed, or the host has ended: judges the rest and hands over to FinishHost().
  void Finish(Controller* controller);

 private:
  void AdvanceTracedUs(Controller* controller, int64_t microseconds);
  void BeginTrace(const Controller& controller);
  void WriteTrace(const Controller& controller);
  void Judge(const Expectation& expectation, const Controller& controller);
  void Fail(const Expectation& expectation, const Message& why);
  int64_t CycleOf(int64_t microseconds) const;
  void WarnOfMovingAxes(const Controller& controller);

  std::shared_ptr<const Scenario> scenario_;
  int card_;
  std::vector<const Expectation*> timed_;  // in order of time, from next_ on to be judged
  size_t next_ = 0;
  std::vector<Message> failures_;
  std::vector<Message> warnings_;
  std::optional<int64_t> end_us_;  ///< of the card's time
  bool over_ = false;
  std::vector<std::string> trace_files_;
  std::optional<Trace> trace_;  // since the card was opened, when there are files
  std::vector<TraceMark> at_power_on_;
};

/// Exit codes that hosts do not use themselves: the host ended with 0, but what was expected of it
/// does not hold, or what was asked for could not be written; it asks for keys that cannot come.
inline constexpr int kExitNotAsExpected = 120;
inline constexpr int kExitNoMoreKeys = 121;

/// Called when the host ends: judges the cards that are still open and reports failed expectations
/// and refused commands on standard error. If there are failures, and the host itself has ended
/// well, ends the process with kExitNotAsExpected.
void FinishHost();
/// Called in a child of fork(): what comes of the host is the parent's to say, and to write.
void LeaveJudgingToParent();
/// The same from another thread while the host still runs: it leaves the cards closed and locked,
/// so that no thread of the host goes on with them.
void ConcludeHost();
/// Ends the process when a card has come to the end of its scenario, after all was judged and
/// reported: with 0, or with kExitNotAsExpected when there are failures. `locked` is the card whose
/// lock the caller holds.
void EndHostIfOver(CardSlot* locked);
/// Lets the cards whose scenario has an end catch up, and ends the process if one has come to it.
/// For hosts that only wait.
void LookForEndOfHost();

}  // namespace oncard::runtime
