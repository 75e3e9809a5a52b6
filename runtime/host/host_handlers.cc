// sigaction() and signal() of a host that is linked with a host library: its handlers are entered
// through RunOrHold(), which lets a signal wait while its thread is in a call (call_scope.h). The
// host does not notice: it is told its own handlers. Signals that report a fault never wait.
// Tested by tests/tools/exec_signals_test.cc.
#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <csignal>

#include "runtime/host/held_signals.h"

namespace {

using oncard::runtime::HoldSignal;
using oncard::runtime::SystemSigaction;

constexpr int kSignals = 64;
constexpr int kOnce = static_cast<int>(SA_RESETHAND);

/// The handler of a signal as the host has set it. A handler that reads it never waits: it is
/// replaced by writing the other of two copies.
struct HostAction {
  struct sigaction copies[2];
  std::atomic<unsigned> current;

  const struct sigaction& Get() const { return copies[current.load() % 2]; }
  void Set(const struct sigaction& action) {
    copies[(current.load() + 1) % 2] = action;
    current.fetch_add(1);
  }
};

HostAction actions[kSignals + 1];
std::atomic_flag changing = ATOMIC_FLAG_INIT;

/// Locks the table of actions; no handler of this thread runs meanwhile.
class Changing {
 public:
  Changing() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    while (changing.test_and_set()) {
    }
  }
  Changing(const Changing&) = delete;
  Changing& operator=(const Changing&) = delete;
  ~Changing() {
    changing.clear();
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t before_{};
};

bool CanWait(int number) {
  switch (number) {
    case SIGSEGV:
    case SIGBUS:
    case SIGFPE:
    case SIGILL:
    case SIGTRAP:
    case SIGSYS:
    case SIGABRT:
      return false;
    default:
      return number >= 1 && number <= kSignals;
  }
}

extern "C" void RunOrHold(int number, siginfo_t* info, void* context) {
  if (HoldSignal(number, info, context)) return;
  const struct sigaction action = actions[number].Get();
  if ((action.sa_flags & kOnce) != 0) {
    struct sigaction none {};
    SystemSigaction(number, &none, nullptr);
  }
  if ((action.sa_flags & SA_NODEFER) != 0 && ::sigismember(&action.sa_mask, number) == 0) {
    sigset_t own;
    ::sigemptyset(&own);
    ::sigaddset(&own, number);
    ::pthread_sigmask(SIG_UNBLOCK, &own, nullptr);
  }
  if ((action.sa_flags & SA_SIGINFO) != 0) {
    action.sa_sigaction(number, info, context);
  } else {
    action.sa_handler(number);
  }
}

bool IsCovered(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) != 0 && action.sa_sigaction == RunOrHold;
}

bool IsFunction(const struct sigaction& action) {
  return (action.sa_flags & SA_SIGINFO) != 0 ||
         (action.sa_handler != SIG_DFL && action.sa_handler != SIG_IGN);
}

/// Sets an action, covered if it is a function. The table is locked.
int SetAction(int number, const struct sigaction& wanted, struct sigaction* before) {
  const struct sigaction of_host = actions[number].Get();
  struct sigaction covered = wanted;
  if (IsFunction(wanted)) {
    actions[number].Set(wanted);
    covered.sa_flags = (wanted.sa_flags | SA_SIGINFO) & ~(kOnce | SA_NODEFER);
    covered.sa_sigaction = RunOrHold;
  }
  const int result = SystemSigaction(number, &covered, before);
  if (result != 0) {
    actions[number].Set(of_host);
  } else if (IsCovered(*before)) {
    *before = of_host;
  }
  return result;
}

using Signal = void (*)(int);

/// signal() with these flags.
Signal SetHandler(int number, Signal handler, int flags) {
  struct sigaction wanted {};
  struct sigaction before {};
  wanted.sa_handler = handler;
  wanted.sa_flags = flags;
  return ::sigaction(number, &wanted, &before) == 0 ? before.sa_handler : SIG_ERR;
}

/// In a child of fork() the thread that had locked the table does not exist.
__attribute__((constructor)) void UnlockActionsInChildren() {
  pthread_atfork(nullptr, nullptr, [] { changing.clear(); });
}

}  // namespace

#define ONCARD_EXPORT extern "C" __attribute__((visibility("default")))

ONCARD_EXPORT int sigaction(int number, const struct sigaction* wanted,
                            struct sigaction* before) noexcept {
  if (!CanWait(number)) return SystemSigaction(number, wanted, before);
  const Changing locked;
  struct sigaction found {};
  if (wanted == nullptr) {
    const int result = SystemSigaction(number, nullptr, &found);
    if (result != 0) return result;
    if (IsCovered(found)) found = actions[number].Get();
  } else {
    const int result = SetAction(number, *wanted, &found);
    if (result != 0) return result;
  }
  if (before != nullptr) *before = found;
  return 0;
}

ONCARD_EXPORT Signal signal(int number, Signal handler) noexcept {
  return SetHandler(number, handler, SA_RESTART);
}

/// What the C library calls signal() for programs of plain C or System V.
ONCARD_EXPORT Signal __sysv_signal(int number, Signal handler) noexcept {
  return SetHandler(number, handler, kOnce | SA_NODEFER);
}
