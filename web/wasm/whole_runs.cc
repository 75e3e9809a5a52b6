#include "web/wasm/whole_runs.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "base/files.h"
#include "base/json_text.h"
#include "compiler/compiler.h"
#include "compiler/diagnostic_printer.h"
#include "explore/reports/report.h"
#include "explore/scenario_exploration.h"
#include "runtime/scenario/requirement_watch.h"
#include "runtime/scenario/result_json.h"
#include "runtime/scenario/scenario.h"

namespace oncard::web {
namespace {

using Json = nlohmann::ordered_json;

/// So many states of any program fit into the memory of a module, at most 4 GiB.
constexpr int64_t kStateLimit = 2'000'000;

/// The string at a key of an object.
const std::string* TextAt(const Json& object, std::string_view key) {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : found->get_ptr<const std::string*>();
}

/// Diagnostics as `oncard check --diagnostics=json` prints them, each in a line.
Json DiagnosticsOf(const compiler::Compilation& compilation) {
  Json diagnostics = Json::array();
  const std::string lines = compiler::PrintJson(compilation, {});
  for (size_t begin = 0; begin < lines.size();) {
    const size_t end = std::min(lines.find('\n', begin), lines.size());
    diagnostics.push_back(Json::parse(lines.substr(begin, end - begin)));
    begin = end + 1;
  }
  return diagnostics;
}

Result<std::string> FileAt(const Json& arguments, const std::string& path) {
  const auto files = arguments.find("files");
  const std::string* text = files == arguments.end() ? nullptr : TextAt(*files, path);
  if (text != nullptr) return *text;
  return MakeError(kNoSuchFile, "there is no file '{0}': give it with the request",
                   "没有文件“{0}”：请随请求一起给出", path);
}

Result<runtime::Scenario> ScenarioOf(const Json& arguments, runtime::ScenarioUse use) {
  const std::string* path = TextAt(arguments, "main");
  if (path == nullptr) {
    return MakeError(1, "'main' must be the name of a file", "“main”应为文件名");
  }
  const auto text = FileAt(arguments, *path);
  if (!text.ok()) return text.error();
  return runtime::ParseScenario(text.value(), *path, use);
}

Result<Json> Run(const runtime::Scenario& scenario, const vm::Object& object) {
  auto result = runtime::RunWithRequirements(scenario, object, {});
  if (!result.ok()) return result.error();
  return Json{{"run", runtime::ResultJson(result.value(), Language::kEnglish)}};
}

Result<Json> Explore(runtime::Scenario scenario, const vm::Object& object,
                     const std::string& source) {
  if (!scenario.explore) scenario.explore.emplace();
  int64_t& states = scenario.explore->max_states;
  states = states == 0 ? kStateLimit : std::min(states, kStateLimit);
  auto findings = explore::ExploreAsWished(scenario, object, source);
  if (!findings.ok()) return findings.error();
  findings.value().source = source;
  return Json{{"report", Json::parse(explore::JsonReport(findings.value()))},
              {"text", explore::TextReport(findings.value(), Language::kEnglish)}};
}

Result<Json> Answer(const Json& request) {
  if (!request.is_object()) {
    return MakeError(1, "a request is a JSON object", "请求应为 JSON 对象");
  }
  const std::string* kind = TextAt(request, "request");
  const auto arguments = request.find("arguments");
  if (kind == nullptr || (*kind != "run" && *kind != "explore") || arguments == request.end()) {
    return MakeError(1, "a request is 'run' or 'explore', with 'arguments'",
                     "请求应为“run”或“explore”，并带有“arguments”");
  }
  const bool runs = *kind == "run";
  auto scenario =
      ScenarioOf(*arguments, runs ? runtime::ScenarioUse::kRun : runtime::ScenarioUse::kExplore);
  if (!scenario.ok()) return scenario.error();
  const compiler::Compilation compilation = compiler::Compile(
      runtime::ProgramPath(scenario.value()), runtime::CompileOptions(scenario.value()),
      [&](const std::string& name) { return FileAt(*arguments, name); });
  Json answer = {{"compiled", compilation.ok()}, {"diagnostics", DiagnosticsOf(compilation)}};
  if (!compilation.ok()) return answer;
  const vm::Object& object = *compilation.object;
  const auto result =
      runs ? Run(scenario.value(), object)
           : Explore(std::move(scenario).value(), object, compilation.files[0].text());
  if (!result.ok()) return result.error();
  answer.update(result.value());
  return answer;
}

}  // namespace

std::string HandleRequest(std::string_view text) {
  const Json request = Json::parse(text, nullptr, false);
  const auto answer = Answer(request);
  Json response = {{"id", request.is_object() ? request.value("id", Json()) : Json()},
                   {"ok", answer.ok()}};
  if (answer.ok()) {
    response["result"] = answer.value();
  } else {
    response["error"] = answer.error().message.en;
  }
  return JsonText(response) + '\n';
}

}  // namespace oncard::web
