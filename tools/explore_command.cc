// oncard explore: checks whether any interleaving of the threads fails.
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "explore/scenario_exploration.h"
#include "runtime/scenario/adapted_schedule.h"
#include "runtime/scenario/scenario_keys.h"
#include "runtime/scenario/scenario_run.h"
#include "tools/commands.h"
#include "tools/explore_search.h"
#include "tools/explore_subject.h"
#include "tools/search_watch.h"
#include "tools/terminal.h"

namespace oncard::tools {
namespace {

struct ExploreArguments {
  std::vector<std::string> paths;
  std::string engine;  ///< empty: as in the scenario
  std::string format = "text";
  std::string save;
  std::string regression;
  std::string report;
  int64_t execution_limit = 0;  ///< 0: as in the scenario
  uint32_t state_limit = 0;
  int64_t runs = 0;
  std::optional<uint64_t> seed;
  std::optional<int> depth;
  std::optional<int> preemptions;
  bool merge_private = false;
  bool races = false;
  bool benign = false;
  std::string search;  ///< the file in which the search is kept
  std::string shard;   ///< `I/N`
  bool merge = false;
  bool full = false;
  bool progress = false;
  double seconds = 0;  ///< 0: no limit
  bool all = false;
  bool strict_commands = false;
};

/// The scenario with all requirements, including those in comments of the source.
runtime::Scenario AskingScenario(const ExploreSubject& subject) {
  runtime::Scenario scenario = subject.scenario;
  scenario.final.clear();
  scenario.always.clear();
  scenario.never.clear();
  scenario.eventually.clear();
  runtime::AddRequirements(subject.requirements, &scenario);
  return scenario;
}

/// Writes the failing schedule with checkpoints, as recorded by a run.
int Save(const std::string& path, const Session& session, const ExploreSubject& subject,
         const explore::Findings& findings) {
  const runtime::Scenario moved = runtime::MoveScenario(AskingScenario(subject), path);
  runtime::RunOptions options;
  options.record = true;
  options.replay = std::make_shared<const vm::Schedule>(
      explore::ScheduleOf(findings.subject, *findings.exploration.failure));
  auto run = runtime::RunScenario(subject.scenario, subject.object, options);
  if (!run.ok()) return Fail(session, kExitInternal, run.error().message);
  vm::Schedule schedule = std::move(*run.value().schedule);
  schedule.scenario = runtime::FormatScenario(runtime::ScenarioOfOneRun(moved));
  auto annotated =
      runtime::AnnotateSchedule(subject.scenario, subject.object, subject.source, &schedule);
  if (!annotated.ok()) return Fail(session, kExitInternal, annotated.error().message);
  return WriteOutput(session, path, vm::FormatSchedule(schedule));
}

/// Writes a scenario that replays the failing schedule and expects that it no longer fails,
/// together with the schedule.
int SaveRegression(const ExploreArguments& arguments, const Session& session,
                   const ExploreSubject& subject, const explore::Findings& findings) {
  if (findings.exploration.failure->livelock) {
    return Fail(session, kExitUsage,
                {"a livelock has no end, so its run cannot become a regression test: keep a "
                 "scenario with explore = \"prove\"",
                 "活锁不是可以重复到底的一次运行：请保留带 explore = \"prove\" 的场景"});
  }
  const std::string schedule =
      std::filesystem::path(arguments.regression).replace_extension(".schedule").string();
  const int saved = Save(schedule, session, subject, findings);
  if (saved != kExitOk) return saved;
  runtime::Scenario scenario = runtime::MoveScenario(AskingScenario(subject), arguments.regression);
  runtime::ExploreWish wish;
  wish.verdict = explore::VerdictName(explore::Verdict::kPassed);
  wish.follow = runtime::PathToScenario(scenario, schedule);
  scenario.explore = std::move(wish);
  return WriteOutput(session, arguments.regression, runtime::FormatScenario(scenario));
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

void ApplyRaceRule(const ExploreArguments& arguments, ExploreSubject* subject) {
  if (arguments.races) subject->scenario.races = "none";
  if (arguments.benign) subject->scenario.races = "benign";
  if (arguments.races || arguments.benign) subject->scenario.text_places.erase("races");
}

explore::ExploreOptions OptionsOf(const ExploreArguments& arguments,
                                  const ExploreSubject& subject) {
  explore::ExploreOptions options =
      explore::OptionsOf(subject.scenario.explore.value_or(runtime::ExploreWish{}));
  if (!arguments.engine.empty()) options.engine = *explore::EngineNamed(arguments.engine);
  if (arguments.execution_limit != 0) options.execution_limit = arguments.execution_limit;
  if (arguments.state_limit != 0) options.state_limit = arguments.state_limit;
  if (arguments.runs != 0) options.runs = arguments.runs;
  options.seed = arguments.seed.value_or(options.seed);
  options.depth = arguments.depth.value_or(options.depth);
  options.preemption_limit = arguments.preemptions.value_or(options.preemption_limit);
  options.merge_private = arguments.merge_private;
  options.all = arguments.all;
  return options;
}

/// Reports options that the engine cannot use. Returns the exit code.
int CheckSettings(const ExploreArguments& arguments, const Session& session,
                  explore::EngineKind engine) {
  const std::pair<std::string_view, bool> given[] = {
      {"--max-executions", arguments.execution_limit != 0},
      {"--max-states", arguments.state_limit != 0},
      {"--runs", arguments.runs != 0},
      {"--seed", arguments.seed.has_value()},
      {"--depth", arguments.depth.has_value()},
      {"--preemptions", arguments.preemptions.has_value()},
      {"--merge-private", arguments.merge_private}};
  const std::string_view name = explore::EngineName(engine);
  for (const runtime::SearchSetting& setting : runtime::SearchSettings()) {
    const bool is_given =
        std::ranges::find(given, std::pair(setting.option, true)) != std::end(given);
    if (!is_given || setting.UsedBy(name)) continue;
    return Fail(session, kExitUsage, runtime::DescribeUnusedSetting(setting, setting.option, name));
  }
  return kExitOk;
}

/// Reports which commands of threads were refused. Returns the exit code for that.
int ReportRefused(const ExploreArguments& arguments, const Session& session,
                  const ExploreSubject& subject, const explore::Findings& findings) {
  for (const runtime::RefusedCommand& refused : findings.refused) {
    const Message text =
        runtime::DescribeRefusedPlace(refused, runtime::ProgramPath(subject.scenario));
    PrintDiagnostics(session.Say(
        MakeMessage("oncard: warning: {0}\n", "oncard: 警告：{1}\n", text.en, text.zh)));
  }
  return arguments.strict_commands && !findings.refused.empty() ? kExitFailed : kExitOk;
}

/// Writes the requested output. Returns the exit code.
int Report(const ExploreArguments& arguments, const Session& session, const ExploreSubject& subject,
           explore::Findings findings) {
  findings.source = subject.source;
  const explore::ReportOptions shown = {arguments.full, OutputWidth()};
  PrintResult(arguments.format == "json" ? explore::JsonReport(findings)
                                         : explore::TextReport(findings, session.language, shown));
  if (!arguments.report.empty()) {
    const std::string report = arguments.report.ends_with(".html")
                                   ? explore::HtmlReport(findings, session.language, shown)
                                   : explore::ChromeReport(findings);
    const int written = WriteOutput(session, arguments.report, report);
    if (written != kExitOk) return written;
  }
  if (findings.exploration.failure && !arguments.save.empty()) {
    const int saved = Save(arguments.save, session, subject, findings);
    if (saved != kExitOk) return saved;
  }
  if (findings.exploration.failure && !arguments.regression.empty()) {
    const int saved = SaveRegression(arguments, session, subject, findings);
    if (saved != kExitOk) return saved;
  }
  const int refused = ReportRefused(arguments, session, subject, findings);
  return refused != kExitOk ? refused : ExitCodeOf(findings.exploration.verdict);
}

/// The file name for a search if none is given: one that does not exist yet.
std::string DefaultSearch(const std::string& input) {
  const std::string name = std::filesystem::path(input).stem().string();
  std::string path = name + ".search";
  std::error_code ignored;
  for (int i = 2; std::filesystem::exists(path, ignored); ++i) {
    path = fmt::format("{}.{}.search", name, i);
  }
  return path;
}

/// Continues a search that is kept in a file.
int ExploreKept(const ExploreArguments& arguments, const Session& session,
                const ExploreSubject& subject, const std::string& path, explore::SearchFile file) {
  const int checked = CheckSettings(arguments, session, file.engine);
  if (checked != kExitOk) return checked;
  SearchWatch watch(session,
                    {.shows = arguments.progress, .seconds = arguments.seconds, .pauses = true});
  explore::ExploreOptions options = OptionsOf(arguments, subject);
  options.progress = watch.progress();
  int written = kExitOk;
  const auto keep = [&](const explore::SearchFile& present) {
    written = WriteOutput(session, path, explore::FormatSearchFile(present));
    return written == kExitOk;
  };
  auto findings = GoOn(subject, options, keep, &file);
  if (!findings.ok()) return Fail(session, kExitUsage, findings.error().message);
  if (written != kExitOk || !keep(file)) return written;
  return Report(arguments, session, subject, std::move(findings).value());
}

/// Begins a search that is kept in a file, or continues it if the file exists.
int ExploreIntoFile(const ExploreArguments& arguments, const Session& session) {
  const std::string& input = arguments.paths.front();
  const bool json = arguments.format == "json";
  explore::SearchPart part;
  if (!arguments.shard.empty()) {
    const auto parsed = explore::ParsePart(arguments.shard);
    if (!parsed.ok()) return Fail(session, kExitUsage, parsed.error().message);
    part = parsed.value();
  }
  std::string path = arguments.search;
  if (path.empty()) {
    path = fmt::format("{}.{}-of-{}.search", std::filesystem::path(input).stem().string(),
                       part.number, part.count);
  }
  ExploreSubject subject;
  explore::SearchFile file;
  if (std::filesystem::exists(path)) {
    const int read = ReadSearch(session, path, json, &file, &subject);
    if (read != kExitOk) return read;
    return ExploreKept(arguments, session, subject, path, std::move(file));
  }
  const int read = ReadSubject(session, input, json, &subject);
  if (read != kExitOk) return read;
  ApplyRaceRule(arguments, &subject);
  auto begun = BeginSearch(subject, input, path, part, OptionsOf(arguments, subject));
  if (!begun.ok()) return Fail(session, kExitUsage, begun.error().message);
  return ExploreKept(arguments, session, subject, path, std::move(begun).value());
}

int Merge(const ExploreArguments& arguments, const Session& session) {
  ExploreSubject subject;
  explore::SearchFile file;
  const int merged =
      MergeSearches(session, arguments.paths, arguments.format == "json", &file, &subject);
  if (merged != kExitOk) return merged;
  if (!arguments.search.empty()) {
    const auto moved = MoveSearch(arguments.paths.front(), arguments.search, &file);
    if (!moved.ok()) return Fail(session, kExitUsage, moved.error().message);
    const int written = WriteOutput(session, arguments.search, explore::FormatSearchFile(file));
    if (written != kExitOk) return written;
  }
  auto findings = ConcludeSearch(subject, file);
  if (!findings.ok()) return Fail(session, kExitUsage, findings.error().message);
  return Report(arguments, session, subject, std::move(findings).value());
}

/// Keeps a search for which no file was given, if it takes long or a signal ends it.
class DefaultKeeper {
 public:
  DefaultKeeper(const ExploreArguments& arguments, const Session& session,
                const ExploreSubject& subject, const explore::ExploreOptions& options)
      : session_(session), path_(DefaultSearch(arguments.paths.front())) {
    auto begun = BeginSearch(subject, arguments.paths.front(), path_, {}, options);
    if (!begun.ok()) {
      why_not_ = begun.error().message;
    } else if (begun.value().engine == explore::EngineKind::kDpor) {
      file_ = std::move(begun).value();
      const auto looks_at_states = [](const explore::Requirement& requirement) {
        return requirement.scope != explore::Scope::kFinal;
      };
      searches_traces_ = options.engine == explore::EngineKind::kDpor ||
                         (subject.scenario.races == runtime::Scenario{}.races &&
                          std::ranges::none_of(subject.requirements, looks_at_states));
    }
  }

  /// True if there will be traces to keep.
  bool searches_traces() const { return searches_traces_; }

  /// Saves the progress. Returns the exit code.
  int Keep(const explore::TraceSearch& search) {
    if (!file_ || search.too_deep) return kExitOk;
    file_->traces = search;
    const int written = WriteOutput(session_, path_, explore::FormatSearchFile(*file_));
    if (written == kExitOk && !std::exchange(kept_, true)) {
      PrintDiagnostics(
          session_.Say(MakeMessage("the search is saved in {0}; to continue: oncard explore {0}\n",
                                   "搜索已保存到 {0}；继续：oncard explore {0}\n", path_)));
    }
    return written;
  }

  /// Called at the end of the search, complete or not: an incomplete search is saved, the file of a
  /// complete one is removed. Returns the exit code.
  int End(const explore::Exploration& found, bool interrupted) {
    const bool incomplete = found.verdict == explore::Verdict::kIncomplete;
    const bool left =
        found.traces && !found.traces->complete && found.verdict != explore::Verdict::kProved;
    if (left && (interrupted || (incomplete && kept_))) return Keep(found.search);
    if (interrupted && incomplete && why_not_) {
      const Message text = MakeMessage("oncard: the search could not be saved: {0}\n",
                                       "oncard: 搜索未保存：{1}\n", why_not_->en, why_not_->zh);
      PrintDiagnostics(session_.Say(text));
    }
    std::error_code ignored;
    if (kept_) std::filesystem::remove(path_, ignored);
    return kExitOk;
  }

 private:
  const Session& session_;
  std::string path_;
  std::optional<explore::SearchFile> file_;
  std::optional<Message> why_not_;  ///< why the search cannot be kept
  bool searches_traces_ = false;
  bool kept_ = false;
};

int Explore(const ExploreArguments& arguments, const Session& session) {
  if (arguments.merge) return Merge(arguments, session);
  if (arguments.paths.size() > 1) {
    return Fail(session, kExitUsage,
                {"only one file can be explored at a time; --merge takes several",
                 "一次只能探索一个文件；多个文件用于 --merge"});
  }
  const std::string& input = arguments.paths.front();
  const bool json = arguments.format == "json";
  ExploreSubject subject;
  if (input.ends_with(".search")) {
    explore::SearchFile file;
    const int read = ReadSearch(session, input, json, &file, &subject);
    if (read != kExitOk) return read;
    return ExploreKept(arguments, session, subject, input, std::move(file));
  }
  if (!arguments.search.empty() || !arguments.shard.empty()) {
    return ExploreIntoFile(arguments, session);
  }
  const int read = ReadSubject(session, input, json, &subject);
  if (read != kExitOk) return read;
  ApplyRaceRule(arguments, &subject);
  const auto& wish = subject.scenario.explore;
  if (arguments.engine.empty() && wish && !wish->follow.empty()) {
    auto findings = explore::ExploreAsWished(subject.scenario, subject.object, subject.source);
    if (!findings.ok()) return Fail(session, kExitUsage, findings.error().message);
    return Report(arguments, session, subject, std::move(findings).value());
  }
  explore::ExploreOptions options = OptionsOf(arguments, subject);
  const int checked = CheckSettings(arguments, session, options.engine);
  if (checked != kExitOk) return checked;
  DefaultKeeper keeper(arguments, session, subject, options);
  SearchWatch watch(session, {.shows = arguments.progress,
                              .seconds = arguments.seconds,
                              .pauses = keeper.searches_traces()});
  options.progress = watch.progress();
  options.keep = [&keeper](const explore::TraceSearch& search) { keeper.Keep(search); };
  auto findings =
      explore::ExploreScenario(subject.scenario, subject.requirements, subject.object, options);
  if (!findings.ok()) return Fail(session, kExitUsage, findings.error().message);
  const int kept = keeper.End(findings.value().exploration, watch.interrupted());
  if (kept != kExitOk) return kept;
  return Report(arguments, session, subject, std::move(findings).value());
}

}  // namespace

void AddExplore(CLI::App& app, Session& session) {
  const auto arguments = std::make_shared<ExploreArguments>();
  arguments->progress = ::isatty(STDERR_FILENO) == 1;
  CLI::App* command = AddCommand(app, session, "explore",
                                 {"prove that a program is correct under every interleaving of its "
                                  "threads, or show one that fails",
                                  "证明线程的任何交错都不会出错，或给出一个出错的交错"},
                                 [arguments, &session] { return Explore(*arguments, session); });
  command
      ->add_option("file", arguments->paths,
                   session.Say({"scenario (.toml), a source with //@ comments, or an interrupted "
                                "search (.search)",
                                "场景文件（.toml）、带 //@ 注释的源程序，或中断的搜索（.search）"}))
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
                   session.Say({"maximum number of preemptions, for bounded (default 2)",
                                "bounded 引擎的最大抢占次数（默认 2）"}))
      ->type_name("N")
      ->check(CLI::Range(0, 1000).description(""));
  command->add_flag(
      "--merge-private", arguments->merge_private,
      session.Say(
          {"combine statements that access no global with the one before them: fewer states",
           "将不涉及全局变量的语句并入前一条语句：状态更少"}));
  command->add_flag(
      "--full", arguments->full,
      session.Say({"show every statement of a failing run and every pass of its loops",
                   "列出出错运行的每条语句，循环逐次列出"}));
  command->add_flag("--races", arguments->races,
                    session.Say({"a data race is a failure", "将数据竞争视为失败"}));
  command->add_flag("--benign", arguments->benign,
                    session.Say({"the same, except races that change no final value",
                                 "同上，但不改变任何最终值的竞争除外"}));
  command
      ->add_option("--runs", arguments->runs,
                   session.Say({"number of random schedules (default 10000)",
                                "尝试的随机调度数（默认 10000）"}))
      ->type_name("N")
      ->check(CLI::Range(int64_t{1}, int64_t{1'000'000'000'000}).description(""));
  command
      ->add_option(
          "--seed", arguments->seed,
          session.Say({"seed of the random schedules (default 1)", "随机调度的种子（默认 1）"}))
      ->type_name("N");
  command
      ->add_option("--depth", arguments->depth,
                   session.Say({"number of orderings that a fault needs, for pct (default 3)",
                                "pct 引擎所假定的错误深度（默认 3）"}))
      ->type_name("N")
      ->check(CLI::Range(1, explore::kPctDepthMax).description(""));
  command
      ->add_option("--save", arguments->save,
                   session.Say({"write a failing schedule for 'oncard replay'",
                                "写出失败的调度，供“oncard replay”使用"}))
      ->type_name("FILE");
  command
      ->add_option("--regression", arguments->regression,
                   session.Say({"write a scenario for 'oncard test' that checks a failing schedule "
                                "again, and the schedule beside it",
                                "写出供“oncard test”再次检查失败调度的场景，调度文件在其旁边"}))
      ->type_name("FILE.toml")
      ->check([&session](const std::string& path) {
        if (path.ends_with(".toml")) return std::string();
        return session.Say({"the file name must end in .toml", "文件名应以 .toml 结尾"});
      });
  command
      ->add_option("--report", arguments->report,
                   session.Say({"write the result as a page (.html), or a failure as trace events "
                                "(.json)",
                                "将结果写成网页（.html），或将失败写成跟踪事件（.json）"}))
      ->type_name("FILE")
      ->check([&session](const std::string& path) {
        if (path.ends_with(".html") || path.ends_with(".json")) return std::string();
        return session.Say(
            {"the file name must end in .html or .json", "文件名应以 .html 或 .json 结尾"});
      });
  command
      ->add_option("--max-executions", arguments->execution_limit,
                   session.Say({"end the search after N executions", "执行次数上限"}))
      ->type_name("N")
      ->check(CLI::Range(int64_t{1}, int64_t{1'000'000'000'000}).description(""));
  command
      ->add_option("--max-states", arguments->state_limit,
                   session.Say({"end the search after N states", "状态数上限"}))
      ->type_name("N")
      ->check(CLI::Range(1u, 4'000'000'000u).description(""));
  command
      ->add_option("--time", arguments->seconds,
                   session.Say({"end the search after this time and report what is known",
                                "搜索超过该秒数后结束，并给出已知结果"}))
      ->type_name("SECONDS")
      ->check(CLI::Range(0.001, 1e9).description(""));
  command->add_flag("--all", arguments->all,
                    session.Say({"continue after a failure, so that all are counted",
                                 "出错后继续搜索，以统计全部错误"}));
  command
      ->add_option("--search", arguments->search,
                   session.Say({"save the search in this file; continue it if the file exists",
                                "将搜索保存到该文件；文件已存在时继续该搜索"}))
      ->type_name("FILE");
  command
      ->add_option(
          "--shard", arguments->shard,
          session.Say({"search only the I-th of N parts, for --merge; saved in a search file",
                       "只搜索 N 部分中的第 I 部分，供 --merge 合并；结果存入搜索文件"}))
      ->type_name("I/N");
  command->add_flag("--merge", arguments->merge,
                    session.Say({"merge the search files of the parts", "合并各部分的搜索文件"}));
  command->add_flag("--progress", arguments->progress,
                    session.Say({"show the progress every second (default on a terminal)",
                                 "每秒显示搜索进度（终端上默认开启）"}));
  AddStrictCommandsOption(*command, session, arguments->strict_commands);
  AddFormatOption(*command, session, arguments->format, {"text", "json"});
}

}  // namespace oncard::tools
