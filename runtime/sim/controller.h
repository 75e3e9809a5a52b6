// One card: virtual machine, motion core, state of its family and virtual time. This is the only
// place where statements, profile cycles, delays and events are interleaved; docs/vm-model.md
// gives the order.
//
// Virtual time counts profile cycles. The owner advances it: by host calls (each takes a time,
// gtcalls/family.h), by AdvanceUs(), or by the clock of a host that calls it (host/host_clock.h).
// Deterministic; not thread-safe: the C API serialises its callers per card.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "gtcalls/card.h"
#include "gtcalls/gts/family.h"
#include "motion/common/rare.h"
#include "motion/motion_core.h"
#include "runtime/sim/axis_unit.h"
#include "runtime/sim/call_text.h"
#include "runtime/sim/card_clock.h"
#include "runtime/sim/card_observer.h"
#include "runtime/sim/reactions.h"
#include "runtime/sim/refused_commands.h"
#include "vm/image.h"
#include "vm/machine.h"

namespace oncard::runtime {

struct ControllerOptions {
  motion::MotionConfig motion;
  /// Statements per millisecond, all threads together (GTS manual 10.2).
  int rate = 100;
  /// The family of the card.
  const gtcalls::Family* family = &gtcalls::GtsFamily();
  /// Its type; nullptr: the default one of the family.
  const gtcalls::CardType* type = nullptr;
  /// In which values are shown; no part of what the card computes.
  std::array<AxisUnit, motion::kAxisMax> units = {};
};

/// The state of a card outside the virtual machine. Statements change it only through GT commands,
/// cycles always.
struct CardBody {
  motion::MotionState motion;
  gtcalls::FamilyState family;
  int64_t pending_ns = 0;
  int64_t pending_statements = 0;
  motion::Rare<CardClock::Change> clock = {};     ///< of a card whose clock has been changed
  motion::Rare<Reactions::State> reactions = {};  ///< of surroundings that react
};

/// The complete state of a card as a value.
struct ControllerSnapshot {
  vm::MachineState machine;
  CardBody body;
};

/// How RunUntilQuiet() ended.
enum class RunEnd : uint8_t { kQuiet, kTimeLimit, kDeadlock, kScheduleEnd, kScheduleDiverged };

class Controller {
 public:
  explicit Controller(const ControllerOptions& options = {});
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  const ControllerOptions& options() const { return options_; }
  vm::Machine& machine() { return machine_; }
  const vm::Machine& machine() const { return machine_; }
  motion::MotionCore& motion() { return motion_; }
  const motion::MotionCore& motion() const { return motion_; }
  gtcalls::Card& card() { return card_; }
  const gtcalls::Family& family() const { return card_.family; }
  gtcalls::CardView view() const { return card_.view(); }
  const vm::CommandTable& commands() const { return commands_; }

  /// From now on logs every refused command of a thread, under this card number. The log must
  /// outlive the controller.
  void LogRefusals(CardLog* log, int card);
  /// The same for what the card does by itself: stops, paths that run out of segments
  /// (card_event_text.h).
  void LogEvents(CardLog* log, int card);
  /// From now on reports to the observer what the card does by itself, and the time in us.
  using EventListener = std::function<void(int64_t time_us, const Message& what)>;
  void ListenToEvents(EventListener listener);
  /// From now on shows the observer what the card does; nullptr ends this. It must exist until
  /// then. There is one at a time.
  void ObserveWith(CardObserver* observer);
  /// From now on adds every refused command of a thread to the list. The list must exist as long as
  /// the controller runs.
  void CollectRefusals(RefusedCommands* refused);

  // --- Programs --------------------------------------------------------------------------------

