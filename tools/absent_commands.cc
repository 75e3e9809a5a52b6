// In place of exec_command.cc and serve_command.cc: the help lists the commands, and each says what
// to use instead.
#include "tools/absent_commands.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "tools/commands.h"

namespace oncard::tools {
namespace {

void AddAbsent(CLI::App& app, Invocation& invocation, const std::string& name, const Message& does,
               const Message& instead) {
  const Message note = absent::Note();
  const auto refuse = [instead, &invocation] { return Fail(invocation, kExitUsage, instead); };
  // Before its arguments are read: whatever they are, the message is the same.
  AddCommand(app, invocation, name,
             {fmt::format("{} ({})", does.en, note.en), fmt::format("{}（{}）", does.zh, note.zh)},
             refuse)
      ->preparse_callback(
          [refuse, &invocation](size_t) { std::exit(FinishOutput(invocation, refuse())); });
}

}  // namespace

void AddExec(CLI::App& app, Invocation& invocation) {
  AddAbsent(app, invocation, "exec",
            {"run a host program in virtual time", "以虚拟时间运行主机程序"},
            absent::InsteadOfExec());
}

void AddServe(CLI::App& app, Invocation& invocation) {
  AddAbsent(app, invocation, "serve",
            {"show the playground on this computer", "在本机显示练习页面"},
            absent::InsteadOfServe());
}

}  // namespace oncard::tools
