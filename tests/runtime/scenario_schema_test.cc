// The schema for editors against the reader: what the samples say is valid for both, and what is
// wrong with one key alone is wrong for both.
#include "runtime/scenario/file/scenario_schema.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "runtime/scenario/file/key_table.h"
#include "runtime/scenario/file/toml_keys.h"
#include "tests/base/json_schema.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

JsonSchema& Checker() {
  static JsonSchema checker(Json::parse(ScenarioSchema(Language::kEnglish)));
  return checker;
}

const Json& Schema() { return Checker().root(); }

bool Fits(const Json& value, const Json& schema) {
  return Checker().MistakeIn(value, schema).empty();
}

Json JsonOf(const toml::node& node) {
  if (const toml::table* table = node.as_table()) {
    Json object = Json::object();
    for (const auto& [key, value] : *table) object[std::string(key.str())] = JsonOf(value);
    return object;
  }
  if (const toml::array* list = node.as_array()) {
    Json array = Json::array();
    for (const toml::node& item : *list) array.push_back(JsonOf(item));
    return array;
  }
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (const auto whole = node.value_exact<int64_t>()) return *whole;
  if (const auto number = node.value_exact<double>()) return *number;
  return node.value_exact<bool>().value();
}

bool FitsSchema(const std::string& text) {
  const toml::parse_result parsed = toml::parse(text);
  EXPECT_TRUE(static_cast<bool>(parsed)) << text;
  return parsed && Fits(JsonOf(parsed.table()), Schema());
}

/// What the reader says; nothing when it takes the text.
std::string Refusal(const std::string& text) {
  const auto scenario = ParseScenario(text, "s.toml");
  return scenario.ok() ? "" : scenario.error().message.en;
}

// --- Tests ---------------------------------------------------------------------------------------

TEST(ScenarioSchema, IsOneOfDraft2020) {
  EXPECT_EQ(Schema()["$schema"], "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(
      Schema()["properties"]["rate"],
      Json::parse(R"({"description": "statements per millisecond, all threads together\n\n)"
                  R"(without it: 100", "type": "integer", "minimum": 1, "maximum": 1000000})"));
  EXPECT_EQ(Schema()["properties"]["thread"]["items"]["required"], Json::parse(R"(["function"])"));
  EXPECT_THAT(ScenarioSchema(Language::kChinese), HasSubstr("控制卡的轴数"));
}

TEST(ScenarioSchema, TakesEverySample) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(ONCARD_SOURCE_DIR "/samples")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_TRUE(FitsSchema(ReadFile(entry.path().string()).value())) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 20);
}

TEST(ScenarioSchema, TakesChoices) {
  const auto fits = [](const std::string& text) {
    return FitsSchema("program = \"p.c\"\n" + text);
  };
  EXPECT_TRUE(fits("globals = { n = { any = [1, 10] } }\n"));
  EXPECT_FALSE(fits("globals = { n = { any = [1] } }\n"));
  EXPECT_FALSE(fits("globals = { n = { all = [1, 10] } }\n"));
  EXPECT_FALSE(fits("[[host]]\nset = { n = { any = [1, 10] } }\n"));
  EXPECT_TRUE(fits("[[world.input]]\nindex = 1\nvalue = \"any\"\nbetween_ms = [1, 2.5]\n"));
  EXPECT_FALSE(fits("[[world.input]]\nindex = 1\nvalue = \"all\"\n"));
  EXPECT_FALSE(fits("[[world.fault]]\nkind = \"stall\"\nbetween_ms = [1, 2, 3]\n"));
}

// 50000 mm/s^2 are 50 pulse/ms^2.
TEST(ScenarioSchema, TakesNumbersInTheUnitOfAnAxis) {
  const std::string text =
      "program = \"p.c\"\n[[world.axis]]\naxis = 1\nunit = \"mm\"\npulses_per_unit = 1000\n"
      "max_acc = 50000\n";
  EXPECT_TRUE(ParseScenario(text, "s.toml").ok());
  EXPECT_TRUE(FitsSchema(text));
}