  /// GT_Download: loads `X.bin` with the `X.ini` beside it. Codes 2007, 2008, 7 as GT_Download
  /// returns them. On failure the old program stays loaded and continues.
  /// `content` receives the bytes of both files if they could be read.
  Result<void> Download(const std::string& bin_path, vm::ObjectFiles* content = nullptr);
  /// Loads an object that is in memory.
  Result<void> Load(vm::Object object);
  /// The same for a program that has been linked with commands().
  void Load(std::shared_ptr<const vm::Image> image);
  /// True if something of the program acts: one of its threads has been started since it was bound,
  /// or the family writes variables by itself (PLC blocks, buffered commands).
  bool ProgramActs() const;

  // --- Host calls ------------------------------------------------------------------------------

  /// Lets time pass up to the next tick.
  using TickPasser = std::function<void()>;

  /// Executes a command for the host: first the time that it takes passes, then it acts. `reason`,
  /// empty before, explains a code other than 0.
  int16_t Call(const gtcalls::Command& command, std::span<vm::CommandArgument> arguments,
               Message* reason = nullptr);
  /// The same for callers that manage the clock themselves: no time passes, unless the command ends
  /// at the next tick, up to which `pass` lets it pass; without it, it does so at once.
  int16_t Execute(const gtcalls::Command& command, std::span<vm::CommandArgument> arguments,
                  Message* reason = nullptr, const TickPasser& pass = {});

  // --- Time ------------------------------------------------------------------------------------

  /// When the cycles of the card are.
  const CardClock& clock() const { return clock_; }
  /// From now on calls the listener each time a command has changed the length of the cycles. There
  /// is one; an empty one ends this.
  void ListenToClock(std::function<void()> listener) { clock_listener_ = std::move(listener); }
  /// Advances time by microseconds; runs a profile cycle whenever a whole one has accumulated.
  void AdvanceUs(int64_t microseconds);
  /// For callers that run cycles themselves: the host is at this instant, which is in the present
  /// cycle.
  void PlaceInCycle(int64_t time_us) {
    pending_ns_ = time_us * CardClock::kNsPerUs - clock_.NsOf(cycle());
  }
  /// The same for the end of the cycle that is about to run.
  void PlaceAtTick() { pending_ns_ = 0; }
  /// The microseconds after which so many more cycles have passed, rounded up.
  int64_t UsToTick(int64_t cycles) const;
  int64_t UsToNextTick() const { return UsToTick(1); }
  /// True if the card has interrupted its host since the last call of this.
  bool TakeInterrupt() { return std::exchange(interrupts_host_, false); }
  /// After how many cycles it may do so (Family::cycles_before_interrupt).
  int64_t CyclesBeforeInterrupt() const;
  /// True if something goes on: motion, or an event outside of the card that is still to come.
  bool GoesOn() const;
  /// Runs one profile cycle: motion tick, the part of the family, then the threads with their
  /// budget.
  void RunCycle();
  /// As many of them. Motion is advanced several cycles at a time as long as no statement can tell.
  void RunCycles(int64_t cycles);
  /// From now on RunCycle() calls the observer in every state: after the beginning of the cycle and
  /// after each statement. It must not change the card. An empty observer ends this.
  void ObserveStates(std::function<void()> observer) { state_observer_ = std::move(observer); }
  bool shows_states() const { return state_observer_ != nullptr; }
  /// For callers that choose the order of statements themselves: calls the observer, if any.
  void ShowState() const {
    if (state_observer_) state_observer_();
  }
  /// From now on every cycle lets the host act in the middle of it: `host` is called before the
  /// first statement, and each time the threads have executed as many statements of the cycle as it
  /// has returned, unless that was the last one. It gets their number, and may write variables. An
  /// empty function ends this.
  using CycleHost = std::function<int64_t(int64_t executed)>;
  void LetHostAct(CycleHost host) { cycle_host_ = std::move(host); }
  /// For callers that choose the order of statements themselves: to be called before each statement
  /// of a cycle, with the number of those executed in it; the host acts if it is its turn. Returns
  /// the number of statements after which it must be called again.
  int64_t StatementsUntilHost(int64_t executed);
  /// From now on the surroundings react to the card.
  void LetWorldReact(Reactions reactions) { reactions_ = std::move(reactions); }
  /// nullptr: they do not.
  const Reactions* reactions() const { return reactions_ ? &*reactions_ : nullptr; }
  /// RunCycle() without the threads: returns the number of statements that they may execute before
  /// the next cycle begins, for a caller that chooses their order.
  int64_t BeginCycle();
  /// Runs at most `limit_cycles` cycles, until no thread is running. kDeadlock: as Deadlocked().
  RunEnd RunUntilQuiet(int64_t limit_cycles);
  /// True if threads wait for values that nothing can change any more: no thread can run, none is
  /// delayed or periodic, and the family writes no variables by itself (PLC blocks, buffered
  /// commands). Only the host can then resolve the wait by writing variables.
  bool Deadlocked() const;
  /// Profile cycles since power-on.
  int64_t cycle() const { return motion_.cycle(); }
  /// Their end in milliseconds.
  double NowMs() const;
  /// Microseconds since power-on, including the current cycle.
  int64_t NowUs() const;

