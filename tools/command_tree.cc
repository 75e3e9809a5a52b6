// Tested by tests/tools/report_commands_test.cc.
#include "tools/command_tree.h"

#include <fmt/format.h>

#include "tools/invocation.h"

namespace oncard::tools {
namespace {

CommandText ReadCommand(const CLI::App& app) {
  CommandText command;
  command.name = app.get_name();
  command.description = app.get_description();
  for (const CLI::Option* option : app.get_options()) {
    OptionText text;
    text.positional = option->get_positional();
    if (text.positional) {
      text.names.push_back(option->get_name(true));
    } else {
      for (const std::string& name : option->get_snames()) text.names.push_back("-" + name);
      for (const std::string& name : option->get_lnames()) text.names.push_back("--" + name);
    }
    text.description = option->get_description();
    text.type = option->get_items_expected_max() == 0 ? "" : option->get_type_name();
    text.required = option->get_required();
    command.options.push_back(std::move(text));
  }
  return command;
}

std::vector<std::string> OptionNames(const CommandText& command) {
  std::vector<std::string> names;
  for (const OptionText& option : command.options) {
    if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

// Text for use inside single quotes of a shell.
std::string ShellQuote(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::string FormatBash(const std::vector<CommandText>& tree) {
  std::vector<std::string> commands;
  std::string cases;
  for (size_t i = 1; i < tree.size(); ++i) {
    commands.push_back(tree[i].name);
    cases += fmt::format("    {}) words=\"{}\" ;;\n", tree[i].name,
                         fmt::join(OptionNames(tree[i]), " "));
  }
  return fmt::format(
      "# bash completion for oncard\n"
      "_oncard() {{\n"
      "  local current=\"${{COMP_WORDS[COMP_CWORD]}}\" command=\"\" words=\"\" word\n"
      "  for word in \"${{COMP_WORDS[@]:1:COMP_CWORD-1}}\"; do\n"
      "    if [[ $word != -* ]]; then command=\"$word\"; break; fi\n"
      "  done\n"
      "  case \"$command\" in\n"
      "    \"\") words=\"{} {}\" ;;\n"
      "{}"
      "  esac\n"
      "  if [[ -z $command || $current == -* ]]; then\n"
      "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
      "  fi\n"
      "}}\n"
      "complete -o default -F _oncard oncard\n",
      fmt::join(commands, " "), fmt::join(OptionNames(tree[0]), " "), cases);
}

std::string FormatZsh(const std::vector<CommandText>& tree) {
  std::string commands;
  std::string cases;
  for (size_t i = 1; i < tree.size(); ++i) {
    commands += fmt::format("    {}\n", ShellQuote(tree[i].name + ":" + tree[i].description));
    cases += fmt::format("    {}) options=({}) ;;\n", tree[i].name,
                         fmt::join(OptionNames(tree[i]), " "));
  }
  return fmt::format(
      "#compdef oncard\n"
      "_oncard() {{\n"
      "  local -a commands options\n"
      "  commands=(\n{}  )\n"
      "  if (( CURRENT == 2 )); then\n"
      "    _describe 'command' commands\n"
      "    compadd -- {}\n"
      "    return\n"
      "  fi\n"
      "  case \"$words[2]\" in\n{}"
      "  esac\n"
      "  if [[ $PREFIX == -* ]]; then compadd -a options; else _files; fi\n"
      "}}\n"
      "_oncard \"$@\"\n",
      commands, fmt::join(OptionNames(tree[0]), " "), cases);
}

void AppendFishOptions(std::string& text, const CommandText& command,
                       const std::string& condition) {
  for (const OptionText& option : command.options) {
    if (option.positional) continue;
    text += "complete -c oncard";
    if (!condition.empty()) text += fmt::format(" -n {}", ShellQuote(condition));
    for (const std::string& name : option.names) {
      text += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2))
                                     : fmt::format(" -s {}", name.substr(1));
    }
    if (!option.type.empty()) text += " -r";
    text += fmt::format(" -d {}\n", ShellQuote(option.description));
  }
}

std::string FormatFish(const std::vector<CommandText>& tree) {
  std::string text = "# fish completion for oncard\n";
  AppendFishOptions(text, tree[0], "");
  for (size_t i = 1; i < tree.size(); ++i) {
    text += fmt::format("complete -c oncard -n __fish_use_subcommand -a {} -d {}\n", tree[i].name,
                        ShellQuote(tree[i].description));
    AppendFishOptions(text, tree[i], "__fish_seen_subcommand_from " + tree[i].name);
  }
  return text;
}

// Text of a roff paragraph: hyphens stay hyphens, and no line looks like a request.
std::string Roff(std::string_view text) {
  std::string escaped;
  if (text.starts_with('.') || text.starts_with('\'')) escaped += "\\&";
  for (const char c : text) {
    if (c == '-') {
      escaped += "\\-";
    } else if (c == '\\') {
      escaped += "\\e";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

void AppendRoffOptions(std::string& text, const CommandText& command) {
  for (const OptionText& option : command.options) {
    std::vector<std::string> names;
    for (const std::string& name : option.names) {
      names.push_back(fmt::format("\\fB{}\\fR", Roff(name)));
    }
    text += fmt::format(".TP\n{}", fmt::join(names, ", "));
    if (!option.positional && !option.type.empty()) {
      text += fmt::format(" \\fI{}\\fR", Roff(option.type));
    }
    text += fmt::format("\n{}\n", Roff(option.description));
  }
}

std::string Synopsis(const CommandText& command) {
  std::string text = fmt::format("\\fBoncard {}\\fR [\\fIoptions\\fR]", command.name);
  for (const OptionText& option : command.options) {
    if (!option.positional) continue;
    text += option.required ? fmt::format(" \\fI{}\\fR", option.names[0])
                            : fmt::format(" [\\fI{}\\fR]", option.names[0]);
  }
  return text;
}

}  // namespace

std::vector<CommandText> ReadCommandTree(const CLI::App& app) {
  std::vector<CommandText> tree;
  tree.push_back(ReadCommand(app));
  const auto all = [](const CLI::App*) { return true; };
  for (const CLI::App* command : app.get_subcommands(all)) {
    if (!command->get_group().empty()) tree.push_back(ReadCommand(*command));
  }
  return tree;
}

std::string FormatCompletion(const std::vector<CommandText>& tree, const std::string& shell) {
  if (shell == "zsh") return FormatZsh(tree);
  if (shell == "fish") return FormatFish(tree);
  return FormatBash(tree);
}

std::string FormatManualPage(const std::vector<CommandText>& tree) {
  std::string text =
      fmt::format(".TH ONCARD 1 \"\" \"oncard {}\"\n.SH NAME\noncard \\- {}\n.SH SYNOPSIS\n",
                  ONCARD_VERSION, Roff(tree[0].description));
  for (size_t i = 1; i < tree.size(); ++i) text += fmt::format("{}\n.br\n", Synopsis(tree[i]));
  text += ".SH OPTIONS\n";
  AppendRoffOptions(text, tree[0]);
  text += ".SH COMMANDS\n";
  for (size_t i = 1; i < tree.size(); ++i) {
    text += fmt::format(".SS {}\n{}\n", Synopsis(tree[i]), Roff(tree[i].description));
    AppendRoffOptions(text, tree[i]);
  }
  text += ".SH EXIT STATUS\n";
  for (const ExitCodeText& row : kExitCodeTexts) {
    text += fmt::format(".TP\n{}\n{}\n", static_cast<int>(row.code), Roff(row.meaning_en));
  }
  return text;
}

}  // namespace oncard::tools
