// oncard completion and oncard man: hidden commands, used by packages and by
// `eval "$(oncard completion bash)"`.
#include "tools/command_tree.h"
#include "tools/commands.h"

namespace oncard::tools {

void AddCompletion(CLI::App& app, Invocation& invocation) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* command = AddCommand(app, invocation, "completion",
                                 {"print a completion script", "输出命令补全脚本"}, [&app, shell] {
                                   PrintResult(FormatCompletion(ReadCommandTree(app), *shell));
                                   return kExitOk;
                                 });
  command->group("");
  command->add_option("shell", *shell, invocation.Say({"bash, zsh or fish", "bash、zsh 或 fish"}))
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}).description(""));
}

void AddMan(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      AddCommand(app, invocation, "man", {"print the manual page", "输出手册页"}, [&app] {
        PrintResult(FormatManualPage(ReadCommandTree(app)));
        return kExitOk;
      });
  command->group("");
}

}  // namespace oncard::tools
