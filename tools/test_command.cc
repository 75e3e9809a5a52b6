// oncard test: runs every scenario in files and folders, with its program or with many.
#include <chrono>
#include <optional>

#include "compiler/diagnostic_printer.h"
#include "compiler/display_text.h"
#include "explore/scenario_exploration.h"
#include "explore/source_comments.h"
#include "runtime/host/call_log.h"
#include "runtime/scenario/run/assert_watch.h"
#include "runtime/scenario/run/choices.h"
#include "runtime/scenario/run/requirement_watch.h"
#include "tools/commands.h"
#include "tools/file_patterns.h"
#include "tools/host_tests.h"
#include "tools/isolation.h"
#include "tools/program_warnings.h"
#include "tools/run_report.h"
#include "tools/scenario_folder.h"
#include "tools/search_watch.h"
#include "tools/stop_signals.h"
#include "tools/terminal.h"
#include "tools/test_report.h"

namespace oncard::tools {
namespace {

struct TestArguments {
  std::vector<std::string> paths;
  std::vector<std::string> programs;
  int jobs = 0;
  std::optional<int> timeout_s;
  double search_s = 60;    ///< of an exploration; 0: no limit
  int64_t search_mib = 0;  ///< the same; 0: those at a time share half of what is free
  bool progress = false;
  std::string format = "text";
  bool strict_commands = false;
  std::vector<std::string> silent;
  bool structured = false;
};

// The ending of scenarios for host programs, which need not name one.
constexpr std::string_view kHostScenario = ".host.toml";

// Seconds for each of many programs, and for a host: they can be endless.
constexpr int kTimeout = 60;

// The programs that match a pattern, sorted by path.
Result<std::vector<std::string>> FindPrograms(const std::string& pattern) {
  auto found = FilesMatching(pattern);
  if (!found) return MakeError(1, "cannot search for '{0}'", "无法查找“{0}”", pattern);
  if (found->empty()) {
    return MakeError(1, "no program matches '{0}'", "没有程序匹配“{0}”", pattern);
  }
  return *std::move(found);
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

/// A test in its process, and what it was asked for.
struct Testing {
  const TestArguments& arguments;
  const Invocation& invocation;
  const StopSignals& signals;
  const std::string& scratch;  ///< a folder for all tests; empty: none could be made
  int jobs = 1;                ///< tests that run at a time
};

/// True if the search was cut short, so that its verdict says nothing of what was asked.
bool ReportCutSearch(const SearchWatch& watch, double limit_s, explore::Verdict verdict,
                     TestOutcome* outcome) {
  const bool searched =
      verdict == explore::Verdict::kProved || verdict == explore::Verdict::kFailed;
  if (searched || !watch.interrupted()) return false;
  if (watch.out_of_time()) {
    outcome->failures.push_back(MakeMessage(
        "the search was ended by the time limit of {0} s before it was complete: --time sets the "
        "limit",
        "搜索在完成前达到时间上限 {0} 秒：可用 --time 设定上限", limit_s));
  } else if (watch.out_of_memory()) {
    outcome->failures.push_back(
        {"the search was ended by its limit of memory before it was complete: --memory sets the "
         "limit",
         "搜索在完成前达到内存上限：可用 --memory 设定上限"});
  } else {
    outcome->interrupted = true;
    outcome->failures.push_back({"interrupted", "被中断"});
  }
  return true;
}

// Explores instead of running: the verdict must be the one in the scenario.
void ExploreTest(const runtime::Scenario& scenario, const runtime::ProgramLoad& load,
                 const Testing& testing, TestOutcome* outcome) {
  explore::ProgramText source;
  if (load.compilation) source = explore::TextOf(*load.compilation);
  SearchWatch watch(testing.invocation, {.shows = testing.arguments.progress,
                                         .seconds = testing.arguments.search_s,
                                         .memory_mib = testing.arguments.search_mib,
                                         .searches = testing.jobs,
                                         .title = compiler::DisplayText(outcome->Title())});
  const auto begin = std::chrono::steady_clock::now();
  auto findings = explore::ExploreAsWished(scenario, *load.object, source.text, watch.progress());
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  outcome->search_ms = taken.count();
  if (!findings.ok()) {
    outcome->failures.push_back(findings.error().message);
    return;
  }
  findings.value().source = std::move(source);
  auto& list = testing.arguments.strict_commands ? outcome->failures : outcome->warnings;
  const std::vector<Message> warnings = ProgramWarnings(
      findings.value(), SilentOf(testing.arguments.silent), runtime::ProgramPath(scenario));
  list.insert(list.end(), warnings.begin(), warnings.end());
  const std::vector<Message>& untested = findings.value().untested;
  outcome->warnings.insert(outcome->warnings.end(), untested.begin(), untested.end());
  const explore::Verdict verdict = findings.value().exploration.verdict;
  if (ReportCutSearch(watch, testing.arguments.search_s, verdict, outcome)) return;
  if (explore::VerdictName(verdict) == scenario.explore->verdict) return;
  const auto report = [&](Language language) {
    std::string text = explore::TextReport(findings.value(), language);
    while (text.ends_with('\n')) text.pop_back();
    return text;
  };
  outcome->failures.push_back(MakeMessage("the verdict should be {0}:\n{1}", "结论应为 {0}：\n{2}",
                                          scenario.explore->verdict, report(Language::kEnglish),
                                          report(Language::kChinese)));
}

/// Runs once; requirements are checked in that run.
void RunOnce(const runtime::Scenario& scenario, vm::Object object, const Testing& testing,
             TestOutcome* outcome) {
  runtime::RunOptions options;
  options.strict_commands = testing.arguments.strict_commands;
  options.silent = SilentOf(testing.arguments.silent);
  options.stop = testing.signals.stop();
  options.log = runtime::CallLog::Wanted();
  const auto result = runtime::RunWithRequirements(scenario, std::move(object), options);
  if (!result.ok()) {
    outcome->failures.push_back(result.error().message);
    return;
  }
  if (result.value().chosen != nullptr) {
    outcome->warnings.push_back(runtime::DescribeChosen(result.value().choice));
  }
  outcome->time_ms = result.value().end_ms;
  outcome->statements = result.value().statements;
  for (const runtime::ScenarioFailure& failure : result.value().failures) {
    outcome->failures.push_back(
        {FormatFailure(failure, Language::kEnglish), FormatFailure(failure, Language::kChinese)});
  }
  outcome->warnings.insert(outcome->warnings.end(), result.value().warnings.begin(),
                           result.value().warnings.end());
  if (result.value().interrupted) {
    outcome->interrupted = true;
    outcome->failures.push_back(
        MakeMessage("interrupted at {0} ms", "在 {0} ms 被中断", result.value().end_ms));
  }
}

/// Replaces the host by the program that the outcome names. Fails if the host is a command.
bool ReplaceHost(runtime::Scenario* scenario, TestOutcome* outcome) {
  if (outcome->program.empty()) return true;
  if (!scenario->host_program) scenario->host_program.emplace();
  if (!scenario->host_program->command.empty()) {
    outcome->failures.push_back(
        {"the host is a command, which --program cannot replace: name a 'source' in 'host'",
         "主机程序是命令，--program 不能代替它：应在“host”中给出“source”"});
    return false;
  }
  scenario->host_program->source = runtime::PathToScenario(*scenario, outcome->program);
  return true;
}

/// Builds and runs a host program.
void TestHost(runtime::Scenario scenario, const std::string& scratch, const Testing& testing,
              TestOutcome* outcome) {
  if (!ReplaceHost(&scenario, outcome)) return;
  if (!scenario.host_program) {
    outcome->skipped = {
        "skipped: it names no host program: add host = { source = \"host.c\" } or host = { command "
        "= [\"./host\"] } to the file",
        "已跳过：未给出主机程序：应在文件中加上 host = { source = \"host.c\" } 或 host = { command "
        "= [\"./host\"] }"};
    return;
  }
  if (const Message why = WhyNoHostTests(); !why.en.empty()) {
    outcome->skipped = why;
    return;
  }
  // Where a test has a limit, it is the only one: of two, either could be reached first.
  const bool limited = testing.arguments.timeout_s || !testing.arguments.programs.empty();
  RunHostTest(scenario,
              {testing.arguments.strict_commands, testing.arguments.silent, limited ? 0 : kTimeout,
               scratch},
              testing.invocation, outcome);
  if (!testing.signals.stopped()) return;
  outcome->interrupted = true;
  outcome->failures = {{"interrupted", "被中断"}};
}

/// `scratch`: a folder that the test may make for itself.
TestOutcome RunTest(TestOutcome outcome, const std::string& scratch, const Testing& testing) {
  const bool of_host = outcome.path.ends_with(kHostScenario);
  auto scenario = runtime::LoadScenario(
      outcome.path, of_host ? runtime::ScenarioUse::kHost : runtime::ScenarioUse::kTest);
  if (!scenario.ok()) {
    outcome.failures.push_back(scenario.error().message);
    return outcome;
  }
  if (of_host || scenario.value().host_program) {
    TestHost(std::move(scenario).value(), scratch, testing, &outcome);
    return outcome;
  }
  if (testing.arguments.structured) scenario.value().structured = true;
  if (!outcome.program.empty()) {
    scenario.value().program = runtime::PathToScenario(scenario.value(), outcome.program);
  }
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
  if (!explore::ChecksSomething(scenario.value()) && !runtime::HasAsserts(*load.object)) {
    outcome.nothing = {"checks nothing: it has no expectation and no requirement",
                       "未检查任何内容：既没有期望也没有要求"};
  }
  if (scenario.value().explore) {
    ExploreTest(scenario.value(), load, testing, &outcome);
  } else {
    RunOnce(scenario.value(), std::move(*load.object), testing, &outcome);
  }
  return outcome;
}

// What all finders find for all texts.
Result<std::vector<std::string>> FindAll(
    const std::vector<std::string>& texts,
    Result<std::vector<std::string>> (*find)(const std::string& text)) {
  std::vector<std::string> all;
  for (const std::string& text : texts) {
    auto found = find(text);
    if (!found.ok()) return found;
    all.insert(all.end(), found.value().begin(), found.value().end());
  }
  return all;
}

// Every scenario with every program, or with its own.
std::vector<IsolatedTest> ListTests(const std::vector<std::string>& scenarios,
                                    const std::vector<std::string>& programs,
                                    const Testing& testing) {
  std::vector<IsolatedTest> tests;
  const auto add = [&](const std::string& scenario, const std::string& program) {
    TestOutcome named;
    named.path = scenario;
    named.program = program;
    const std::string scratch =
        testing.scratch.empty() ? "" : fmt::format("{}/{}", testing.scratch, tests.size());
    tests.push_back(
        {named, [named, scratch, &testing] { return RunTest(named, scratch, testing); }});
  };
  for (const std::string& scenario : scenarios) {
    if (testing.arguments.programs.empty()) add(scenario, {});
    for (const std::string& program : programs) add(scenario, program);
  }
  return tests;
}

int Test(const TestArguments& arguments, const Invocation& invocation) {
  const auto scenarios = FindAll(arguments.paths, FindScenarios);
  if (!scenarios.ok()) return Fail(invocation, kExitUnreadable, scenarios.error().message);
  const auto programs = FindAll(arguments.programs, FindPrograms);
  if (!programs.ok()) return Fail(invocation, kExitUnreadable, programs.error().message);
  const StopSignals signals;
  IsolationOptions isolation;
  isolation.jobs = arguments.jobs > 0 ? arguments.jobs : ProcessorCount();
  isolation.timeout_s = arguments.timeout_s.value_or(programs.value().empty() ? 0 : kTimeout);
  const HostTestFolder scratch;
  const Testing testing = {arguments, invocation, signals, scratch.path(), isolation.jobs};
  const std::vector<TestOutcome> outcomes = RunIsolated(
      ListTests(scenarios.value(), programs.value(), testing), isolation, *signals.stop());
  if (outcomes.empty()) {
    return Fail(invocation, kExitUnreadable,
                {"no scenario (.toml) found", "未找到场景文件（.toml）"});
  }
  if (arguments.format == "junit") {
    PrintResult(FormatTestJunit(outcomes, invocation.language));
  } else if (arguments.format == "tap") {
    PrintResult(FormatTestTap(outcomes, invocation.language));
  } else if (arguments.format == "csv") {
    PrintResult(FormatTestCsv(outcomes, invocation.language));
  } else if (arguments.format == "json") {
    PrintResult(FormatTestJson(outcomes, invocation.language));
  } else {
    PrintResult(FormatTestText(outcomes, invocation.language, invocation.color));
  }
  const bool failed = std::ranges::any_of(
      outcomes, [](const TestOutcome& outcome) { return outcome.status() == TestStatus::kFailed; });
  if (std::ranges::any_of(outcomes, &TestOutcome::interrupted)) return kExitIncomplete;
  return failed ? kExitFailed : kExitOk;
}

}  // namespace

void AddTest(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<TestArguments>();
  arguments->progress = ErrorsGoToTerminal();
  CLI::App* command =
      AddCommand(app, invocation, "test",
                 {"run scenarios and report which expectations fail", "运行场景并报告未满足的期望"},
                 [arguments, &invocation] { return Test(*arguments, invocation); });
  command
      ->add_option("paths", arguments->paths,
                   invocation.Say({"scenarios (.toml), or folders searched for them",
                                   "场景文件（.toml）或含有场景的文件夹"}))
      ->required()
      ->type_name("PATH");
  command
      ->add_option(
          "--program", arguments->programs,
          invocation.Say({"programs that run in place of the scenarios' own, each a test of "
                          "its own: a file or a pattern such as 'hand-in/*.c' (repeatable)",
                          "代替场景中程序运行的程序，各为一个测试：文件或通配，如 "
                          "'hand-in/*.c'（可重复）"}))
      ->type_name("PATTERN")
      ->allow_extra_args(false);
  command
      ->add_option("--jobs", arguments->jobs,
                   invocation.Say({"tests at the same time (default: one per processor)",
                                   "同时运行的测试数（默认每个处理器一个）"}))
      ->type_name("N")
      ->check(CLI::Range(1, 1000).description(""));
  command
      ->add_option(
          "--timeout", arguments->timeout_s,
          invocation.Say({"a test that takes longer has failed; 0: no limit (default 60 with "
                          "--program and for host programs, otherwise 0)",
                          "耗时更长的测试视为失败；0 为不限（使用 --program 时和主机程序默认 60，"
                          "否则为 0）"}))
      ->type_name("SECONDS")
      ->check(CLI::Range(0, 86'400).description(""));
  command
      ->add_option("--time", arguments->search_s,
                   invocation.Say({"an exploration that takes longer has failed; 0: no limit "
                                   "(default 60)",
                                   "耗时更长的探索视为失败；0 为不限（默认 60）"}))
      ->type_name("SECONDS")
      ->check(CLI::Range(0.0, 1e9).description(""));
  command
      ->add_option(
          "--memory", arguments->search_mib,
          invocation.Say({"an exploration that occupies more has failed (default: those at "
                          "a time share half of what is free)",
                          "占用内存更多的探索视为失败（默认：同时进行的探索共用可用内存的"
                          "一半）"}))
      ->type_name("MIB")
      ->check(CLI::Range(int64_t{1}, kMemoryMibMax).description(""));
  command->add_flag("--progress", arguments->progress,
                    invocation.Say({"show the progress of explorations every second (default on a "
                                    "terminal)",
                                    "每秒显示探索进度（终端上默认开启）"}));
  AddStructuredOption(*command, invocation, arguments->structured);
  AddStrictCommandsOption(*command, invocation, arguments->strict_commands);
  AddSilentOption(*command, invocation, arguments->silent);
  AddFormatOption(*command, invocation, arguments->format, {"text", "junit", "tap", "json", "csv"});
}

}  // namespace oncard::tools
