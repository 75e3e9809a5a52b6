// The card's virtual machine for motion programs: 32 threads with 32 data pages and the globals.
//
// One statement is one atomic step. The scheduling policy chooses which thread executes the next
// one; the virtual machine is a deterministic function of (program, initial values, policy, calls
// from outside). Its complete state is the value MachineState: a snapshot is a copy.
//
// Sources: GTS manual 10.2 and 10.3; assumptions are listed in docs/assumptions.md.
// Not thread-safe: one caller at a time.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "vm/command_table.h"
#include "vm/image.h"
#include "vm/limits.h"
#include "vm/recording.h"
#include "vm/schedule.h"
#include "vm/scheduler.h"

namespace oncard::vm {

struct Frame;
enum class Exit : uint8_t;

/// Return codes of the card that the virtual machine itself returns (GTS manual table 3-1).
inline constexpr int16_t kOk = 0;
inline constexpr int16_t kRefused = 1;
inline constexpr int16_t kBadParameter = 7;

/// A fault stops its thread; TThreadSts.error holds the number. The card's own return codes of
/// commands inside programs are below 100.
enum class Fault : int16_t {
  kNone = 0,
  kDivisionByZero = 100,
  kIndexOutOfBounds = 101,
  kOutputBeyondStorage = 102,
};

enum class ThreadRun : uint8_t { kUnbound, kStopped, kRunning, kPaused, kFaulted };

/// The complete state of one thread.
struct ThreadState {
  ThreadRun run = ThreadRun::kUnbound;
  uint8_t page = 0;
  uint8_t function = 0;  ///< index, not id
  bool started = false;  ///< has executed since it was bound: `pc` and `error` are valid
  /// Index of the current instruction while running or paused; of the last one afterwards.
  uint16_t pc = 0;
  /// Return code of the last GT command, or the fault.
  int16_t error = 0;
  DataType result_type = DataType::kInt;
  int64_t result = 0;       ///< int, or raw fixed point
  int64_t fault_value = 0;  ///< the offending index or element count
  int64_t fault_limit = 0;  ///< the size it was compared with
  int64_t wake_cycle = 0;   ///< delayed until this cycle has begun; 0 = not delayed
  bool waiting = false;     ///< until `wait_slot` holds `wait_value`
  SlotAddress wait_slot;
  int64_t wait_value = 0;
  uint16_t breakpoint_line = 0;  ///< pauses before a statement of this line; 0 = none
  int64_t period_cycles = 0;     ///< period of repeated starts in cycles; 0 = not periodic
  int64_t next_start = 0;        ///< cycle of the next periodic start
  int64_t overruns =
      0;  ///< missed periodic starts: the thread was still running, or the clock jumped
  int16_t priority = 4;      ///< smaller runs first under the priority policy
  int64_t executed = 0;      ///< statements since the last start
  int64_t executed_max = 0;  ///< largest `executed` of a completed periodic run
};

/// True for a thread that is running, or is to be started again.
inline bool IsAwake(const ThreadState& thread) {
  return thread.run == ThreadRun::kRunning || thread.period_cycles > 0;
}

/// True for a thread that is in the middle of its function, or is to be started again.
inline bool IsActive(const ThreadState& thread) {
  return IsAwake(thread) || thread.run == ThreadRun::kPaused;
}

/// The data pages. Few programs use more than a handful of the 32, so it records which ones have
/// ever been accessed for writing: the others are all 0 and need not be copied.
class DataPages {
 public:
  using Page = std::array<int64_t, kSlotCount>;

  DataPages() = default;
  DataPages(const DataPages& other) { *this = other; }
  DataPages& operator=(const DataPages& other);
  ~DataPages() = default;

  const Page& operator[](size_t page) const { return pages_[page]; }
  /// Bit n: page n may hold values other than 0.
  uint32_t used() const { return used_; }
  /// The page, for writing.
  Page& Use(size_t page) {
    used_ |= uint32_t{1} << page;
    return pages_[page];
  }

