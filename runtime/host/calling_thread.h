// The numbers of the calling thread and of this process in the operating system. It is asked once
// for each: virtual time needs them several times at every sleep, and a system call takes longer
// than all else that a sleep does.
//
// A child process has numbers of its own from its first instruction on, however it was made; only
// the child of vfork(), which borrows the memory of its parent, sees those of its parent.
//
// Thread-safe, and safe in handlers of signals.
// Tested by tests/runtime/calling_thread_test.cc.
#pragma once

#include <sys/types.h>

namespace oncard::runtime {

/// A thread, by its number in the operating system.
using ThreadId = int;

ThreadId CallingThread();
pid_t CallingProcess();

}  // namespace oncard::runtime
