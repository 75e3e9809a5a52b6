// In place of exec_command.cc and serve_command.cc in WebAssembly: what to use instead.
#include "tools/absent_command.h"
#include "tools/host_tests.h"

namespace oncard::tools {

void AddExec(CLI::App& app, Invocation& invocation) {
  AddAbsentCommand(
      app, invocation, "exec",
      {"run a host program in virtual time (not in the oncard of npm)",
       "以虚拟时间运行主机程序（npm 版 oncard 不含）"},
      {"'exec' needs an installed oncard: its package on Linux, or gts.dll beside the host "
       "on Windows",
       "“exec”需要安装的 oncard：Linux 上安装其软件包，Windows 上把 gts.dll 放在主机程序旁"});
}

void AddServe(CLI::App& app, Invocation& invocation) {
  AddAbsentCommand(
      app, invocation, "serve",
      {"show the playground on this computer (not in the oncard of npm)",
       "在本机显示练习页面（npm 版 oncard 不含）"},
      {"'serve' needs an installed oncard; the playground also runs as a page without it: "
       "docs/playground.md",
       "“serve”需要安装的 oncard；练习页面也可不经它单独使用：docs/playground.md"});
}

Message WhyNoHostTests() {
  return {"skipped: host programs need an installed oncard, this is that of npm",
          "已跳过：主机程序需要安装的 oncard，此处为 npm 版本"};
}

}  // namespace oncard::tools
