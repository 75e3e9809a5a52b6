// The time that a host program uses: the process's virtual time with ONCARD_CLOCK=virtual,
// otherwise the wall clock. Tested by tests/tools/exec_command_test.cc.
#pragma once

#include <cstdint>

namespace oncard::runtime {

/// The virtual time that reading a clock or the keyboard takes.
inline constexpr int64_t kLookNs = 1000;

/// By ONCARD_CLOCK as the library found it when it was loaded, or as the opening of a card has read
/// it since: the environment is not searched at each sleep, nor in a handler of a signal.
bool HostTimeIsVirtual();
/// Reads ONCARD_CLOCK again.
void ReadHostTimeSetting();
/// Nanoseconds since the library was loaded, after the time that the reading takes.
int64_t LookAtHostTimeNs();
/// The same without taking time; safe in a handler of a signal.
int64_t HostTimeNs();
/// Sleeps for this duration. Zero or less counts as reading the clock. Returns what is left of it
/// if a signal ends the sleep, otherwise 0. To be called outside of a CallScope: with the wall
/// clock handlers of signals run during the sleep, which then goes on.
int64_t SleepHostNs(int64_t duration_ns);

}  // namespace oncard::runtime