TEST(ScenarioSchema, TakesWhatIsWritten) {
  const std::string text =
      "program = \"p.c\"\ncard = \"GTS-400\"\nuntil_ms = 2.5\nexplore = { engine = \"stateful\", "
      "max_states = 7 }\n"
      "keys = [{ at_ms = 1, text = \"q\" }]\n[globals]\nn = [1, 2.5]\n\"s.m\" = 3\n"
      "[[thread]]\nfunction = \"f\"\nperiod_ms = 5\ninit = { k = 1 }\n"
      "[[world.axis]]\naxis = 1\ndrive = \"velocity\"\n[[world.switch]]\naxis = 1\nfrom = 5\n"
      "active_low = true\n[[world.input]]\nvalue = 3\n[[world.module]]\nvolts = [1, -2.5]\n"
      "[[world.move]]\nswitch = 1\nto = 9\nat_ms = 4\n"
      "[[world.react]]\nwhen = \"n == 1\"\nafter_ms = 0.5\ntype = \"alarm\"\nvalue = 3\n"
      "[[world.fault]]\nkind = \"cut_switch\"\nswitch = 1\n[[host]]\nset = { n = 1 }\n";
  const auto scenario = ParseScenario(text, "s.toml");
  ASSERT_TRUE(scenario.ok()) << scenario.error().message.en;
  EXPECT_TRUE(FitsSchema(text));
  EXPECT_TRUE(FitsSchema(FormatScenario(scenario.value()))) << FormatScenario(scenario.value());
}

struct WrongCase {
  const char* text;
  const char* refusal;  ///< of the reader
};

class ScenarioSchemaTest : public testing::TestWithParam<WrongCase> {};

TEST_P(ScenarioSchemaTest, RefusesWhatTheReaderRefuses) {
  const std::string text = std::string("program = \"p.c\"\n") + GetParam().text;
  EXPECT_THAT(Refusal(text), HasSubstr(GetParam().refusal));
  EXPECT_FALSE(FitsSchema(text)) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Wrong, ScenarioSchemaTest,
    testing::Values(
        WrongCase{"rat = 5\n", "unknown key 'rat'"},
        WrongCase{"[[thread]]\nfunction = \"f\"\nfoo = 1\n", "unknown key 'foo'"},
        WrongCase{"[world]\nfoo = 1\n", "unknown key 'foo'"},
        WrongCase{"[[world.axis]]\naxis = 1\nfoo = 1\n", "unknown key 'foo'"},
        WrongCase{"explore = { foo = 1 }\n", "unknown key 'foo'"},
        WrongCase{"title = 5\n", "'title' must be a string"},
        WrongCase{"rate = \"5\"\n", "'rate' must be a whole number"},
        WrongCase{"rate = 5.5\n", "'rate' must be a whole number"},
        WrongCase{"card = \"GTS-500\"\n", "'card' must be one of GTS-400"},
        WrongCase{"axes = 6\n", "'axes' must be one of 4, 8, 12"},
        WrongCase{"cycle_us = 300\n", "'cycle_us' must be a multiple of 125"},
        WrongCase{"until_ms = -1\n", "'until_ms' must be a time in ms"},
        WrongCase{"final = \"n == 1\"\n", "'final' must be a list of strings"},
        WrongCase{"final = [1]\n", "'final' must be a list of strings"},
        WrongCase{"expect = [1]\n", "an expectation must be a string"},
        WrongCase{"double = \"8.8\"\n", "'double' is '8.8'"},
        WrongCase{"races = \"some\"\n", "'races' must be one of"},
        WrongCase{"explore = \"perhaps\"\n", "'explore' must be \"prove\""},
        WrongCase{"explore = { engine = \"fast\" }\n", "'engine' must be one of"},
        WrongCase{"globals = 1\n", "'globals' must be a table"},
        WrongCase{"[globals]\nn = \"1\"\n", "'n' must be a number or a list of numbers"},
        WrongCase{"[globals]\nn = []\n", "'n' must be a number or a list of numbers"},
        WrongCase{"[thread]\nfunction = \"f\"\n", "'thread' must be a list of tables"},
        WrongCase{"[[thread]]\nthread = 1\n", "'function' is missing"},
        WrongCase{"[[host]]\nat_ms = 1\n", "'set' is missing"},
        WrongCase{"host = { command = \"./h\" }\n", "'command' must be a list of strings"},
        WrongCase{"host = { sauce = \"h.c\" }\n", "unknown key 'sauce'"},
        WrongCase{"keys = [{ at_ms = 1 }]\n", "'text' is missing"},
        WrongCase{"[[world.input]]\nat_ms = 1\n", "'value' is missing"},
        WrongCase{"[[world.input]]\ntype = \"knob\"\nvalue = 1\n", "no inputs are named 'knob'"},
        WrongCase{"[[world.react]]\nvalue = 1\n", "'when' is missing"},
        WrongCase{"[[world.react]]\nwhen = \"n\"\nindex = 1\nvalue = \"any\"\n",
                  "'value' must be a whole number from 0 to 1"},
        WrongCase{"[[world.axis]]\ndrive = \"ideal\"\n", "'axis' is missing"},
        WrongCase{"[[world.axis]]\naxis = 1\ndrive = \"hydraulic\"\n", "'drive' must be one of"},
        WrongCase{"[[world.switch]]\naxis = 1\nfrom = 1\nactive_low = 1\n",
                  "'active_low' must be true or false"},
        WrongCase{"[[world.move]]\nfrom = 1\n", "'switch' is missing"},
        WrongCase{"[[world.fault]]\naxis = 1\n", "'kind' is missing"},
        WrongCase{"[[world.hand]]\naxis = 1\npulses = 1\n", "'until_ms' is missing"},
        WrongCase{"[[world.analog]]\nchannel = 1\n", "'volts' is missing"},
        WrongCase{"[[world.module]]\nvolts = [11]\n", "'volts' must be a list of at most"}));

