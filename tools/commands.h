// The subcommands. Each Add...() describes one to CLI11 and attaches its action; the action stores
// its exit code in the session. The help, the manual page and the shell completions all come from
// these descriptions.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "tools/session.h"

namespace oncard::tools {

/// The whole command line: root options and all subcommands. The session must outlive the app; its
/// language chooses the language of the help.
void DescribeApp(CLI::App& app, Session& session);

void AddBuild(CLI::App& app, Session& session);
void AddCheck(CLI::App& app, Session& session);
void AddLower(CLI::App& app, Session& session);
void AddExplain(CLI::App& app, Session& session);
void AddRun(CLI::App& app, Session& session);
void AddTest(CLI::App& app, Session& session);
void AddDump(CLI::App& app, Session& session);
void AddVerify(CLI::App& app, Session& session);
void AddExplore(CLI::App& app, Session& session);
void AddReplay(CLI::App& app, Session& session);
void AddDebug(CLI::App& app, Session& session);
void AddExec(CLI::App& app, Session& session);
void AddSchema(CLI::App& app, Session& session);
void AddDoctor(CLI::App& app, Session& session);
/// Hidden commands for packagers.
void AddCompletion(CLI::App& app, Session& session);
void AddMan(CLI::App& app, Session& session);

/// A new subcommand with its one-line description, and the action that returns the exit code.
CLI::App* AddCommand(CLI::App& app, Session& session, const std::string& name,
                     const Message& description, std::function<int()> action);

/// Options that several subcommands have, described once.
CLI::Option* AddIncludeOption(CLI::App& command, const Session& session,
                              std::vector<std::string>& folders);
CLI::Option* AddDoubleOption(CLI::App& command, const Session& session, std::string& format);
CLI::Option* AddStructuredOption(CLI::App& command, const Session& session, bool& structured);
CLI::Option* AddMaxErrorsOption(CLI::App& command, const Session& session, int& count);
/// `-Werror`, `-Wno-NAME`: one value for each, without the W.
CLI::Option* AddWarningOption(CLI::App& command, const Session& session,
                              std::vector<std::string>& warnings);
CLI::Option* AddStrictCommandsOption(CLI::App& command, const Session& session, bool& strict);
CLI::Option* AddFormatOption(CLI::App& command, const Session& session, std::string& format,
                             const std::vector<std::string>& choices);

}  // namespace oncard::tools
