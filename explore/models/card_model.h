// A card that runs a motion program, as a transition system: threads that execute one statement at
// a time, with the motion core and the clock.
//
// Time is part of the state. A profile cycle has the number of statements given by the scenario's
// rate; when they are used up, or no thread can run, the next cycle begins by itself, with its
// motion, inputs and delays. The search varies the order in which the threads execute the
// statements of a cycle, with one restriction, without which a thread could be delayed for ever:
// every thread that can run executes at least one statement per cycle.
//
// If the scenario has `races = "none"`, the past that decides races is part of the state, too
// (CardRaces).
//
// States are values; Step() goes from one to the next. Deterministic; not thread-safe. Tested by
// tests/explore/card_model_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"
#include "explore/models/horizon.h"
#include "explore/models/host_events.h"
#include "explore/models/model.h"
#include "explore/models/problem.h"
#include "explore/models/races.h"
#include "explore/models/state_key.h"
#include "explore/models/statement_coverage.h"
#include "runtime/observe/statement_access.h"
#include "runtime/observe/supervisor.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/run/assert_watch.h"
#include "runtime/scenario/run/response.h"
#include "runtime/scenario/run/run_course.h"
#include "runtime/scenario/run/vacuity.h"
#include "runtime/sim/controller.h"
#include "vm/packed_state.h"

namespace oncard::explore {

class CardModel {
 public:
  /// The part of a state that only commands and cycles change; most states share it with their
  /// predecessor.
  struct Body;
  /// A state between two statements.
  struct State {
    vm::PackedVariables variables;
    std::array<vm::ThreadState, vm::kThreadCount> threads{};
    int64_t executed = 0;
    std::shared_ptr<const Body> body;
    runtime::Supervisor::HistoryPointer history;  ///< does not influence the future
    int64_t left = 0;                             ///< statements of the cycle that are left
    uint32_t served = 0;    ///< threads that have executed one in the cycle, by number on the card
    bool ended = false;     ///< the run is over: nothing that the scenario requires is left
    bool finished = false;  ///< the run ended because no thread will run any more
    uint32_t choices = 0;   ///< bit n: thread n of the model may execute the next statement
    uint32_t reached = 0;   ///< bit n: the n-th kEventually has held before
    std::vector<runtime::Owed> owed;         ///< to each response, in the order of the requirements
    std::shared_ptr<const CardRaces> races;  ///< nullptr: races are no failures
    Fault fault;  ///< the fault of the state, or of a cycle that led to it
  };

  /// The scenario's program on a card of its own, before the first statement; its expectations and
  /// the requirements must hold. Host events are ignored. Fails with everything that does not fit
  /// the program, or is not an expression; `errors` contains what the caller has found so far.
  static Result<CardModel> Create(const runtime::Scenario& scenario,
                                  const std::vector<Requirement>& requirements, vm::Object object,
                                  runtime::ScenarioErrors errors = {});

  /// The card of a recorded host, at the call that starts the first thread; what must hold are the
  /// requirements, and that calls are answered as in the record. The run ends where the host closed
  /// the card if threads were running there; otherwise `limit_ms` later at the latest. Fails as
  /// HostEvents::Create(), and when a requirement is no condition of the program.
  static Result<CardModel> CreateFromCalls(const runtime::Scenario& scenario,
                                           const std::vector<Requirement>& requirements,
                                           std::shared_ptr<const runtime::HostCalls> calls,
                                           runtime::ScenarioErrors errors = {});

