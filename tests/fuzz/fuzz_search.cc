// Search files: reading, continuing and merging. Their mutator changes JSON documents.
#include <xxhash.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "base/json_text.h"
#include "explore/scenario_exploration.h"
#include "explore/search/explorer.h"
#include "explore/search/search_check.h"
#include "explore/search/search_file.h"
#include "tests/fuzz/fuzz.h"

namespace oncard::fuzz {
namespace {

using Json = nlohmann::ordered_json;

const explore::Problem& SeedProblem() {
  static const explore::Problem problem = [] {
    runtime::Scenario scenario;
    scenario.path = "race.toml";
    scenario.program = "race.c";
    for (const char* thread : {"0=t0", "1=t1"}) {
      scenario.threads.push_back(runtime::ParseThreadStart(thread).value());
    }
    return explore::ProblemOfScenario(scenario, {}, SeedProgram()).value();
  }();
  return problem;
}

void CollectNodes(Json& node, std::vector<Json*>* nodes) {
  nodes->push_back(&node);
  if (!node.is_structured()) return;
  for (Json& child : node) CollectNodes(child, nodes);
}

Json RandomValue(std::mt19937& random) {
  switch (random() % 10) {
    case 0:
      return nullptr;
    case 1:
      return random() % 2 == 0;
    case 2:
      return std::string(random() % 40, 'x');
    case 3:
      return Json::array();
    case 4:
      return Json::object();
    case 5:
      return 1e300;
    case 6:
      return int64_t{-1} - static_cast<int64_t>(random() % 3);
    case 7:
      return uint64_t{1} << (random() % 64);
    default:
      return random() % 40;
  }
}

void Change(Json* document, std::mt19937& random) {
  std::vector<Json*> nodes;
  CollectNodes(*document, &nodes);
  Json& node = *nodes[random() % nodes.size()];
  switch (random() % 5) {
    case 0:
      node = RandomValue(random);
      break;
    case 1:
      // Numbers wrap around, so that every value can occur.
      if (node.is_number_integer()) node = node.get<uint64_t>() + random() % 5 - 2;
      break;
    case 2:
      if (node.is_structured() && !node.empty()) {
        auto at = node.begin();
        std::advance(at, random() % node.size());
        node.erase(at);
      }
      break;
    case 3:
      if (node.is_array()) node.push_back(node.empty() ? RandomValue(random) : node.back());
      break;
    default: {
      const Json other = *nodes[random() % nodes.size()];
      node = other;
    }
  }
}

}  // namespace

size_t MutateSearch(uint8_t* data, size_t size, size_t max_size, unsigned seed) {
  std::mt19937 random(seed);
  Json document = Json::parse(data, data + size, nullptr, false);
  if (document.is_discarded()) document = Json::object();
  const int changes = 1 + static_cast<int>(random() % 3);
  for (int i = 0; i < changes; ++i) Change(&document, random);
  if (document.is_object()) {
    document.erase("check");
    const std::string checked = JsonText(document);
    document["check"] = fmt::format("{:016x}", XXH64(checked.data(), checked.size(), 0));
  }
  const std::string text = JsonText(document, 1) + '\n';
  const size_t kept = std::min(text.size(), max_size);
  std::memcpy(data, text.data(), kept);
  return kept;
}

void FuzzSearch(std::string_view bytes) {
  auto file = explore::ParseSearchFile(bytes);
  if (!file.ok()) return;
  const auto again = explore::ParseSearchFile(explore::FormatSearchFile(file.value()));
  FUZZ_CHECK(again.ok());
  static_cast<void>(explore::MergeInto(&file.value(), again.value()));
  // The operations of `oncard explore` with a file for this program.
  const explore::Problem& problem = SeedProblem();
  if (explore::HashOf(problem) != file.value().problem) return;
  if (!explore::CheckSearch(problem, file.value()).ok()) return;
  static_cast<void>(explore::Conclude(problem, file.value()));
  if (file.value().engine != explore::EngineKind::kDpor) return;
  explore::ExploreOptions options;
  options.engine = explore::EngineKind::kDpor;
  options.execution_limit = 100;
  options.begun = &file.value().traces;
  static_cast<void>(explore::Explore(problem, options));
}

}  // namespace oncard::fuzz
