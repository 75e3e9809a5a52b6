// Tested by tests/tools/run_command_test.cc.
#include "runtime/scenario/run/result_json.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "runtime/observe/thread_status.h"

namespace oncard::runtime {
namespace {

using Json = nlohmann::ordered_json;

// The numbers are already written in the form that JSON uses.
Json Number(const std::string& text) { return Json::parse(text, nullptr, false); }

/// `reads` by name, `writes` as `[old, new]`.
Json StepsJson(const StepLog& log) {
  Json steps = Json::array();
  for (const LoggedStep& step : log.steps) {
    const vm::Object& object = log.image->object;
    Json json = {{"thread", step.thread}, {"line", step.line}, {"at_ms", step.at_ms}};
    for (const SlotValue& read : step.reads) {
      json["reads"][NameOf(step, read.slot, object)] =
          Number(ValueText(step, read.slot, read.raw, object));
    }
    for (const SlotChange& write : step.writes) {
      json["writes"][NameOf(step, write.slot, object)] = {
          Number(ValueText(step, write.slot, write.before, object)),
          Number(ValueText(step, write.slot, write.after, object))};
    }
    steps.push_back(std::move(json));
  }
  return steps;
}

/// quiet, until, time-limit, deadlock, schedule-end, diverged, interrupted.
std::string_view EndName(const ScenarioResult& result) {
  if (result.interrupted) return "interrupted";
  if (result.reached_until && result.end != RunEnd::kDeadlock) return "until";
  switch (result.end) {
    case RunEnd::kQuiet:
      return "quiet";
    case RunEnd::kTimeLimit:
      return "time-limit";
    case RunEnd::kDeadlock:
      return "deadlock";
    case RunEnd::kScheduleEnd:
      return "schedule-end";
    case RunEnd::kScheduleDiverged:
      return "diverged";
  }
  return "quiet";
}

}  // namespace

nlohmann::ordered_json ResultJson(const ScenarioResult& result, Language language) {
  Json json;
  if (result.chosen != nullptr) json["choice"] = result.choice.In(language);
  json["passed"] = result.passed();
  json["end"] = EndName(result);
  json["time_ms"] = result.end_ms;
  json["statements"] = result.statements;
  json["program_hash"] = fmt::format("{:016x}", result.program_hash);
  json["state_hash"] = fmt::format("{:016x}", result.hash);
  json["threads"] = Json::array();
  for (const ThreadReport& thread : result.threads) {
    json["threads"].push_back({{"thread", thread.thread},
                               {"function", thread.function},
                               {"page", thread.page},
                               {"state", ThreadStateName(thread.run)},
                               {"result", Number(thread.result)},
                               {"error", thread.error},
                               {"place", thread.place},
                               {"statements", thread.statements},
                               {"status", thread.status.In(language)}});
  }
  json["values"] = Json::object();
  for (const ShownValue& value : result.values) {
    Json elements = Json::array();
    for (const std::string& element : value.elements) elements.push_back(Number(element));
    json["values"][value.name] = value.array ? elements : elements.front();
  }
  if (result.steps) json["steps"] = StepsJson(*result.steps);
  json["failures"] = Json::array();
  for (const ScenarioFailure& failure : result.failures) {
    json["failures"].push_back(
        {{"expectation", failure.expectation}, {"message", failure.message.In(language)}});
  }
  json["warnings"] = Json::array();
  for (const Message& warning : result.warnings) json["warnings"].push_back(warning.In(language));
  return json;
}

}  // namespace oncard::runtime
