// oncard check: diagnostics only. Text goes to standard error like any diagnostics; JSON and SARIF
// are what was asked for, so they go to standard output.
#include "compiler/diagnostic_printer.h"
#include "tools/commands.h"

namespace oncard::tools {
namespace {

struct CheckOptions {
  std::vector<std::string> sources;
  std::vector<std::string> include_folders;
  std::string double_format = "32.16";
  int max_errors = compiler::Options().max_errors;
  std::string diagnostics = "text";
};

int Check(const CheckOptions& options, const Session& session) {
  const compiler::Options compile = {DoubleFormatOf(options.double_format), options.include_folders,
                                     options.max_errors};
  const compiler::PrintOptions print = {session.language, session.color};
  int code = kExitOk;
  std::vector<compiler::Compilation> compilations;
  for (const std::string& source : options.sources) {
    runtime::ProgramLoad load = runtime::LoadProgram(source, compile);
    if (load.error) {
      code = std::max<int>(code, Fail(session, kExitUnreadable, load.error->message));
    } else if (load.compilation) {
      if (!load.object) code = std::max<int>(code, kExitFailed);
      if (options.diagnostics == "text") {
        PrintDiagnostics(compiler::PrintText(*load.compilation, print));
      } else if (options.diagnostics == "json") {
        PrintResult(compiler::PrintJson(*load.compilation, print));
      }
      compilations.push_back(std::move(*load.compilation));
    } else {
      code = std::max<int>(code, Fail(session, kExitUsage,
                                      MakeMessage("'{0}' is an object: use 'oncard verify'",
                                                  "“{0}”是目标文件：请用“oncard verify”", source)));
    }
  }
  if (options.diagnostics == "sarif") PrintResult(compiler::PrintSarif(compilations, print));
  return code;
}

}  // namespace

void AddCheck(CLI::App& app, Session& session) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = AddCommand(
      app, session, "check",
      {"report what is wrong with programs, write nothing", "检查程序并报告问题，不写任何文件"},
      [options, &session] { return Check(*options, session); });
  command
      ->add_option("sources", options->sources,
                   session.Say({"motion programs (.c)", "运动程序（.c）"}))
      ->required()
      ->type_name("FILE");
  AddIncludeOption(*command, session, options->include_folders);
  AddDoubleOption(*command, session, options->double_format);
  AddMaxErrorsOption(*command, session, options->max_errors);
  command
      ->add_option(
          "--diagnostics,--format", options->diagnostics,
          session.Say({"form of the diagnostics: text|json|sarif", "诊断格式：text|json|sarif"}))
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"text", "json", "sarif"}).description(""));
}

}  // namespace oncard::tools
