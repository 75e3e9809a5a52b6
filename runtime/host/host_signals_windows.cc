#include <windows.h>

#include <atomic>

#include "runtime/host/host_scenario.h"
#include "runtime/host/host_signals.h"

namespace oncard::runtime {
namespace {

std::atomic<bool> watches = false;

/// Called in a thread of its own that Windows starts. The next handler, at last that of Windows,
/// ends the process.
BOOL WINAPI ConcludeBeforeEnd(DWORD /*event*/) {
  if (watches.exchange(false)) ConcludeHost();
  return FALSE;
}

/// Added when the library is loaded: handlers that the host adds later come first.
struct Handler {
  Handler() { ::SetConsoleCtrlHandler(ConcludeBeforeEnd, TRUE); }
  Handler(const Handler&) = delete;
  Handler& operator=(const Handler&) = delete;
  ~Handler() { ::SetConsoleCtrlHandler(ConcludeBeforeEnd, FALSE); }
};
const Handler handler;

}  // namespace

void WatchHostSignals() { watches = true; }

}  // namespace oncard::runtime
