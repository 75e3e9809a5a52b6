// Runs a test in a process of its own, so that a crash affects neither the other tests nor the
// report. Tested by tests/tools/isolation_test.cc.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "tools/test_report.h"

namespace oncard::tools {

/// The result of `work`, executed in a child process. If the child crashes or ends unexpectedly,
/// this test has failed. If `stop` is set meanwhile, the child gets SIGTERM, and is killed if it
/// does not end soon. To be called while the process has only one thread.
TestOutcome RunIsolated(const std::string& path, const std::function<TestOutcome()>& work,
                        const std::atomic<bool>& stop);

}  // namespace oncard::tools
