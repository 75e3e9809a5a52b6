#include "tools/explore_subject.h"

#include <utility>

#include "explore/scenario_exploration.h"
#include "runtime/scenario/requirement.h"

namespace oncard::tools {
namespace {

int ReadSource(const Session& session, const std::string& path, bool json,
               ExploreSubject* subject) {
  runtime::ProgramLoad load;
  const int loaded = LoadOrReport(session, path, {}, json, &load);
  if (loaded != kExitOk) return loaded;
  subject->source = load.compilation ? load.compilation->files[0].text() : std::string();
  auto read = explore::ReadComments(path, subject->source, *load.object);
  if (!read.ok()) return Fail(session, kExitUsage, read.error().message);
  subject->scenario = std::move(read.value().scenario);
  subject->requirements = std::move(read.value().requirements);
  subject->object = std::move(*load.object);
  return kExitOk;
}

int ReadScenario(const Session& session, const std::string& path, bool json,
                 ExploreSubject* subject) {
  auto scenario = runtime::LoadScenario(path, runtime::ScenarioUse::kExplore);
  if (!scenario.ok()) return Fail(session, kExitUnreadable, scenario.error().message);
  subject->scenario = std::move(scenario).value();
  subject->requirements = runtime::RequirementsOf(subject->scenario);
  runtime::ProgramLoad load;
  const int loaded = LoadOrReport(session, runtime::ProgramPath(subject->scenario),
                                  runtime::CompileOptions(subject->scenario), json, &load);
  if (loaded != kExitOk) return loaded;
  subject->source = load.compilation ? load.compilation->files[0].text() : std::string();
  subject->object = std::move(*load.object);
  return kExitOk;
}

}  // namespace

int ReadSubject(const Session& session, const std::string& path, bool json,
                ExploreSubject* subject) {
  return path.ends_with(".toml") ? ReadScenario(session, path, json, subject)
                                 : ReadSource(session, path, json, subject);
}

}  // namespace oncard::tools
