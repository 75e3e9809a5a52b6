// The oncard command: reads language and colour first, because the help texts depend on them; CLI11
// does the rest. CLI11 reports errors by exceptions, which are caught here (system_wasi.cc:
// reported where they are thrown).
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <span>
#include <system_error>

#include "base/nearest.h"
#include "tools/command_tree.h"
#include "tools/commands.h"
#include "tools/out_of_memory.h"
#include "tools/terminal.h"
#include "tools/thrown.h"

namespace oncard::tools {
namespace {

struct CommandLine {
  Invocation invocation;
  CLI::App app;
};

/// The one that is executed.
CommandLine* executed = nullptr;

// The value of `--name=value` or `--name value`; the last one counts.
std::optional<std::string_view> OptionValue(std::span<char*> arguments, std::string_view name) {
  std::optional<std::string_view> value;
  for (size_t i = 1; i < arguments.size(); ++i) {
    std::string_view argument = arguments[i];
    if (argument == "--") break;
    if (!argument.starts_with(name)) continue;
    argument.remove_prefix(name.size());
    if (argument.starts_with('=')) {
      value = argument.substr(1);
    } else if (argument.empty() && i + 1 < arguments.size()) {
      value = arguments[i + 1];
    }
  }
  return value;
}

bool UseColor(std::string_view when) {
  if (when == "always") return true;
  if (when == "never") return false;
  // https://no-color.org: set and not empty.
  const char* no_color = std::getenv("NO_COLOR");
  if (no_color != nullptr && *no_color != '\0') return false;
  return ErrorsHaveColors();
}

// Its name is that of the command.
bool IsExtras(const CLI::ParseError& error) {
  return error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
}

Message DescribeMistake(const CLI::ParseError& error) {
  const std::string name = error.get_name();
  std::string_view kind = "命令行有误";
  if (IsExtras(error)) kind = "多余的参数";
  if (name == "RequiredError") kind = "缺少必需的参数";
  if (name == "ValidationError" || name == "ConversionError") kind = "参数值不合法";
  if (name == "ArgumentMismatch") kind = "参数个数不对";
  return {error.what(), fmt::format("{}：{}", kind, error.what())};
}

// Suggests commands similar to an unknown word.
Message DescribeUnknownCommand(const CLI::App& app, const std::string& word) {
  std::vector<std::string_view> names;
  const std::vector<CommandText> tree = ReadCommandTree(app);
  for (size_t i = 1; i < tree.size(); ++i) names.push_back(tree[i].name);
  const std::string_view near = NearestName(word, names);
  if (near.empty()) return MakeMessage("there is no command '{0}'", "没有命令“{0}”", word);
  return MakeMessage("there is no command '{0}'; did you mean '{1}'?",
                     "没有命令“{0}”；是否为“{1}”？", word, near);
}

// The first word that looks like an option and is none; empty if there is none.
std::string UnknownOption(const CLI::App& app, const CLI::ParseError& error) {
  if (!IsExtras(error) && error.get_name() != "RequiredError") return {};
  std::vector<std::string> words = app.remaining(true);
  const auto word = std::ranges::find_if(
      words, [](const std::string& each) { return each.size() > 1 && each.starts_with('-'); });
  return word == words.end() ? std::string() : word->substr(0, word->find('='));
}

// Suggests options of the command, and those that every command has, similar to an unknown one.
Message DescribeUnknownOption(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  const auto add = [&names](const CLI::App* command) {
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
  };
  for (const CLI::App* chosen : app.get_subcommands()) add(chosen);
  add(&app);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const std::string_view near = NearestName(word, candidates);
  if (near.empty()) return MakeMessage("there is no option '{0}'", "没有选项“{0}”", word);
  return MakeMessage("there is no option '{0}'; did you mean '{1}'?",
                     "没有选项“{0}”；是否为“{1}”？", word, near);
}

Message DescribeWords(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> words = app.remaining();
  if (const std::string option = UnknownOption(app, error); !option.empty()) {
    return DescribeUnknownOption(app, option);
  }
  const bool unknown =
      app.get_subcommands().empty() && !words.empty() && !words.front().starts_with('-');
  return unknown ? DescribeUnknownCommand(app, words.front()) : DescribeMistake(error);
}

int ReportMistake(const CLI::App& app, const CLI::ParseError& error, const Invocation& invocation) {
  std::string command = app.get_name();
  for (const CLI::App* chosen : app.get_subcommands()) command += ' ' + chosen->get_name();
  Fail(invocation, kExitUsage, DescribeWords(app, error));
  PrintDiagnostics(invocation.Say(
      MakeMessage("run '{0} --help' for its usage\n", "运行“{0} --help”查看用法\n", command)));
  return kExitUsage;
}

int Main(int argc, char** argv) {
  const std::span<char*> arguments(argv, static_cast<size_t>(argc));
  static CommandLine line;
  executed = &line;
  Invocation& invocation = line.invocation;
  const auto language = OptionValue(arguments, "--lang");
  invocation.language = language.has_value()
                            ? (*language == "zh" ? Language::kChinese : Language::kEnglish)
                            : LanguageFromEnvironment();
  invocation.color = UseColor(OptionValue(arguments, "--color").value_or("auto"));

  EndWhenOutOfMemory(invocation);
  line.app.name("oncard");
  DescribeApp(line.app, invocation);
  line.app.parse(argc, argv);
  return FinishOutput(invocation, invocation.exit_code);
}

}  // namespace

int ReportThrown(const std::exception& thrown) {
  const auto* const wish = dynamic_cast<const CLI::Success*>(&thrown);
  const auto* const mistake = dynamic_cast<const CLI::ParseError*>(&thrown);
  const auto* const refused = dynamic_cast<const std::system_error*>(&thrown);
  if (wish != nullptr) {  // --help and --version
    executed->app.exit(*wish);
    return FinishOutput(executed->invocation, kExitOk);
  }
  if (mistake != nullptr) {
    const int code = ReportMistake(executed->app, *mistake, executed->invocation);
    return FinishOutput(executed->invocation, code);
  }
  if (refused != nullptr) {
    const int code =
        Fail(executed->invocation, kExitIncomplete,
             MakeMessage("the system refuses what the command needs, such as another thread: {0}",
                         "系统拒绝了该命令所需的资源，例如再启动一个线程：{0}", refused->what()));
    return FinishOutput(executed->invocation, code);
  }
  std::fprintf(stderr, "oncard: internal error: %s\n", thrown.what());
  return kExitInternal;
}

}  // namespace oncard::tools

int main(int argc, char** argv) {
  oncard::tools::PrepareStreams();
  try {
    return oncard::tools::Main(argc, argv);
  } catch (const std::exception& thrown) {
    return oncard::tools::ReportThrown(thrown);
  }
}
