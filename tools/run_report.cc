#include "tools/run_report.h"
#include "base/json_text.h"

#include <nlohmann/json.hpp>

namespace oncard::tools {
namespace {

using Json = nlohmann::ordered_json;

std::string_view ThreadStateName(vm::ThreadRun run) {
  switch (run) {
    case vm::ThreadRun::kUnbound:
      return "unbound";
    case vm::ThreadRun::kStopped:
      return "finished";
    case vm::ThreadRun::kRunning:
      return "running";
    case vm::ThreadRun::kPaused:
      return "paused";
    case vm::ThreadRun::kFaulted:
      return "faulted";
  }
  return "unbound";
}

// The numbers are already written in the form that JSON uses.
Json Number(const std::string& text) { return Json::parse(text); }

/// `reads` by name, `writes` as `[old, new]`.
Json StepsJson(const runtime::StepLog& log) {
  Json steps = Json::array();
  for (const runtime::LoggedStep& step : log.steps) {
    const vm::Object& object = log.image->object;
    Json json = {{"thread", step.thread}, {"line", step.line}, {"at_ms", step.at_ms}};
    for (const runtime::SlotValue& read : step.reads) {
      json["reads"][NameOf(step, read.slot, object)] =
          Number(ValueText(step, read.slot, read.raw, object));
    }
    for (const runtime::SlotChange& write : step.writes) {
      json["writes"][NameOf(step, write.slot, object)] = {
          Number(ValueText(step, write.slot, write.before, object)),
          Number(ValueText(step, write.slot, write.after, object))};
    }
    steps.push_back(std::move(json));
  }
  return steps;
}

}  // namespace

std::string_view EndName(const runtime::ScenarioResult& result) {
  if (result.interrupted) return "interrupted";
  if (result.reached_until && result.end != runtime::RunEnd::kDeadlock) return "until";
  switch (result.end) {
    case runtime::RunEnd::kQuiet:
      return "quiet";
    case runtime::RunEnd::kTimeLimit:
      return "time-limit";
    case runtime::RunEnd::kDeadlock:
      return "deadlock";
    case runtime::RunEnd::kScheduleEnd:
      return "schedule-end";
    case runtime::RunEnd::kScheduleDiverged:
      return "diverged";
  }
  return "quiet";
}

std::string FormatFailure(const runtime::ScenarioFailure& failure, Language language) {
  const std::string& message = failure.message.In(language);
  return failure.expectation.empty() ? message
                                     : fmt::format("{}: {}", failure.expectation, message);
}

std::string FormatRunText(const runtime::ScenarioResult& result, const Session& session) {
  std::string text;
  for (const runtime::ThreadReport& thread : result.threads) {
    text += session.Say(MakeMessage("thread {0} {1}: {2}\n", "线程 {0} {1}：{3}\n", thread.thread,
                                    thread.function, thread.status.en, thread.status.zh));
  }
  for (const runtime::ShownValue& value : result.values) {
    const std::string list = fmt::to_string(fmt::join(value.elements, ", "));
    text += fmt::format(fmt::runtime(value.array ? "{} = [{}]\n" : "{} = {}\n"), value.name, list);
  }
  return text;
}

std::string FormatRunJson(const runtime::ScenarioResult& result, const Session& session) {
  Json json;
  json["passed"] = result.passed();
  json["end"] = EndName(result);
  json["time_ms"] = result.end_ms;
  json["statements"] = result.statements;
  json["program_hash"] = fmt::format("{:016x}", result.program_hash);
  json["state_hash"] = fmt::format("{:016x}", result.hash);
  json["threads"] = Json::array();
  for (const runtime::ThreadReport& thread : result.threads) {
    json["threads"].push_back({{"thread", thread.thread},
                               {"function", thread.function},
                               {"page", thread.page},
                               {"state", ThreadStateName(thread.run)},
                               {"result", Number(thread.result)},
                               {"error", thread.error},
                               {"place", thread.place},
                               {"statements", thread.statements},
                               {"status", session.Say(thread.status)}});
  }
  json["values"] = Json::object();
  for (const runtime::ShownValue& value : result.values) {
    Json elements = Json::array();
    for (const std::string& element : value.elements) elements.push_back(Number(element));
    json["values"][value.name] = value.array ? elements : elements.front();
  }
  if (result.steps) json["steps"] = StepsJson(*result.steps);
  json["failures"] = Json::array();
  for (const runtime::ScenarioFailure& failure : result.failures) {
    json["failures"].push_back(
        {{"expectation", failure.expectation}, {"message", session.Say(failure.message)}});
  }
  json["warnings"] = Json::array();
  for (const Message& warning : result.warnings) json["warnings"].push_back(session.Say(warning));
  return JsonText(json, 2) + '\n';
}

int ReportRun(const runtime::ScenarioResult& result, const std::string& format,
              const Session& session) {
  PrintResult(format == "json" ? FormatRunJson(result, session) : FormatRunText(result, session));
  for (const runtime::ScenarioFailure& failure : result.failures) {
    PrintDiagnostics(fmt::format("oncard: {}\n", FormatFailure(failure, session.language)));
  }
  for (const Message& warning : result.warnings) {
    PrintDiagnostics(session.Say(
        MakeMessage("oncard: warning: {0}\n", "oncard: 警告：{1}\n", warning.en, warning.zh)));
  }
  if (!result.passed()) return kExitFailed;
  if (!result.interrupted) return kExitOk;
  return Fail(
      session, kExitIncomplete,
      MakeMessage("interrupted at {0} ms: requirements on the end of the run were not checked",
                  "在 {0} ms 被中断：未检查结束时应成立的条件", result.end_ms));
}

}  // namespace oncard::tools
