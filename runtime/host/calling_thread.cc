#include "runtime/host/calling_thread.h"

#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <new>

namespace oncard::runtime {
namespace {

using ProcessNumber = std::atomic<pid_t>;

/// Memory that the kernel clears in every child process; nullptr if it does not know how.
ProcessNumber* MapClearedInChildren() {
  constexpr size_t kSize = sizeof(ProcessNumber);
  void* const page =
      ::mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) return nullptr;
  if (::madvise(page, kSize, MADV_WIPEONFORK) != 0) {
    ::munmap(page, kSize);
    return nullptr;
  }
  return new (page) ProcessNumber(0);
}

/// 0: not asked yet. nullptr: asked each time, also before this is initialised.
ProcessNumber* const known_process = MapClearedInChildren();

/// What a thread knows of itself.
struct OwnNumbers {
  ThreadId thread;
  pid_t process;  ///< in which `thread` was asked
};
// Of the model that is never allocated in a handler of a signal.
constinit thread_local OwnNumbers own __attribute__((tls_model("initial-exec"))) = {0, 0};

}  // namespace

pid_t CallingProcess() {
  if (known_process == nullptr) return ::getpid();
  pid_t process = known_process->load(std::memory_order_relaxed);
  if (process == 0) {
    process = ::getpid();
    known_process->store(process, std::memory_order_relaxed);
  }
  return process;
}

ThreadId CallingThread() {
  const pid_t process = CallingProcess();
  if (own.process != process) {
    own.thread = static_cast<ThreadId>(::syscall(SYS_gettid));
    std::atomic_signal_fence(std::memory_order_seq_cst);
    own.process = process;
  }
  return own.thread;
}

}  // namespace oncard::runtime
