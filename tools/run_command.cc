// oncard run: runs a program with options, or a scenario file, to its end.
#include <algorithm>
#include <cstddef>

#include "base/milliseconds.h"
#include "base/number.h"
#include "explore/source_comments.h"
#include "runtime/host/call_log.h"
#include "runtime/scenario/run/requirement_watch.h"
#include "tools/commands.h"
#include "tools/run_report.h"
#include "tools/run_views.h"
#include "tools/stop_signals.h"

namespace oncard::tools {
namespace {

struct RunArguments {
  std::string path;
  std::vector<std::string> threads;
  std::vector<std::string> globals;
  std::vector<std::string> show;
  std::vector<std::string> expectations;
  std::optional<std::string> schedule;
  std::optional<uint64_t> seed;
  std::optional<int> rate;
  std::optional<int64_t> cycle_us;
  std::optional<double> until_ms;
  std::optional<int64_t> limit_ms;
  std::optional<std::string> double_format;
  std::vector<std::string> include_folders;
  bool structured = false;
  std::string record;
  RunViews views;
  bool strict_commands = false;
  std::vector<std::string> silent;
  std::string format = "text";
};

// The scenario that the command line describes.
Result<runtime::Scenario> ScenarioOf(const RunArguments& arguments) {
  runtime::Scenario scenario;
  if (arguments.path.ends_with(".toml")) {
    auto loaded = runtime::LoadScenario(arguments.path, runtime::ScenarioUse::kRun);
    if (!loaded.ok()) return Error{kExitUnreadable, loaded.error().message};
    scenario = std::move(loaded).value();
    if (!arguments.threads.empty()) scenario.threads.clear();
  } else {
    scenario.program = arguments.path;
  }
  for (const std::string& text : arguments.threads) {
    auto start = runtime::ParseThreadStart(text);
    if (!start.ok()) return Error{kExitUsage, start.error().message};
    scenario.threads.push_back(std::move(start).value());
  }
  for (const std::string& text : arguments.globals) {
    auto initial = runtime::ParseInitialValue(text);
    if (!initial.ok()) return Error{kExitUsage, initial.error().message};
    scenario.globals.push_back(std::move(initial).value());
  }
  for (const std::string& text : arguments.expectations) {
    auto expectation = runtime::ParseExpectation(text);
    if (!expectation.ok()) return Error{kExitUsage, expectation.error().message};
    scenario.expectations.push_back(std::move(expectation).value());
  }
  for (const std::string& folder : arguments.include_folders) {
    scenario.include_folders.push_back(runtime::PathToScenario(scenario, folder));
  }
  if (arguments.schedule) {
    scenario.schedule = *arguments.schedule;
    scenario.text_places.erase("schedule");
    using runtime::kReplayPrefix;
    if (scenario.schedule.starts_with(kReplayPrefix)) {
      scenario.schedule =
          std::string(kReplayPrefix) +
          runtime::PathToScenario(scenario, scenario.schedule.substr(kReplayPrefix.size()));
    }
  }
  if (arguments.double_format) scenario.double_format = DoubleFormatOf(*arguments.double_format);
  if (arguments.structured) scenario.structured = true;
  scenario.rate = arguments.rate.value_or(scenario.rate);
  scenario.cycle_us = arguments.cycle_us.value_or(scenario.cycle_us);
  scenario.limit_ms = arguments.limit_ms.value_or(scenario.limit_ms);
  if (arguments.until_ms) scenario.until_us = FromMs(*arguments.until_ms);
  return scenario;
}

/// What the command line sets, the last values, is not left open.
void CloseChoices(size_t set, std::vector<runtime::InitialValue>* globals) {
  const std::vector<runtime::InitialValue> last(globals->end() - static_cast<std::ptrdiff_t>(set),
                                                globals->end());
  std::erase_if(*globals, [&](const runtime::InitialValue& value) {
    return value.last &&
           std::ranges::find(last, value.name, &runtime::InitialValue::name) != last.end();
  });
}

int WriteRecording(const RunArguments& arguments, const runtime::Scenario& scenario,
                   vm::Recording recording, const Invocation& invocation) {
  recording.scenario = runtime::FormatScenario(runtime::MoveScenario(scenario, arguments.record));
  return WriteOutput(invocation, arguments.record, vm::FormatRecording(recording));
}

int Run(const RunArguments& arguments, const Invocation& invocation) {
  auto scenario = ScenarioOf(arguments);
  if (!scenario.ok()) return Fail(invocation, scenario.error().code, scenario.error().message);
  runtime::ProgramLoad load;
  const int loaded = LoadOrReport(invocation, runtime::ProgramPath(scenario.value()),
                                  runtime::CompileOptions(scenario.value()), false, &load);
  if (loaded != kExitOk) return loaded;

  const std::string source = load.compilation ? load.compilation->files[0].text() : std::string();
  const bool alone = !arguments.path.ends_with(".toml");
  if (alone) {
    const auto added =
        explore::AddComments(arguments.path, source, *load.object, &scenario.value());
    if (!added.ok()) return Fail(invocation, kExitUsage, added.error().message);
  }
  CloseChoices(arguments.globals.size(), &scenario.value().globals);

  runtime::RunOptions options;
  vm::Recording recording;
  if (!arguments.record.empty()) options.recording = &recording;
  options.show = arguments.show;
  options.seed = arguments.seed;
  ApplyViews(arguments.views, &options);
  options.strict_commands = arguments.strict_commands;
  options.silent = SilentOf(arguments.silent);
  const StopSignals signals;
  options.stop = signals.stop();
  options.log = runtime::CallLog::Wanted();
  auto result = runtime::RunWithRequirements(scenario.value(), *load.object, options);
  if (!result.ok()) return Fail(invocation, kExitUsage, result.error().message);

  if (const auto unused = explore::DescribeUnusedComments(scenario.value(), source);
      unused && !alone) {
    result.value().warnings.push_back(*unused);
  }
  PrintSteps(result.value(), load, arguments.views, arguments.format, invocation);
  int code = ReportRun(result.value(), arguments.format, invocation);
  code = std::max(code, WriteViews(result.value(), arguments.views,
                                   runtime::TitleOf(scenario.value()), invocation));
  if (options.recording != nullptr) {
    const auto& chosen = result.value().chosen;
    code = std::max(code, WriteRecording(arguments, chosen ? *chosen : scenario.value(),
                                         std::move(recording), invocation));
  }
  return code;
}

// The range check of CLI11 accepts NaN.
std::string CheckTime(const std::string& text) {
  const auto value = ReadNumber(text);
  const bool good = value && *value >= 0 && *value <= static_cast<double>(runtime::kTimeMsMax);
  return good ? "" : fmt::format("{} is not a time from 0 to {} ms", text, runtime::kTimeMsMax);
}

std::string CheckCycle(const std::string& text) {
  const auto value = ReadWhole<int>(text);
  const bool good = value && *value >= 125 && *value <= 4000 && *value % 125 == 0;
  return good ? "" : fmt::format("{} is not a multiple of 125 from 125 to 4000", text);
}

// A list option that takes one value per occurrence.
void AddList(CLI::App& command, const std::string& name, std::vector<std::string>& values,
             const std::string& type, const std::string& description) {
  command.add_option(name, values, description)->type_name(type)->allow_extra_args(false);
}

}  // namespace

void AddRun(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<RunArguments>();
  const auto say = [&invocation](std::string_view en, std::string_view zh) {
    return invocation.Say({std::string(en), std::string(zh)});
  };
  CLI::App* command = AddCommand(app, invocation, "run",
                                 {"run a program or a scenario in virtual time, print its results",
                                  "以虚拟时间运行程序或场景并显示结果"},
                                 [arguments, &invocation] { return Run(*arguments, invocation); });
  command
      ->add_option("program", arguments->path,
                   say("source (.c), object (.bin) or scenario (.toml)",
                       "源文件（.c）、目标文件（.bin）或场景（.toml）"))
      ->required()
      ->type_name("FILE");
  AddList(*command, "--thread", arguments->threads, "N=FUNCTION[@PAGE][:NAME=VALUE,...]",
          say("bind and start a thread (repeatable; default: thread 0 runs main, or the first "
              "function, on page 0)",
              "绑定并启动一个线程（可重复）；省略时由线程 0 在数据页 0 运行 main 或第一个函数"));
  AddList(*command, "--set", arguments->globals, "NAME=VALUE",
          say("set a global before the start (repeatable)", "启动前的全局变量值（可重复）"));
  AddList(*command, "--show", arguments->show, "NAME",
          say("value to print at the end, such as sum, page0.i, thread0.result, gpo (repeatable; "
              "default: all globals)",
              "结束时显示的量，如 "
              "sum、page0.i、thread0.result、gpo（可重复）；省略时显示全部全局变量"));
  AddList(*command, "--expect", arguments->expectations, "TEXT",
          say("fail unless this holds, such as 'sum == 5050' or 'gpo == 1 @ 10ms' (repeatable)",
              "不成立则失败，如 'sum == 5050' 或 'gpo == 1 @ 10ms'（可重复）"));
  command
      ->add_option("--schedule", arguments->schedule,
                   say("rr[:N], priority, random:SEED, pct:SEED:D or replay:FILE (default rr)",
                       "rr[:N]、priority、random:SEED、pct:SEED:D 或 replay:FILE（默认 rr）"))
      ->type_name("POLICY");
  command
      ->add_option("--seed", arguments->seed,
                   say("of what the scenario leaves open, the case that this seed draws (default: "
                       "the earliest and smallest)",
                       "场景留有选择时，采用该种子抽取的情形（默认：最早、最小者）"))
      ->type_name("N");
  command
      ->add_option("--rate", arguments->rate,
                   say("statements per ms, shared by all threads (default 100)",
                       "每毫秒语句数，由所有线程共享（默认 100）"))
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000).description(""));
  command
      ->add_option("--cycle", arguments->cycle_us,
                   say("profile cycle in us, a multiple of 125 (default 250)",
                       "规划周期，单位 us，125 的倍数（默认 250）"))
      ->type_name("US")
      ->check(CLI::Validator(CheckCycle, ""));
  command
      ->add_option("--until", arguments->until_ms,
                   say("end the run at this time, even if threads still run",
                       "到此时刻结束运行，不论线程是否仍在运行"))
      ->type_name("MS")
      ->check(CLI::Validator(CheckTime, ""));
  command
      ->add_option("--limit", arguments->limit_ms,
                   say("fail when threads still run at this time (default 60000)",
                       "到此时刻仍有线程在运行则失败（默认 60000）"))
      ->type_name("MS")
      ->check(CLI::Range(int64_t{1}, runtime::kTimeMsMax).description(""));
  command
      ->add_option(
          "--record", arguments->record,
          say("write the schedule, for 'oncard replay'", "写出调度文件，供“oncard replay”使用"))
      ->type_name("FILE");
  AddViewOptions(*command, invocation, arguments->views);
  AddIncludeOption(*command, invocation, arguments->include_folders);
  command
      ->add_option("--double", arguments->double_format,
                   say("width of the type double of a source: 32.16 (default) or 16.16",
                       "源文件中 double 类型的宽度：32.16（默认）或 16.16"))
      ->type_name("WIDTH")
      ->check(CLI::IsMember({"32.16", "16.16"}).description(""));
  AddStructuredOption(*command, invocation, arguments->structured);
  AddStrictCommandsOption(*command, invocation, arguments->strict_commands);
  AddSilentOption(*command, invocation, arguments->silent);
  AddFormatOption(*command, invocation, arguments->format, {"text", "json"});
}

}  // namespace oncard::tools
