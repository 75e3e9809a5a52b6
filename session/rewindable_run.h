// A scenario with its program as a sequence of moments that can be walked in both directions.
//
// From one moment to the next the card takes one *step*: the scenario acts between two cycles
// (expectations of that instant, writes of the host) or in the middle of one (writes of the host),
// a recorded host makes a call, a profile cycle begins, or a thread executes one statement. Moment
// 0 is before the first step. The scenario's policy decides which thread executes a statement
// unless the user chooses one; variables and inputs can be changed between two steps. Choices and
// changes are recorded, so that every moment up to head() can be reached again, exactly. A choice
// or a change at an earlier moment discards what was after it.
//
// Copies of the state are kept more densely near the present: at most kKeptMax, and executing again
// from the nearest one takes a fraction of the way to it.
//
// Deterministic; not thread-safe. Tested by tests/session/rewindable_run_test.cc.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "runtime/conditions/card_condition.h"
#include "runtime/observe/supervisor.h"
#include "runtime/scenario/file/scenario.h"
#include "runtime/scenario/record/host_calls.h"
#include "runtime/scenario/run/response.h"
#include "runtime/scenario/run/run_course.h"
#include "runtime/sim/controller.h"
#include "session/race_watch.h"
#include "vm/packed_state.h"
#include "vm/schedule.h"

namespace oncard::session {

/// What happens from one moment to the next.
enum class StepKind : uint8_t { kHost, kCycle, kStatement };

/// A GT command that a thread, or a recorded host, was refused.
struct Refusal {
  int thread = 0;  ///< -1: the recorded host
  int16_t code = 0;
  Message call;  ///< `GT_AxisOn(9) = 7: parameter axis is 9; the range is [1, 8]`
};

/// What a step did.
struct StepReport {
  StepKind kind = StepKind::kStatement;
  int thread = -1;                         ///< kStatement
  std::shared_ptr<const Refusal> refusal;  ///< kStatement: nullptr if no command was refused
  std::optional<Message> race;             ///< kStatement: only while races are watched
  std::vector<Message> failed;             ///< kHost: expectations that did not hold, and why
  bool call = false;                       ///< kHost: a call of a recorded host
  std::optional<Message> deviation;        ///< the card has not answered as it is recorded
  std::optional<Message> warning;          ///< the first of the supervisor's that are new
};

class RewindableRun {
 public:
  /// States that are kept at most.
  static constexpr size_t kKeptMax = 192;
  /// Steps between two kept states of a run that goes forward.
  static constexpr int64_t kKeptInterval = 4096;

  /// The scenario with its program before the first step. `schedule` is followed as far as it goes;
  /// then the scenario's own policy continues. Fails with everything that does not fit the program.
  static Result<std::unique_ptr<RewindableRun>> Create(
      runtime::Scenario scenario, vm::Object object,
      std::shared_ptr<const vm::Schedule> schedule = nullptr);

  /// The card of a host, without a program before the first call. Of the scenario only the card and
  /// its surroundings count.
  static std::unique_ptr<RewindableRun> CreateFromCalls(
      runtime::Scenario scenario, std::unique_ptr<const runtime::HostCalls> calls);

  RewindableRun(const RewindableRun&) = delete;
  RewindableRun& operator=(const RewindableRun&) = delete;

  const runtime::Controller& controller() const { return controller_; }
  const vm::Machine& machine() const { return controller_.machine(); }
  /// The program; one without functions as long as a recorded host has downloaded none.
  const vm::Image& image() const;
  /// A card with a program that a recorded host downloads, for those who look up names.
  const runtime::Controller& CardWith(const std::shared_ptr<const vm::Image>& program) const;
  /// The scenario without changes.
  const runtime::Scenario& scenario() const { return scenario_; }
  /// The scenario with the changes that have been made up to head().
  runtime::Scenario ScenarioWithChanges() const { return ScenarioWithWrites(INT64_MAX); }

  // --- The present -----------------------------------------------------------------------------

