#include "tools/absent_commands.h"
#include "tools/host_tests.h"

namespace oncard::tools {

Message absent::Note() { return {"not in the oncard of npm", "npm 版 oncard 不含"}; }

Message absent::InsteadOfExec() {
  return {
      "'exec' needs an installed oncard: its package on Linux, or gts.dll beside the host "
      "on Windows",
      "“exec”需要安装的 oncard：Linux 上安装其软件包，Windows 上把 gts.dll 放在主机程序旁"};
}

Message absent::InsteadOfServe() {
  return {
      "'serve' needs an installed oncard; the playground also runs as a page without it: "
      "docs/playground.md",
      "“serve”需要安装的 oncard；练习页面也可不经它单独使用：docs/playground.md"};
}

Message WhyNoHostTests() {
  return {"skipped: host programs need an installed oncard, this is that of npm",
          "已跳过：主机程序需要安装的 oncard，此处为 npm 版本"};
}

}  // namespace oncard::tools
