#include "runtime/host/host_time.h"

#include <cstdlib>
#include <string_view>
#include <thread>

#include "runtime/host/call_scope.h"
#include "runtime/host/clock.h"
#include "runtime/host/virtual_time.h"

namespace oncard::runtime {
namespace {

/// The steady clock is not read in virtual time, where reading a clock takes time.
const int64_t begin_ns = HostTimeIsVirtual() ? 0 : CardClock::SteadyNanoseconds();

}  // namespace

bool HostTimeIsVirtual() {
  const char* setting = std::getenv("ONCARD_CLOCK");
  return setting != nullptr && std::string_view(setting) == "virtual";
}

int64_t LookAtHostTimeNs() {
  if (HostTimeIsVirtual()) return VirtualTime::OfProcess().Pass(kLookNs);
  return HostTimeNs();
}

int64_t HostTimeNs() {
  if (HostTimeIsVirtual()) return VirtualTime::OfProcess().NowNs();
  return CardClock::SteadyNanoseconds() - begin_ns;
}

int64_t SleepHostNs(int64_t duration_ns) {
  if (!HostTimeIsVirtual()) {
    if (duration_ns > 0) std::this_thread::sleep_for(std::chrono::nanoseconds(duration_ns));
    return 0;
  }
  const CallScope scope;
  if (duration_ns <= 0) {
    LookAtHostTimeNs();
    return 0;
  }
  VirtualTime& time = VirtualTime::OfProcess();
  return time.SleepUntil(time.After(duration_ns));
}

}  // namespace oncard::runtime
