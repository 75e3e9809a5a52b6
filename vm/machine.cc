// The machine's threads, variables, turns and state. The interpreter executes statements
// (interpreter.cc), the policies choose threads (scheduler.cc), and run_ahead.cc executes the
// one-statement round robin faster.
// Tested by tests/vm/machine_test.cc.
#include "vm/machine.h"

#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "vm/handlers.h"
#include "vm/interpreter.h"
#include "vm/thread_words.h"

namespace oncard::vm {
namespace {

bool IsThread(int thread) { return thread >= 0 && thread < kThreadCount; }
uint32_t Bit(int thread) { return uint32_t{1} << thread; }

// Calls `visit(thread)` for each bit of `threads`, in ascending order.
template <typename Visit>
void ForEachThread(uint32_t threads, const Visit& visit) {
  for (; threads != 0; threads &= threads - 1) visit(std::countr_zero(threads));
}

}  // namespace

DataPages& DataPages::operator=(const DataPages& other) {
  for (uint32_t rest = used_ | other.used_; rest != 0; rest &= rest - 1) {
    const auto page = static_cast<size_t>(std::countr_zero(rest));
    pages_[page] = other.pages_[page];
  }
  used_ = other.used_;
  return *this;
}

Machine::Machine(CommandTable* commands)
    : commands_(commands), state_(std::make_unique<MachineState>()) {}

// --- Program -------------------------------------------------------------------------------------

void Machine::Load(std::shared_ptr<const Image> image) {
  const int64_t cycle = state_->cycle;
  const Policy policy = state_->scheduler.policy;
  image_ = std::move(image);
  *state_ = MachineState{};
  awake_ = 0;
  state_->cycle = cycle;
  state_->scheduler = StartPolicy(policy);
}

const Function& Machine::FunctionOf(const ThreadState& thread) const {
  return image_->object.functions[thread.function];
}

// --- Threads -------------------------------------------------------------------------------------

bool Machine::Blocked(const ThreadState& thread) const {
  if (thread.wake_cycle > state_->cycle) return true;
  return thread.waiting && ReadRaw(thread.wait_slot) != thread.wait_value;
}

bool Machine::CanContinue(const ThreadState& thread) const {
  return thread.run == ThreadRun::kRunning && !Blocked(thread);
}

void Machine::Start(int thread) {
  awake_ |= Bit(thread);
  ThreadState& state = ThreadAt(thread);
  state.run = ThreadRun::kRunning;
  state.started = true;
  state.pc = 0;
  state.error = kOk;
  state.result_type = FunctionOf(state).return_type;
  state.result = 0;
  state.fault_value = 0;
  state.fault_limit = 0;
  state.wake_cycle = 0;
  state.waiting = false;
  state.breakpoint_line = 0;
  state.executed = 0;
  if (FunctionOf(state).instructions.empty()) state.run = ThreadRun::kStopped;
}

int16_t Machine::Bind(int thread, int function_id, int page) {
  if (!IsThread(thread) || page < 0 || page >= kPageCount) return kBadParameter;
  if (image_ == nullptr || function_id < 1 ||
      static_cast<size_t>(function_id) > image_->functions.size()) {
    return kBadParameter;
  }
  if (IsActive(ThreadAt(thread))) return kRefused;
  for (int other = 0; other < kThreadCount; ++other) {
    const ThreadState& holder = ThreadAt(other);
    if (other != thread && holder.run != ThreadRun::kUnbound && holder.page == page) {
      return kRefused;
    }
  }
  ThreadAt(thread) = ThreadState{};
  ThreadAt(thread).run = ThreadRun::kStopped;
  ThreadAt(thread).function = static_cast<uint8_t>(function_id - 1);
  ThreadAt(thread).page = static_cast<uint8_t>(page);
  return kOk;
}

int16_t Machine::Run(int thread) {
  if (!IsThread(thread)) return kBadParameter;
  ThreadState& state = ThreadAt(thread);
  switch (state.run) {
    case ThreadRun::kUnbound:
    case ThreadRun::kRunning:
      return kRefused;
    case ThreadRun::kPaused:
      awake_ |= Bit(thread);
      state.run = ThreadRun::kRunning;
      state.breakpoint_line = 0;
      return kOk;
    case ThreadRun::kStopped:
    case ThreadRun::kFaulted:
      break;
  }
  if (state.period_cycles > 0) return kRefused;
  Start(thread);
  return kOk;
}

int16_t Machine::StopThread(int thread) {
  if (!IsThread(thread)) return kBadParameter;
  ThreadState& state = ThreadAt(thread);
  if (state.run == ThreadRun::kUnbound) return kRefused;
  if (state.run != ThreadRun::kFaulted) state.run = ThreadRun::kStopped;
  state.period_cycles = 0;
  state.wake_cycle = 0;
  state.waiting = false;
  return kOk;
}

int16_t Machine::Pause(int thread) {
  if (!IsThread(thread)) return kBadParameter;
  if (ThreadAt(thread).run != ThreadRun::kRunning) return kRefused;
  ThreadAt(thread).run = ThreadRun::kPaused;
  return kOk;
}

int16_t Machine::Step(int thread) {
  if (!IsThread(thread)) return kBadParameter;
  const ThreadState before = ThreadAt(thread);
  if (before.run == ThreadRun::kPaused) {
    awake_ |= Bit(thread);
    ThreadAt(thread).run = ThreadRun::kRunning;
  } else if (const int16_t code = Run(thread); code != kOk) {
    return code;
  }
  if (ThreadAt(thread).run == ThreadRun::kRunning) {
    if (!ExecuteOne(thread)) {
      ThreadAt(thread) = before;
      return kRefused;
    }
    if (ThreadAt(thread).run == ThreadRun::kRunning) ThreadAt(thread).run = ThreadRun::kPaused;
  }
  return kOk;
}

int16_t Machine::RunToBreakpoint(int thread, int line) {
  if (!IsThread(thread)) return kBadParameter;
  ThreadState& state = ThreadAt(thread);
  if (state.run == ThreadRun::kUnbound) return kRefused;
  const auto& lines = FunctionOf(state).lines;
  if (line <= 0 || std::find(lines.begin(), lines.end(), line) == lines.end()) return kBadParameter;
  const bool resumed = state.run == ThreadRun::kPaused;
  if (const int16_t code = Run(thread); code != kOk) return code;
  state.breakpoint_line = static_cast<uint16_t>(line);
  // A thread that was paused at the line continues from it; one that starts there pauses at once.
  if (!resumed) PauseAtBreakpoint(state);
  return kOk;
}

void Machine::PauseAtBreakpoint(ThreadState& thread) const {
  if (thread.run != ThreadRun::kRunning || thread.breakpoint_line == 0) return;
  const auto& lines = FunctionOf(thread).lines;
  if (thread.pc < lines.size() && lines[thread.pc] == thread.breakpoint_line) {
    thread.run = ThreadRun::kPaused;
    thread.breakpoint_line = 0;
  }
}

int16_t Machine::RunPeriodic(int thread, int64_t period_cycles, int16_t priority) {
  if (!IsThread(thread) || period_cycles < 1) return kBadParameter;
  ThreadState& state = ThreadAt(thread);
  if (state.run == ThreadRun::kUnbound || IsActive(state)) return kRefused;
  Start(thread);
  state.period_cycles = period_cycles;
  state.next_start = state_->cycle + period_cycles;
  state.overruns = 0;
  state.executed_max = 0;
  state.priority = priority;
  return kOk;
}

int16_t Machine::SwitchPage(int thread, int page) {
  if (page < 0 || page >= kPageCount) return kBadParameter;
  for (int other = 0; other < kThreadCount; ++other) {
    const ThreadState& holder = ThreadAt(other);
    if (other != thread && holder.run != ThreadRun::kUnbound && holder.page == page) {
      return kRefused;
    }
  }
  ThreadAt(thread).page = static_cast<uint8_t>(page);
  return kOk;
}

void Machine::Delay(int thread, int64_t cycles) {
  ThreadAt(thread).wake_cycle = state_->cycle + cycles;
}

void Machine::WaitForValue(int thread, const SlotAddress& slot, int64_t raw) {
  ThreadState& state = ThreadAt(thread);
  state.waiting = true;
  state.wait_slot = slot;
  state.wait_value = raw;
}

// --- Variables -----------------------------------------------------------------------------------

int64_t Machine::ReadRaw(const SlotAddress& slot) const {
  const int64_t raw = slot.global ? state_->globals[slot.id] : state_->pages[slot.page][slot.id];
  return slot.type == DataType::kDouble ? raw : static_cast<int32_t>(raw);
}

void Machine::WriteRaw(const SlotAddress& slot, int64_t raw) {
  (slot.global ? state_->globals[slot.id] : state_->pages.Use(slot.page)[slot.id]) = raw;
}

double Machine::Read(const SlotAddress& slot) const {
  const int64_t raw = ReadRaw(slot);
  return slot.type == DataType::kDouble ? DoubleFromFixed(raw) : static_cast<double>(raw);
}

bool Machine::Write(const SlotAddress& slot, double value) {
  int64_t raw = 0;
  if (slot.type == DataType::kDouble) {
    const auto format = image_ == nullptr ? DoubleFormat::k32_16 : image_->object.double_format;
    if (!FixedFromDouble(value, format, &raw)) return false;
  } else {
    const double truncated = std::trunc(value);
    if (!(truncated >= INT32_MIN && truncated <= INT32_MAX)) return false;
    raw = static_cast<int64_t>(truncated);
  }
  WriteRaw(slot, raw);
  return true;
}

// --- Execution -----------------------------------------------------------------------------------

void Machine::SetPolicy(const Policy& policy) { state_->scheduler = StartPolicy(policy); }

uint32_t Machine::RunnableThreads() const {
  uint32_t runnable = 0;
  ForEachThread(awake_, [&](int number) {
    if (CanContinue(thread(number))) runnable |= Bit(number);
  });
  return runnable;
}

uint32_t Machine::RoundMembers() const {
  uint32_t members = 0;
  ForEachThread(awake_, [&](int number) {
    const ThreadState& state = thread(number);
    if (state.run == ThreadRun::kRunning && state.wake_cycle <= state_->cycle) {
      members |= Bit(number);
    }
  });
  return members;
}

Frame Machine::MakeFrame(int thread) {
  const ThreadState& state = ThreadAt(thread);
  Frame frame;
  frame.function = &image_->functions[state.function];
  frame.pc = frame.function->code.data() + state.pc;
  frame.elements = frame.function->elements.data();
  frame.bases[kLocalBase] = state_->pages.Use(state.page).data();
  frame.bases[kGlobalBase] = state_->globals.data();
  frame.bases[kConstantBase] = const_cast<int64_t*>(frame.function->constants.data());
  frame.wrap_shift = WrapShift(image_->object.double_format);
  frame.thread = thread;
  frame.machine = this;
  return frame;
}

void Machine::Settle(const Frame& frame, Exit exit, int64_t executed) {
  ThreadState& state = ThreadAt(frame.thread);
  state.pc = static_cast<uint16_t>(frame.pc - frame.function->code.data());
  state.executed += executed;
  state_->executed += executed;
  if (exit == Exit::kFault) {
    ++state_->faults;
    state.run = ThreadRun::kFaulted;
    state.period_cycles = 0;
    state.error = static_cast<int16_t>(frame.fault);
    state.fault_value = frame.fault_value;
    state.fault_limit = frame.fault_limit;
  } else if (exit == Exit::kFinished) {
    state.run = ThreadRun::kStopped;
    // An int is in the low half of a slot.
    state.result =
        state.result_type == DataType::kDouble ? frame.result : static_cast<int32_t>(frame.result);
    state.executed_max = std::max(state.executed_max, state.executed);
  }
}

int64_t Machine::RunTurn(int thread, int64_t statements) {
  ThreadState& state = ThreadAt(thread);
  state.waiting = false;
  state.wake_cycle = 0;
  // A breakpoint is checked after every statement.
  if (state.breakpoint_line != 0) statements = std::min<int64_t>(statements, 1);
  Frame frame = MakeFrame(thread);
  Exit exit = Interpret(frame, statements, Reach::kAll);
  const int64_t executed = statements - frame.left;
  // Reaching the end of the code belongs to the last statement.
  if (exit == Exit::kBudget && frame.pc->op == kEnd) exit = Interpret(frame, 0, Reach::kAll);
  Settle(frame, exit, executed);
  PauseAtBreakpoint(state);
  return executed;
}

uint32_t Machine::FinishSleepersAtEnd() {
  uint32_t runnable = 0;
  ForEachThread(awake_, [&](int thread) {
    const ThreadState& state = ThreadAt(thread);
    if (!IsAwake(state)) awake_ &= ~Bit(thread);
    if (!CanContinue(state)) return;
    const bool slept = state.wake_cycle != 0 || state.waiting;
    if (slept && MakeFrame(thread).pc->op == kEnd) {
      RunTurn(thread, 0);
    } else {
      runnable |= Bit(thread);
    }
  });
  return runnable;
}

bool Machine::ExecuteOne(int thread) {
  if (!IsThread(thread) || !CanContinue(ThreadAt(thread))) return false;
  RecordTurn(thread, RunTurn(thread, 1));
  return true;
}

int64_t Machine::Execute(int64_t budget) {
  int64_t executed = 0;
  last_stop_ = Stop::kBudget;
  const SchedulerState& scheduler = state_->scheduler;
  const bool one_statement_rounds =
      scheduler.policy.kind == PolicyKind::kRoundRobin && scheduler.policy.quantum == 1;
  for (uint32_t runnable = FinishSleepersAtEnd(); executed < budget && last_stop_ == Stop::kBudget;
       runnable = FinishSleepersAtEnd()) {
    const int64_t left = std::min(budget - executed, kInterpretMax);
    if (runnable == 0) {
      last_stop_ = Stop::kIdle;
      break;
    }
    if (one_statement_rounds) {
      const uint32_t members = RoundMembers();
      if (members == runnable && std::has_single_bit(members)) {
        executed += RunAlone(std::countr_zero(members), std::min(left, UntilCheckpoint()));
        continue;
      }
      const int64_t rounds = std::min(left, UntilCheckpoint()) / std::popcount(members);
      // For a few rounds the preparation is not worthwhile.
      constexpr int64_t kRoundsMin = 4;
      if (rounds >= kRoundsMin) {
        const int64_t done = ExecuteRounds(members, rounds);
        executed += done;
        if (done > 0) {
          PassCheckpoint();
          continue;
        }
      }
    }
    executed += ExecuteTurn(runnable, left);
  }
  return executed;
}

int64_t Machine::RunAlone(int thread, int64_t statements) {
  const int64_t executed = RunTurn(thread, statements);
  state_->scheduler.next_thread = (thread + 1) % kThreadCount;
  RecordTurn(thread, executed);
  PassCheckpoint();
  return executed;
}

Turn Machine::NextTurn(SchedulerState& scheduler, uint32_t runnable, int64_t budget) const {
  std::array<int16_t, kThreadCount> priorities{};
  if (scheduler.policy.kind == PolicyKind::kPriority) {
    for (size_t i = 0; i < kThreadCount; ++i) priorities[i] = state_->threads[i].priority;
  }
  return BeginTurn(scheduler, runnable, budget, priorities);
}

int Machine::NextThread() const {
  const uint32_t runnable = RunnableThreads();
  if (runnable == 0) return -1;
  SchedulerState scheduler = state_->scheduler;
  return NextTurn(scheduler, runnable, 1).thread;
}

int64_t Machine::ExecuteTurn(uint32_t runnable, int64_t budget) {
  SchedulerState& scheduler = state_->scheduler;
  const Turn turn = NextTurn(scheduler, runnable, std::min(budget, UntilCheckpoint()));
  if (turn.thread < 0) {
    const bool at_end = scheduler.segment >= scheduler.policy.schedule->segments.size();
    last_stop_ = at_end ? Stop::kScheduleEnd : Stop::kScheduleDiverged;
    return 0;
  }
  const int64_t executed = RunTurn(turn.thread, turn.statements);
  EndTurn(scheduler, turn.thread, executed, !CanContinue(ThreadAt(turn.thread)));
  RecordTurn(turn.thread, executed);
  if (!PassCheckpoint()) last_stop_ = Stop::kScheduleDiverged;
  return executed;
}

void Machine::BeginCycle(int64_t cycle) {
  state_->cycle = std::max(state_->cycle, cycle);
  ForEachThread(awake_, [&](int number) {
    ThreadState& thread = ThreadAt(number);
    if (thread.period_cycles == 0 || thread.next_start > state_->cycle) return;
    if (thread.run == ThreadRun::kStopped) {
      Start(number);
    } else {
      if (overrun_observer_) overrun_observer_(number);
      ++thread.overruns;
    }
    // Starts that were skipped because the clock jumped are not executed later.
    const int64_t missed = (state_->cycle - thread.next_start) / thread.period_cycles;
    thread.overruns += missed;
    thread.next_start += (missed + 1) * thread.period_cycles;
  });
}

int64_t Machine::IdleCycles() const {
  int64_t next = INT64_MAX;
  for (uint32_t rest = awake_; rest != 0; rest &= rest - 1) {
    const ThreadState& state = thread(std::countr_zero(rest));
    if (state.period_cycles != 0) next = std::min(next, state.next_start);
    if (CanContinue(state)) return 0;
    if (state.run == ThreadRun::kRunning && state.wake_cycle > state_->cycle) {
      next = std::min(next, state.wake_cycle);
    }
  }
  return next == INT64_MAX ? next : std::max<int64_t>(0, next - state_->cycle - 1);
}

bool Machine::Quiet() const {
  for (uint32_t rest = awake_; rest != 0; rest &= rest - 1) {
    if (IsAwake(thread(std::countr_zero(rest)))) return false;
  }
  return true;
}

// --- Recording -----------------------------------------------------------------------------------

void Machine::RecordTurn(int thread, int64_t statements) {
  if (recording_ != nullptr && statements > 0) recording_->AddTurn(thread, statements);
}

int64_t Machine::UntilCheckpoint() const {
  const bool replaying = state_->scheduler.policy.kind == PolicyKind::kReplay;
  if (recording_ == nullptr && !replaying) return INT64_MAX;
  return kCheckpointInterval - state_->executed % kCheckpointInterval;
}

bool Machine::PassCheckpoint() {
  if (state_->executed == 0 || state_->executed % kCheckpointInterval != 0) return true;
  if (recording_ != nullptr) {
    auto& checkpoints = recording_->checkpoints;
    if (checkpoints.empty() || checkpoints.back().statement < state_->executed) {
      checkpoints.push_back({state_->executed, Hash()});
    }
  }
  if (state_->scheduler.policy.kind != PolicyKind::kReplay) return true;
  const auto& expected = state_->scheduler.policy.schedule->checkpoints;
  const auto found = std::lower_bound(
      expected.begin(), expected.end(), state_->executed,
      [](const ScheduleCheckpoint& checkpoint, int64_t at) { return checkpoint.statement < at; });
  return found == expected.end() || found->statement != state_->executed || found->hash == Hash();
}

void Machine::EndRecording() {
  const int64_t executed = state_->executed;
  if (executed > 0 && executed % kCheckpointInterval != 0) {
    recording_->checkpoints.push_back({executed, Hash()});
  }
  recording_ = nullptr;
}

// --- State ---------------------------------------------------------------------------------------

void Machine::Restore(const MachineState& state) {
  *state_ = state;
  awake_ = 0;
  for (int number = 0; number < kThreadCount; ++number) {
    if (IsAwake(thread(number))) awake_ |= Bit(number);
  }
}

std::array<int64_t, kThreadWordCount> WordsOf(const ThreadState& thread) {
  return {static_cast<int64_t>(thread.run),
          thread.page,
          thread.function,
          thread.started,
          thread.pc,
          thread.error,
          static_cast<int64_t>(thread.result_type),
          thread.result,
          thread.fault_value,
          thread.fault_limit,
          thread.wake_cycle,
          thread.waiting,
          thread.wait_slot.global,
          thread.wait_slot.page,
          thread.wait_slot.id,
          static_cast<int64_t>(thread.wait_slot.type),
          thread.wait_value,
          thread.breakpoint_line,
          thread.period_cycles,
          thread.next_start,
          thread.overruns,
          thread.priority,
          thread.executed,
          thread.executed_max};
}

uint64_t Machine::Hash() const {
  std::vector<int64_t> words;
  words.reserve(size_t{kThreadCount} * kThreadWordCount + 2);
  for (const ThreadState& thread : state_->threads) {
    const auto of_thread = WordsOf(thread);
    words.insert(words.end(), of_thread.begin(), of_thread.end());
  }
  words.push_back(state_->executed);
  words.push_back(state_->cycle);
  uint64_t hash = 0;
  for (size_t page = 0; page < kPageCount; ++page) {
    hash = XXH64(state_->pages[page].data(), sizeof state_->pages[page], hash);
  }
  hash = XXH64(state_->globals.data(), sizeof state_->globals, hash);
  return XXH64(words.data(), words.size() * sizeof words[0], hash);
}

int Machine::Line(int thread) const {
  const ThreadState& state = state_->threads[static_cast<size_t>(thread)];
  if (image_ == nullptr || state.run == ThreadRun::kUnbound) return 0;
  const auto& lines = FunctionOf(state).lines;
  // A delay or a wait has been executed but is not over: it is still the thread's current
  // statement.
  const bool alive = state.run == ThreadRun::kRunning || state.run == ThreadRun::kPaused;
  const size_t pc = state.pc - size_t{alive && Blocked(state)};
  return pc < lines.size() ? lines[pc] : 0;
}

}  // namespace oncard::vm
