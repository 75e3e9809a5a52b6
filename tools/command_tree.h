// The command line as plain data, read back from CLI11's description of it: the one source of the
// manual page and of the shell completions.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace oncard::tools {

struct OptionText {
  std::vector<std::string> names;  ///< with dashes, short ones first; a positional's own name
  std::string type;                ///< the name of its value; empty for a flag
  std::string description;
  bool positional = false;
  bool required = false;
};

struct CommandText {
  std::string name;
  std::string description;
  std::vector<OptionText> options;
};

/// The root (its name is the program's) followed by every subcommand that is not hidden.
std::vector<CommandText> ReadCommandTree(const CLI::App& app);

/// Completion script for `bash`, `zsh` or `fish`.
std::string FormatCompletion(const std::vector<CommandText>& tree, const std::string& shell);

/// The manual page oncard(1), in roff.
std::string FormatManualPage(const std::vector<CommandText>& tree);

}  // namespace oncard::tools
