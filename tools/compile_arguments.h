// The options of the command line with which a source is compiled, for all commands that compile
// one themselves.
#pragma once

#include <string>
#include <vector>

#include "tools/commands.h"

namespace oncard::tools {

struct CompileArguments {
  std::vector<std::string> include_folders;
  std::string double_format = "32.16";
  std::vector<std::string> warnings;
  int max_errors = compiler::Options().max_errors;
  bool structured = false;
};

/// Adds -I, --double, -W and --max-errors, and --structured unless the command reads nothing but
/// structured C.
void AddCompileOptions(CLI::App& command, const Invocation& invocation, CompileArguments& arguments,
                       bool with_structured = true);

/// Adds --diagnostics, for commands whose results are files: `text` or `json`.
void AddDiagnosticsOption(CLI::App& command, const Invocation& invocation, std::string& format);

compiler::Options OptionsOf(const CompileArguments& arguments);

}  // namespace oncard::tools
