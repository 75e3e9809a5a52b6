#include "tools/explore_subject.h"

#include <utility>

#include "explore/scenario_exploration.h"
#include "runtime/scenario/file/requirement.h"

namespace oncard::tools {
namespace {

int ReadSource(const Invocation& invocation, const std::string& path, SubjectReading reading,
               ExploreSubject* subject) {
  runtime::ProgramLoad load;
  runtime::Scenario alone;
  alone.structured = reading.structured;
  const int loaded =
      LoadOrReport(invocation, path, runtime::CompileOptions(alone), reading.json, &load);
  if (loaded != kExitOk) return loaded;
  if (load.compilation) subject->source = explore::TextOf(*load.compilation);
  auto read = explore::ReadComments(path, subject->source.text, *load.object);
  if (!read.ok()) return Fail(invocation, kExitUsage, read.error().message);
  subject->scenario = std::move(read.value().scenario);
  subject->scenario.structured = reading.structured;
  subject->requirements = std::move(read.value().requirements);
  subject->object = std::move(*load.object);
  return kExitOk;
}

int ReadScenario(const Invocation& invocation, const std::string& path, SubjectReading reading,
                 ExploreSubject* subject) {
  auto scenario = runtime::LoadScenario(path, runtime::ScenarioUse::kExplore);
  if (!scenario.ok()) return Fail(invocation, kExitUnreadable, scenario.error().message);
  subject->scenario = std::move(scenario).value();
  if (reading.structured) subject->scenario.structured = true;
  subject->requirements = runtime::RequirementsOf(subject->scenario);
  runtime::ProgramLoad load;
  const int loaded = LoadOrReport(invocation, runtime::ProgramPath(subject->scenario),
                                  runtime::CompileOptions(subject->scenario), reading.json, &load);
  if (loaded != kExitOk) return loaded;
  if (load.compilation) subject->source = explore::TextOf(*load.compilation);
  subject->object = std::move(*load.object);
  return kExitOk;
}

}  // namespace

int ReadSubject(const Invocation& invocation, const std::string& path, SubjectReading reading,
                ExploreSubject* subject) {
  return path.ends_with(".toml") ? ReadScenario(invocation, path, reading, subject)
                                 : ReadSource(invocation, path, reading, subject);
}

}  // namespace oncard::tools
