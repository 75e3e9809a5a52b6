// In place of host_tests.cc on Windows, where there is no `oncard exec`.
#include "tools/host_tests.h"

namespace oncard::tools {

HostTestFolder::HostTestFolder() = default;

HostTestFolder::~HostTestFolder() = default;

Message WhyNoHostTests() {
  return {
      "skipped: on Windows oncard starts no hosts: start it yourself, with gts.dll beside it and "
      "the scenario in the variable ONCARD_SCENARIO",
      "已跳过：Windows 上 oncard 不启动主机程序：请将 gts.dll 放在主机程序旁，用变量 "
      "ONCARD_SCENARIO 给出场景，再自行启动"};
}

void RunHostTest(const runtime::Scenario& /*scenario*/, const HostTestOptions& /*options*/,
                 const Invocation& /*invocation*/, TestOutcome* outcome) {
  outcome->skipped = WhyNoHostTests();
}

}  // namespace oncard::tools
