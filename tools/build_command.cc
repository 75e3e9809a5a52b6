// oncard build: compiles motion programs to object pairs.
#include <algorithm>

#include "base/files.h"
#include "tools/commands.h"
#include "tools/compile_arguments.h"
#include "vm/object_writer.h"

namespace oncard::tools {
namespace {

struct BuildOptions {
  std::vector<std::string> sources;
  std::string folder;
  bool vendor_format = false;
  CompileArguments compile;
  std::string diagnostics = "text";
};

int BuildOne(const BuildOptions& options, const std::string& source, const Invocation& invocation) {
  if (source.ends_with(".bin")) {
    return Fail(invocation, kExitUsage,
                MakeMessage("'{0}' is an object: build takes sources",
                            "“{0}”是目标文件：build 需要源文件", source));
  }
  runtime::ProgramLoad load;
  const int code = LoadOrReport(invocation, source, OptionsOf(options.compile),
                                options.diagnostics == "json", &load);
  if (code != kExitOk) return code;
  const compiler::OutputPaths paths = compiler::OutputPathsFor(source, options.folder);
  const vm::ObjectFiles files = vm::WriteObject(*load.object, options.vendor_format);
  const auto written = WritePairAtomically(paths.bin, files.bin, paths.ini, files.ini);
  return written.ok() ? kExitOk : Fail(invocation, kExitUnreadable, written.error().message);
}

int Build(const BuildOptions& options, const Invocation& invocation) {
  if (FileExists(options.folder) && !IsFolder(options.folder)) {
    return Fail(invocation, kExitUsage,
                MakeMessage("'{0}' is a file: -o names the folder of the objects, whose names are "
                            "those of the sources",
                            "“{0}”是文件：-o 给出目标文件所在的文件夹，目标文件与源文件同名",
                            options.folder));
  }
  int code = kExitOk;
  for (const std::string& source : options.sources) {
    code = std::max(code, BuildOne(options, source, invocation));
  }
  return code;
}

}  // namespace

void AddBuild(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<BuildOptions>();
  CLI::App* command = AddCommand(app, invocation, "build",
                                 {"compile programs to .bin and .ini", "把程序编译为 .bin 和 .ini"},
                                 [options, &invocation] { return Build(*options, invocation); });
  command
      ->add_option("sources", options->sources,
                   invocation.Say({"motion programs (.c)", "运动程序（.c）"}))
      ->required()
      ->type_name("FILE");
  command
      ->add_option("-o,--output", options->folder,
                   invocation.Say({"folder of the objects (default: beside each source)",
                                   "目标文件所在文件夹（默认与源文件相同）"}))
      ->type_name("DIR");
  command->add_flag(
      "--vendor-format", options->vendor_format,
      invocation.Say({"omit the section [oncard] of the .ini, as the vendor's compiler does",
                      ".ini 中不写本工具的节，与原厂编译器一致"}));
  AddCompileOptions(*command, invocation, options->compile);
  AddDiagnosticsOption(*command, invocation, options->diagnostics);
}

}  // namespace oncard::tools
