#include "web/wasm/exploration.h"

#include <algorithm>
#include <utility>

#include "compiler/diagnostic_printer.h"
#include "explore/question.h"
#include "explore/reports/interleaving.h"
#include "explore/reports/report.h"
#include "explore/scenario_exploration.h"
#include "runtime/scenario/file/scenario.h"
#include "session/arguments.h"
#include "session/project.h"

namespace oncard::web {
namespace {

using session::Json;

/// So many states of any program fit into the memory of a module, at most 4 GiB.
constexpr uint32_t kStateLimit = 2'000'000;

Result<explore::Findings> Search(const explore::Question& question, const std::string& source,
                                 const vm::Object& object, const session::Files& files) {
  const runtime::ExploreWish wish = question.scenario.explore.value_or(runtime::ExploreWish{});
  if (!wish.follow.empty()) {
    return explore::FollowWished(question, object, source,
                                 [&files](const std::string& path) { return files.Read(path); });
  }
  explore::ExploreOptions options = explore::OptionsOf(wish);
  options.state_limit = std::min(options.state_limit, kStateLimit);
  return explore::ExploreScenario(question.scenario, question.requirements, object, options);
}

}  // namespace

Result<Json> Explore(const Json& json, Language* language, std::vector<std::string>* missing) {
  session::Arguments arguments(json);
  const std::string main = arguments.Text("main");
  const session::Files files(arguments.TextsByName("files"), {});
  const bool structured = arguments.Flag("structured", false);
  const bool chinese = arguments.Has("language") && arguments.Word("language", {"en", "zh"}) == 1;
  if (auto mistakes = arguments.Mistakes()) return *std::move(mistakes);
  if (chinese) *language = Language::kChinese;

  const auto project =
      session::ReadProject(main, files, structured, runtime::ScenarioUse::kExplore);
  *missing = files.missing();
  if (!project.ok()) return project.error();
  const compiler::Compilation& compilation = project.value().compilation;
  Json answer = {{"compiled", compilation.ok()},
                 {"diagnostics", compiler::DiagnosticsJson(compilation, *language)}};
  if (!compilation.ok()) return answer;

  explore::ProgramText source = explore::TextOf(compilation);
  const vm::Object& object = *compilation.object;
  const auto question = explore::QuestionOf(main, project.value().scenario, source.text, object);
  if (!question.ok()) return question.error();
  auto findings = Search(question.value(), source.text, object, files);
  *missing = files.missing();
  if (!findings.ok()) return findings.error();
  findings.value().source = std::move(source);
  if (const auto& wish = question.value().scenario.explore) answer["expected"] = wish->verdict;
  answer["report"] = Json::parse(explore::JsonReport(findings.value()));
  answer["text"] = explore::TextReport(findings.value(), *language);
  if (findings.value().exploration.failure) {
    auto schedule =
        explore::FailureScheduleBeside(main, question.value(), object, findings.value());
    if (!schedule.ok()) return schedule.error();
    answer["schedule"] = std::move(schedule).value();
    const explore::Failure& failure = *findings.value().exploration.failure;
    answer["interleaving"] = explore::InterleavingJson(findings.value(), failure, *language);
  }
  return answer;
}

}  // namespace oncard::web
