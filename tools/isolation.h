// Runs tests in processes of their own, several at a time, so that a crash or an endless test
// affects neither the others nor the report: isolation.cc on Linux, isolation_windows.cc on
// Windows, isolation_wasi.cc in WebAssembly, which has threads instead. Tested by
// tests/tools/isolation_test.cc.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "tools/test_report.h"

namespace oncard::tools {

/// What is reported of a test if its work gives no outcome, and the work.
struct IsolatedTest {
  TestOutcome named;
  std::function<TestOutcome()> work;
};

struct IsolationOptions {
  /// Number of processes at the same time.
  int jobs = 1;
  /// Seconds of the wall clock after which a test is killed and has failed; 0: never.
  int timeout_s = 0;
};

/// How many tests this computer runs at the same time at best; 0: it does not say
/// (processor_count.cc, processor_count_wasi.cc).
int ProcessorCount();

/// The outcomes in the order of the tests. Each child is the leader of a process group of its own,
/// with which it is stopped or killed, and dies with the caller. A child that crashes or ends
/// unexpectedly has failed. If `stop` is set meanwhile, children get SIGTERM, and are killed if
/// they do not end soon; tests that have not begun are not run. To be called while the process has
/// only one thread.
std::vector<TestOutcome> RunIsolated(const std::vector<IsolatedTest>& tests,
                                     const IsolationOptions& options,
                                     const std::atomic<bool>& stop);

}  // namespace oncard::tools