  const runtime::Scenario& scenario() const { return scenario_; }
  /// The bound threads, in the order of their numbers on the card.
  int thread_count() const { return static_cast<int>(setups_.size()); }
  const ThreadSetup& setup(int thread) const { return setups_[static_cast<size_t>(thread)]; }
  const std::vector<ThreadSetup>& setups() const { return setups_; }
  const std::shared_ptr<const vm::Image>& image() const { return image_; }
  /// What must hold: the scenario's expectations, then the requirements, then the asserts of the
  /// program.
  std::vector<Requirement> Requirements() const;
  /// What a state owes to a response, by its number among Requirements(), which the state has
  /// violated, or owes at the end of its run.
  const runtime::Owed& OwedTo(const State& state, int requirement) const;
  /// The statements that had been executed before the first state.
  int64_t executed_before() const { return initial_.executed; }
  /// True when there are none.
  bool asks_nothing() const { return requirements_.empty() && asserts_.empty(); }
  /// The values of what the assert named that failed last, in the state before its statement.
  const Message& assert_values() const { return assert_values_; }
  /// What the recorded host does; nullptr: there is none.
  const std::shared_ptr<const HostEvents>& host() const { return host_; }
  /// The card, as the last Start(), Step() or Load() left it.
  const runtime::Controller& controller() const { return *controller_; }
  /// What still went on where the runs that were taken ended without a failure. Axes are noted if
  /// every run ends at an instant, or if a requirement on every state names the card.
  const Horizon& horizon() const { return horizon_; }
  /// What none of the runs that were taken has put to the test (runtime/scenario/run/vacuity.h).
  std::vector<Message> Untested() const;
  /// The part of it that concerns requirements, and those that were checked and have held so far.
  std::vector<Message> UntestedRequirements() const;
  std::vector<std::string> HeldSoFar() const;
  /// The statements of the program that were executed in any of the steps that were taken, except
  /// by AdvanceAlone().
  const StatementCoverage& coverage() const { return coverage_; }
  /// Commands that threads have been refused in any of the steps that were taken.
  const std::vector<runtime::RefusedCommand>& refused() const { return refused_->list(); }
  /// What the supervisor has found in them.
  const std::vector<runtime::CardFinding>& found() const { return supervisor_->findings(); }
  /// The races of statements in them, each once, whichever was first: `first` belongs to the thread
  /// with the smaller number. A run goes on to its first race.
  const std::set<Race>& races_met() const { return races_met_; }

  /// The first state in which a thread can run, or the end.
  State Start();
  /// The state after a statement of a thread that may execute it, and after everything that then
  /// happens without threads.
  State Step(const State& state, int thread);
  /// Puts the card into a state.
  void Load(const State& state);

  // The same for a run that is never revisited, which is much faster: the card itself advances, and
  // the state's `slots`, `threads` and `body` are not updated. Nothing else may use the model until
  // the run is over.

  State Begin();
  void Advance(State* state, int thread);
  /// Executes up to `most` statements of a thread within its cycle: several if no other thread runs
  /// and no requirement applies in between. Returns their number.
  int64_t AdvanceAlone(State* state, int thread, int64_t most);
  /// The complete current state of such a run, which can be loaded again.
  State Whole(const State& state);
  /// Copies the variables and threads of the card to the state.
  void CopyVariables(State* state) const;
  /// Whether, in the current state of the card, the next statements of two threads access the same
  /// thing and one of them writes it.
  bool NextDependOnEachOther(int a, int b) const;

  // Of an island (islands.h), whose threads run beside others that are not in the model. What these
  // do with their statements and when they end is a choice like that of the next thread.

  /// The model is an island of this program. A state in which its threads have ended is `finished`
  /// and not `ended` if the end of the run depends on others.
  void RunBeside(const CardModel& whole);
  /// True if the others may take the statements that are left of the cycle: each thread of the
  /// island that can run has been served.
  bool MayEndCycle(const State& state) const;
  /// The state after that, or after a cycle in which others still run.
  State EndCycle(const State& state);
  /// The fault of the run, if it has any, when the others end in a state that is `finished`.
  Fault EndRun(const State& state);
  /// The cycle up to which every run goes on: that of the last instant of an expectation.
  int64_t last_instant() const { return last_instant_; }
  /// Takes over what the runs of an island have put to the test, and what was noted in them. Its
  /// requirement n is, or is a part of, this model's requirement `origins[n]`.
  void Include(const CardModel& island, const std::vector<size_t>& origins);

  /// What the conditions of requirements on every state are read from, and what the condition of an
  /// assert of a thread is read from (runtime/observe/lasting_access.h); that is empty if it is no
  /// condition.
  runtime::StatementAccess WatchedAccess() const;
  std::optional<runtime::StatementAccess> AccessOfAssert(int thread,
                                                         const vm::Assert& assert) const;

  /// The locals that requirements, asserts and reactions name, with the data pages of their
  /// threads.
  std::vector<vm::SlotAddress> NamedLocals() const;

  /// The cycle before which the host has made all its calls, in the current state of such a run.
  int64_t host_acted_until() const { return host_acted_until_; }

  /// The cycle in which a state is.
  static int64_t CycleOf(const State& state);
  /// A key of everything that the future depends on.
  StateKey KeyOf(const State& state) const;
  /// Keys of the final values of the globals, without and with the return values of the threads.
  StateKey GlobalsKey(const State& state) const;
  StateKey FinalKey(const State& state) const;

 private:
  friend class CardRows;
  friend class CardSteps;
  struct BoundRequirement {
    Requirement requirement;
    runtime::CardCondition condition;
    int64_t cycle = -1;  ///< an expectation with an instant: at the end of this cycle
    std::optional<runtime::CardCondition> then = {};  ///< of a response: its right side
    size_t response = 0;                              ///< its number in State::owed
    std::optional<runtime::Guard> guard = {};
    std::optional<runtime::CardCondition> matters = {};  ///< of the guard
    mutable bool mattered = false;
    mutable bool judged = false;
  };