  int64_t moment() const { return place_.moment; }
  /// The last moment that has been reached since the last choice or change.
  int64_t head() const { return head_; }
  /// The statements that the threads may still execute in this cycle.
  int64_t statements_left() const { return place_.statements_left; }
  StepKind NextStep() const;
  /// The thread that executes the next statement if the user chooses none; -1: the next step is no
  /// statement.
  int NextThread() const;
  /// Set if a run of the scenario is over at this moment. The card can go on.
  std::optional<runtime::RunOver> Over() const;
  /// The cycle with whose end it was first over; -1: it has not been.
  int64_t over_cycle() const { return place_.over_cycle; }
  /// True if a schedule was given and is still followed: it has not ended, its threads could run,
  /// and the user has chosen no other one.
  bool follows_schedule() const;
  /// Number of commands that threads were refused, and of expectations that failed, up to this
  /// moment.
  int64_t refused() const { return place_.refused; }
  int64_t failed() const { return place_.failed; }
  /// The expectations without an instant.
  const std::vector<runtime::Agenda::Check>& expectations_at_end() const {
    return course_.agenda().at_end();
  }
  /// True where a run that may last for ever is cut (RunBounds::CutsAt()).
  bool is_cut() const { return course_.bounds().CutsAt(controller_); }
  /// True if the scenario has expectations or writes of the host after this moment.
  bool scenario_goes_on() const {
    return course_.agenda().has_checks() || course_.agenda().has_writes() || CallIsLeft();
  }
  /// The recorded calls of a host; nullptr: there is no such host.
  const runtime::HostCalls* calls() const { return calls_.get(); }
  /// How many of them have acted.
  size_t calls_made() const { return place_.calls; }
  /// The last one with its code; nullptr: none.
  const Message* last_call() const { return place_.last_call.get(); }
  /// Number of calls up to this moment that the card did not answer as it is recorded.
  int64_t deviations() const { return place_.deviations; }
  /// The last refused command of a thread since it was started; nullptr: none.
  const Refusal* LastRefusal(int thread) const;
  /// What the supervisor has found up to this moment. What the end of the run has shown stays while
  /// the card goes on, until something is changed.
  const std::vector<runtime::CardFinding>& findings() const { return supervisor_.findings(); }
  /// Grows with each new finding that is not silenced, and not otherwise.
  int64_t warned() const { return place_.warned; }
  /// Findings of these kinds are no warnings. To be called at moment 0.
  void Silence(runtime::CardWarnings silent) { silent_ = silent; }
  bool IsSilent(const runtime::CardFinding& finding) const { return silent_.Has(finding.warning); }

  // --- Forward ---------------------------------------------------------------------------------

  /// Takes one step.
  const StepReport& Step();
  /// What the last single step did.
  const StepReport& last_step() const { return report_; }
  /// Takes the next steps up to the end of the cycle, but not beyond the moment `last`. Much faster
  /// than single steps.
  void Advance(int64_t last);
  /// Takes all steps up to a moment.
  void AdvanceTo(int64_t moment);
  /// Fails if there is no thread with this number.
  static Result<void> CheckThread(int thread);
  /// A thread executes the next statement of this cycle, or of the next one if this one has no
  /// statements left. Fails if it cannot run; then nothing has changed.
  Result<void> StepThread(int thread);

  /// While it is true, all that takes more than a few steps ends early, at any moment on its way:
  /// for who needs the run no more. It must outlive the run; another thread may set it.
  void EndEarly(const std::atomic<bool>* wanted) { end_wanted_ = wanted; }
  bool EndIsWanted() const { return end_wanted_ != nullptr && *end_wanted_; }

  // --- Back ------------------------------------------------------------------------------------

  /// Goes to a moment from 0 to head().
  void GoTo(int64_t moment);
  /// Goes to the end of a cycle, or to head() if that is earlier.
  void GoToCycle(int64_t cycle);
  /// Number of states that are kept.
  size_t kept_count() const { return kept_.size(); }
  /// The last kept moment before `moment`; 0 for moment 0.
  int64_t KeptBefore(int64_t moment) const;

  // --- Data races ------------------------------------------------------------------------------

  /// From now on every step says which data race it completes; those before the present count, too.
  /// Costs the execution of the run up to the present, and slows down all others. Fails with the
  /// variables of the scenario's `sync` that the program does not have.
  Result<void> WatchRaces(bool on);

  // --- What must hold at some time -------------------------------------------------------------