 private:
  std::array<Page, kPageCount> pages_{};
  uint32_t used_ = 0;
};

/// The whole state, ready to be copied.
struct MachineState {
  DataPages pages;
  std::array<int64_t, kSlotCount> globals{};
  std::array<ThreadState, kThreadCount> threads{};
  SchedulerState scheduler;
  int64_t executed = 0;  ///< statements since the program was loaded
  int64_t faults = 0;    ///< of threads, since the program was loaded
  int64_t cycle = 0;     ///< current profile cycle
};

/// Why Execute() stopped early.
enum class Stop : uint8_t {
  kBudget,           ///< the whole budget was executed
  kIdle,             ///< no thread can run now
  kScheduleEnd,      ///< a replayed schedule has no more segments
  kScheduleDiverged  ///< a replayed schedule names a thread that cannot run, or a hash differs
};

class Machine {
 public:
  /// `commands` must outlive the machine.
  explicit Machine(CommandTable* commands);

  // --- Program ---------------------------------------------------------------------------------

  /// Replaces the program (nullptr: by none): unbinds all threads, sets all variables to 0, and
  /// resets the policy. The clock continues.
  void Load(std::shared_ptr<const Image> image);
  /// The program, or nullptr before the first Load().
  const Image* image() const { return image_.get(); }
  /// Same pointer, shared.
  std::shared_ptr<const Image> shared_image() const { return image_; }

  // --- Threads. Each returns the GT command's code --------------------------------------------

  /// Binds function `function_id` (from 1) and `page`. 7: out of range or no such function;
  /// 1: the thread runs or is paused, or another bound thread holds the page.
  int16_t Bind(int thread, int function_id, int page);
  /// Starts a stopped or faulted thread at its first instruction, or resumes a paused one.
  /// 7: out of range; 1: not bound, or already running.
  int16_t Run(int thread);
  /// 7: out of range; 1: not bound. Also ends periodic starts.
  int16_t StopThread(int thread);
  /// 7: out of range; 1: not running.
  int16_t Pause(int thread);
  /// Executes one statement of a stopped or paused thread, which is paused afterwards unless it
  /// finished. 7: out of range; 1: not bound, running, or unable to step (delayed, waiting).
  int16_t Step(int thread);
  /// Runs until just before a statement of `line`, then pauses. 7: out of range, or the function
  /// has no statement on that line; 1: as Run().
  int16_t RunToBreakpoint(int thread, int line);
  /// Starts the function every `period_cycles` cycles, beginning now. 7: out of range; 1: not
  /// bound, running or paused, or already periodic.
  int16_t RunPeriodic(int thread, int64_t period_cycles, int16_t priority);

  // --- For commands executed by a thread -------------------------------------------------------

  /// Switches the page of a thread. 7: out of range; 1: another bound thread holds it.
  int16_t SwitchPage(int thread, int page);
  /// Blocks a thread until `cycles` more cycles have begun.
  void Delay(int thread, int64_t cycles);
  /// Blocks a thread until the slot holds `raw`.
  void WaitForValue(int thread, const SlotAddress& slot, int64_t raw);

  // --- Variables -------------------------------------------------------------------------------

  /// The raw content of a slot, interpreted by `slot.type`: an int, or a raw fixed-point number.
  int64_t ReadRaw(const SlotAddress& slot) const;
  void WriteRaw(const SlotAddress& slot, int64_t raw);
  /// The same as a double, exact.
  double Read(const SlotAddress& slot) const;
  /// Stores a host's value, truncated toward zero. Returns false, and stores nothing, if the value
  /// does not fit the slot's type.
  bool Write(const SlotAddress& slot, double value);

  // --- Execution -------------------------------------------------------------------------------

