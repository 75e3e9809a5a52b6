// In place of host_tests.cc where there is no `oncard exec`. WhyNoHostTests() is beside what is
// said of that command: in absent_commands_windows.cc and absent_commands_wasi.cc.
#include "tools/host_tests.h"

namespace oncard::tools {

HostTestFolder::HostTestFolder() = default;

HostTestFolder::~HostTestFolder() = default;

void RunHostTest(const runtime::Scenario& /*scenario*/, const HostTestOptions& /*options*/,
                 const Invocation& /*invocation*/, TestOutcome* outcome) {
  outcome->skipped = WhyNoHostTests();
}

}  // namespace oncard::tools
