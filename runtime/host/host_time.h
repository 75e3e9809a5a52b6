// The time that a host program goes by: the process's virtual time with ONCARD_CLOCK=virtual,
// otherwise the wall clock. Tested by tests/tools/exec_command_test.cc.
#pragma once

#include <cstdint>

namespace oncard::runtime {

/// What a look at a clock, or at the keyboard, takes of virtual time.
inline constexpr int64_t kLookNs = 1000;

bool HostTimeIsVirtual();
/// Nanoseconds since the library was loaded, after the time that the look takes.
int64_t LookAtHostTimeNs();
/// Sleeps that long. Nothing, or less, is a look at the clock.
void SleepHostNs(int64_t duration_ns);

}  // namespace oncard::runtime
