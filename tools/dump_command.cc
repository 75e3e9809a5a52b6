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

int Dump(const DumpArguments& arguments, const Session& session) {
  runtime::ProgramLoad load;
  const int code = LoadOrReport(session, arguments.path, {}, false, &load);
  if (code != kExitOk) return code;
  const runtime::Controller controller;
  PrintResult(arguments.json ? vm::DisassembleJson(*load.object, controller.commands())
                             : vm::Disassemble(*load.object, controller.commands()));
  return kExitOk;
}

}  // namespace

void AddDump(CLI::App& app, Session& session) {
  const auto arguments = std::make_shared<DumpArguments>();
  CLI::App* command = AddCommand(
      app, session, "dump",
      {"list an object's instructions, words and source lines", "列出目标文件的指令、字和源代码行"},
      [arguments, &session] { return Dump(*arguments, session); });
  command
      ->add_option("object", arguments->path,
                   session.Say({"object (.bin), or a source to be compiled first",
                                "目标文件（.bin），或先行编译的源文件"}))
      ->required()
      ->type_name("FILE");
  command->add_flag("--json", arguments->json, session.Say({"print JSON", "以 JSON 输出"}));
}

}  // namespace oncard::tools
