// The root of the command line.
#include "tools/commands.h"

#include <fmt/format.h>

namespace oncard::tools {
namespace {

// The Chinese texts of CLI11's own words.
void TranslateLabels(CLI::App& app) {
  const auto formatter = app.get_formatter();
  formatter->label("Usage", "用法");
  formatter->label("OPTIONS", "选项");
  formatter->label("SUBCOMMAND", "子命令");
  formatter->label("SUBCOMMANDS", "子命令");
  formatter->label("Subcommands", "子命令");
  formatter->label("Positionals", "参数");
  formatter->label("POSITIONALS", "参数");
  formatter->label("REQUIRED", "必需");
  app.option_defaults()->group("选项");
}

std::string ExitCodeFooter(const Invocation& invocation) {
  std::string text = invocation.Say({"Exit codes:", "退出码："});
  for (const ExitCodeText& row : kExitCodeTexts) {
    const bool chinese = invocation.language == Language::kChinese;
    text += fmt::format("\n  {} {}", static_cast<int>(row.code),
                        chinese ? row.meaning_zh : row.meaning_en);
  }
  return text;
}

/// -W, which may be given several times; `check` says what is wrong with a value.
CLI::Option* AddW(CLI::App& command, std::vector<std::string>& values, const std::string& help,
                  std::string (*check)(const std::string& value)) {
  return command.add_option("-W", values, help)
      ->type_name("WARNING")
      ->allow_extra_args(false)
      ->check(CLI::Validator([check](const std::string& value) { return check(value); }, ""));
}

}  // namespace

CLI::App* AddCommand(CLI::App& app, Invocation& invocation, const std::string& name,
                     const Message& description, std::function<int()> action) {
  CLI::App* command = app.add_subcommand(name, invocation.Say(description));
  command->fallthrough();
  if (invocation.language == Language::kChinese) command->group("子命令");
  command->set_help_flag("-h,--help", invocation.Say({"print this help", "显示本帮助"}));
  command->callback([&invocation, run = std::move(action)] { invocation.exit_code = run(); });
  return command;
}

CLI::Option* AddIncludeOption(CLI::App& command, const Invocation& invocation,
                              std::vector<std::string>& folders) {
  return command
      .add_option("-I,--include", folders,
                  invocation.Say({"folder searched for #include (repeatable)",
                                  "查找 #include 的文件夹（可重复）"}))
      ->type_name("DIR")
      ->allow_extra_args(false);
}

CLI::Option* AddDoubleOption(CLI::App& command, const Invocation& invocation, std::string& format) {
  return command
      .add_option("--double", format,
                  invocation.Say({"width of the type double: 32.16 (default) or 16.16",
                                  "double 类型的宽度：32.16（默认）或 16.16"}))
      ->type_name("WIDTH")
      ->check(CLI::IsMember({"32.16", "16.16"}).description(""));
}

CLI::Option* AddStructuredOption(CLI::App& command, const Invocation& invocation,
                                 bool& structured) {
  return command.add_flag(
      "--structured", structured,
      invocation.Say({"the program is structured C, even if its first line is not //@ structured",
                      "程序为结构化 C，即使其首行不是 //@ structured"}));
}

CLI::Option* AddMaxErrorsOption(CLI::App& command, const Invocation& invocation, int& count) {
  return command
      .add_option("--max-errors", count,
                  invocation.Say({"stop reporting after N errors; 0 = report all (default 50)",
                                  "报告 N 个错误后停止；0 表示全部报告（默认 50）"}))
      ->type_name("N")
      ->check(CLI::Range(0, 1'000'000).description(""));
}

CLI::Option* AddWarningOption(CLI::App& command, const Invocation& invocation,
                              std::vector<std::string>& warnings) {
  return AddW(
      command, warnings,
      invocation.Say({"-Werror turns warnings into errors, -Wno-NAME switches one off (repeatable)",
                      "-Werror 把警告当作错误，-Wno-名称 不报告某种警告（可重复）"}),
      [](const std::string& value) {
        return compiler::ReadWarningOption(value, nullptr)
                   ? std::string()
                   : "expected error or no-NAME, where NAME is in the brackets of a warning";
      });
}

CLI::Option* AddSilentOption(CLI::App& command, const Invocation& invocation,
                             std::vector<std::string>& silent) {
  return AddW(command, silent,
              invocation.Say({"-Wno-NAME switches a warning about the card off (repeatable)",
                              "-Wno-名称 不报告控制卡的某种警告（可重复）"}),
              [](const std::string& value) {
                if (runtime::ReadSilentWarning(value, nullptr)) return std::string();
                std::vector<std::string_view> names;
                for (const runtime::CardWarningInfo& info : runtime::CardWarningTable()) {
                  names.push_back(info.name);
                }
                return fmt::format("expected no-NAME, where NAME is a warning about the card: {}",
                                   fmt::join(names, ", "));
              });
}

runtime::CardWarnings SilentOf(const std::vector<std::string>& silent) {
  runtime::CardWarnings warnings;
  for (const std::string& name : silent) runtime::ReadSilentWarning(name, &warnings);
  return warnings;
}

CLI::Option* AddStrictCommandsOption(CLI::App& command, const Invocation& invocation,
                                     bool& strict) {
  return command.add_flag(
      "--strict-commands", strict,
      invocation.Say(
          {"fail when a GT command returns a code other than 0, or the card's supervisor "
           "warns (by default warnings)",
           "GT 指令返回值不为 0 或有运行警告时视为失败（默认仅警告）"}));
}

CLI::Option* AddFormatOption(CLI::App& command, const Invocation& invocation, std::string& format,
                             const std::vector<std::string>& choices) {
  const std::string list = fmt::to_string(fmt::join(choices, "|"));
  return command
      .add_option("--format", format,
                  fmt::format("{}: {}", invocation.Say({"output format", "输出格式"}), list))
      ->type_name("FORMAT")
      ->check(CLI::IsMember(choices).description(""));
}

void DescribeApp(CLI::App& app, Invocation& invocation) {
  if (invocation.language == Language::kChinese) TranslateLabels(app);
  app.description(invocation.Say(
      {"write, run and test Googol GTS motion programs", "编写、运行和测试固高 GTS 运动程序"}));
  app.set_help_flag("-h,--help", invocation.Say({"print this help", "显示本帮助"}));
  app.set_version_flag("--version", "oncard " ONCARD_VERSION,
                       invocation.Say({"print the version", "显示版本"}));
  // main() has evaluated these two before the help texts were chosen; here they are only described.
  app.add_option("--lang", invocation.Say({"language of messages: en or zh (default: the locale's)",
                                           "消息语言：en 或 zh（默认取自区域设置）"}))
      ->type_name("LANG")
      ->check(CLI::IsMember({"en", "zh"}).description(""));
  app.add_option("--color", invocation.Say({"colours: auto (default), always or never",
                                            "颜色：auto（默认）、always 或 never"}))
      ->type_name("WHEN")
      ->check(CLI::IsMember({"auto", "always", "never"}).description(""));
  app.require_subcommand(1);
  AddNew(app, invocation);
  AddBuild(app, invocation);
  AddCheck(app, invocation);
  AddLower(app, invocation);
  AddExplain(app, invocation);
  AddRun(app, invocation);
  AddTest(app, invocation);
  AddExplore(app, invocation);
  AddReplay(app, invocation);
  AddDebug(app, invocation);
  AddServe(app, invocation);
  AddDump(app, invocation);
  AddVerify(app, invocation);
  AddExec(app, invocation);
  AddSchema(app, invocation);
  AddEni(app, invocation);
  AddDoctor(app, invocation);
  AddCompletion(app, invocation);
  AddMan(app, invocation);
  // Set after the subcommands are added, because they would inherit it.
  app.footer(ExitCodeFooter(invocation));
}

}  // namespace oncard::tools
