#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "explore/reports/report.h"
#include "explore/reports/step_table.h"

namespace oncard::explore {

std::string ChromeReport(const Findings& findings) {
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  const Subject& subject = findings.subject;
  const vm::Object& object = subject.image->object;
  const StatementTexts texts(findings.source, object);
  for (size_t i = 0; i < subject.threads.size(); ++i) {
    events.push_back({{"ph", "M"},
                      {"pid", 0},
                      {"tid", subject.threads[i].thread},
                      {"name", "thread_name"},
                      {"args", {{"name", ThreadHead(subject, i, Language::kEnglish)}}}});
  }
  int64_t at = 0;
  for (const auto* steps : {&findings.trail.steps, &findings.trail.cycle}) {
    for (const TrailStep& step : *steps) {
      nlohmann::ordered_json arguments = {{"statement", at + 1}, {"line", step.log.line}};
      for (const runtime::SlotValue& read : step.log.reads) {
        arguments["read"][NameOf(step.log, read.slot, object)] =
            ValueText(step.log, read.slot, read.raw, object);
      }
      for (const runtime::SlotChange& write : step.log.writes) {
        arguments["written"][NameOf(step.log, write.slot, object)] = {
            ValueText(step.log, write.slot, write.before, object),
            ValueText(step.log, write.slot, write.after, object)};
      }
      if (findings.trail.with_card) arguments["at_ms"] = step.log.at_ms;
      if (steps == &findings.trail.cycle) arguments["repeats"] = true;
      const std::string text = texts.Of(step.log);
      events.push_back({{"ph", "X"},
                        {"pid", 0},
                        {"tid", step.log.thread},
                        {"ts", at++},
                        {"dur", 1},
                        {"name", text.empty() ? fmt::format("line {}", step.log.line) : text},
                        {"args", std::move(arguments)}});
    }
  }
  const nlohmann::ordered_json report = {{"traceEvents", std::move(events)}};
  return JsonText(report, 1) + '\n';
}

}  // namespace oncard::explore
