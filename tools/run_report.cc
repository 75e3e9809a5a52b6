#include "tools/run_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "runtime/scenario/run/choices.h"
#include "runtime/scenario/run/result_json.h"

namespace oncard::tools {

std::string FormatFailure(const runtime::ScenarioFailure& failure, Language language) {
  const std::string& message = failure.message.In(language);
  return failure.expectation.empty() ? message
                                     : fmt::format("{}: {}", failure.expectation, message);
}

std::string FormatRunText(const runtime::ScenarioResult& result, const Invocation& invocation) {
  std::string text;
  if (result.chosen != nullptr) {
    text = runtime::DescribeChosen(result.choice).In(invocation.language) + '\n';
  }
  for (const runtime::ThreadReport& thread : result.threads) {
    text +=
        invocation.Say(MakeMessage("thread {0} {1}: {2}\n", "线程 {0} {1}：{3}\n", thread.thread,
                                   thread.function, thread.status.en, thread.status.zh));
  }
  for (const runtime::ShownValue& value : result.values) {
    const std::string list = fmt::to_string(fmt::join(value.elements, ", "));
    const std::string unit = value.unit.empty() ? "" : ' ' + value.unit;
    text += fmt::format(fmt::runtime(value.array ? "{} = [{}]\n" : "{} = {}{}\n"), value.name, list,
                        unit);
  }
  return text;
}

int ReportRun(const runtime::ScenarioResult& result, const std::string& format,
              const Invocation& invocation) {
  PrintResult(format == "json"
                  ? JsonText(runtime::ResultJson(result, invocation.language), 2) + '\n'
                  : FormatRunText(result, invocation));
  for (const runtime::ScenarioFailure& failure : result.failures) {
    PrintDiagnostics(fmt::format("oncard: {}\n", FormatFailure(failure, invocation.language)));
  }
  for (const Message& warning : result.warnings) {
    PrintDiagnostics(invocation.Say(
        MakeMessage("oncard: warning: {0}\n", "oncard: 警告：{1}\n", warning.en, warning.zh)));
  }
  if (!result.passed()) return kExitFailed;
  if (!result.interrupted) return kExitOk;
  return Fail(
      invocation, kExitIncomplete,
      MakeMessage("interrupted at {0} ms: requirements on the end of the run were not checked",
                  "在 {0} ms 被中断：未检查结束时应成立的条件", result.end_ms));
}

}  // namespace oncard::tools
