#include "tools/explore_search.h"

#include <utility>

#include "base/files.h"
#include "compiler/text.h"
#include "explore/scenario_exploration.h"
#include "explore/search/search_check.h"
#include "runtime/scenario/run/choices.h"
#include "runtime/scenario/run/scenario_card.h"

namespace oncard::tools {
namespace {

/// A location whose relative paths are those of a file at `path`.
runtime::Scenario At(const std::string& path) {
  runtime::Scenario scenario;
  scenario.path = path;
  return scenario;
}

Result<explore::Problem> ProblemOf(const ExploreSubject& subject) {
  if (runtime::NeedsCard(subject.scenario, subject.object)) {
    return MakeError(
        1,
        "the search of a program with its card cannot be saved or split: explore it in one piece",
        "带控制卡的程序的搜索不能保存或拆分：请一次完成探索");
  }
  const auto choices = runtime::Choices::Of(subject.scenario);
  if (!choices.ok()) return choices.error();
  if (!choices.value().empty()) {
    return MakeError(
        1,
        "the search of all cases of choices cannot be saved or split: explore it in one "
        "piece",
        "对所有选择的搜索不能保存或拆分：请一次完成探索");
  }
  return explore::ProblemOfScenario(subject.scenario, subject.requirements, subject.object);
}

/// The search file contains the path of the program and must be valid text.
Result<void> CheckInput(const explore::SearchFile& file) {
  if (compiler::IsUtf8(file.input)) return {};
  return MakeError(1,
                   "the search of '{0}' cannot be saved: its path is not UTF-8, as a search file "
                   "must be; rename the file or its folder",
                   "无法保存“{0}”的搜索：其路径不是 UTF-8，而搜索文件必须是 UTF-8；"
                   "请重命名该文件或文件夹",
                   file.input);
}

Error Prefixed(const std::string& path, const Message& message) {
  return MakeError(1, "{0}: {1}", "{0}：{2}", path, message.en, message.zh);
}

/// Checks the file's data with its program. Returns the exit code.
int Check(const Invocation& invocation, const std::string& path, const explore::Problem& problem,
          const explore::SearchFile& file) {
  const auto checked = explore::CheckSearch(problem, file);
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
  const auto problem = ProblemOf(*subject);
  if (!problem.ok()) return Fail(invocation, kExitUsage, problem.error().message);
  if (explore::HashOf(problem.value()) != file->problem) {
    return Fail(invocation, kExitFailed,
                MakeMessage("{0} has changed since {1} was written: explore it again",
                            "{1} 写出之后 {0} 已改变：请重新探索", input, path));
  }
  return Check(invocation, path, problem.value(), *file);
}

int MergeSearches(const Invocation& invocation, const std::vector<std::string>& paths,
                  SubjectReading reading, explore::SearchFile* file, ExploreSubject* subject) {
  const int read = ReadSearch(invocation, paths.front(), reading, file, subject);
  if (read != kExitOk) return read;
  const auto problem = ProblemOf(*subject);
  if (!problem.ok()) return Fail(invocation, kExitUsage, problem.error().message);
  for (size_t i = 1; i < paths.size(); ++i) {
    const auto other = ReadFileOf(paths[i]);
    if (!other.ok()) return Fail(invocation, kExitUnreadable, other.error().message);
    if (other.value().problem == file->problem) {
      const int checked = Check(invocation, paths[i], problem.value(), other.value());
      if (checked != kExitOk) return checked;
    }
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
  const auto problem = ProblemOf(subject);
  if (!problem.ok()) return problem.error();
  explore::SearchFile file;
  file.input = runtime::PathToScenario(At(path), input);
  if (auto checked = CheckInput(file); !checked.ok()) return checked.error();
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
  const auto problem = ProblemOf(subject);
  if (!problem.ok()) return problem.error();
  auto exploration = explore::GoOn(problem.value(), options, keep, file);
  if (!exploration.ok()) return exploration.error();
  return FindingsOf(subject.scenario, problem.value(), std::move(exploration).value());
}

Result<explore::Findings> ConcludeSearch(const ExploreSubject& subject,
                                         const explore::SearchFile& file) {
  const auto problem = ProblemOf(subject);
  if (!problem.ok()) return problem.error();
  return FindingsOf(subject.scenario, problem.value(), Conclude(problem.value(), file));
}

Result<void> MoveSearch(const std::string& from, const std::string& to, explore::SearchFile* file) {
  const std::string input = runtime::PathFromScenario(At(from), file->input);
  file->input = runtime::PathToScenario(At(to), input);
  return CheckInput(*file);
}

}  // namespace oncard::tools
