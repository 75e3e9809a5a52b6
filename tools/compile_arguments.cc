#include "tools/compile_arguments.h"

namespace oncard::tools {

void AddCompileOptions(CLI::App& command, const Invocation& invocation, CompileArguments& arguments,
                       bool with_structured) {
  AddIncludeOption(command, invocation, arguments.include_folders);
  AddDoubleOption(command, invocation, arguments.double_format);
  if (with_structured) AddStructuredOption(command, invocation, arguments.structured);
  AddMaxErrorsOption(command, invocation, arguments.max_errors);
  AddWarningOption(command, invocation, arguments.warnings);
}

void AddDiagnosticsOption(CLI::App& command, const Invocation& invocation, std::string& format) {
  command
      .add_option("--diagnostics", format,
                  invocation.Say({"form of the diagnostics: text|json", "诊断格式：text|json"}))
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"text", "json"}).description(""));
}

compiler::Options OptionsOf(const CompileArguments& arguments) {
  compiler::Options options;
  options.double_format = DoubleFormatOf(arguments.double_format);
  options.include_folders = arguments.include_folders;
  options.max_errors = arguments.max_errors;
  options.structured = arguments.structured;
  for (const std::string& warning : arguments.warnings) {
    compiler::ReadWarningOption(warning, &options);
  }
  return options;
}

}  // namespace oncard::tools
