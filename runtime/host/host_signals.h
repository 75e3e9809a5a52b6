// A host program that is told to end by SIGINT, SIGTERM or SIGHUP: what was recorded and found
// until then is written first. Tested by tests/tools/exec_command_test.cc.
#pragma once

namespace oncard::runtime {

/// From now on these signals end the process after ConcludeHost(), where the host itself has no
/// handler for them. The work is done by a thread that waits otherwise. Once per process.
void WatchHostSignals();

}  // namespace oncard::runtime
