// The subcommands. Each Add...() describes one to CLI11 and attaches its action; the action stores
// its exit code in the invocation. The help, the manual page and the shell completions all come
// from these descriptions.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "runtime/observe/card_warnings.h"
#include "tools/invocation.h"

namespace oncard::tools {

/// The whole command line: root options and all subcommands. The invocation must outlive the app;
/// its language chooses the language of the help.
void DescribeApp(CLI::App& app, Invocation& invocation);

void AddNew(CLI::App& app, Invocation& invocation);
void AddBuild(CLI::App& app, Invocation& invocation);
void AddCheck(CLI::App& app, Invocation& invocation);
void AddLower(CLI::App& app, Invocation& invocation);
void AddExplain(CLI::App& app, Invocation& invocation);
void AddRun(CLI::App& app, Invocation& invocation);
void AddTest(CLI::App& app, Invocation& invocation);
void AddDump(CLI::App& app, Invocation& invocation);
void AddVerify(CLI::App& app, Invocation& invocation);
void AddExplore(CLI::App& app, Invocation& invocation);
void AddReplay(CLI::App& app, Invocation& invocation);
void AddDebug(CLI::App& app, Invocation& invocation);
void AddServe(CLI::App& app, Invocation& invocation);
void AddExec(CLI::App& app, Invocation& invocation);
void AddSchema(CLI::App& app, Invocation& invocation);
void AddEni(CLI::App& app, Invocation& invocation);
void AddDoctor(CLI::App& app, Invocation& invocation);
/// Hidden commands for packagers.
void AddCompletion(CLI::App& app, Invocation& invocation);
void AddMan(CLI::App& app, Invocation& invocation);

/// A new subcommand with its one-line description, and the action that returns the exit code.
CLI::App* AddCommand(CLI::App& app, Invocation& invocation, const std::string& name,
                     const Message& description, std::function<int()> action);

/// Options that several subcommands have, described once.
CLI::Option* AddIncludeOption(CLI::App& command, const Invocation& invocation,
                              std::vector<std::string>& folders);
CLI::Option* AddDoubleOption(CLI::App& command, const Invocation& invocation, std::string& format);
CLI::Option* AddStructuredOption(CLI::App& command, const Invocation& invocation, bool& structured);
CLI::Option* AddMaxErrorsOption(CLI::App& command, const Invocation& invocation, int& count);
/// `-Werror`, `-Wno-NAME`: one value for each, without the W.
CLI::Option* AddWarningOption(CLI::App& command, const Invocation& invocation,
                              std::vector<std::string>& warnings);
/// `-Wno-NAME`: one value for each warning of the supervisor that is switched off, without the W.
CLI::Option* AddSilentOption(CLI::App& command, const Invocation& invocation,
                             std::vector<std::string>& silent);
runtime::CardWarnings SilentOf(const std::vector<std::string>& silent);
CLI::Option* AddStrictCommandsOption(CLI::App& command, const Invocation& invocation, bool& strict);
CLI::Option* AddFormatOption(CLI::App& command, const Invocation& invocation, std::string& format,
                             const std::vector<std::string>& choices);

}  // namespace oncard::tools
