// The scenario that ONCARD_SCENARIO names for a host program: every card that is opened gets its
// inputs, drives and mechanics, and its expectations and requirements are checked while the host
// runs. The scenario contains no program: the host downloads one, or none. Tested by
// tests/tools/exec_command_test.cc and exec_requirements_test.cc.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "runtime/observe/trace.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/requirement_watch.h"
#include "runtime/scenario/run/run_course.h"
#include "runtime/scenario/run/scenario_errors.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

struct CardSlot;

/// The scenario, read at the first call; NULL if the environment names none.
Result<std::shared_ptr<const Scenario>> ScenarioFromEnvironment();

/// The file names in ONCARD_TRACE, between kNameSeparator (host_system.h), to which a trace of the
/// first opened card is written (trace_file.h).
std::vector<std::string> TraceFilesFromEnvironment();

/// With the number of the card before it.
Message OfCard(int card, const Message& message);

/// The expectations and requirements of a scenario on one card, from its opening on, and the trace
/// of the card.
class CardWatch {
 public:
  CardWatch(std::shared_ptr<const Scenario> scenario, int card,
            std::vector<std::string> trace_files = {});

  /// To be called before the card is switched on: adds what the card does by itself to the trace,
  /// and looks at every state if requirements speak of them. The watch must exist as long as the
  /// card runs.
  void Listen(Controller* controller);
  /// To be called before every host call: advances the card's time, at most to the end of the
  /// scenario, and checks the expectations that become due, and the requirements in every state.
  void AdvanceUs(Controller* controller, int64_t microseconds);
  /// True if the card has reached `until_ms` or `limit_ms` of the scenario.
  bool over() const { return over_; }
  /// The instant of the card's time at which the scenario ends, if it does.
  std::optional<int64_t> EndUs(const CardClock& clock) const;
  /// To be called when the card is closed or the host has ended: checks the remaining expectations,
  /// `final` and `eventually`, and passes the results to FinishHost().
  void Finish(Controller* controller);

 private:
  void AdvanceTracedUs(Controller* controller, int64_t microseconds);
  void BeginTrace(const Controller& controller);
  void WriteTrace(const Controller& controller);
  void Judge(const Expectation& expectation, const Controller& controller);
  void Fail(const Expectation& expectation, const Message& why);
  void FinishRequirements(const Controller& controller, bool in_order);
  void FinishReactions(const Controller& controller, const Reactions& reactions);
  Message OfCard(const Message& message) const { return runtime::OfCard(card_, message); }

  std::shared_ptr<const Scenario> scenario_;
  int card_;
  std::vector<const Expectation*> timed_;  // in order of time; not yet checked from next_ on
  size_t next_ = 0;
  std::optional<RequirementWatch> requirements_;  ///< when the scenario has some
  ScenarioErrors errors_;
  std::vector<Message> failures_;
  std::vector<Message> warnings_;
  std::vector<Message> held_;  ///< requirements, and over what
  bool over_ = false;
  std::vector<std::string> trace_files_;
  std::optional<Trace> trace_;  // since the card was opened, when there are files
  std::vector<TraceMark> at_power_on_;
};

/// Exit codes that hosts do not use themselves: the host ended with 0, but an expectation failed or
/// an output file could not be written; the host keeps asking for keys that will never come.
inline constexpr int kExitNotAsExpected = 120;
inline constexpr int kExitNoMoreKeys = 121;

/// Called when the host ends: checks the cards that are still open, and reports failed expectations
/// and requirements, the requirements that held, refused commands, and what the supervisors of the
/// cards have found, on standard error. If there are failures and the host ended with 0, ends the
/// process with kExitNotAsExpected.
void FinishHost();
/// Called in a child of fork(): only the parent reports results and writes files.
void LeaveJudgingToParent();
bool HostIsJudgedByParent();
/// Something that makes the host fail, to be reported when it ends.
void FailHost(Message failure);
/// The same from another thread while the host still runs: leaves the cards closed and locked, so
/// that no thread of the host can use them any more.
void ConcludeHost();
/// Ends the process when a card has reached the end of its scenario, after everything has been
/// checked and reported: with 0, or with kExitNotAsExpected if there are failures. `locked` is the
/// card whose lock the caller holds.
void EndHostIfOver(CardSlot* locked);
/// Lets the cards whose scenario may be over catch up, and ends the process if it is. For hosts
/// that only wait.
void LookForEndOfHost();

}  // namespace oncard::runtime
