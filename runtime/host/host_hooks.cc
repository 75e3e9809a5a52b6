#include "runtime/host/host_hooks.h"

#include "runtime/host/call_scope.h"
#include "runtime/host/host_interrupts.h"
#include "runtime/host/host_keys.h"
#include "runtime/host/host_scenario.h"
#include "runtime/host/host_time.h"
#include "runtime/host/virtual_time.h"

using oncard::runtime::call_state;
using oncard::runtime::CallScope;
using oncard::runtime::HostInterrupts;
using oncard::runtime::VirtualTime;

#define ONCARD_EXPORT extern "C" __attribute__((visibility("default")))

namespace {
/// The number of a wait that a handler begins where it may not take a lock: it ends at once.
constexpr long long kNoWait = -1;
}  // namespace

ONCARD_EXPORT int oncard_host_virtual() { return oncard::runtime::HostTimeIsVirtual() ? 1 : 0; }

// In a handler that has interrupted another call of its thread these take no time and no lock.

ONCARD_EXPORT long long oncard_host_time_ns() {
  long long now_ns = 0;
  {
    const CallScope scope;
    if (CallScope::Interrupts()) return oncard::runtime::HostTimeNs();
    now_ns = oncard::runtime::LookAtHostTimeNs();
  }
  HostInterrupts::OfProcess().Come();
  return now_ns;
}

ONCARD_EXPORT long long oncard_host_sleep_ns(long long duration_ns) {
  {
    const CallScope scope;
    if (CallScope::Interrupts()) return 0;
  }
  const long long left_ns = oncard::runtime::SleepHostNs(duration_ns);
  const CallScope scope;
  oncard::runtime::LookForEndOfHost();
  return left_ns;
}

ONCARD_EXPORT void oncard_host_wait_begin(long long deadline_ns, oncard_host_wait* wait) {
  const CallScope scope;
  if (CallScope::Interrupts()) {
    *wait = {deadline_ns, kNoWait};
    return;
  }
  call_state.waits = call_state.waits + 1;
  const VirtualTime::Wait begun = VirtualTime::OfProcess().BeginWait(deadline_ns);
  *wait = {begun.deadline_ns, begun.number};
}

ONCARD_EXPORT long long oncard_host_wait_slice_ns(const oncard_host_wait* wait) {
  long long slice_ns = 0;
  {
    const CallScope scope;
    if (wait->number == kNoWait) return 0;
    slice_ns = VirtualTime::OfProcess().NextSliceNs({wait->deadline_ns, wait->number});
  }
  HostInterrupts::OfProcess().Come();
  return slice_ns;
}

ONCARD_EXPORT void oncard_host_wait_end(const oncard_host_wait* wait, int expired) {
  const CallScope scope;
  if (wait->number == kNoWait) return;
  VirtualTime::OfProcess().EndWait({wait->deadline_ns, wait->number}, expired != 0);
  call_state.waits = call_state.waits - 1;
}

ONCARD_EXPORT int oncard_host_kbhit() {
  bool hit = false;
  {
    const CallScope scope;
    if (CallScope::Interrupts()) return 0;
    hit = oncard::runtime::HostKeys::OfProcess().Hit();
  }
  HostInterrupts::OfProcess().Come();
  return hit ? 1 : 0;
}

ONCARD_EXPORT int oncard_host_getch() { return oncard::runtime::HostKeys::OfProcess().Read(); }
