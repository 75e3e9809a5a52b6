// A problem to be explored: a program with its threads at their first statements, and its
// requirements.
//
// A source without a scenario states them in comments, one per line:
//
//   //@ init: g=1, h=5         values of globals before the start
//   //@ input: g = 0..3        a value of which one is chosen: any whole number between them
//   //@ final: EXPRESSION      must hold when all threads have ended
//   //@ always: EXPRESSION     must hold in every state
//   //@ never: EXPRESSION      must hold in no state
//   //@ eventually: EXPRESSION every run must have a state in which it holds
//   //@ leads: A -> B          each state with A must be followed by this or a later one with B
//   //@ within 5 ms: A -> B    the same, and in time
//   //@ races: none            no data race is allowed; benign: those that change no final value
//   //@ endless                the program is meant to run for ever
//   //@ livelock: any          threads may run for ever without an end
//   //@ deadlock: any          all threads may wait for ever
//   //@ sync: f, g             variables that order what threads do, and do not race themselves
//
// and its functions t0, t1, ... are bound to threads 0, 1, ... on pages 0, 1, ... Asserts are read
// by the compiler (compiler/asserts.h).
// Tested by tests/explore/problem_test.cc.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "explore/models/model.h"
#include "explore/models/property.h"
#include "explore/models/races.h"
#include "runtime/scenario/file/requirement.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/scenario_errors.h"
#include "runtime/scenario/run/vacuity.h"
#include "vm/object.h"

namespace oncard::explore {

using runtime::Requirement;
using runtime::Scope;

/// The content of a source's comments, as the equivalent scenario.
struct CommentProblem {
  /// A key that speaks of all schedules, with the comment that has it.
  struct PlacedKey {
    std::string key;  ///< `//@ races`
    runtime::TextPlace place;
  };
  runtime::Scenario scenario;  ///< program, threads, initial values
  std::vector<Requirement> requirements;
  std::vector<PlacedKey> of_all_schedules;
};

/// Reads the comments of a source, without binding threads. Fails on a comment that cannot be read:
/// the message shows each with its line.
Result<CommentProblem> ReadCommentLines(const std::string& path, std::string_view source);

/// The first line with such a comment, which an assert is not; 0 if there is none.
int FirstCommentLine(std::string_view source);

/// The first line with an assert; 0 if there is none.
int FirstAssertLine(std::string_view source);

/// Reads the comments of a source, whose functions are those of `object`. Fails as
/// ReadCommentLines(), and when there is no function t0.
Result<CommentProblem> ReadComments(const std::string& path, std::string_view source,
                                    const vm::Object& object);

struct BoundRequirement {
  Scope scope = Scope::kFinal;
  Property property = {};             ///< of a response, its left side
  std::optional<Property> then = {};  ///< of a response, its right side
  std::optional<runtime::Guard> guard = {};
  std::optional<Property> matters = {};  ///< of the guard
  /// Whether the guard has held in a state that was checked by any search of the problem, in any
  /// thread of the computer; only if there is a guard.
  std::shared_ptr<std::atomic<bool>> mattered = {};
  /// kAssert: its statement, and whether any search of the problem has executed it.
  std::string at = {};
  std::shared_ptr<std::atomic<bool>> reached = {};

  /// As written.
  Requirement AsRequirement() const;
};

/// Maximum number of `eventually` requirements of a problem; one under `leads` counts as two.
inline constexpr int kEventuallyMax = 24;

struct Problem {
  Model model;  ///< before the first statement
  std::vector<BoundRequirement> requirements = {};
  RaceRule races = RaceRule::kAny;
  SyncCells sync = {};
  bool may_last = false;  ///< a run that never ends is no failure

  /// True if a requirement applies to states before the end. Asserts do not: they belong to the
  /// statements of the model (StatementCheck).
  bool HasInvariants() const;
};

/// Resolves the names of the requirements. Adds unknown names, and a requirement that is one too
/// many, to `errors`; the problem is not usable then.
Problem BindProblem(Model model, const std::vector<Requirement>& requirements,
                    runtime::ScenarioErrors* errors);

/// Adds the asserts of the program's functions to a problem and its model. Conditions that cannot
/// be read, and names that do not exist, are added to `errors`. `program_path`: as for AssertsOf()
/// (runtime/scenario/run/assert_watch.h).
void AddAsserts(const std::string& program_path, Problem* problem, runtime::ScenarioErrors* errors);

/// The model in which the search of traces (dpor.h) checks what a problem requires of states before
/// the end: every statement that writes a global which `always` or `never` names checks it
/// afterwards. Such a statement reads all globals of that requirement, so the statements that write
/// one of them depend on each other. Executions of one trace then have the same sequence of their
/// values, and the requirement is violated in all of them or in none. The state before the first
/// statement is not checked.
Model ModelOfTraces(const Problem& problem);

/// True if that is all that the problem requires of states before the end: there is no `eventually`
/// or `leads`, and no `always`, `never` or assert that names something else or too many globals.
bool CanSearchTraces(const Problem& problem);

/// What the searches so far have not put to the test (runtime/scenario/run/vacuity.h).
std::vector<Message> UntestedOf(const Problem& problem);

/// The rule with a name: `any`, `benign`, `none`.
std::optional<RaceRule> RaceRuleNamed(std::string_view name);

/// A fault of a state.
struct Fault {
  enum class Kind : uint8_t {
    kNone,
    kRequirement,
    kThread,
    kDeadlock,   ///< threads wait for values that nothing can change any more
    kTimeLimit,  ///< threads are still running at the scenario's `limit_ms`
    kRace,       ///< two threads access a variable, or set an axis or output, without an order
    kHostCall    ///< a call of the recorded host is not answered as in the record
  };
  Kind kind = Kind::kNone;
  int requirement = 0;  ///< kRequirement: which one is violated
  /// kThread: the thread that ended with a fault; kRequirement, of an assert: the one that was
  /// about to execute the statement; by its number in the model.
  int thread = 0;
  Race race = {};    ///< kRace
  size_t call = 0;   ///< kHostCall: its number in the record
  int16_t code = 0;  ///< kHostCall: what it returns

  explicit operator bool() const { return kind != Kind::kNone; }
};

/// The first fault that is visible in a state alone: of a thread, of an invariant or, if all
/// threads have ended, of a final requirement. Faults that depend on the path are found by
/// ProgramWalk (walk.h).
Fault FindFault(const Problem& problem, const Model& state);

}  // namespace oncard::explore
