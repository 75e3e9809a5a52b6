// oncard replay: executes a recorded run again, statement by statement.
#include "base/files.h"
#include "base/milliseconds.h"
#include "runtime/host/call_log.h"
#include "runtime/scenario/record/call_replay.h"
#include "runtime/scenario/run/adapted_schedule.h"
#include "runtime/scenario/run/requirement_watch.h"
#include "runtime/scenario/run/scenario_card.h"
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
  std::vector<std::string> silent;
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

/// Gives a card the calls of a host and says whether it does the same.
Result<Message> ReplayCalls(runtime::CallRecord record) {
  runtime::Controller controller(runtime::CardOptions(record.scenario));
  runtime::SwitchOn(record, &controller);
  const auto replay = runtime::CallReplay::Create(std::move(record), controller.commands());
  if (!replay.ok()) return replay.error();
  for (size_t i = 0; i < replay.value().size(); ++i) {
    const int64_t time_us = replay.value().TimeUs(i);
    controller.AdvanceUs(time_us - controller.NowUs());
    const auto done = replay.value().Execute(i, &controller);
    if (!done.deviation) continue;
    return MakeError(1, "call {0} at {1} ms: {2}", "第 {0} 个调用，时刻 {1} ms：{3}", i + 1,
                     ToMs(time_us), done.deviation->en, done.deviation->zh);
  }
  const size_t calls = replay.value().record().calls.size();
  if (auto incomplete = replay.value().Incomplete()) return Error{1, *std::move(incomplete)};
  return MakeMessage("{0} calls in {1} ms as recorded, hash {2:016x}",
                     "{0} 个调用，{1} ms，与记录一致，散列值 {2:016x}", calls,
                     ToMs(controller.NowUs()), controller.Hash());
}

/// Replays the calls for all cards of a record.
int ReplayHost(const std::string& path, const Invocation& invocation) {
  const auto text = ReadFile(path);
  if (!text.ok()) return Fail(invocation, kExitUnreadable, text.error().message);
  auto records = runtime::ParseCallRecords(text.value(), path);
  if (!records.ok()) return Fail(invocation, kExitUnreadable, records.error().message);
  int code = kExitOk;
  for (runtime::CallRecord& record : records.value()) {
    const int card = record.card;
    const int opening = record.opening;
    const auto replayed = ReplayCalls(std::move(record));
    const Message& what = replayed.ok() ? replayed.value() : replayed.error().message;
    const Message of_card = MakeMessage("card {0}, opening {1}: {2}", "卡 {0}，第 {1} 次打开：{3}",
                                        card, opening, what.en, what.zh);
    if (replayed.ok()) {
      PrintResult(of_card.In(invocation.language) + '\n');
    } else {
      code = Fail(invocation, kExitFailed, of_card);
    }
  }
  return code;
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
    const auto checked = runtime::CheckWithRequirements(scenario.value(), *load.object);
    if (!checked.ok()) return Fail(invocation, kExitFailed, checked.error().message);
    schedule = Adapt(scenario.value(), load, schedule.value(), invocation);
    if (!schedule.ok()) return Fail(invocation, kExitFailed, schedule.error().message);
  }
  runtime::RunOptions options;
  options.replay = std::make_shared<const vm::Schedule>(std::move(schedule).value());
  options.show = arguments.show;
  ApplyViews(arguments.views, &options);
  options.strict_commands = arguments.strict_commands;
  options.silent = SilentOf(arguments.silent);
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

/// An option that the user has given; empty: none.
std::string GivenOption(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional() && option->count() > 0) return option->get_name();
  }
  return {};
}

}  // namespace

void AddReplay(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command =
      AddCommand(app, invocation, "replay", {"repeat a recorded run exactly", "精确重放录制的调度"},
                 [arguments, &app, &invocation] {
                   if (!arguments->path.ends_with(runtime::kCallRecordEnding)) {
                     return Replay(*arguments, invocation);
                   }
                   if (const std::string option = GivenOption(*app.get_subcommand("replay"));
                       !option.empty()) {
                     return Fail(invocation, kExitUsage,
                                 MakeMessage("{0} is not for the record of a host program",
                                             "{0} 不用于主机程序的记录", option));
                   }
                   return ReplayHost(arguments->path, invocation);
                 });
  command
      ->add_option(
          "schedule", arguments->path,
          invocation.Say({"file written by 'oncard run --record' or 'oncard exec --record'",
                          "由“oncard run --record”或“oncard exec --record”写出的文件"}))
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
  AddSilentOption(*command, invocation, arguments->silent);
  AddFormatOption(*command, invocation, arguments->format, {"text", "json"});
}

}  // namespace oncard::tools
