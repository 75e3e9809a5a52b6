// Requests of the session protocol: the host answers every line, and always with JSON. An input
// that does not begin like a request is a source: an editor asks everything about a place in it.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "base/json_text.h"
#include "session/editor_requests.h"
#include "session/host.h"
#include "tests/fuzz/fuzz.h"

namespace oncard::fuzz {
namespace {

/// Requests that are allowed to take long: a whole run, and walks with a large budget or time.
bool TakesLong(const std::string& line) {
  static const std::regex kLong(R"re("run"|[0-9]{5})re");
  return std::regex_search(line, kLong);
}

void CheckAnswer(const std::string& answer) {
  FUZZ_CHECK(!answer.empty() && answer.back() == '\n');
  const size_t last = answer.rfind('\n', answer.size() - 2);
  const auto json = nlohmann::json::parse(answer.substr(last == std::string::npos ? 0 : last + 1),
                                          nullptr, false);
  FUZZ_CHECK(json.is_object() && json.contains("ok"));
}

/// The first character chooses the language, the second one the place.
void AskAboutSource(std::string_view bytes) {
  constexpr size_t kPlaces = 128;
  if (bytes.size() < 2) return;
  const std::string source(bytes.substr(2));
  const size_t offset = source.size() * (static_cast<unsigned char>(bytes[1]) % kPlaces) / kPlaces;
  const auto lines_end = source.begin() + static_cast<std::ptrdiff_t>(offset);
  const auto line = std::count(source.begin(), lines_end, '\n') + 1;
  const size_t line_end = source.rfind('\n', offset == 0 ? 0 : offset - 1);
  const size_t column =
      offset - (line_end == std::string::npos || line == 1 ? 0 : line_end + 1) + 1;
  session::SessionHost host;
  for (const session::EditorRequest& each : session::EditorRequests()) {
    session::Json arguments = {{"main", "p.c"},
                               {"files", {{"p.c", source}, {"h.h", source}}},
                               {"structured", bytes[0] == 's'}};
    if (each.text.arguments.find("line") != std::string_view::npos) {
      arguments["line"] = line;
      arguments["column"] = column;
    }
    if (each.text.name == "rename") arguments["name"] = "fresh_name";
    const session::Json request = {
        {"id", 1}, {"request", each.text.name}, {"arguments", std::move(arguments)}};
    CheckAnswer(host.Handle(JsonText(request)));
  }
}

}  // namespace

void FuzzSession(std::string_view bytes) {
  constexpr int kRequestMax = 32;
  if (!bytes.starts_with('{')) {
    AskAboutSource(bytes);
    return;
  }
  session::SessionHost host;
  for (int i = 0; i < kRequestMax && !bytes.empty(); ++i) {
    const size_t end = bytes.find('\n');
    const std::string line(bytes.substr(0, end));
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
    if (TakesLong(line)) continue;
    CheckAnswer(host.Handle(line));
  }
}

}  // namespace oncard::fuzz
