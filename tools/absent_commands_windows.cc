#include "tools/absent_commands.h"
#include "tools/host_tests.h"

namespace oncard::tools {

Message absent::Note() { return {"not on Windows", "Windows 上没有"}; }

Message absent::InsteadOfExec() {
  return {
      "there is no 'exec' on Windows: put gts.dll beside the host, set ONCARD_SCENARIO to the "
      "scenario, and ONCARD_CLOCK, ONCARD_TRACE and others as needed, and start the host",
      "Windows 上没有“exec”：请将 gts.dll 放在主机程序旁，用 ONCARD_SCENARIO 给出场景，按需设置 "
      "ONCARD_CLOCK、ONCARD_TRACE 等变量，再启动主机程序"};
}

Message absent::InsteadOfServe() {
  return {
      "there is no 'serve' on Windows: use the playground with its own engine, or 'oncard "
      "serve' on a computer with Linux, such as WSL",
      "Windows 上没有“serve”：请使用自带引擎的练习页面，或在 Linux（例如 WSL）上运行“oncard "
      "serve”"};
}

Message WhyNoHostTests() {
  return {
      "skipped: on Windows oncard starts no hosts: start it yourself, with gts.dll beside it and "
      "the scenario in the variable ONCARD_SCENARIO",
      "已跳过：Windows 上 oncard 不启动主机程序：请将 gts.dll 放在主机程序旁，用变量 "
      "ONCARD_SCENARIO 给出场景，再自行启动"};
}

}  // namespace oncard::tools
