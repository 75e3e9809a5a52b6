// oncard test: runs every scenario in files and folders.
#include <filesystem>

#include "compiler/diagnostic_printer.h"
#include "explore/scenario_exploration.h"
#include "explore/source_comments.h"
#include "runtime/host/call_log.h"
#include "runtime/scenario/requirement_watch.h"
#include "tools/commands.h"
#include "tools/isolation.h"
#include "tools/run_report.h"
#include "tools/stop_signals.h"
#include "tools/test_report.h"

namespace oncard::tools {
namespace {

struct TestArguments {
  std::vector<std::string> paths;
  std::string format = "text";
  bool strict_commands = false;
  bool structured = false;
};

// The ending of scenarios for host programs, which `oncard exec` runs.
constexpr std::string_view kHostScenario = ".host.toml";

// The scenarios in a folder and its subfolders, sorted by path; for a file the file itself.
Result<std::vector<std::string>> FindScenarios(const std::string& path) {
  std::vector<std::string> found;
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) {
    if (!std::filesystem::exists(path, error)) {
      return MakeError(1, "cannot open '{0}': no such file or folder",
                       "无法打开“{0}”：没有该文件或文件夹", path);
    }
    found.push_back(path);
    return found;
  }
  using Iterator = std::filesystem::recursive_directory_iterator;
  for (Iterator entry(path, error); !error && entry != Iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.ends_with(".toml") && !name.ends_with(kHostScenario))
      found.push_back(entry->path().generic_string());
  }
  if (error) {
    return MakeError(1, "cannot read the folder '{0}': {1}", "无法读取文件夹“{0}”：{1}", path,
                     error.message());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// A failed compilation as one message: its diagnostics in the format of `check`.
Message DescribeDiagnostics(const compiler::Compilation& compilation) {
  Message message;
  message.en = compiler::PrintText(compilation, {Language::kEnglish, false});
  message.zh = compiler::PrintText(compilation, {Language::kChinese, false});
  for (std::string* text : {&message.en, &message.zh}) {
    while (text->ends_with('\n')) text->pop_back();
  }
  return message;
}

// Explores instead of running: the verdict must be the one in the scenario.
void ExploreTest(const runtime::Scenario& scenario, const runtime::ProgramLoad& load,
                 bool strict_commands, TestOutcome* outcome) {
  const std::string source = load.compilation ? load.compilation->files[0].text() : std::string();
  auto findings = explore::ExploreAsWished(scenario, *load.object, source);
  if (!findings.ok()) {
    outcome->failures.push_back(findings.error().message);
    return;
  }
  findings.value().source = source;
  for (const runtime::RefusedCommand& refused : findings.value().refused) {
    auto& list = strict_commands ? outcome->failures : outcome->warnings;
    list.push_back(runtime::DescribeRefusedPlace(refused, runtime::ProgramPath(scenario)));
  }
  const std::string_view verdict = explore::VerdictName(findings.value().exploration.verdict);
  if (verdict == scenario.explore->verdict) return;
  const auto report = [&](Language language) {
    std::string text = explore::TextReport(findings.value(), language);
    while (text.ends_with('\n')) text.pop_back();
    return text;
  };
  outcome->failures.push_back(MakeMessage("the verdict should be {0}:\n{1}", "结论应为 {0}：\n{2}",
                                          scenario.explore->verdict, report(Language::kEnglish),
                                          report(Language::kChinese)));
}

TestOutcome RunTest(const std::string& path, const TestArguments& arguments,
                    const StopSignals& signals) {
  TestOutcome outcome;
  outcome.path = path;
  auto scenario = runtime::LoadScenario(path, runtime::ScenarioUse::kTest);
  if (!scenario.ok()) {
    outcome.failures.push_back(scenario.error().message);
    return outcome;
  }
  if (arguments.structured) scenario.value().structured = true;
  runtime::ProgramLoad load = runtime::LoadProgram(runtime::ProgramPath(scenario.value()),
                                                   runtime::CompileOptions(scenario.value()));
  if (!load.object) {
    outcome.failures.push_back(load.error ? load.error->message
                                          : DescribeDiagnostics(*load.compilation));
    return outcome;
  }
  if (load.compilation) {
    const auto unused =
        explore::DescribeUnusedComments(scenario.value(), load.compilation->files[0].text());
    if (unused) outcome.warnings.push_back(*unused);
  }
  if (scenario.value().explore) {
    ExploreTest(scenario.value(), load, arguments.strict_commands, &outcome);
    return outcome;
  }
  runtime::RunOptions options;
  options.strict_commands = arguments.strict_commands;
  options.stop = signals.stop();
  options.log = runtime::CallLog::Wanted();
  const auto result =
      runtime::RunWithRequirements(scenario.value(), std::move(*load.object), options);
  if (!result.ok()) {
    outcome.failures.push_back(result.error().message);
    return outcome;
  }
  outcome.time_ms = result.value().end_ms;
  outcome.statements = result.value().statements;
  for (const runtime::ScenarioFailure& failure : result.value().failures) {
    outcome.failures.push_back(
        {FormatFailure(failure, Language::kEnglish), FormatFailure(failure, Language::kChinese)});
  }
  outcome.warnings.insert(outcome.warnings.end(), result.value().warnings.begin(),
                          result.value().warnings.end());
  if (result.value().interrupted) {
    outcome.interrupted = true;
    outcome.failures.push_back(
        MakeMessage("interrupted at {0} ms", "在 {0} ms 被中断", result.value().end_ms));
  }
  return outcome;
}

/// The outcome of a scenario that was not run because the command was stopped.
TestOutcome NotRun(const std::string& path) {
  TestOutcome outcome;
  outcome.path = path;
  outcome.interrupted = true;
  outcome.failures.push_back({"not run: interrupted", "未运行：被中断"});
  return outcome;
}

int Test(const TestArguments& arguments, const Session& session) {
  std::vector<std::string> scenarios;
  for (const std::string& path : arguments.paths) {
    const auto found = FindScenarios(path);
    if (!found.ok()) return Fail(session, kExitUnreadable, found.error().message);
    scenarios.insert(scenarios.end(), found.value().begin(), found.value().end());
  }
  const StopSignals signals;
  std::vector<TestOutcome> outcomes;
  for (const std::string& path : scenarios) {
    if (signals.stopped()) {
      outcomes.push_back(NotRun(path));
      continue;
    }
    const auto work = [&] { return RunTest(path, arguments, signals); };
    outcomes.push_back(RunIsolated(path, work, *signals.stop()));
  }
  if (outcomes.empty()) {
    return Fail(session, kExitUnreadable, {"no scenario (.toml) found", "未找到场景文件（.toml）"});
  }
  if (arguments.format == "junit") {
    PrintResult(FormatTestJunit(outcomes, session.language));
  } else if (arguments.format == "tap") {
    PrintResult(FormatTestTap(outcomes, session.language));
  } else if (arguments.format == "json") {
    PrintResult(FormatTestJson(outcomes, session.language));
  } else {
    PrintResult(FormatTestText(outcomes, session.language, session.color));
  }
  const bool passed = std::all_of(outcomes.begin(), outcomes.end(),
                                  [](const TestOutcome& outcome) { return outcome.passed(); });
  if (std::ranges::any_of(outcomes, &TestOutcome::interrupted)) return kExitIncomplete;
  return passed ? kExitOk : kExitFailed;
}

}  // namespace

void AddTest(CLI::App& app, Session& session) {
  const auto arguments = std::make_shared<TestArguments>();
  CLI::App* command =
      AddCommand(app, session, "test",
                 {"run scenarios and report which expectations fail", "运行场景并报告未满足的期望"},
                 [arguments, &session] { return Test(*arguments, session); });
  command
      ->add_option("paths", arguments->paths,
                   session.Say({"scenarios (.toml), or folders searched for them",
                                "场景文件（.toml）或含有场景的文件夹"}))
      ->required()
      ->type_name("PATH");
  AddStructuredOption(*command, session, arguments->structured);
  AddStrictCommandsOption(*command, session, arguments->strict_commands);
  AddFormatOption(*command, session, arguments->format, {"text", "junit", "tap", "json"});
}

}  // namespace oncard::tools
