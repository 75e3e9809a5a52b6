#include "tools/explore_search.h"

#include <utility>

#include "base/files.h"
#include "compiler/text.h"
#include "explore/kept_exploration.h"

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
  const auto checked = explore::CheckKept(SearchedOf(subject), file);
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
  const auto hash = explore::HashOfKept(SearchedOf(*subject));
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
  const std::string seen = runtime::PathToScenario(At(path), input);
  if (auto checked = CheckInput(seen); !checked.ok()) return checked.error();
  auto begun = explore::BeginKept(SearchedOf(subject), options, part);
  if (begun.ok()) begun.value().input = seen;
  return begun;
}

Result<explore::Findings> GoOn(const ExploreSubject& subject,
                               const explore::ExploreOptions& options,
                               const explore::SearchKeeper& keep, explore::SearchFile* file) {
  return explore::GoOnKept(SearchedOf(subject), options, keep, file);
}

Result<explore::Findings> ConcludeSearch(const ExploreSubject& subject,
                                         const explore::ExploreOptions& options,
                                         const explore::SearchFile& file) {
  return explore::ConcludeKept(SearchedOf(subject), options, file);
}

Result<void> MoveSearch(const std::string& from, const std::string& to, explore::SearchFile* file) {
  const std::string input = runtime::PathFromScenario(At(from), file->input);
  file->input = runtime::PathToScenario(At(to), input);
  return CheckInput(file->input);
}

}  // namespace oncard::tools
