// oncard explore: can any interleaving of the threads go wrong?
#include "base/files.h"
#include "explore/scenario_exploration.h"
#include "runtime/adapted_schedule.h"
#include "runtime/scenario_run.h"
#include "tools/commands.h"

namespace oncard::tools {
namespace {

struct ExploreArguments {
  std::string path;
  std::string engine;  ///< empty: as the scenario says
  std::string format = "text";
  std::string save;
  std::string report;
  int64_t execution_limit = 0;  ///< 0: as the scenario says
  uint32_t state_limit = 0;
  int64_t runs = 0;
  uint64_t seed = explore::ExploreOptions{}.seed;
  int depth = explore::ExploreOptions{}.depth;
  int preemptions = explore::ExploreOptions{}.preemption_limit;
  bool races = false;
  bool benign = false;
};

/// A file to be explored: its scenario, what it requires, its program.
struct Subject {
  runtime::Scenario scenario;
  std::vector<explore::Requirement> requirements;
  vm::Object object;
  std::string source;  ///< of a program that was compiled
};

/// Gives the exit code; the subject is filled in when that is kExitOk.
int ReadSource(const ExploreArguments& arguments, const Session& session, Subject* subject) {
  runtime::ProgramLoad load;
  const int loaded = LoadOrReport(session, arguments.path, {}, arguments.format == "json", &load);
  if (loaded != kExitOk) return loaded;
  subject->source = load.compilation ? load.compilation->files[0].text() : std::string();
  auto read = explore::ReadComments(arguments.path, subject->source, *load.object);
  if (!read.ok()) return Fail(session, kExitUsage, read.error().message);
  subject->scenario = std::move(read.value().scenario);
  subject->requirements = std::move(read.value().requirements);
  subject->object = std::move(*load.object);
  return kExitOk;
}

int ReadScenario(const ExploreArguments& arguments, const Session& session, Subject* subject) {
  auto scenario = runtime::LoadScenario(arguments.path);
  if (!scenario.ok()) return Fail(session, kExitUnreadable, scenario.error().message);
  subject->scenario = std::move(scenario).value();
  subject->requirements = explore::RequirementsOf(subject->scenario);
  runtime::ProgramLoad load;
  const int loaded =
      LoadOrReport(session, runtime::ProgramPath(subject->scenario),
                   runtime::CompileOptions(subject->scenario), arguments.format == "json", &load);
  if (loaded != kExitOk) return loaded;
  subject->source = load.compilation ? load.compilation->files[0].text() : std::string();
  subject->object = std::move(*load.object);
  return kExitOk;
}

/// Writes the failing schedule with checkpoints, as a run of it records them.
int Save(const ExploreArguments& arguments, const Session& session, const Subject& subject,
         const explore::Findings& findings) {
  const runtime::Scenario moved = runtime::MoveScenario(subject.scenario, arguments.save);
  runtime::RunOptions options;
  options.record = true;
  options.replay = std::make_shared<const vm::Schedule>(
      explore::ScheduleOf(findings.subject, *findings.exploration.failure));
  auto run = runtime::RunScenario(subject.scenario, subject.object, options);
  if (!run.ok()) return Fail(session, kExitInternal, run.error().message);
  vm::Schedule schedule = std::move(*run.value().schedule);
  schedule.scenario = runtime::FormatScenario(moved);
  auto annotated =
      runtime::AnnotateSchedule(subject.scenario, subject.object, subject.source, &schedule);
  if (!annotated.ok()) return Fail(session, kExitInternal, annotated.error().message);
  return WriteOutput(session, arguments.save, vm::FormatSchedule(schedule));
}

int ExitCodeOf(explore::Verdict verdict) {
  switch (verdict) {
    case explore::Verdict::kProved:
      return kExitOk;
    case explore::Verdict::kPassed:
      return kExitBounded;
    case explore::Verdict::kFailed:
      return kExitFailed;
    case explore::Verdict::kIncomplete:
      break;
  }
  return kExitIncomplete;
}

int Explore(const ExploreArguments& arguments, const Session& session) {
  Subject subject;
  const bool is_scenario = arguments.path.ends_with(".toml");
  const int read = is_scenario ? ReadScenario(arguments, session, &subject)
                               : ReadSource(arguments, session, &subject);
  if (read != kExitOk) return read;
  explore::ExploreOptions options =
      explore::OptionsOf(subject.scenario.explore.value_or(runtime::ExploreWish{}));
  if (!arguments.engine.empty()) options.engine = *explore::EngineNamed(arguments.engine);
  if (arguments.execution_limit != 0) options.execution_limit = arguments.execution_limit;
  if (arguments.state_limit != 0) options.state_limit = arguments.state_limit;
  if (arguments.runs != 0) options.runs = arguments.runs;
  options.seed = arguments.seed;
  options.depth = arguments.depth;
  options.preemption_limit = arguments.preemptions;
  if (arguments.races) subject.scenario.races = "none";
  if (arguments.benign) subject.scenario.races = "benign";
  auto findings =
      explore::ExploreScenario(subject.scenario, subject.requirements, subject.object, options);
  if (!findings.ok()) return Fail(session, kExitUsage, findings.error().message);
  findings.value().source = subject.source;
  PrintResult(arguments.format == "json" ? explore::JsonReport(findings.value())
                                         : explore::TextReport(findings.value(), session.language));
  if (!arguments.report.empty()) {
    const std::string report = arguments.report.ends_with(".html")
                                   ? explore::HtmlReport(findings.value(), session.language)
                                   : explore::ChromeReport(findings.value());
    const int written = WriteOutput(session, arguments.report, report);
    if (written != kExitOk) return written;
  }
  if (findings.value().exploration.failure && !arguments.save.empty()) {
    const int saved = Save(arguments, session, subject, findings.value());
    if (saved != kExitOk) return saved;
  }
  return ExitCodeOf(findings.value().exploration.verdict);
}

}  // namespace

void AddExplore(CLI::App& app, Session& session) {
  const auto arguments = std::make_shared<ExploreArguments>();
  CLI::App* command =
      AddCommand(app, session, "explore",
                 {"prove that no interleaving of the threads goes wrong, or show one that does",
                  "证明线程的任何交错都不会出错，或给出一个出错的交错"},
                 [arguments, &session] { return Explore(*arguments, session); });
  command
      ->add_option("file", arguments->path,
                   session.Say({"scenario (.toml), or a source with //@ comments",
                                "场景文件（.toml），或带 //@ 注释的源程序"}))
      ->required()
      ->type_name("FILE");
  command
      ->add_option(
          "--engine", arguments->engine,
          session.Say(
              {"auto (default), dpor or stateful search all schedules; bounded those with few "
               "preemptions; random, pct and pos try some",
               "auto（默认）、dpor 或 stateful 搜索所有调度；bounded "
               "搜索抢占较少的调度；random、pct "
               "和 pos 只尝试一部分"}))
      ->type_name("NAME")
      ->check(CLI::IsMember({"auto", "dpor", "stateful", "bounded", "random", "pct", "pos"})
                  .description(""));
  command
      ->add_option("--preemptions", arguments->preemptions,
                   session.Say({"the most preemptions of a schedule, for bounded (default 2)",
                                "bounded 引擎的最大抢占次数（默认 2）"}))
      ->type_name("N")
      ->check(CLI::Range(0, 1000).description(""));
  command->add_flag("--races", arguments->races,
                    session.Say({"a data race is a failure", "将数据竞争视为失败"}));
  command->add_flag("--benign", arguments->benign,
                    session.Say({"the same, but for races that change no final value",
                                 "同上，但不改变任何最终值的竞争除外"}));
  command
      ->add_option("--runs", arguments->runs,
                   session.Say({"random schedules to try (default 10000)",
                                "尝试的随机调度数（默认 10000）"}))
      ->type_name("N")
      ->check(CLI::Range(int64_t{1}, int64_t{1'000'000'000'000}).description(""));
  command
      ->add_option("--seed", arguments->seed,
                   session.Say({"of the random schedules (default 1)", "随机调度的种子（默认 1）"}))
      ->type_name("N");
  command
      ->add_option("--depth", arguments->depth,
                   session.Say({"orderings that a fault needs, for pct (default 3)",
                                "pct 引擎所假定的错误深度（默认 3）"}))
      ->type_name("N")
      ->check(CLI::Range(1, 64).description(""));
  command
      ->add_option("--save", arguments->save,
                   session.Say({"write a failing schedule for 'oncard replay'",
                                "写出失败的调度，供“oncard replay”使用"}))
      ->type_name("FILE");
  command
      ->add_option("--report", arguments->report,
                   session.Say({"write the result as a page (.html), or a failure as trace events "
                                "(.json)",
                                "将结果写成网页（.html），或将失败写成跟踪事件（.json）"}))
      ->type_name("FILE")
      ->check([&session](const std::string& path) {
        if (path.ends_with(".html") || path.ends_with(".json")) return std::string();
        return session.Say(
            {"the file must end in .html or .json", "文件名应以 .html 或 .json 结尾"});
      });
  command
      ->add_option("--max-executions", arguments->execution_limit,
                   session.Say({"end the search after so many executions", "执行次数上限"}))
      ->type_name("N")
      ->check(CLI::Range(int64_t{1}, int64_t{1'000'000'000'000}).description(""));
  command
      ->add_option("--max-states", arguments->state_limit,
                   session.Say({"end the search after so many states", "状态数上限"}))
      ->type_name("N")
      ->check(CLI::Range(1u, 4'000'000'000u).description(""));
  AddFormatOption(*command, session, arguments->format, {"text", "json"});
}

}  // namespace oncard::tools
