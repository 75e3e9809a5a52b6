// A test in a process of its own: whatever becomes of it, the others run and the report is written.
// Tested by tests/tools/isolation_test.cc.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "tools/test_report.h"

namespace oncard::tools {

/// What `work` gives, done in a child process. A child that crashes or ends otherwise is a failure
/// of this test. When `stop` is set meanwhile, the child is told by SIGTERM, and killed when it
/// does not end soon. To be called while the process has one thread.
TestOutcome RunIsolated(const std::string& path, const std::function<TestOutcome()>& work,
                        const std::atomic<bool>& stop);

}  // namespace oncard::tools
