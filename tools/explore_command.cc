// oncard explore: checks whether any interleaving of the threads fails.
#include <xxhash.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/path_bytes.h"
#include "explore/failure_files.h"
#include "explore/host_exploration.h"
#include "explore/scenario_exploration.h"
#include "runtime/scenario/file/scenario_keys.h"
#include "runtime/scenario/record/call_record.h"
#include "tools/commands.h"
#include "tools/explore_options.h"
#include "tools/explore_search.h"
#include "tools/explore_subject.h"
#include "tools/program_warnings.h"
#include "tools/search_watch.h"
#include "tools/terminal.h"
#include "tools/unnamed_search.h"

namespace oncard::tools {
namespace {

explore::Explored ExploredOf(const ExploreSubject& subject) {
  return {subject.scenario, subject.requirements, subject.object, subject.source.text};
}

/// Writes the failing schedule. Returns the exit code.
int SaveSchedule(const std::string& path, const Invocation& invocation,
                 const ExploreSubject& subject, const explore::Findings& findings) {
  const auto text = explore::FailureSchedule(ExploredOf(subject), findings, path);
  if (!text.ok()) return Fail(invocation, kExitInternal, text.error().message);
  return WriteOutput(invocation, path, text.value());
}

/// Writes a scenario that replays the failing schedule and expects that it no longer fails,
/// together with the schedule. Returns the exit code.
int SaveRegression(const std::string& path, const Invocation& invocation,
                   const ExploreSubject& subject, const explore::Findings& findings) {
  const std::string schedule = FileNameOf(PathOf(path).replace_extension(".schedule"));
  const auto text = explore::RegressionScenario(ExploredOf(subject), findings, path, schedule);
  if (!text.ok()) return Fail(invocation, kExitUsage, text.error().message);
  const int saved = SaveSchedule(schedule, invocation, subject, findings);
  if (saved != kExitOk) return saved;
  return WriteOutput(invocation, path, text.value());
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
  if (arguments.merge_private) options.merge_private = true;
  if (arguments.no_merge_private) options.merge_private = false;
  options.dead_locals = !arguments.no_dead_locals;
  options.symmetry = !arguments.no_symmetry;
  options.islands = !arguments.no_islands;
  options.reductions = !arguments.no_reductions;
  options.all = arguments.all;
  return options;
}

/// Reports options that the engine cannot use. Returns the exit code.
int CheckSettings(const ExploreArguments& arguments, const Invocation& invocation,
                  explore::EngineKind engine) {
  if (arguments.merge_private && arguments.no_merge_private) {
    return Fail(invocation, kExitUsage,
                {"'--merge-private' and '--no-merge-private' contradict each other: give one",
                 "“--merge-private”与“--no-merge-private”相互矛盾：只能给出一个"});
  }
  const std::pair<std::string_view, bool> given[] = {
      {"--max-executions", arguments.execution_limit != 0},
      {"--max-states", arguments.state_limit != 0},
      {"--runs", arguments.runs != 0},
      {"--seed", arguments.seed.has_value()},
      {"--depth", arguments.depth.has_value()},
      {"--preemptions", arguments.preemptions.has_value()},
      {"--merge-private", arguments.merge_private},
      {"--no-merge-private", arguments.no_merge_private},
      {"--no-dead-locals", arguments.no_dead_locals},
      {"--no-symmetry", arguments.no_symmetry},
      {"--no-islands", arguments.no_islands},
      {"--no-reductions", arguments.no_reductions}};
  const std::string_view name = explore::EngineName(engine);
  for (const runtime::SearchSetting& setting : runtime::SearchSettings()) {
    const bool is_given =
        std::ranges::find(given, std::pair(setting.option, true)) != std::end(given);
    if (!is_given || setting.UsedBy(name)) continue;
    return Fail(invocation, kExitUsage,
                runtime::DescribeUnusedSetting(setting, setting.option, name));
  }
  return kExitOk;
}

/// Reports which commands of threads were refused, and what the supervisor has found. Returns the
/// exit code for that.
int ReportRefused(const ExploreArguments& arguments, const Invocation& invocation,
                  const ExploreSubject& subject, const explore::Findings& findings) {
  const std::vector<Message> warnings =
      ProgramWarnings(findings, SilentOf(arguments.silent), runtime::ProgramPath(subject.scenario));
  for (const Message& text : warnings) {
    PrintDiagnostics(invocation.Say(
        MakeMessage("oncard: warning: {0}\n", "oncard: 警告：{1}\n", text.en, text.zh)));
  }
  return arguments.strict_commands && !warnings.empty() ? kExitFailed : kExitOk;
}

/// `kept.search, 0123456789abcdef`.
std::string HashedFile(const std::string& path, std::string_view text) {
  return fmt::format("{}, {:016x}", FileNameOf(PathOf(path).filename()),
                     XXH64(text.data(), text.size(), 0));
}

/// How a page says that the search is repeated.
void AddRepetition(const ExploreArguments& arguments, const ExploreSubject& subject,
                   explore::Findings* findings) {
  explore::Repetition& repetition = findings->repetition;
  repetition.command = SameSearch(arguments);
  // A host runs, and not its threads alone.
  if (!findings->exploration.failure || !findings->subject.record.empty()) return;
  auto schedule = explore::FailureSchedule(ExploredOf(subject), *findings, subject.scenario.path);
  if (schedule.ok()) repetition.schedule = std::move(schedule).value();
}

/// Writes the requested output. Returns the exit code.
int Report(const ExploreArguments& arguments, const Invocation& invocation,
           const ExploreSubject& subject, explore::Findings* found) {
  found->source = subject.source;
  if (arguments.report.ends_with(".html")) AddRepetition(arguments, subject, found);
  const explore::Findings& findings = *found;
  const explore::ReportOptions shown = {arguments.full, OutputWidth()};
  PrintResult(arguments.format == "json"
                  ? explore::JsonReport(findings)
                  : explore::TextReport(findings, invocation.language, shown));
  // Where both streams are read together, what is said of files comes after the verdict.
  std::fflush(stdout);
  if (!arguments.report.empty()) {
    const std::string report = arguments.report.ends_with(".html")
                                   ? explore::HtmlReport(findings, invocation.language, shown)
                                   : explore::ChromeReport(findings);
    const int written = WriteOutput(invocation, arguments.report, report);
    if (written != kExitOk) return written;
  }
  if (findings.exploration.failure && !arguments.save.empty()) {
    const int saved = SaveSchedule(arguments.save, invocation, subject, findings);
    if (saved != kExitOk) return saved;
  }
  if (findings.exploration.failure && !arguments.regression.empty()) {
    const int saved = SaveRegression(arguments.regression, invocation, subject, findings);
    if (saved != kExitOk) return saved;
  }
  const int refused = ReportRefused(arguments, invocation, subject, findings);
  return refused != kExitOk ? refused : ExitCodeOf(findings.exploration.verdict);
}

/// How often a search by units is saved.
constexpr std::chrono::seconds kUnitsKept{10};

/// Continues a search that is kept in a file.
int ExploreKept(const ExploreArguments& arguments, const Invocation& invocation,
                const ExploreSubject& subject, const std::string& path, explore::SearchFile file) {
  const int checked = CheckSettings(arguments, invocation, file.engine);
  if (checked != kExitOk) return checked;
  SearchWatch watch(invocation, {.shows = arguments.progress,
                                 .seconds = arguments.seconds,
                                 .memory_mib = arguments.memory_mib,
                                 .pauses = !file.units});
  explore::ExploreOptions options = OptionsOf(arguments, subject);
  options.progress = watch.progress();
  options.kept = path;
  int written = kExitOk;
  const auto keep = [&](const explore::SearchFile& present) {
    written = WriteOutput(invocation, path, explore::FormatSearchFile(present));
    return written == kExitOk;
  };
  // Units are many, and most take a moment.
  auto kept = std::chrono::steady_clock::now();
  const auto keep_often = [&](const explore::SearchFile& present) {
    const auto now = std::chrono::steady_clock::now();
    if (present.units && now - kept < kUnitsKept) return true;
    kept = now;
    return keep(present);
  };
  auto findings = GoOn(subject, options, keep_often, &file);
  if (!findings.ok()) return Fail(invocation, kExitUsage, findings.error().message);
  if (written != kExitOk || !keep(file)) return written;
  findings.value().repetition.searches = {HashedFile(path, explore::FormatSearchFile(file))};
  return Report(arguments, invocation, subject, &findings.value());
}

SubjectReading ReadingOf(const ExploreArguments& arguments) {
  return {arguments.format == "json", arguments.structured};
}

/// Begins a search that is kept in a file, or continues it if the file exists.
int ExploreIntoFile(const ExploreArguments& arguments, const Invocation& invocation) {
  const std::string& input = arguments.paths.front();
  explore::SearchPart part;
  if (!arguments.shard.empty()) {
    const auto parsed = explore::ParsePart(arguments.shard);
    if (!parsed.ok()) return Fail(invocation, kExitUsage, parsed.error().message);
    part = parsed.value();
  }
  std::string path = arguments.search;
  if (path.empty()) {
    path = fmt::format("{}.{}-of-{}.search", FileNameOf(PathOf(input).stem()), part.number,
                       part.count);
  }
  ExploreSubject subject;
  explore::SearchFile file;
  if (FileExists(path)) {
    const int read = ReadSearch(invocation, path, ReadingOf(arguments), &file, &subject);
    if (read != kExitOk) return read;
    return ExploreKept(arguments, invocation, subject, path, std::move(file));
  }
  const int read = ReadSubject(invocation, input, ReadingOf(arguments), &subject);
  if (read != kExitOk) return read;
  ApplyRaceRule(arguments, &subject);
  auto begun = BeginSearch(subject, input, path, part, OptionsOf(arguments, subject));
  if (!begun.ok()) return Fail(invocation, kExitUsage, begun.error().message);
  return ExploreKept(arguments, invocation, subject, path, std::move(begun).value());
}

int Merge(const ExploreArguments& arguments, const Invocation& invocation) {
  ExploreSubject subject;
  explore::SearchFile file;
  std::vector<std::string> incomplete;
  const int merged = MergeSearches(invocation, arguments.paths, ReadingOf(arguments), &file,
                                   &subject, &incomplete);
  if (merged != kExitOk) return merged;
  if (!arguments.search.empty()) {
    const auto moved = MoveSearch(arguments.paths.front(), arguments.search, &file);
    if (!moved.ok()) return Fail(invocation, kExitUsage, moved.error().message);
    const int written = WriteOutput(invocation, arguments.search, explore::FormatSearchFile(file));
    if (written != kExitOk) return written;
  }
  if (const bool fails = file.failed(); arguments.search.empty() && !fails && !file.whole()) {
    return Fail(invocation, kExitUsage,
                MakeMessage("of the {0} parts these are missing: {1}; merge their files, too, or "
                            "save what is there with --search",
                            "{0} 个部分中缺少：{1}；请一并合并其文件，或用 --search 保存已有部分",
                            file.parts, explore::MissingParts(file)));
  }
  explore::ExploreOptions options = OptionsOf(arguments, subject);
  SearchWatch watch(invocation, {.memory_mib = arguments.memory_mib});
  options.progress = watch.progress();
  auto findings = ConcludeSearch(subject, options, file);
  if (!findings.ok()) return Fail(invocation, kExitUsage, findings.error().message);
  for (const std::string& path : arguments.paths) {
    const auto text = ReadFile(path);
    if (!text.ok()) return Fail(invocation, kExitUnreadable, text.error().message);
    findings.value().repetition.searches.push_back(HashedFile(path, text.value()));
  }
  if (findings.value().exploration.verdict == explore::Verdict::kIncomplete) {
    for (const std::string& part : incomplete) {
      const std::string line = "oncard explore " + part;
      findings.value().way_out.next.push_back({line, line});
    }
  }
  return Report(arguments, invocation, subject, &findings.value());
}

/// The record of a host program.
int ExploreHost(const ExploreArguments& arguments, const Invocation& invocation) {
  const std::pair<const char*, bool> unused[] = {
      {"--save", !arguments.save.empty()},     {"--regression", !arguments.regression.empty()},
      {"--search", !arguments.search.empty()}, {"--shard", !arguments.shard.empty()},
      {"--structured", arguments.structured},  {"--races", arguments.races},
      {"--benign", arguments.benign}};
  for (const auto& [option, given] : unused) {
    if (!given) continue;
    return Fail(invocation, kExitUsage,
                MakeMessage("{0} is not for the record of a host program",
                            "{0} 不适用于主机程序的记录", option));
  }
  ExploreSubject subject;
  explore::ExploreOptions options = OptionsOf(arguments, subject);
  const int checked = CheckSettings(arguments, invocation, options.engine);
  if (checked != kExitOk) return checked;
  const std::string& path = arguments.paths.front();
  const auto text = ReadFile(path);
  if (!text.ok()) return Fail(invocation, kExitUnreadable, text.error().message);
  SearchWatch watch(invocation, {.shows = arguments.progress,
                                 .seconds = arguments.seconds,
                                 .memory_mib = arguments.memory_mib,
                                 .pauses = false});
  options.progress = watch.progress();
  auto findings = explore::ExploreRecord(text.value(), path, options);
  if (!findings.ok()) return Fail(invocation, kExitUsage, findings.error().message);
  subject.source = findings.value().source;
  subject.scenario.program = findings.value().subject.program;
  return Report(arguments, invocation, subject, &findings.value());
}

int Explore(const ExploreArguments& arguments, const Invocation& invocation) {
  if (arguments.merge) return Merge(arguments, invocation);
  if (arguments.paths.size() > 1) {
    return Fail(invocation, kExitUsage,
                {"only one file can be explored at a time; --merge takes several",
                 "一次只能探索一个文件；多个文件用于 --merge"});
  }
  const std::string& input = arguments.paths.front();
  if (input.ends_with(runtime::kCallRecordEnding)) return ExploreHost(arguments, invocation);
  ExploreSubject subject;
  if (input.ends_with(".search")) {
    explore::SearchFile file;
    const int read = ReadSearch(invocation, input, ReadingOf(arguments), &file, &subject);
    if (read != kExitOk) return read;
    return ExploreKept(arguments, invocation, subject, input, std::move(file));
  }
  if (!arguments.search.empty() || !arguments.shard.empty()) {
    return ExploreIntoFile(arguments, invocation);
  }
  const int read = ReadSubject(invocation, input, ReadingOf(arguments), &subject);
  if (read != kExitOk) return read;
  ApplyRaceRule(arguments, &subject);
  const auto& wish = subject.scenario.explore;
  if (arguments.engine.empty() && wish && !wish->follow.empty()) {
    auto findings = explore::ExploreAsWished(subject.scenario, subject.object, subject.source.text);
    if (!findings.ok()) return Fail(invocation, kExitUsage, findings.error().message);
    return Report(arguments, invocation, subject, &findings.value());
  }
  explore::ExploreOptions options = OptionsOf(arguments, subject);
  const int checked = CheckSettings(arguments, invocation, options.engine);
  if (checked != kExitOk) return checked;
  UnnamedSearch unnamed(invocation, input, subject, options);
  SearchWatch watch(invocation, {.shows = arguments.progress,
                                 .seconds = arguments.seconds,
                                 .memory_mib = arguments.memory_mib,
                                 .pauses = unnamed.searches_traces()});
  options.progress = watch.progress();
  options.keep = [&unnamed](const explore::TraceSearch& search) { unnamed.Keep(search); };
  auto findings =
      explore::ExploreScenario(subject.scenario, subject.requirements, subject.object, options);
  if (!findings.ok()) return Fail(invocation, kExitUsage, findings.error().message);
  const int reported = Report(arguments, invocation, subject, &findings.value());
  const int kept = unnamed.End(findings.value().exploration, watch.interrupted());
  return kept != kExitOk ? kept : reported;
}

}  // namespace

void AddExplore(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<ExploreArguments>();
  arguments->progress = ErrorsGoToTerminal();
  CLI::App* command =
      AddCommand(app, invocation, "explore",
                 {"prove that a program is correct under every interleaving of its "
                  "threads, or show one that fails",
                  "证明线程的任何交错都不会出错，或给出一个出错的交错"},
                 [arguments, &invocation] { return Explore(*arguments, invocation); });
  AddExploreOptions(*command, invocation, *arguments);
  AddStrictCommandsOption(*command, invocation, arguments->strict_commands);
  AddSilentOption(*command, invocation, arguments->silent);
  AddFormatOption(*command, invocation, arguments->format, {"text", "json"});
}

}  // namespace oncard::tools