  /// With a card for the scenario.
  explicit CardModel(const runtime::Scenario& scenario);
  /// Takes the program from the card, and the threads that are to be explored.
  void KeepThreads(std::vector<ThreadSetup> threads);
  void BindRequirements(const std::vector<Requirement>& requirements,
                        runtime::ScenarioErrors* errors);
  void BindGuards();
  /// Calls `look` with each condition that is checked or awaited.
  template <typename Look>
  void ForEachCondition(const Look& look) const;
  /// True if any of them depends on how many statements were executed.
  bool AnyCountsStatements() const;
  /// Prepares the search for races, or refuses it.
  void BindRaces(runtime::ScenarioErrors* errors);
  bool Holds(const BoundRequirement& bound) const;
  /// Goes on with what is owed to a response.
  void ObserveResponse(const BoundRequirement& bound, runtime::Owed* owed) const;
  /// Checks the final requirements without an instant, and those under kEventually and kLeads.
  void JudgeEnd(State* state) const;
  /// Checks the requirements on every state, and records the kEventually ones and responses.
  void JudgeState(State* state) const;
  /// Checks the expectations whose instant is the end of this cycle.
  void JudgeInstant(State* state) const;
  void JudgeThreads(State* state) const;
  /// Begins cycles until a thread can run or the run has ended.
  void Settle(State* state);
  /// Begins a cycle, up to its first statement.
  void NextCycle(State* state);
  /// Ends the run and checks its final requirements.
  void End(State* state);
  /// Notes what still goes on at the end of a run.
  void NoteHorizon();
  /// True if the host still does something now or later.
  bool HostActs() const { return host_ != nullptr && host_->LeftAt(controller_->cycle()); }
  /// Lets the host make the calls of the cycle.
  void ActAsHost(State* state);
  /// The threads that may execute the next statement, by number on the card.
  uint32_t Candidates(const State& state) const;
  /// Notes the next statement of a thread; returns the race that it completes, if there is any.
  Race NoteRaces(State* state, int thread) const;
  /// Notes that the statement has begun to wait for a variable.
  void NoteWait(State* state, int thread) const;
  /// The fault of a thread's next statement if an assert before it does not hold.
  Fault JudgeAsserts(int thread);
  /// Notes what the next statement of a thread does, by its number on the card.
  void NoteCoverage(int number);
  /// Executes a statement and what then happens without threads.
  void Execute(State* state, int thread);
  /// Returns the statements of the cycle.
  int64_t BeginCycle();
  /// Those that held at the last boundary of cycles.
  uint64_t ConditionsOfReactions() const;
  /// Copies the state of the card.
  void Save(State* state);
  std::shared_ptr<const Body> CurrentBody() const;

  runtime::Scenario scenario_;
  std::shared_ptr<const vm::Image> image_;
  std::shared_ptr<const HostEvents> host_;
  std::unique_ptr<runtime::RefusedCommands> refused_ = std::make_unique<runtime::RefusedCommands>();
  std::unique_ptr<runtime::Controller> controller_;
  std::unique_ptr<runtime::Supervisor> supervisor_;
  /// The controller's body is this one after the given number of cycles; nullptr: it is not known.
  std::shared_ptr<const Body> held_;
  int64_t cycles_since_held_ = 0;
  int64_t host_acted_until_ = 0;
  State initial_;                              ///< before the first cycle
  std::unique_ptr<vm::MachineState> scratch_;  ///< large
  mutable std::vector<int64_t> words_;         ///< of the state whose key is computed
  std::vector<ThreadSetup> setups_;
  std::vector<BoundRequirement> requirements_;
  std::shared_ptr<const CardRaces> races_;  ///< before the first statement; nullptr: any is allowed
  std::set<Race> races_met_;
  uint32_t fault_expected_ = 0;  ///< threads whose error an expectation names
  runtime::AssertWatch asserts_;
  Message assert_values_;
  bool has_invariants_ = false;     ///< or kEventually
  bool counts_statements_ = false;  ///< a condition names how many were executed
  bool watches_card_ = false;       ///< a requirement on every state names more than the program
  StatementCoverage coverage_;
  Horizon horizon_;
  int64_t latest_end_ = 0;  ///< cycle in which the longest run that was taken ended
  bool others_end_runs_ =
      false;  ///< of an island: threads that are not in the model may run longer
  runtime::RunBounds bounds_;
  int64_t last_instant_ = 0;  ///< cycle of the last expectation with an instant, or `until_ms`
};

}  // namespace oncard::explore
