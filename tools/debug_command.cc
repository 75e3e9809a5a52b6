// oncard debug: the session protocol on standard input and output, for adapters and scripts.
#include <cerrno>
#include <cstdio>
#include <iostream>
#include <string>

#include "tools/commands.h"
#include "tools/project_session.h"

namespace oncard::tools {
namespace {

/// One request a line, until the input ends.
int ServeStandardStreams(const Invocation& invocation) {
  session::SessionHost host = NewProjectSession();
  std::ios::sync_with_stdio(false);
  for (std::string line; std::getline(std::cin, line);) {
    if (line.empty()) continue;
    PrintResult(host.Handle(line));
    if (const int code = FinishOutput(invocation, kExitOk); code != kExitOk) return code;
  }
  return kExitOk;
}

}  // namespace

void AddDebug(CLI::App& app, Invocation& invocation) {
  // The action keeps what the option writes to.
  const auto stdio = std::make_shared<bool>(false);
  CLI::App* command = AddCommand(
      app, invocation, "debug",
      {"step a program forward and back, for editors and scripts (docs/session-protocol.md)",
       "供编辑器和脚本使用：让程序向前、向后单步运行（docs/session-protocol.md）"},
      [stdio, &invocation] { return ServeStandardStreams(invocation); });
  command
      ->add_flag("--stdio", *stdio,
                 invocation.Say({"requests on standard input, one JSON object a line; answers on "
                                 "standard output",
                                 "从标准输入读取请求，每行一个 JSON 对象；回答写到标准输出"}))
      ->required();
}

}  // namespace oncard::tools
