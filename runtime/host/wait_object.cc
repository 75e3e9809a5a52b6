#include "runtime/host/wait_object.h"

#include <algorithm>
#include <map>
#include <utility>

#include "runtime/host/call_scope.h"
#include "runtime/host/host_clock.h"
#include "runtime/host/host_time.h"
#include "runtime/host/system_waits.h"
#include "runtime/host/virtual_time.h"

namespace oncard::runtime {

// --- Objects -------------------------------------------------------------------------------------

bool WaitObject::Take() {
  const std::lock_guard lock(mutex_);
  if (!is_set_) return false;
  is_set_ = kind_ != Kind::kAutomaticEvent;
  return true;
}

void WaitObject::Set() {
  {
    const std::lock_guard lock(mutex_);
    is_set_ = true;
    ++changes_;
  }
  if (HostTimeIsVirtual()) {
    VirtualTime::OfProcess().Wake(changes_, kind_ != Kind::kAutomaticEvent);
  } else {
    WakeAll(&changes_);
  }
}

void WaitObject::Reset() {
  const std::lock_guard lock(mutex_);
  is_set_ = false;
}

WaitObject::End WaitObject::Wait(int64_t duration_ns) {
  return HostTimeIsVirtual() ? WaitInVirtualTime(duration_ns) : WaitInRealTime(duration_ns);
}

WaitObject::End WaitObject::WaitInVirtualTime(int64_t duration_ns) {
  VirtualTime& time = VirtualTime::OfProcess();
  HostInterrupts::OfProcess().Listen();
  if (duration_ns == 0) {
    const CallScope scope;
    LookAtHostTimeNs();
  }
  const int64_t deadline_ns = duration_ns < 0 ? VirtualTime::kNeverNs : time.After(duration_ns);
  for (;;) {
    HostInterrupts::OfProcess().Come();
    const CallScope scope;
    const int seen = changes_;
    if (Take()) return End::kSet;
    if (time.NowNs() >= deadline_ns) return End::kTimeOut;
    if (time.SleepOn(changes_, seen, deadline_ns) == VirtualTime::Woken::kNever) {
      ReportHopelessWait();
      return End::kFailed;
    }
  }
}

WaitObject::End WaitObject::WaitInRealTime(int64_t duration_ns) {
  const int64_t begin_ns = HostClock::SteadyNanoseconds();
  for (;;) {
    HostInterrupts& interrupts = HostInterrupts::OfProcess();
    interrupts.Come();
    const int seen = changes_;
    if (Take()) return End::kSet;
    int64_t left_ns = INT64_MAX;
    if (duration_ns >= 0) left_ns = duration_ns - (HostClock::SteadyNanoseconds() - begin_ns);
    if (left_ns <= 0) return End::kTimeOut;
    if (interrupts.Awaited()) left_ns = std::min(left_ns, kRealStepNs);
    WaitFor(&changes_, seen, left_ns);
  }
}

// --- Handles -------------------------------------------------------------------------------------

namespace {

struct Handles {
  std::mutex mutex;
  std::map<const void*, std::shared_ptr<WaitObject>> objects;

  static Handles& OfProcess() {
    // Never destroyed: other threads of the host may still wait while the process exits.
    static Handles& handles = *new Handles;
    return handles;
  }
};

}  // namespace

void* OpenHandle(std::shared_ptr<WaitObject> object) {
  Handles& handles = Handles::OfProcess();
  const std::lock_guard lock(handles.mutex);
  void* const handle = object.get();
  handles.objects.emplace(handle, std::move(object));
  return handle;
}

std::shared_ptr<WaitObject> FindObject(const void* handle) {
  Handles& handles = Handles::OfProcess();
  const std::lock_guard lock(handles.mutex);
  const auto found = handles.objects.find(handle);
  return found == handles.objects.end() ? nullptr : found->second;
}

std::shared_ptr<WaitObject> FindEvent(const void* handle) {
  auto object = FindObject(handle);
  return object != nullptr && object->is_event() ? object : nullptr;
}

std::shared_ptr<InterruptEvent> InterruptEventOf(void* handle) { return FindEvent(handle); }

bool CloseHandle(const void* handle) {
  Handles& handles = Handles::OfProcess();
  const std::lock_guard lock(handles.mutex);
  return handles.objects.erase(handle) != 0;
}

}  // namespace oncard::runtime
