// Signals of a host and its calls of a host library. A handler may call the card, as an emergency
// stop does, and read clocks; it must not find the library's locks held by the thread that it has
// interrupted. So a signal that arrives during a call waits until the call is over
// (held_signals.h), and a sleep ends early for it, as a sleep of the operating system does. Where
// a signal cannot wait, because it reports a fault or because its handler was installed without the
// library, a call that finds its thread inside another one is refused.
//
// Every function that takes a lock of the library for a host opens a CallScope before.
// Tested by tests/tools/exec_signals_test.cc.
#pragma once

#include <atomic>
#include <csignal>
#include <cstdint>

namespace oncard::runtime {

/// What a thread is doing, for the signals that interrupt it. Never allocated in a handler.
struct CallState {
  volatile std::sig_atomic_t depth = 0;  ///< open scopes
  volatile std::sig_atomic_t waits = 0;  ///< with a deadline, outside of scopes (virtual_time.h)
  volatile uint64_t held = 0;            ///< bit n: signal n + 1 waits
  /// A futex on which the thread sleeps, if a signal shall wake it.
  std::atomic<int>* volatile asleep_on = nullptr;
};

#define ONCARD_CALL_STATE __attribute__((tls_model("initial-exec")))
extern constinit thread_local CallState call_state ONCARD_CALL_STATE;

/// While it exists signals of the thread wait. Its end is where they are handled.
class CallScope {
 public:
  CallScope() { Begin(); }
  CallScope(const CallScope&) = delete;
  CallScope& operator=(const CallScope&) = delete;
  ~CallScope() { End(); }

  /// A scope that is no block of a function.
  static void Begin() {
    call_state.depth = call_state.depth + 1;
    std::atomic_signal_fence(std::memory_order_seq_cst);
  }
  static void End() {
    std::atomic_signal_fence(std::memory_order_seq_cst);
    call_state.depth = call_state.depth - 1;
    if (call_state.depth == 0 && call_state.held != 0) Deliver();
  }

  /// True in a handler that has interrupted a call of its thread: locks may be held.
  static bool Interrupts() { return call_state.depth > 1; }
  /// True if a signal waits for the end of the call.
  static bool HoldsSignal() { return call_state.held != 0; }

 private:
  static void Deliver();
};

/// While it exists a held signal changes the word, so that a wait for the futex returns.
class WakingSignals {
 public:
  explicit WakingSignals(std::atomic<int>* word) { call_state.asleep_on = word; }
  WakingSignals(const WakingSignals&) = delete;
  WakingSignals& operator=(const WakingSignals&) = delete;
  ~WakingSignals() { call_state.asleep_on = nullptr; }
};

}  // namespace oncard::runtime
