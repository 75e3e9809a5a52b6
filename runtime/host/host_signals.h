// Handles SIGINT, SIGTERM and SIGHUP in a host program: recordings and results are written before
// the process ends. Tested by tests/tools/exec_command_test.cc.
#pragma once

namespace oncard::runtime {

/// From now on these signals end the process after ConcludeHost(), unless the host has its own
/// handler. A separate waiting thread does the work. To be called once per process.
void WatchHostSignals();

}  // namespace oncard::runtime
