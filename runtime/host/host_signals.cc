#include "runtime/host/host_signals.h"

#include <pthread.h>
#include <sys/eventfd.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdint>

#include "runtime/host/held_signals.h"
#include "runtime/host/host_scenario.h"
#include "runtime/host/system_waits.h"
#include "runtime/host/thread_waits.h"

namespace oncard::runtime {
namespace {

constexpr int kEndSignals[] = {SIGINT, SIGTERM, SIGHUP};

/// The handler writes the number of the signal to it.
int wake_descriptor = -1;
/// A child process of the host inherits the handler, but not the thread. The operating system is
/// asked who is a child: that of vfork() has the memory of its parent.
pid_t watched_process = 0;

extern "C" void WakeWatcher(int signal) {
  if (::getpid() == watched_process) {
    const auto number = static_cast<uint64_t>(signal);
    if (::write(wake_descriptor, &number, sizeof number) > 0) return;
  }
  std::signal(signal, SIG_DFL);
  ::raise(signal);
}

void* Watch(void* /*argument*/) {
  const LeftOutThread watcher;
  uint64_t signal = 0;
  // A direct system call: the C library's functions may be replaced by functions that lead back
  // here.
  while (::syscall(SYS_read, wake_descriptor, &signal, sizeof signal) < 0) {
  }
  ConcludeHost();
  const int number = static_cast<int>(signal);
  std::signal(number, SIG_DFL);
  ::kill(::getpid(), number);
  for (;;) ::pause();
}

bool HasDefaultAction(int signal) {
  struct sigaction action {};
  return SystemSigaction(signal, nullptr, &action) == 0 && (action.sa_flags & SA_SIGINFO) == 0 &&
         action.sa_handler == SIG_DFL;
}

/// The handler is entered at once, also during a call, which may last.
void WatchSignal(int signal) {
  struct sigaction action {};
  action.sa_handler = WakeWatcher;
  action.sa_flags = SA_RESTART;
  SystemSigaction(signal, &action, nullptr);
}

}  // namespace

void WatchHostSignals() {
  static std::atomic<bool> begun = false;
  if (begun.exchange(true)) return;
  wake_descriptor = ::eventfd(0, EFD_CLOEXEC);
  if (wake_descriptor < 0) return;
  watched_process = ::getpid();
  pthread_t thread{};
  if (!StartOwnThread(&thread, Watch, nullptr)) return;
  ::pthread_detach(thread);
  for (const int signal : kEndSignals) {
    if (HasDefaultAction(signal)) WatchSignal(signal);
  }
}

}  // namespace oncard::runtime
