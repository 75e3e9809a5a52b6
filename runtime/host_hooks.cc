#include "runtime/host_hooks.h"

#include "runtime/host_keys.h"
#include "runtime/host_scenario.h"
#include "runtime/host_time.h"

#define ONCARD_EXPORT extern "C" __attribute__((visibility("default")))

ONCARD_EXPORT int oncard_host_virtual() { return oncard::runtime::HostTimeIsVirtual() ? 1 : 0; }

ONCARD_EXPORT long long oncard_host_time_ns() { return oncard::runtime::LookAtHostTimeNs(); }

ONCARD_EXPORT void oncard_host_sleep_ns(long long duration_ns) {
  oncard::runtime::SleepHostNs(duration_ns);
}

ONCARD_EXPORT int oncard_host_kbhit() {
  return oncard::runtime::HostKeys::OfProcess().Hit() ? 1 : 0;
}

ONCARD_EXPORT int oncard_host_getch() { return oncard::runtime::HostKeys::OfProcess().Read(); }

namespace {

/// Runs when the host has ended, after its own destructors.
__attribute__((destructor)) void JudgeHost() { oncard::runtime::FinishHost(); }

}  // namespace
