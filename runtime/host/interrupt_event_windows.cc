// Events of the host are those of Windows.
#include <windows.h>

#include "runtime/host/host_interrupts.h"
#include "runtime/host/host_threads_windows.h"

namespace oncard::runtime {
namespace {

class WindowsEvent final : public InterruptEvent {
 public:
  /// Takes ownership of the handle.
  explicit WindowsEvent(HANDLE event) : event_(event) {}
  WindowsEvent(const WindowsEvent&) = delete;
  WindowsEvent& operator=(const WindowsEvent&) = delete;
  ~WindowsEvent() override { ::CloseHandle(event_); }

  void Set() override {
    ::SetEvent(event_);
    handle_word.Change();
  }

 private:
  HANDLE event_;
};

/// Only ntdll.dll can tell an event from other objects.
bool IsEvent(HANDLE handle) {
  using QueryEvent = LONG WINAPI(HANDLE, int, void*, ULONG, ULONG*);
  const auto query = reinterpret_cast<QueryEvent*>(
      reinterpret_cast<void*>(::GetProcAddress(::GetModuleHandleA("ntdll.dll"), "NtQueryEvent")));
  LONG basic[2] = {};
  return query == nullptr || query(handle, 0, basic, sizeof basic, nullptr) >= 0;
}

}  // namespace

std::shared_ptr<InterruptEvent> InterruptEventOf(void* handle) {
  HANDLE own = nullptr;
  const HANDLE process = ::GetCurrentProcess();
  if (!IsEvent(handle) ||
      ::DuplicateHandle(process, handle, process, &own, 0, FALSE, DUPLICATE_SAME_ACCESS) == 0) {
    return nullptr;
  }
  return std::make_shared<WindowsEvent>(own);
}

}  // namespace oncard::runtime
