#include <windows.h>

#include "runtime/host/calling_thread.h"

namespace oncard::runtime {

pid_t CallingProcess() { return static_cast<pid_t>(::GetCurrentProcessId()); }

ThreadId CallingThread() { return static_cast<ThreadId>(::GetCurrentThreadId()); }

}  // namespace oncard::runtime
