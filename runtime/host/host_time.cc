#include "runtime/host/host_time.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <string_view>
#include <thread>

#include "runtime/host/call_scope.h"
#include "runtime/host/host_clock.h"
#include "runtime/host/host_interrupts.h"
#include "runtime/host/virtual_time.h"

namespace oncard::runtime {
namespace {

enum class TimeKind : uint8_t { kUnread, kReal, kVirtual };
constinit std::atomic<TimeKind> known_time = TimeKind::kUnread;

/// The steady clock is not read in virtual time, where reading a clock takes time.
const int64_t begin_ns = HostTimeIsVirtual() ? 0 : HostClock::SteadyNanoseconds();

/// The sleep of a host whose cards may interrupt it is in steps.
void SleepInRealTime(int64_t duration_ns) {
  HostInterrupts& interrupts = HostInterrupts::OfProcess();
  for (int64_t left_ns = duration_ns; left_ns > 0;) {
    const int64_t before_ns = HostClock::SteadyNanoseconds();
    const int64_t step_ns = interrupts.Awaited() ? std::min(left_ns, kRealStepNs) : left_ns;
    std::this_thread::sleep_for(std::chrono::nanoseconds(step_ns));
    interrupts.Come();
    left_ns -= HostClock::SteadyNanoseconds() - before_ns;
  }
}

}  // namespace

void ReadHostTimeSetting() {
  const char* setting = std::getenv("ONCARD_CLOCK");
  const bool is_virtual = setting != nullptr && std::string_view(setting) == "virtual";
  known_time = is_virtual ? TimeKind::kVirtual : TimeKind::kReal;
}

bool HostTimeIsVirtual() {
  if (known_time == TimeKind::kUnread) ReadHostTimeSetting();
  return known_time == TimeKind::kVirtual;
}

int64_t LookAtHostTimeNs() {
  if (HostTimeIsVirtual()) return VirtualTime::OfProcess().Pass(kLookNs);
  return HostTimeNs();
}

int64_t HostTimeNs() {
  if (HostTimeIsVirtual()) return VirtualTime::OfProcess().NowNs();
  return HostClock::SteadyNanoseconds() - begin_ns;
}

int64_t SleepHostNs(int64_t duration_ns) {
  if (!HostTimeIsVirtual()) {
    SleepInRealTime(duration_ns);
    return 0;
  }
  VirtualTime& time = VirtualTime::OfProcess();
  const int64_t deadline_ns = time.After(duration_ns);
  for (;;) {
    {
      const CallScope scope;
      if (duration_ns <= 0) {
        LookAtHostTimeNs();
      } else {
        const int64_t left_ns = time.SleepUntil(deadline_ns);
        if (CallScope::HoldsSignal()) return left_ns;
      }
    }
    HostInterrupts::OfProcess().Come();
    if (time.NowNs() >= deadline_ns) return 0;
  }
}

}  // namespace oncard::runtime
