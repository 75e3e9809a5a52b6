#include "runtime/host/system_waits.h"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <climits>
#include <csignal>

namespace oncard::runtime {
namespace {

timespec TimeOf(int64_t ns) {
  constexpr int64_t kSecondNs = 1'000'000'000;
  return {static_cast<time_t>(ns / kSecondNs), static_cast<long>(ns % kSecondNs)};
}

}  // namespace

void RealSleep(int64_t ns) {
  const timespec duration = TimeOf(ns);
  ::syscall(SYS_nanosleep, &duration, nullptr);
}

void WaitFor(std::atomic<int>* word, int seen) {
  ::syscall(SYS_futex, word, FUTEX_WAIT_PRIVATE, seen, nullptr);
}

void WaitFor(std::atomic<int>* word, int seen, int64_t at_most_ns) {
  const timespec at_most = TimeOf(at_most_ns);
  ::syscall(SYS_futex, word, FUTEX_WAIT_PRIVATE, seen, &at_most);
}

void WakeAll(std::atomic<int>* word) {
  ::syscall(SYS_futex, word, FUTEX_WAKE_PRIVATE, INT_MAX, nullptr);
}

bool StartOwnThread(pthread_t* thread, void* (*function)(void*), void* argument) {
  sigset_t all;
  sigset_t before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  const bool started = ::pthread_create(thread, nullptr, function, argument) == 0;
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return started;
}

}  // namespace oncard::runtime
