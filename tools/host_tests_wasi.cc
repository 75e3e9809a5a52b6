// In WebAssembly, which can neither compile nor load a host.
#include "tools/host_tests.h"

namespace oncard::tools {

HostTestFolder::HostTestFolder() = default;

HostTestFolder::~HostTestFolder() = default;

Message WhyNoHostTests() {
  return {"skipped: host programs need an installed oncard, this is that of npm",
          "已跳过：主机程序需要安装的 oncard，此处为 npm 版本"};
}

void RunHostTest(const runtime::Scenario& /*scenario*/, const HostTestOptions& /*options*/,
                 const Invocation& /*invocation*/, TestOutcome* /*outcome*/) {}

}  // namespace oncard::tools
