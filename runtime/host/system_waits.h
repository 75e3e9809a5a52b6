// How threads wait, past the functions of the C library: `oncard exec` replaces these for a host by
// functions that lead back to virtual time. Thread-safe.
#pragma once

#include <pthread.h>

#include <atomic>
#include <cstdint>

namespace oncard::runtime {

/// Sleeps in real time.
void RealSleep(int64_t ns);

/// Sleeps while the word has the value that was `seen`, until WakeAll(); may return earlier.
void WaitFor(std::atomic<int>* word, int seen);
/// The same, at most for this real time.
void WaitFor(std::atomic<int>* word, int seen, int64_t at_most_ns);
/// Wakes all who wait for the word, which has been changed before.
void WakeAll(std::atomic<int>* word);

/// Starts a thread of the library, which receives none of the host's signals. False if that is
/// impossible.
bool StartOwnThread(pthread_t* thread, void* (*function)(void*), void* argument);

}  // namespace oncard::runtime
