// Threads of motion programs: bind, run, stop, pause, step, and their state.
// Source: GTS manual 10.3 and chapter 13; the public header for the thread extensions.
// Tested by tests/gtcalls/thread_command_test.cc.
#include <algorithm>

#include "gtcalls/gts/commands/commands.h"

namespace oncard::gtcalls::gts {
namespace {

using vm::ThreadRun;
using vm::ThreadState;

/// GT_GetThreadTime reports execution times in milliseconds at this many statements a millisecond
/// (GTS manual 10.2).
constexpr double kStatementsPerMs = 100;

/// TThreadSts.run. Assumption: the manual names only 1.
constexpr int kRunStopped = 0;
constexpr int kRunRunning = 1;
constexpr int kRunPaused = 2;

int RunCode(ThreadRun run) {
  switch (run) {
    case ThreadRun::kRunning:
      return kRunRunning;
    case ThreadRun::kPaused:
      return kRunPaused;
    case ThreadRun::kUnbound:
    case ThreadRun::kStopped:
    case ThreadRun::kFaulted:
      break;
  }
  return kRunStopped;
}

const ThreadState& ThreadStateOf(const Call& call) {
  return call.card.machine.thread(call.integer(0));
}

/// Returns the machine's code; if it is not 0, `before`, the state before the call, gives the
/// reason.
int16_t Answer(Call& call, int16_t code, const ThreadState& before) {
  if (code == vm::kOk) return code;
  return call.Refuse(code, DescribeThread(call.integer(0), before));
}

// --- Binding --------------------------------------------------------------------------------

Message WhyNotBound(const Call& call, int16_t code) {
  const vm::Machine& machine = call.card.machine;
  if (code == vm::kBadParameter) {
    const size_t count = machine.image() == nullptr ? 0 : machine.image()->object.functions.size();
    return MakeMessage("no function has id {0}; the program has {1} functions, numbered from 1",
                       "没有标识为 {0} 的函数；程序有 {1} 个函数，从 1 起编号", call.integer(1),
                       count);
  }
  const ThreadState& state = ThreadStateOf(call);
  if (IsActive(state)) return DescribeThread(call.integer(0), state);
  return DescribeTakenPage(call.integer(2));
}

}  // namespace

int16_t GT_Bind(Call& call) {
  if (const int16_t code = LinkPendingWords(call, call.integer(1)); code != vm::kOk) return code;
  const int16_t code = call.card.machine.Bind(call.integer(0), call.integer(1), call.integer(2));
  return code == vm::kOk ? code : call.Refuse(code, WhyNotBound(call, code));
}

// --- Running --------------------------------------------------------------------------------

int16_t GT_RunThread(Call& call) {
  const ThreadState before = ThreadStateOf(call);
  return Answer(call, call.card.machine.Run(call.integer(0)), before);
}

int16_t GT_StopThread(Call& call) {
  const ThreadState before = ThreadStateOf(call);
  return Answer(call, call.card.machine.StopThread(call.integer(0)), before);
}

int16_t GT_PauseThread(Call& call) {
  const ThreadState before = ThreadStateOf(call);
  return Answer(call, call.card.machine.Pause(call.integer(0)), before);
}

int16_t GT_StepThread(Call& call) {
  const ThreadState before = ThreadStateOf(call);
  const int16_t code = call.card.machine.Step(call.integer(0));
  if (code == vm::kRefused && before.run == ThreadRun::kPaused) {
    return call.Refuse(code, MakeMessage("thread {0} is in a delay or waits for a variable",
                                         "线程 {0} 正在延时或等待变量", call.integer(0)));
  }
  return Answer(call, code, before);
}

int16_t GT_RunThreadToBreakpoint(Call& call) {
  const ThreadState before = ThreadStateOf(call);
  const int16_t code = call.card.machine.RunToBreakpoint(call.integer(0), call.integer(1));
  if (code == vm::kBadParameter) {
    return call.Refuse(code, MakeMessage("the function has no statement on line {0}",
                                         "函数在第 {0} 行没有语句", call.integer(1)));
  }
  return Answer(call, code, before);
}

int16_t GT_RunThreadPeriod(Call& call) {
  const ThreadState before = ThreadStateOf(call);
  const int milliseconds = call.integer(1);
  return Answer(call,
                call.card.machine.RunPeriodic(call.integer(0), CyclesFromMs(call, milliseconds),
                                              static_cast<int16_t>(call.integer(2))),
                before);
}

// --- State ----------------------------------------------------------------------------------

namespace {

double ResultOf(const ThreadState& state) {
  return state.result_type == vm::DataType::kDouble ? vm::DoubleFromFixed(state.result)
                                                    : static_cast<double>(state.result);
}

double MsFromCycles(const Call& call, int64_t cycles) {
  const int64_t whole_ms = cycles * call.card.motion.config().cycle_us / 1000;
  return static_cast<double>(whole_ms);
}

}  // namespace

int16_t GT_GetThreadSts(Call& call) {
  const ThreadState& state = ThreadStateOf(call);
  call.Set(1, RunCode(state.run), 0);
  call.Set(1, state.error, 1);
  call.Set(1, ResultOf(state), 2);
  call.Set(1, call.card.machine.Line(call.integer(0)), 3);
  return vm::kOk;
}

int16_t GT_GetThreadTime(Call& call) {
  const ThreadState& state = ThreadStateOf(call);
  call.Set(1, MsFromCycles(call, state.period_cycles));
  call.Set(2, static_cast<double>(state.executed) / kStatementsPerMs);
  call.Set(3, static_cast<double>(state.executed_max) / kStatementsPerMs);
  return vm::kOk;
}

/// TThreadStatus. Assumption: the public header only gives the names of the members. `address` has
/// no counterpart here and is 0, `link` says whether the thread is bound, `count` counts overruns
/// of a periodic thread.
int16_t GT_GetThread(Call& call) {
  const ThreadState& state = ThreadStateOf(call);
  const vm::Machine& machine = call.card.machine;
  const bool bound = state.run != ThreadRun::kUnbound;
  const size_t size =
      bound ? machine.image()->object.functions[state.function].instructions.size() : 0;
  const int64_t delay = std::max<int64_t>(0, state.wake_cycle - machine.state().cycle);
  size_t cell = 0;
  const auto put = [&](double value) { call.Set(1, value, cell++); };
  put(bound ? 1 : 0);                     // link
  put(0);                                 // address
  put(static_cast<double>(size));         // size, in instructions
  put(bound ? state.page : 0);            // page
  put(MsFromCycles(call, delay));         // delay, in ms
  put(state.priority);                    // priority
  put(state.pc);                          // ptr
  put(RunCode(state.run));                // status
  put(state.error);                       // error
  for (int word = 0; word < 4; ++word) {  // result, low word first
    put(static_cast<int16_t>(state.result >> (16 * word)));
  }
  put(static_cast<int>(state.result_type));                                 // resultType
  put(state.breakpoint_line);                                               // breakpoint
  put(MsFromCycles(call, state.period_cycles));                             // period, in ms
  put(static_cast<int16_t>(std::min<int64_t>(state.overruns, INT16_MAX)));  // count
  put(bound ? state.function + 1 : 0);                                      // function, its id
  return vm::kOk;
}

Message DescribeThread(int thread, const vm::ThreadState& state) {
  switch (state.run) {
    case ThreadRun::kUnbound:
      return MakeMessage("thread {0} is not bound; call GT_Bind first",
                         "线程 {0} 未绑定；应先调用 GT_Bind", thread);
    case ThreadRun::kStopped:
      if (state.period_cycles > 0) {
        return MakeMessage("thread {0} is started periodically; call GT_StopThread first",
                           "线程 {0} 正在周期运行；应先调用 GT_StopThread", thread);
      }
      return MakeMessage("thread {0} is stopped; call GT_RunThread first",
                         "线程 {0} 已停止；应先调用 GT_RunThread", thread);
    case ThreadRun::kRunning:
      return MakeMessage("thread {0} is running; call GT_StopThread or GT_PauseThread first",
                         "线程 {0} 正在运行；应先调用 GT_StopThread 或 GT_PauseThread", thread);
    case ThreadRun::kPaused:
      return MakeMessage("thread {0} is paused; call GT_RunThread or GT_StopThread first",
                         "线程 {0} 已暂停；应先调用 GT_RunThread 或 GT_StopThread", thread);
    case ThreadRun::kFaulted:
      break;
  }
  return MakeMessage("thread {0} stopped with fault {1}; call GT_RunThread to start it again",
                     "线程 {0} 因故障 {1} 停止；可调用 GT_RunThread 重新启动", thread, state.error);
}

Message DescribeTakenPage(int page) {
  return MakeMessage("data page {0} belongs to another bound thread; choose another page",
                     "数据页 {0} 已属于另一个已绑定的线程；应选择其他数据页", page);
}

}  // namespace oncard::gtcalls::gts