  /// A response with its sides.
  struct Response {
    runtime::Requirement requirement;
    runtime::CardCondition left;
    runtime::CardCondition right;
  };
  /// Notes from now on, in each state of the scenario's run, which conditions have held and what is
  /// owed to responses: in the present one, after the beginning of a cycle, and after a statement.
  /// To be called at moment 0. While a condition has not held yet, and with responses always, every
  /// statement is executed by itself.
  void Await(std::vector<runtime::CardCondition> conditions, std::vector<Response> responses);
  /// True if the condition with this number has held up to the present.
  bool HasHeld(size_t condition) const { return place_.held[condition]; }
  /// What is owed at present to the response with this number.
  const runtime::Owed& OwedTo(size_t response) const { return place_.owed[response]; }

  // --- Changes ---------------------------------------------------------------------------------

  /// The host writes a variable (quantity.h). Items of the scenario that are due come first. Fails
  /// if there is no such variable or the value does not fit.
  Result<void> WriteVariable(const std::string& name, double value);
  /// Changes the level of an input pin, or the voltage at an analogue input, from the next cycle
  /// on. Numbers count from 1. Fails if there is no such input, or if a switch of the scenario's
  /// world is wired to it.
  Result<void> SetInput(motion::DiType type, int index, bool level);
  Result<void> SetVoltage(int channel, double volts);
  /// Moves a switch of the scenario's world, from the next cycle on: it is then operated from one
  /// position to the other, in pulses; infinite ones are allowed. Fails if there is no such switch,
  /// or `from` is greater than `to`.
  Result<void> MoveSwitch(int number, double from, double to);

  // --- Recording -------------------------------------------------------------------------------

  /// The run up to this moment as a schedule with its scenario, which lasts longer than the
  /// original one if the card went on after its end. The scenario's paths are relative to the file
  /// `path`; empty: to the file from which the scenario was read.
  vm::Schedule Record(const std::string& path = {});
  /// The threads of the steps from one moment to another, at most `most` segments.
  struct Turn {
    int64_t moment = 0;  ///< of its first statement
    int64_t cycle = 0;
    int thread = 0;
    int64_t statements = 0;
  };
  std::vector<Turn> Turns(int64_t from, int64_t to, size_t most);
  /// A time in which a bound thread is in one state, and if it waits, waits for one thing.
  struct Span {
    int thread = 0;
    bool waits = false;                  ///< running, but for now it cannot execute a statement
    vm::ThreadState state;               ///< at its beginning
    const vm::Image* program = nullptr;  ///< the card's, likewise
    int line = 0;                        ///< likewise
    int64_t from = 0;                    ///< moments
    int64_t to = 0;          ///< the moment of the next state, or the last one that was looked at
    int64_t from_cycle = 0;  ///< of the card at these moments
    int64_t to_cycle = 0;
  };
  /// The states of the threads from one moment to another, in the order of their beginnings. With
  /// more than `most` of them, all end where the next one would begin.
  std::vector<Span> Spans(int64_t from, int64_t to, size_t most);

 private:
  /// The part of the present that is not the card's.
  struct Place {
    int64_t moment = 0;
    int64_t statements_left = 0;
    int64_t statements_done = 0;  ///< of this cycle
    int64_t refused = 0;
    int64_t failed = 0;
    int64_t over_cycle = -1;          ///< the cycle with whose end the scenario's run was over
    bool end_judged = false;          ///< by the supervisor, since the last change
    size_t findings = 0;              ///< of the supervisor, that have been noted
    int64_t warned = 0;               ///< warned()
    std::vector<bool> held;           ///< which of the awaited conditions have held
    std::vector<runtime::Owed> owed;  ///< to each response
    size_t calls = 0;                 ///< of the recorded host
    int64_t deviations = 0;
    std::shared_ptr<const Message> last_call;
    /// The last refused command of each thread.
    std::array<std::shared_ptr<const Refusal>, vm::kThreadCount> refusals{};
  };
  struct Kept {
    Place place;
    runtime::RunCourse::Position course;
    std::shared_ptr<const vm::Image> program;
    vm::PackedState machine;
    runtime::CardBody body;
    runtime::Supervisor::HistoryPointer history;
    runtime::Supervisor::FoundPointer found;
    std::optional<RaceWatch> races;
  };
  struct Choice {
    int64_t moment = 0;
    int thread = 0;
  };
  /// A change of a variable, of an input, or of a switch.
  struct Change {
    int64_t moment = 0;
    std::optional<runtime::HostEvent> write;
    std::vector<runtime::Quantity> variables;  ///< of `write`
    std::optional<runtime::InputEvent> input;
    std::optional<runtime::VoltageEvent> voltage;
    std::optional<runtime::SwitchMove> move;
  };
  /// Notes the commands that threads are refused.
  class RefusalLog final : public runtime::CardLog {
   public:
    explicit RefusalLog(RewindableRun* run) : run_(*run) {}
    void Write(const runtime::LoggedCall& call) override;
    /// What the card does by itself is not asked for.
    void Write(int64_t, int, const Message&) override {}

