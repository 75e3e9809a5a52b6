// oncard replay: executes a recorded run again, statement by statement.
#include "base/files.h"
#include "runtime/host/call_log.h"
#include "runtime/scenario/adapted_schedule.h"
#include "runtime/scenario/requirement_watch.h"
#include "tools/commands.h"
#include "tools/run_report.h"
#include "tools/run_views.h"
#include "tools/stop_signals.h"

namespace oncard::tools {
namespace {

struct ReplayArguments {
  std::string path;
  std::vector<std::string> show;
  std::string format = "text";
  bool tolerant = false;
  RunViews views;
  bool strict_commands = false;
};

/// The schedule adapted to the current program; reports the part that it cannot follow.
Result<vm::Schedule> Adapt(const runtime::Scenario& scenario, const runtime::ProgramLoad& load,
                           const vm::Schedule& schedule, const Invocation& invocation) {
  const std::string source = load.compilation ? load.compilation->files[0].text() : std::string();
  auto adapted = runtime::AdaptSchedule(scenario, *load.object, source, schedule);
  if (!adapted.ok()) return adapted.error();
  const Message followed =
      MakeMessage("followed {0} of {1} segments of the schedule", "已按调度执行 {0} / {1} 段",
                  adapted.value().followed, schedule.segments.size());
  fmt::print(stderr, "{}\n", followed.In(invocation.language));
  if (adapted.value().divergence) {
    fmt::print(stderr, "{}\n", adapted.value().divergence->In(invocation.language));
  }
  return std::move(adapted.value().schedule);
}

int Replay(const ReplayArguments& arguments, const Invocation& invocation) {
  auto schedule = vm::LoadSchedule(arguments.path);
  if (!schedule.ok()) return Fail(invocation, kExitUnreadable, schedule.error().message);
  const auto scenario = runtime::ParseScenario(
      schedule.value().scenario, arguments.path, runtime::ScenarioUse::kRun,
      {vm::kLinesBeforeScenario, static_cast<int>(vm::kScenarioPrefix.size())});
  if (!scenario.ok()) return Fail(invocation, kExitUnreadable, scenario.error().message);
  runtime::ProgramLoad load;
  const int loaded = LoadOrReport(invocation, runtime::ProgramPath(scenario.value()),
                                  runtime::CompileOptions(scenario.value()), false, &load);
  if (loaded != kExitOk) return loaded;

  if (arguments.tolerant) {
    const auto fits = runtime::FitWithRequirements(scenario.value(), *load.object);
    if (!fits.ok()) return Fail(invocation, kExitFailed, fits.error().message);
    schedule = Adapt(scenario.value(), load, schedule.value(), invocation);
    if (!schedule.ok()) return Fail(invocation, kExitFailed, schedule.error().message);
  }
  runtime::RunOptions options;
  options.replay = std::make_shared<const vm::Schedule>(std::move(schedule).value());
  options.show = arguments.show;
  ApplyViews(arguments.views, &options);
  options.strict_commands = arguments.strict_commands;
  const StopSignals signals;
  options.stop = signals.stop();
  options.log = runtime::CallLog::Wanted();
  const auto result = runtime::RunWithRequirements(scenario.value(), *load.object, options);
  if (!result.ok()) return Fail(invocation, kExitFailed, result.error().message);
  PrintSteps(result.value(), load, arguments.views, arguments.format, invocation);
  const int code = ReportRun(result.value(), arguments.format, invocation);
  return std::max(code, WriteViews(result.value(), arguments.views,
                                   runtime::TitleOf(scenario.value()), invocation));
}

}  // namespace

void AddReplay(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command =
      AddCommand(app, invocation, "replay", {"repeat a recorded run exactly", "精确重放录制的调度"},
                 [arguments, &invocation] { return Replay(*arguments, invocation); });
  command
      ->add_option("schedule", arguments->path,
                   invocation.Say({"file written by 'oncard run --record'",
                                   "由“oncard run --record”写出的文件"}))
      ->required()
      ->type_name("FILE");
  command->add_flag("--tolerant", arguments->tolerant,
                    invocation.Say({"for an edited program: threads switch at the same lines as "
                                    "before, as far as they still reach them",
                                    "用于修改过的程序：各线程仍在原来的行处切换，直到无法继续"}));
  command
      ->add_option("--show", arguments->show,
                   invocation.Say({"value to print at the end (repeatable; default: all globals)",
                                   "结束时显示的量（可重复）；省略时显示全部全局变量"}))
      ->type_name("NAME")
      ->allow_extra_args(false);
  AddViewOptions(*command, invocation, arguments->views);
  AddStrictCommandsOption(*command, invocation, arguments->strict_commands);
  AddFormatOption(*command, invocation, arguments->format, {"text", "json"});
}

}  // namespace oncard::tools
