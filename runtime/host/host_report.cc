#include "runtime/host/host_report.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "base/json_text.h"
#include "runtime/host/host_system.h"

namespace oncard::runtime {
namespace {

using Json = nlohmann::ordered_json;

/// False if the member is no list of messages.
bool Unpack(const Json& object, const char* name, std::vector<Message>* messages) {
  const auto list = object.find(name);
  return list != object.end() && ReadMessages(*list, messages);
}

bool Unpack(const Json& line, HostReport* report) {
  if (!line.is_object() || !line.contains("end_ms") || !line["end_ms"].is_number()) return false;
  report->end_ms = std::max(report->end_ms, line["end_ms"].get<double>());
  return Unpack(line, "failures", &report->failures) &&
         Unpack(line, "warnings", &report->warnings) && Unpack(line, "held", &report->held);
}

}  // namespace

bool AppendHostReport(const HostReport& report) {
  const char* const path = std::getenv("ONCARD_REPORT");
  if (path == nullptr || *path == '\0') return false;
  const Json json = {{"end_ms", report.end_ms},
                     {"failures", JsonOfMessages(report.failures)},
                     {"warnings", JsonOfMessages(report.warnings)},
                     {"held", JsonOfMessages(report.held)}};
  return AppendLine(path, JsonText(json) + '\n');
}

Result<HostReport> ReadHostReports(std::string_view lines) {
  HostReport report;
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    if (!Unpack(Json::parse(line, nullptr, false), &report)) {
      return MakeError(1, "the report of the host is damaged", "主机程序的报告已损坏");
    }
    lines.remove_prefix(std::min(line.size() + 1, lines.size()));
  }
  return report;
}

}  // namespace oncard::runtime
