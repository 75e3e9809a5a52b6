// oncard dump: shows the contents of an object.
#include "runtime/sim/controller.h"
#include "tools/commands.h"
#include "vm/disassembler.h"

namespace oncard::tools {
namespace {

struct DumpArguments {
  std::string path;
  bool json = false;
};

int Dump(const DumpArguments& arguments, const Invocation& invocation) {
  runtime::ProgramLoad load;
  const int code = LoadOrReport(invocation, arguments.path, {}, false, &load);
  if (code != kExitOk) return code;
  const runtime::Controller controller;
  PrintResult(arguments.json ? vm::DisassembleJson(*load.object, controller.commands())
                             : vm::Disassemble(*load.object, controller.commands()));
  return kExitOk;
}

}  // namespace

void AddDump(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<DumpArguments>();
  CLI::App* command = AddCommand(
      app, invocation, "dump",
      {"list an object's instructions, words and source lines", "列出目标文件的指令、字和源代码行"},
      [arguments, &invocation] { return Dump(*arguments, invocation); });
  command
      ->add_option("object", arguments->path,
                   invocation.Say({"object (.bin), or a source to be compiled first",
                                   "目标文件（.bin），或先行编译的源文件"}))
      ->required()
      ->type_name("FILE");
  command->add_flag("--json", arguments->json, invocation.Say({"print JSON", "以 JSON 输出"}));
}

}  // namespace oncard::tools