   private:
    RewindableRun& run_;
  };

  explicit RewindableRun(runtime::Scenario scenario);
  Result<void> Start(vm::Object object, std::shared_ptr<const vm::Schedule> schedule);

  /// The thread that the user has chosen for the next statement.
  std::optional<int> ChosenNow() const;
  /// The first moment after the present at which a choice or change is recorded.
  int64_t NextRecorded() const;
  /// True if the host writes now, in the middle of a cycle.
  bool HostActsWithin() const;
  /// True if calls of a recorded host are left.
  bool CallIsLeft() const { return calls_ != nullptr && place_.calls < calls_->size(); }
  /// True if one acts before the next cycle.
  bool CallIsDue() const;
  void StepHost();
  void StepCall();
  /// True if the user has chosen or changed something before the present.
  bool HasBeenChanged() const;
  void StepHostWithin();
  void StepStatement();
  /// Begins a cycle without executing its statements.
  void BeginCycle();
  /// Executes statements of this cycle in the policy's order, up to the moment `last`.
  void ExecuteTo(int64_t last);
  void LeaveSchedule();
  /// To be called at the end of a step: applies recorded changes, keeps the state.
  void Arrive();
  void Apply(const Change& change);
  /// After a change the run may go on: its end is judged again.
  void ForgetEnd();
  /// Notes what the supervisor has found since this was called last.
  void NoteFindings();
  /// A cycle's statements that no thread can use are lost.
  void LoseStatements();
  void NoteEnd();
  /// True while a condition is awaited that has not held yet, and during the scenario's run with
  /// responses.
  bool Awaits() const;
  /// Notes which awaited conditions hold in this state, and what is owed.
  void NoteState();
  void Keep();
  void ThinOut();
  void Restore(const Kept& kept);
  std::vector<Kept>::iterator FirstKeptAfter(int64_t moment);
  /// Discards what was recorded after the present.
  void Cut();
  void AddChange(Change change);
  /// The scenario with the writes up to a moment, and with all other changes: the events of the
  /// world that are still to come belong to the state of the card.
  runtime::Scenario ScenarioWithWrites(int64_t last) const;
  /// The instant from which a change of an input acts.
  int64_t InputInstant() const;
  /// Gives the card the events of the scenario with its changes.
  void UpdateWorld();
  /// The same if they are those of another state of the card.
  void ShareWorld();
  const runtime::CardClock& clock() const { return controller_.clock(); }

  runtime::Scenario scenario_;
  vm::Policy own_policy_;  ///< of the scenario, after the schedule
  RefusalLog log_;
  runtime::Controller controller_;
  runtime::Supervisor supervisor_;
  runtime::CardWarnings silent_;
  runtime::RunCourse course_;
  std::unique_ptr<const runtime::HostCalls> calls_;
  const std::atomic<bool>* end_wanted_ = nullptr;
  std::unique_ptr<runtime::Controller> lookup_;  // of CardWith()
  Place place_;
  int64_t head_ = 0;
  std::vector<Choice> choices_;  // in order of moments
  std::vector<Change> changes_;
  std::vector<Kept> kept_;  // in order of moments; the first one is moment 0
  int64_t keep_interval_ = kKeptInterval;
  std::shared_ptr<const motion::WorldEvents> world_events_;
  runtime::CardClock world_clock_ = controller_.clock();  ///< with which they have been computed
  StepReport report_;
  std::optional<RaceWatch> races_;
  std::vector<runtime::CardCondition> awaited_;
  std::vector<Response> responses_;
  std::unique_ptr<vm::MachineState> scratch_ = std::make_unique<vm::MachineState>();
};

}  // namespace oncard::session
