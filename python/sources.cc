#include "python/sources.h"

#include <fmt/format.h>

#include <utility>

#include "explore/scenario_exploration.h"
#include "explore/source_comments.h"
#include "tools/project_session.h"

namespace oncard::python {

session::Files FilesOf(const Source& source) { return {source.files, tools::ReadProjectFile}; }

Result<session::Project> ReadProject(const Source& source, const session::Files& files,
                                     runtime::ScenarioUse use) {
  auto project = session::ReadProject(source.main, files, source.structured, use);
  if (!project.ok() || use != runtime::ScenarioUse::kRun) return project;
  auto& [scenario, compilation, schedule, calls] = project.value();
  // A scenario and a recording say everything themselves, and an object has no comments.
  if (scenario.program != source.main || !compilation.ok() || compilation.files.empty()) {
    return project;
  }
  auto read = explore::AddComments(source.main, compilation.files[0].text(), *compilation.object,
                                   &scenario);
  if (!read.ok()) return read.error();
  return project;
}

Result<CompiledProgram> Compile(const Source& source) {
  const session::Files files = FilesOf(source);
  auto read = session::ReadProgramSource(source.main, files, source.structured);
  if (!read.ok()) return read.error();
  session::ProgramSource& program = read.value();
  const auto reader = [&files](const std::string& path) { return files.Read(path); };
  CompiledProgram compiled;
  compiled.compilation =
      compiler::CompileText(program.path, std::move(program.text), program.options, reader);
  compiled.path = std::move(program.path);
  return compiled;
}

Result<TestKind> KindOfTest(const Source& source) {
  // As `oncard test` does: the name alone says that it is for a host program.
  if (source.main.ends_with(".host.toml")) return TestKind{"host", {}};
  const auto text = FilesOf(source).Read(source.main);
  if (!text.ok()) return text.error();
  const auto scenario =
      runtime::ParseScenario(text.value(), source.main, runtime::ScenarioUse::kTest);
  if (!scenario.ok()) return scenario.error();
  if (scenario.value().host_program) return TestKind{"host", {}};
  const bool checks = explore::ChecksSomething(scenario.value());
  if (const auto& wish = scenario.value().explore)
    return TestKind{"explore", wish->verdict, checks};
  return TestKind{"run", {}, checks};
}

Result<runtime::CardWarnings> WarningsNamed(const std::vector<std::string>& names) {
  runtime::CardWarnings warnings;
  for (const std::string& name : names) {
    const runtime::CardWarningInfo* info = runtime::FindCardWarning(name);
    if (info == nullptr) {
      std::vector<std::string_view> known;
      for (const runtime::CardWarningInfo& each : runtime::CardWarningTable()) {
        known.push_back(each.name);
      }
      return MakeError(1, "'{0}' is no warning about the card; there are: {1}",
                       "“{0}”不是关于控制卡的警告；可用的有：{1}", name, fmt::join(known, ", "));
    }
    warnings.Add(info->warning);
  }
  return warnings;
}

}  // namespace oncard::python
