#include "session/project.h"

#include <algorithm>
#include <utility>

#include "base/files.h"
#include "vm/object_reader.h"

namespace oncard::session {
namespace {

Result<std::shared_ptr<const vm::Schedule>> ReadSchedule(const std::string& path,
                                                         const Files& files) {
  const auto text = files.Read(path);
  if (!text.ok()) return text.error();
  auto schedule = vm::ParseScheduleFile(path, text.value());
  if (!schedule.ok()) return schedule.error();
  return std::make_shared<const vm::Schedule>(std::move(schedule).value());
}

/// Reads the scenario, which may come from a recording.
Result<void> ReadScenario(const std::string& main, const Files& files, runtime::ScenarioUse use,
                          Project* project) {
  std::string text;
  runtime::TextMargin margin;
  if (main.ends_with(".schedule")) {
    auto schedule = ReadSchedule(main, files);
    if (!schedule.ok()) return schedule.error();
    project->schedule = std::move(schedule).value();
    text = project->schedule->scenario;
    margin = {vm::kLinesBeforeScenario, static_cast<int>(vm::kScenarioPrefix.size())};
  } else if (main.ends_with(".toml")) {
    auto read = files.Read(main);
    if (!read.ok()) return read.error();
    text = std::move(read).value();
  } else {
    project->scenario.program = main;
    return {};
  }
  auto scenario = runtime::ParseScenario(text, main, use, margin);
  if (!scenario.ok()) return scenario.error();
  project->scenario = std::move(scenario).value();
  return {};
}

Result<void> ReadProgram(const Files& files, Project* project) {
  const std::string path = runtime::ProgramPath(project->scenario);
  auto text = files.Read(path);
  if (!text.ok()) return text.error();
  if (path.ends_with(".bin")) {
    auto ini = files.Read(vm::IniPathFor(path));
    if (!ini.ok()) return ini.error();
    auto object = vm::ReadObject({std::move(text).value(), std::move(ini).value()});
    if (!object.ok()) return object.error();
    project->compilation.object = std::move(object).value();
    return {};
  }
  const auto reader = [&files](const std::string& name) { return files.Read(name); };
  project->compilation = compiler::CompileText(path, std::move(text).value(),
                                               runtime::CompileOptions(project->scenario), reader);
  return {};
}

Error NoProgram(const std::string& main) {
  return MakeError(1, "'{0}' is a record of host calls, which is only for 'load'",
                   "“{0}”是主机调用记录，只能用于“load”", main);
}

void NoteMissing(const std::string& path, std::vector<std::string>* missing) {
  if (std::ranges::find(*missing, path) == missing->end()) missing->push_back(path);
}

}  // namespace

Result<std::string> Files::Read(const std::string& path) const {
  if (const auto found = texts_.find(path); found != texts_.end()) return found->second;
  if (other_) {
    auto text = other_(path);
    if (!text.ok() && text.error().code == kNoSuchFile) NoteMissing(path, &missing_);
    return text;
  }
  NoteMissing(path, &missing_);
  return MakeError(kNoSuchFile, "there is no file '{0}': give it with the request",
                   "没有文件“{0}”：请随请求一起给出", path);
}

Result<ProgramSource> ReadProgramSource(const std::string& main, const Files& files,
                                        bool structured) {
  Project project;
  if (main.ends_with(runtime::kCallRecordEnding)) return NoProgram(main);
  if (auto read = ReadScenario(main, files, runtime::ScenarioUse::kText, &project); !read.ok()) {
    return read.error();
  }
  if (structured) project.scenario.structured = true;
  ProgramSource source;
  source.path = runtime::ProgramPath(project.scenario);
  if (source.path.ends_with(".bin")) {
    return MakeError(1, "'{0}' is an object file and has no source", "“{0}”是目标文件，没有源程序",
                     source.path);
  }
  auto text = files.Read(source.path);
  if (!text.ok()) return text.error();
  source.text = std::move(text).value();
  source.options = runtime::CompileOptions(project.scenario);
  return source;
}

Result<Project> ReadProject(const std::string& main, const Files& files, bool structured,
                            runtime::ScenarioUse use) {
  Project project;
  if (main.ends_with(runtime::kCallRecordEnding)) {
    if (use != runtime::ScenarioUse::kSession) return NoProgram(main);
    auto text = files.Read(main);
    if (!text.ok()) return text.error();
    project.calls = std::move(text).value();
    return project;
  }
  if (auto read = ReadScenario(main, files, use, &project); !read.ok()) return read.error();
  if (structured) project.scenario.structured = true;
  if (auto read = ReadProgram(files, &project); !read.ok()) return read.error();
  const std::string& policy = project.scenario.schedule;
  if (project.schedule == nullptr && policy.starts_with(runtime::kReplayPrefix)) {
    auto schedule = ReadSchedule(
        runtime::PathFromScenario(project.scenario, policy.substr(runtime::kReplayPrefix.size())),
        files);
    if (!schedule.ok()) return schedule.error();
    project.schedule = std::move(schedule).value();
  }
  return project;
}

}  // namespace oncard::session
