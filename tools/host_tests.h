// Host programs as tests: builds the host of a scenario and runs it under `oncard exec`.
// host_tests.cc does, where there is that command; elsewhere host_tests_absent.cc skips the test.
// Tested by tests/tools/host_tests_test.cc.
#pragma once

#include <string>
#include <vector>

#include "runtime/scenario/file/scenario.h"
#include "tools/invocation.h"
#include "tools/test_report.h"

namespace oncard::tools {

struct HostTestOptions {
  bool strict_commands = false;
  std::vector<std::string> silent;  ///< warnings that are switched off, each as `no-NAME`
  /// Seconds of the wall clock that the compiler and the host may each take; 0: no limit.
  int limit_s = 0;
  /// A folder that the test may make, for the compiled host and its report; empty: none can be
  /// made.
  std::string scratch;
};

/// A new folder for all tests, removed with the object.
class HostTestFolder {
 public:
  HostTestFolder();
  ~HostTestFolder();
  HostTestFolder(const HostTestFolder&) = delete;
  HostTestFolder& operator=(const HostTestFolder&) = delete;

  /// Empty if there is none.
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Why hosts are not tested here; empty if they are.
Message WhyNoHostTests();

/// Adds to `outcome` what became of Scenario::host_program, which runs in the scenario's folder. To
/// be called while the process has only one thread.
void RunHostTest(const runtime::Scenario& scenario, const HostTestOptions& options,
                 const Invocation& invocation, TestOutcome* outcome);

}  // namespace oncard::tools
