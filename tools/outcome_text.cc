#include "tools/outcome_text.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "base/json_text.h"

namespace oncard::tools {

std::string PackOutcome(const TestOutcome& outcome) {
  const nlohmann::ordered_json packed = {
      {"failures", JsonOfMessages(outcome.failures)},
      {"warnings", JsonOfMessages(outcome.warnings)},
      {"reasons", JsonOfMessages({outcome.nothing, outcome.skipped})},
      {"time_ms", outcome.time_ms},
      {"search_ms", outcome.search_ms},
      {"statements", outcome.statements},
      {"interrupted", outcome.interrupted}};
  return JsonText(packed);
}

bool UnpackOutcome(std::string_view text, TestOutcome* outcome) {
  const nlohmann::ordered_json packed = nlohmann::ordered_json::parse(text, nullptr, false);
  std::vector<Message> reasons;
  if (!packed.is_object() || !ReadMessages(packed.at("failures"), &outcome->failures) ||
      !ReadMessages(packed.at("warnings"), &outcome->warnings) ||
      !ReadMessages(packed.at("reasons"), &reasons)) {
    return false;
  }
  outcome->nothing = reasons.at(0);
  outcome->skipped = reasons.at(1);
  outcome->time_ms = packed.at("time_ms");
  outcome->search_ms = packed.at("search_ms");
  outcome->statements = packed.at("statements");
  outcome->interrupted = packed.at("interrupted");
  return true;
}

}  // namespace oncard::tools
