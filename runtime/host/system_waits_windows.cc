#include "runtime/host/system_waits.h"

#include <windows.h>

#include <algorithm>
#include <array>

namespace oncard::runtime {
namespace {

/// Windows 7 has no waits for words. Those who wait for one stand in the queue of its address, with
/// others whose words have the same queue.
struct Queue {
  SRWLOCK lock = SRWLOCK_INIT;
  CONDITION_VARIABLE changed = CONDITION_VARIABLE_INIT;
};
constinit std::array<Queue, 64> queues;

Queue& QueueOf(const std::atomic<int>* word) {
  return queues[reinterpret_cast<uintptr_t>(word) / sizeof *word % queues.size()];
}

/// At least a millisecond, which is what Windows counts in.
DWORD MillisecondsOf(int64_t ns) {
  constexpr int64_t kNsPerMs = 1'000'000;
  return static_cast<DWORD>(std::clamp<int64_t>(ns / kNsPerMs, 1, INFINITE - 1));
}

void WaitInQueue(const std::atomic<int>* word, int seen, DWORD at_most_ms) {
  Queue& queue = QueueOf(word);
  ::AcquireSRWLockExclusive(&queue.lock);
  if (*word == seen) ::SleepConditionVariableSRW(&queue.changed, &queue.lock, at_most_ms, 0);
  ::ReleaseSRWLockExclusive(&queue.lock);
}

}  // namespace

void RealSleep(int64_t ns) { ::Sleep(MillisecondsOf(ns)); }

void WaitFor(std::atomic<int>* word, int seen) { WaitInQueue(word, seen, INFINITE); }

void WaitFor(std::atomic<int>* word, int seen, int64_t at_most_ns) {
  WaitInQueue(word, seen, MillisecondsOf(at_most_ns));
}

void WakeAll(std::atomic<int>* word) {
  Queue& queue = QueueOf(word);
  // Who has seen the old word waits by now.
  ::AcquireSRWLockExclusive(&queue.lock);
  ::ReleaseSRWLockExclusive(&queue.lock);
  ::WakeAllConditionVariable(&queue.changed);
}

// A thread of a DLL would have to end before the host can unload it, which nobody could wait for.
bool StartOwnThread(pthread_t* /*thread*/, void* (* /*function*/)(void*), void* /*argument*/) {
  return false;
}

}  // namespace oncard::runtime
