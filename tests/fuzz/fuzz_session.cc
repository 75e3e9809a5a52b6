// Requests of the session protocol: the host answers every line, and always with JSON.
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "session/host.h"
#include "tests/fuzz/fuzz.h"

namespace oncard::fuzz {
namespace {

/// Requests that are allowed to take long: a whole run, and walks with a large budget or time.
bool TakesLong(const std::string& line) {
  static const std::regex kLong(R"re("run"|[0-9]{5})re");
  return std::regex_search(line, kLong);
}

}  // namespace

void FuzzSession(std::string_view bytes) {
  constexpr int kRequestMax = 32;
  session::SessionHost host;
  for (int i = 0; i < kRequestMax && !bytes.empty(); ++i) {
    const size_t end = bytes.find('\n');
    const std::string line(bytes.substr(0, end));
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
    if (TakesLong(line)) continue;
    const std::string answer = host.Handle(line);
    FUZZ_CHECK(!answer.empty() && answer.back() == '\n');
    const size_t last = answer.rfind('\n', answer.size() - 2);
    const auto json = nlohmann::json::parse(answer.substr(last == std::string::npos ? 0 : last + 1),
                                            nullptr, false);
    FUZZ_CHECK(json.is_object() && json.contains("ok"));
  }
}

}  // namespace oncard::fuzz
