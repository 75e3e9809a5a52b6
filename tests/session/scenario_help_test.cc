#include "session/scenario_help.h"

#include <gmock/gmock.h>

#include <vector>

namespace oncard::session {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using Json = nlohmann::ordered_json;

/// A scenario with its place at `$`.
ScenarioPlace PlaceIn(const std::string& marked) {
  const size_t at = marked.find('$');
  ScenarioPlace where;
  where.path = "s.toml";
  where.text = marked.substr(0, at) + marked.substr(at + 1);
  for (const char c : marked.substr(0, at)) {
    where.place = c == '\n' ? editor::Place{where.place.line + 1, 1}
                            : editor::Place{where.place.line, where.place.column + 1};
  }
  return where;
}

std::vector<std::string> LabelsAt(const std::string& marked) {
  std::vector<std::string> labels;
  const Json answer = CompleteScenario(PlaceIn(marked), Language::kEnglish);
  for (const Json& item : answer["items"]) labels.push_back(item["label"]);
  return labels;
}

TEST(ScenarioHelp, OffersTheKeysOfTheTable) {
  EXPECT_THAT(LabelsAt("$"), Contains("program"));
  EXPECT_THAT(LabelsAt("[[thread]]\nfun$"), Contains("function"));
  EXPECT_THAT(LabelsAt("[[thread]]\nfun$"), Not(Contains("program")));
  EXPECT_THAT(LabelsAt("[[world.input]]\n\n$\n"), Contains("type"));
  // Mistakes elsewhere do not matter.
  EXPECT_THAT(LabelsAt("program = \n[[world.switch]\nx =\n$"), Contains("active_low"));
  EXPECT_THAT(LabelsAt("[unknown]\n$"), IsEmpty());
  // What a scenario leaves open, reactions, and units.
  EXPECT_THAT(LabelsAt("[[world.input]]\n$"), Contains("between_ms"));
  EXPECT_THAT(LabelsAt("[[world.react]]\n$"), IsSupersetOf({"when", "after_ms", "value"}));
  EXPECT_THAT(LabelsAt("[[world.axis]]\n$"), IsSupersetOf({"unit", "pulses_per_unit"}));
}

TEST(ScenarioHelp, OffersTables) {
  const auto labels = LabelsAt("program = \"p.c\"\n[[$");
  EXPECT_THAT(labels, Contains("thread"));
  EXPECT_THAT(labels, Contains("world.input"));
  EXPECT_THAT(labels, Not(Contains("program")));
}

TEST(ScenarioHelp, OffersValues) {
  EXPECT_THAT(LabelsAt("structured = $"), ElementsAre("true", "false"));
  EXPECT_THAT(LabelsAt("double = $"), ElementsAre("32.16", "16.16"));
  EXPECT_THAT(LabelsAt("rate = $"), IsEmpty());
  EXPECT_THAT(LabelsAt("expect = [\n  \"x == $1\"\n]\n"), IsEmpty());
  EXPECT_THAT(LabelsAt("# $"), IsEmpty());
  const Json bare = CompleteScenario(PlaceIn("double = $"), Language::kEnglish);
  EXPECT_EQ(bare["items"][0]["insert"], "\"32.16\"");
  const Json quoted = CompleteScenario(PlaceIn("double = \"3$\""), Language::kEnglish);
  EXPECT_FALSE(quoted["items"][0].contains("insert"));
  EXPECT_EQ(quoted["range"], Json::parse(R"({"file": "s.toml", "line": 1, "column": 11,
                                             "end_line": 1, "end_column": 12})"));
}

TEST(ScenarioHelp, DescribesKeysAndTables) {
  const Json rate = DescribeScenario(PlaceIn("ra$te = 5\n"), Language::kEnglish);
  EXPECT_EQ(rate["name"], "rate");
  EXPECT_THAT(rate["markdown"].get<std::string>(),
              HasSubstr("`rate`: integer, 1 to 1000000\n\nstatements per millisecond"));
  const Json table = DescribeScenario(PlaceIn("[[wor$ld.input]]\n"), Language::kChinese);
  EXPECT_EQ(table["kind"], "table");
  EXPECT_EQ(table["name"], "world.input");
  EXPECT_EQ(DescribeScenario(PlaceIn("unknown$ = 1\n"), Language::kEnglish), nullptr);
  EXPECT_EQ(DescribeScenario(PlaceIn("$"), Language::kEnglish), nullptr);
  EXPECT_EQ(DescribeScenario(PlaceIn("# rate$"), Language::kEnglish), nullptr);
}

TEST(ScenarioHelp, TakesPlacesBehindTheEnd) {
  ScenarioPlace where = PlaceIn("rate = 1\n$");
  where.place = {1000000, 1000000};
  EXPECT_FALSE(CompleteScenario(where, Language::kEnglish)["items"].empty());
}

}  // namespace
}  // namespace oncard::session
