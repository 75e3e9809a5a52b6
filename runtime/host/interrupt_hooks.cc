// The functions of host_hooks.h for hosts whose cards interrupt them: events and threads of
// Windows, and the lock of interrupts of DOS. Tested by tests/families/toy_family_test.cc and
// tests/families/gt400/gt400_family_test.cc.
#include <pthread.h>

#include <atomic>
#include <memory>
#include <utility>

#include "runtime/host/call_scope.h"
#include "runtime/host/host_hooks.h"
#include "runtime/host/host_interrupts.h"
#include "runtime/host/wait_object.h"

using oncard::runtime::CallScope;
using oncard::runtime::HostInterrupts;
using oncard::runtime::WaitObject;

#define ONCARD_EXPORT extern "C" __attribute__((visibility("default")))

ONCARD_EXPORT void* oncard_host_event_new(int automatic, int is_set) {
  const CallScope scope;
  if (CallScope::Interrupts()) return nullptr;
  const auto kind =
      automatic != 0 ? WaitObject::Kind::kAutomaticEvent : WaitObject::Kind::kManualEvent;
  return oncard::runtime::OpenHandle(std::make_shared<WaitObject>(kind, is_set != 0));
}

ONCARD_EXPORT int oncard_host_event_set(void* handle, int is_set) {
  const CallScope scope;
  if (CallScope::Interrupts()) return 0;
  const auto object = oncard::runtime::FindEvent(handle);
  if (object == nullptr) return 0;
  if (is_set != 0) {
    object->Set();
  } else {
    object->Reset();
  }
  return 1;
}

ONCARD_EXPORT int oncard_host_event_wait(void* handle, long long duration_ns) {
  std::shared_ptr<WaitObject> object;
  {
    const CallScope scope;
    if (CallScope::Interrupts()) return -1;
    object = oncard::runtime::FindObject(handle);
  }
  if (object == nullptr) return -1;
  switch (object->Wait(duration_ns)) {
    case WaitObject::End::kSet:
      return 1;
    case WaitObject::End::kTimeOut:
      return 0;
    case WaitObject::End::kFailed:
      break;
  }
  return -1;
}

ONCARD_EXPORT int oncard_host_event_close(void* handle) {
  const CallScope scope;
  if (CallScope::Interrupts()) return 0;
  return oncard::runtime::CloseHandle(handle) ? 1 : 0;
}

// --- Threads -------------------------------------------------------------------------------------

namespace {

/// A thread from its start to its end. Its ends set the object: its own return, and an exit.
struct HostThread {
  unsigned long (*function)(void*);
  void* argument;
  std::shared_ptr<WaitObject> ended;
};

/// The object of the calling thread.
thread_local std::shared_ptr<WaitObject> own_end;

void EndThread() {
  const CallScope scope;
  if (const auto ended = std::exchange(own_end, nullptr)) ended->Set();
}

void* RunThread(void* started) {
  const std::unique_ptr<HostThread> thread(static_cast<HostThread*>(started));
  own_end = thread->ended;
  thread->function(thread->argument);
  EndThread();
  return nullptr;
}

}  // namespace

ONCARD_EXPORT void* oncard_host_thread_new(unsigned long (*function)(void*), void* argument,
                                           unsigned long* number) {
  static std::atomic<unsigned long> threads = 0;
  const CallScope scope;
  if (CallScope::Interrupts()) return nullptr;
  const auto ended = std::make_shared<WaitObject>(WaitObject::Kind::kThread, false);
  auto thread = std::make_unique<HostThread>(HostThread{function, argument, ended});
  pthread_t started{};
  if (::pthread_create(&started, nullptr, RunThread, thread.get()) != 0) return nullptr;
  [[maybe_unused]] const HostThread* const owned_by_itself = thread.release();
  ::pthread_detach(started);
  const unsigned long own_number = ++threads;
  if (number != nullptr) *number = own_number;
  return oncard::runtime::OpenHandle(ended);
}

ONCARD_EXPORT void oncard_host_thread_exit() {
  EndThread();
  ::pthread_exit(nullptr);
}

// --- Interrupts ----------------------------------------------------------------------------------

ONCARD_EXPORT void oncard_host_interrupts(int enabled) {
  if (enabled != 0) {
    HostInterrupts::OfProcess().Enable();
  } else {
    HostInterrupts::OfProcess().Disable();
  }
}