/// What must be there for a key to be looked at.
std::string ContextOf(const std::string& key) {
  static const std::map<std::string, std::string> kContexts = {
      {"thread.priority", "period_ms = 5\n"},
      {"world.fault.pulses", "kind = \"noise\"\n"},
      {"world.fault.velocity", "kind = \"slip\"\n"},
      {"world.fault.axis", "kind = \"stall\"\n"},
      {"world.fault.switch", "kind = \"cut_switch\"\n"}};
  const auto context = kContexts.find(key);
  return context == kContexts.end() ? "" : context->second;
}

/// A file with one key.
std::string FileWith(const KeySection& section, const KeyDescription& key, double value) {
  const std::string path(section.path);
  const std::string number = key.type.kind == KeyKind::kWhole
                                 ? fmt::format("{}", static_cast<int64_t>(value))
                                 : fmt::format("{:.1f}", value);
  const std::string line = fmt::format("{} = {}\n", key.name, number);
  std::string text = "program = \"p.c\"\n";
  if (path.empty()) return text + line;
  if (path == "explore") return text + fmt::format("explore = {{ {} = {} }}\n", key.name, number);
  if (path == "view") return text + "[view]\n" + line;
  if (path == "world.move" || (path == "world.fault" && key.name == "switch")) {
    text += "[[world.switch]]\naxis = 1\nfrom = 1\n";
  }
  return text + fmt::format("[[{}]]\n", path) + ContextOf(path + '.' + std::string(key.name)) +
         line;
}

/// True if the schema takes the value of a key, whatever else is missing.
bool Takes(const KeySection& section, const KeyDescription& key, double value) {
  const Json* schema = &Schema();
  std::string_view path = section.path;
  while (!path.empty()) {
    const size_t dot = std::min(path.find('.'), path.size());
    schema = &(*schema)["properties"][std::string(path.substr(0, dot))];
    if (schema->contains("anyOf")) schema = &(*schema)["anyOf"][1];
    if (schema->contains("items")) schema = &(*schema)["items"];
    path.remove_prefix(std::min(dot + 1, path.size()));
  }
  const Json json =
      key.type.kind == KeyKind::kWhole ? Json(static_cast<int64_t>(value)) : Json(value);
  return Fits(json, (*schema)["properties"][std::string(key.name)]);
}

// Except for what can be in the unit of an axis.
TEST(ScenarioSchema, HasTheRangesOfTheReader) {
  int count = 0;
  for (const KeySection& section : KeySections()) {
    for (const KeyDescription& key : section.keys) {
      if (key.type.kind != KeyKind::kWhole && key.type.kind != KeyKind::kNumber) continue;
      const std::string where = fmt::format("{}.{}", section.path, key.name);
      for (const double end : {key.type.smallest, key.type.largest}) {
        if (!std::isfinite(end)) continue;
        const double beyond = end == key.type.smallest ? end - 1 : end + 1;
        EXPECT_TRUE(Takes(section, key, end)) << where;
        EXPECT_EQ(Takes(section, key, beyond), key.type.measure.has_value()) << where;
        EXPECT_THAT(Refusal(FileWith(section, key, beyond)),
                    HasSubstr(fmt::format("'{}' must be a", key.name)))
            << where;
        ++count;
      }
    }
  }
  EXPECT_GT(count, 50);
}

}  // namespace
}  // namespace oncard::runtime
