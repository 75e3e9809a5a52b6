#include "runtime/host/call_scope.h"

#include <dlfcn.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <bit>
#include <cerrno>

#include "runtime/host/calling_thread.h"
#include "runtime/host/held_signals.h"

namespace oncard::runtime {

constinit thread_local CallState call_state ONCARD_CALL_STATE;

void CallScope::Deliver() {
  sigset_t waiting;
  ::sigemptyset(&waiting);
  for (uint64_t rest = call_state.held; rest != 0; rest &= rest - 1) {
    ::sigaddset(&waiting, std::countr_zero(rest) + 1);
  }
  call_state.held = 0;
  ::pthread_sigmask(SIG_UNBLOCK, &waiting, nullptr);
}

// The signal is sent once more and stays blocked when its handler returns.
bool HoldSignal(int number, siginfo_t* info, void* context) {
  if (call_state.depth == 0) return false;
  const int error = errno;
  ::sigaddset(&static_cast<ucontext_t*>(context)->uc_sigmask, number);
  call_state.held = call_state.held | uint64_t{1} << (number - 1);
  const long process = CallingProcess();
  const long thread = CallingThread();
  if (::syscall(SYS_rt_tgsigqueueinfo, process, thread, number, info) != 0) {
    ::syscall(SYS_tgkill, process, thread, number);
  }
  if (std::atomic<int>* const word = call_state.asleep_on) word->fetch_add(1);
  errno = error;
  return true;
}

int SystemSigaction(int number, const struct sigaction* wanted, struct sigaction* before) {
  static auto* const system =
      reinterpret_cast<decltype(::sigaction)*>(::dlsym(RTLD_NEXT, "sigaction"));
  return system(number, wanted, before);
}

}  // namespace oncard::runtime