  /// GT_Reset: registers, program state and clock to their power-on values; the downloaded program
  /// is gone, as after power-on.
  void Reset();

  // --- State -----------------------------------------------------------------------------------

  ControllerSnapshot Snapshot() const;
  /// Puts back a snapshot taken from this controller with the same program.
  void Restore(const ControllerSnapshot& snapshot);
  /// Separate parts of it; together with Machine::Restore() the same as above.
  CardBody Body() const;
  void RestoreBody(const CardBody& body);
  /// XXH64 of the body alone.
  uint64_t BodyHash() const;
  /// XXH64 of everything in a snapshot except the internal state of the scheduling policy.
  uint64_t Hash() const;

 private:
  void ObserveRefusals(gtcalls::RefusalObserver observer);
  /// Lets the motion core report to all who listen.
  void PassEventsOn();
  void TellListeners(const Message& what) const;
  /// The threads' part of a cycle, with the observer and the host.
  void ExecuteInParts(int64_t budget);
  /// Runs at least one and at most `limit` cycles, after which motion may be late; returns their
  /// number.
  int64_t RunSome(int64_t limit);
  /// Cycles in which no thread can run and nothing is done for the threads.
  int64_t IdleCycles() const;
  void RunIdle(int64_t cycles);
  RunEnd RunSomeUntilQuiet(int64_t limit_cycles);
  /// Brings motion to the cycle of the threads.
  void CatchUp();
  /// The statements of the next `cycles`, all threads together.
  int64_t TakeBudget(int64_t cycles);

  /// Instants outside, with the time of the host.
  int64_t NowNs() const { return clock_.NsOf(cycle()) + pending_ns_; }
  void SetCycle(int64_t cycle_ns);
  /// The hash with what only some cards have: a clock that is not that of the motion core, and
  /// surroundings that react.
  uint64_t WithRareParts(uint64_t hash) const;

  ControllerOptions options_;
  motion::MotionCore motion_;
  CardClock clock_;
  gtcalls::FamilyState family_state_;
  gtcalls::CardCommands commands_;
  vm::Machine machine_;
  gtcalls::Card card_;
  std::vector<gtcalls::RefusalObserver> refusal_observers_;
  std::vector<EventListener> event_listeners_;
  CardObserver* observer_ = nullptr;
  std::function<void()> state_observer_;
  CycleHost cycle_host_;
  int64_t host_acts_after_ = 0;  // statements of this cycle
  std::optional<Reactions> reactions_;
  bool interrupts_host_ = false;
  std::function<void()> clock_listener_;
  int64_t pending_ns_ = 0;  // host time not yet converted to cycles
  int64_t pending_statements_ =
      0;                     // rounding remainder of the last budget, in thousandths of a statement
  int64_t motion_late_ = 0;  // cycles that the threads have had and motion has not, inside a call
};

}  // namespace oncard::runtime
