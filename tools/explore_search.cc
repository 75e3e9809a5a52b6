#include "tools/explore_search.h"

#include <utility>

#include "base/files.h"
#include "compiler/text.h"
#include "explore/kept_exploration.h"
#include "explore/scenario_exploration.h"
#include "explore/search/search_check.h"

namespace oncard::tools {
namespace {

/// A location whose relative paths are those of a file at `path`.
runtime::Scenario At(const std::string& path) {
  runtime::Scenario scenario;
  scenario.path = path;
  return scenario;
}

explore::SearchedScenario SearchedOf(const ExploreSubject& subject) {
  return {subject.scenario, subject.requirements, subject.object};
}

Result<explore::Problem> ProblemOf(const ExploreSubject& subject) {
  return explore::ProblemOfScenario(subject.scenario, subject.requirements, subject.object);
}

Result<uint64_t> HashOf(const ExploreSubject& subject) {
  const auto by_cases = explore::IsKeptByCases(SearchedOf(subject));
  if (!by_cases.ok()) return by_cases.error();
  if (by_cases.value()) return explore::HashByCases(SearchedOf(subject));
  const auto problem = ProblemOf(subject);
  if (!problem.ok()) return problem.error();
  return explore::HashOf(problem.value());
}

/// The search file contains the path of the program and must be valid text.
Result<void> CheckInput(const std::string& input) {
  if (compiler::IsUtf8(input)) return {};
  return MakeError(1,
                   "the search of '{0}' cannot be saved: its path is not UTF-8, as a search file "
                   "must be; rename the file or its folder",
                   "无法保存“{0}”的搜索：其路径不是 UTF-8，而搜索文件必须是 UTF-8；"
                   "请重命名该文件或文件夹",
                   input);
}

Error Prefixed(const std::string& path, const Message& message) {
  return MakeError(1, "{0}: {1}", "{0}：{2}", path, message.en, message.zh);
}

/// Checks the file's data with its program, whose hash it has. Returns the exit code.
int Check(const Invocation& invocation, const std::string& path, const ExploreSubject& subject,
          const explore::SearchFile& file) {
  const auto check = [&]() -> Result<void> {
    const auto by_cases = explore::IsKeptByCases(SearchedOf(subject));
    if (!by_cases.ok()) return by_cases.error();
    if (by_cases.value()) return explore::CheckByCases(SearchedOf(subject), file);
    const auto problem = ProblemOf(subject);
    if (!problem.ok()) return problem.error();
    return explore::CheckSearch(problem.value(), file);
  };
  const auto checked = check();
  if (checked.ok()) return kExitOk;
  return Fail(invocation, kExitUnreadable, Prefixed(path, checked.error().message).message);
}

Result<explore::SearchFile> ReadFileOf(const std::string& path) {
  const auto text = ReadFile(path, kSearchKind);
  if (!text.ok()) return text.error();
  auto file = explore::ParseSearchFile(text.value());
  if (file.ok()) return file;
  return Prefixed(path, file.error().message);
}

}  // namespace

int ReadSearch(const Invocation& invocation, const std::string& path, SubjectReading reading,
               explore::SearchFile* file, ExploreSubject* subject) {
  auto read = ReadFileOf(path);
  if (!read.ok()) return Fail(invocation, kExitUnreadable, read.error().message);
  *file = std::move(read).value();
  const std::string input = runtime::PathFromScenario(At(path), file->input);
  const int found = ReadSubject(invocation, input, reading, subject);
  if (found != kExitOk) return found;
  subject->scenario.races = file->races;
  const auto hash = HashOf(*subject);
  if (!hash.ok()) return Fail(invocation, kExitUsage, hash.error().message);
  if (hash.value() != file->problem) {
    return Fail(invocation, kExitFailed,
                MakeMessage("{0} has changed since {1} was written: explore it again",
                            "{1} 写出之后 {0} 已改变：请重新探索", input, path));
  }
  return Check(invocation, path, *subject, *file);
}

int MergeSearches(const Invocation& invocation, const std::vector<std::string>& paths,
                  SubjectReading reading, explore::SearchFile* file, ExploreSubject* subject,
                  std::vector<std::string>* incomplete) {
  const int read = ReadSearch(invocation, paths.front(), reading, file, subject);
  if (read != kExitOk) return read;
  if (!file->done()) incomplete->push_back(paths.front());
  for (size_t i = 1; i < paths.size(); ++i) {
    const auto other = ReadFileOf(paths[i]);
    if (!other.ok()) return Fail(invocation, kExitUnreadable, other.error().message);
    if (other.value().problem == file->problem) {
      const int checked = Check(invocation, paths[i], *subject, other.value());
      if (checked != kExitOk) return checked;
    }
    if (!other.value().done()) incomplete->push_back(paths[i]);
    if (const auto merged = MergeInto(file, other.value()); !merged.ok()) {
      return Fail(invocation, kExitUsage, Prefixed(paths[i], merged.error().message).message);
    }
  }
  return kExitOk;
}

Result<explore::SearchFile> BeginSearch(const ExploreSubject& subject, const std::string& input,
                                        const std::string& path, const explore::SearchPart& part,
                                        const explore::ExploreOptions& options) {
  using explore::EngineKind;
  const std::string seen = runtime::PathToScenario(At(path), input);
  if (auto checked = CheckInput(seen); !checked.ok()) return checked.error();
  const auto by_cases = explore::IsKeptByCases(SearchedOf(subject));
  if (!by_cases.ok()) return by_cases.error();
  if (by_cases.value()) {
    auto begun = explore::BeginByCases(SearchedOf(subject), options, part);
    if (begun.ok()) begun.value().input = seen;
    return begun;
  }
  const auto problem = ProblemOf(subject);
  if (!problem.ok()) return problem.error();
  explore::SearchFile file;
  file.input = seen;
  file.problem = explore::HashOf(problem.value());
  file.races = subject.scenario.races;
  file.parts = part.count;
  file.held = {part.number};
  switch (options.engine) {
    case EngineKind::kAuto:
    case EngineKind::kDpor:
      file.traces = explore::TracesOfPart(problem.value(), part);
      return file;
    case EngineKind::kRandom:
    case EngineKind::kPct:
    case EngineKind::kPos:
      file.engine = options.engine;
      file.seed = options.seed;
      file.depth = options.depth;
      file.runs = options.runs;
      file.runs_cut = explore::RunsOfPart(options.runs, part).second;
      return file;
    case EngineKind::kStateful:
    case EngineKind::kBounded:
    case EngineKind::kFollow:
      break;
  }
  return MakeError(
      1, "searches of the engine {0} cannot be saved or split: use dpor, random, pct or pos",
      "{0} 引擎的搜索不能保存或拆分：请使用 dpor、random、pct 或 pos",
      explore::EngineName(options.engine));
}

Result<explore::Findings> GoOn(const ExploreSubject& subject,
                               const explore::ExploreOptions& options,
                               const explore::SearchKeeper& keep, explore::SearchFile* file) {
  const auto by_cases = explore::IsKeptByCases(SearchedOf(subject));
  if (!by_cases.ok()) return by_cases.error();
  if (by_cases.value()) return explore::GoOnByCases(SearchedOf(subject), options, keep, file);
  const auto problem = ProblemOf(subject);
  if (!problem.ok()) return problem.error();
  auto exploration = explore::GoOn(problem.value(), options, keep, file);
  if (!exploration.ok()) return exploration.error();
  explore::Findings findings =
      FindingsOf(subject.scenario, problem.value(), std::move(exploration).value());
  if (findings.exploration.verdict == explore::Verdict::kIncomplete) {
    explore::ExploreOptions of_file = options;
    of_file.engine = file->engine;
    findings.way_out = WayOutOf(findings.subject, findings.exploration, of_file, problem.value());
  }
  return findings;
}

Result<explore::Findings> ConcludeSearch(const ExploreSubject& subject,
                                         const explore::ExploreOptions& options,
                                         const explore::SearchFile& file) {
  const auto by_cases = explore::IsKeptByCases(SearchedOf(subject));
  if (!by_cases.ok()) return by_cases.error();
  if (by_cases.value()) return explore::ConcludeByCases(SearchedOf(subject), options, file);
  const auto problem = ProblemOf(subject);
  if (!problem.ok()) return problem.error();
  return FindingsOf(subject.scenario, problem.value(), Conclude(problem.value(), file));
}

Result<void> MoveSearch(const std::string& from, const std::string& to, explore::SearchFile* file) {
  const std::string input = runtime::PathFromScenario(At(from), file->input);
  file->input = runtime::PathToScenario(At(to), input);
  return CheckInput(file->input);
}

}  // namespace oncard::tools