  /// Sets a policy and resets its state.
  void SetPolicy(const Policy& policy);
  /// Executes up to `budget` statements in the policy's order. Returns how many; `last_stop()` says
  /// why it returned.
  int64_t Execute(int64_t budget);
  Stop last_stop() const { return last_stop_; }
  /// Executes one statement of a running thread, independent of the policy. False if it cannot run
  /// now.
  bool ExecuteOne(int thread);
  /// Bit n: thread n could execute a statement now.
  uint32_t RunnableThreads() const;
  /// The thread whose statement Execute() would execute next; -1: none.
  int NextThread() const;
  /// Advances the clock to a cycle (never backwards): wakes delayed threads, starts periodic ones.
  void BeginCycle(int64_t cycle);
  /// From now on calls `observer` when a periodic thread has to start anew and still runs, before
  /// that is counted; an empty function ends this. It must not change the machine.
  void ObserveOverruns(std::function<void(int thread)> observer) {
    overrun_observer_ = std::move(observer);
  }
  /// Cycles from now on in which no thread can run, as long as nothing else writes variables;
  /// INT64_MAX: for ever.
  int64_t IdleCycles() const;
  /// True when no thread is running: all are unbound, stopped, paused or faulted, and none is
  /// periodic.
  bool Quiet() const;

  // --- Recording -------------------------------------------------------------------------------

  /// Appends what is executed to `recording` until called with nullptr or EndRecording(); it must
  /// exist until then.
  void Record(Recording* recording) { recording_ = recording; }
  /// Ends a recording with a checkpoint of the present state.
  void EndRecording();

  // --- State -----------------------------------------------------------------------------------

  const MachineState& state() const { return *state_; }
  const ThreadState& thread(int index) const { return state_->threads[static_cast<size_t>(index)]; }
  /// Restores a state taken from a virtual machine with the same image.
  void Restore(const MachineState& state);
  /// XXH64 of variables, threads and counters: the whole state except that of the policy and the
  /// number of faults. Equal states have equal hashes on every computer.
  uint64_t Hash() const;
  /// Source line of the current or last instruction of a thread, 0 when unknown.
  int Line(int thread) const;

 private:
  friend Exit CallCommand(Frame& frame, const CallSite& site);

  ThreadState& ThreadAt(int thread) { return state_->threads[static_cast<size_t>(thread)]; }
  const Function& FunctionOf(const ThreadState& thread) const;
  /// True if the thread is in a delay, or waits for a value that its variable does not have.
  bool Blocked(const ThreadState& thread) const;
  /// True if the thread neither sleeps nor waits for a value.
  bool CanContinue(const ThreadState& thread) const;
  /// Sets a bound thread to the first instruction of its function.
  void Start(int thread);
  void PauseAtBreakpoint(ThreadState& thread) const;
  Frame MakeFrame(int thread);
  /// Applies the result of Interpret() to a thread.
  void Settle(const Frame& frame, Exit exit, int64_t executed);
  /// Executes up to `statements` of a thread; returns how many.
  int64_t RunTurn(int thread, int64_t statements);
  /// The same for the only thread that can run, under the one-statement round robin.
  int64_t RunAlone(int thread, int64_t statements);
  /// Ends the threads that have woken up with nothing left to execute, because their last statement
  /// put them to sleep. Returns the threads that can continue.
  uint32_t FinishSleepersAtEnd();
  /// The next turn of a policy among runnable threads.
  Turn NextTurn(SchedulerState& scheduler, uint32_t runnable, int64_t budget) const;
  /// Executes one turn of the policy, or returns why it stops.
  int64_t ExecuteTurn(uint32_t runnable, int64_t budget);
  /// Number of statements until the next checkpoint of a recording or a replay.
  int64_t UntilCheckpoint() const;
  /// Writes the recording's checkpoint, or compares with the replay's. False: the hash differs.
  bool PassCheckpoint();
  void RecordTurn(int thread, int64_t statements);
  /// Threads that take a turn each round: the runnable and those waiting for a value.
  uint32_t RoundMembers() const;
  /// Executes `rounds` whole rounds of the one-statement round robin; returns the number of
  /// statements.
  int64_t ExecuteRounds(uint32_t members, int64_t rounds);

  CommandTable* commands_;
  std::shared_ptr<const Image> image_;
  std::unique_ptr<MachineState> state_;  // large: keep Machine itself movable and small
  uint32_t awake_ = 0;  // bit n: thread n may be running or periodic; the others are neither
  Recording* recording_ = nullptr;
  std::function<void(int)> overrun_observer_;
  std::vector<double> cells_;  // scratch of CallCommand(), kept to avoid allocation
  Stop last_stop_ = Stop::kBudget;
};

}  // namespace oncard::vm
