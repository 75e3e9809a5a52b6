#include "session/recorded_host.h"

#include <utility>

#include "runtime/scenario/record/call_replay.h"
#include "session/arguments.h"

namespace oncard::session {

Result<RecordedHost> OpenRecordedHost(const std::string& text, const std::string& path,
                                      std::optional<int> card, int opening) {
  auto opened = runtime::OpenCallRecord(text, path, card, opening);
  if (!opened.ok()) return opened.error();
  auto& [scenario, calls, sources, openings] = opened.value();
  auto session = Session::CreateFromCalls(std::move(scenario), std::move(calls));
  if (!session.ok()) return session.error();
  Json answer = {{"compiled", true}, {"diagnostics", Json::array()}, {"files", Json::array()}};
  for (const runtime::RecordedSource& source : sources) {
    answer["files"].push_back({{"path", source.path}, {"text", source.text}});
  }
  answer["cards"] = Json::array();
  for (const auto& each : openings) {
    answer["cards"].push_back(
        {{"card", each.card}, {"opening", each.opening}, {"calls", each.calls}});
  }
  return RecordedHost{std::move(session).value(), std::move(answer)};
}

}  // namespace oncard::session
