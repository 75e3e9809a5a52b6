#include "runtime/scenario/file/scenario_schema.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "base/json_text.h"
#include "gtcalls/card_type.h"
#include "runtime/scenario/file/key_table.h"

namespace oncard::runtime {
namespace {

using Json = nlohmann::ordered_json;

class SchemaWriter {
 public:
  explicit SchemaWriter(Language language) : language_(language), sections_(KeySections()) {}

  Json Write() const {
    Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                   {"title", Say({"oncard scenario", "oncard 场景"})}};
    schema.update(ObjectOf(""));
    return schema;
  }

 private:
  std::string Say(const Words& words) const {
    return std::string(language_ == Language::kChinese ? words.zh : words.en);
  }

  /// A table with the keys of a section.
  Json ObjectOf(std::string_view path) const {
    const KeySection& section = *std::ranges::find(sections_, path, &KeySection::path);
    Json object = {{"type", "object"}, {"additionalProperties", false}};
    Json required = Json::array();
    for (const KeyDescription& key : section.keys) {
      Json value = {{"description", DescriptionOf(key)}};
      value.update(ValueOf(key.type));
      object["properties"][std::string(key.name)] = std::move(value);
      if (key.required()) required.push_back(key.name);
    }
    if (!required.empty()) object["required"] = std::move(required);
    return object;
  }

  std::string DescriptionOf(const KeyDescription& key) const {
    if (key.required()) return Say(key.meaning);
    return fmt::format(fmt::runtime(Say({"{}\n\nwithout it: {}", "{}\n\n省略时：{}"})),
                       Say(key.meaning), Say(key.standard));
  }

  /// A list of two of these.
  static Json PairOf(Json item) {
    return {{"type", "array"}, {"minItems", 2}, {"maxItems", 2}, {"items", std::move(item)}};
  }

  /// A table of variables, whose values are one of these.
  static Json ValuesOf(Json forms) {
    return {{"type", "object"}, {"additionalProperties", {{"anyOf", std::move(forms)}}}};
  }

  Json ValueOf(const KeyType& type) const {
    Json number = {{"type", "number"}};
    const Json list = {{"type", "array"}, {"minItems", 1}, {"items", number}};
    Json time = {{"type", "number"}, {"minimum", 0}, {"maximum", kTimeMsMax}};
    switch (type.kind) {
      case KeyKind::kText:
        return {{"type", "string"}};
      case KeyKind::kTexts:
        return {{"type", "array"}, {"items", {{"type", "string"}}}};
      case KeyKind::kChoice:
        return {{"enum", std::vector<std::string>(type.choices.begin(), type.choices.end())}};
      case KeyKind::kCard: {
        const auto names = gtcalls::CardTypeNames();
        return {{"enum", std::vector<std::string>(names.begin(), names.end())}};
      }
      case KeyKind::kAxes:
        return {{"enum", gtcalls::AxisCounts()}};
      case KeyKind::kWhole: {
        Json whole = {{"type", "integer"}, {"minimum", static_cast<int64_t>(type.smallest)}};
        if (std::isfinite(type.largest)) whole["maximum"] = static_cast<int64_t>(type.largest);
        if (type.step != 1) whole["multipleOf"] = type.step;
        return whole;
      }
      case KeyKind::kNumber:
        // In the unit of an axis the range is another one.
        if (type.measure) return number;
        return {{"type", "number"}, {"minimum", type.smallest}, {"maximum", type.largest}};
      case KeyKind::kNumbers:
        return {
            {"type", "array"},
            {"maxItems", type.count},
            {"items", {{"type", "number"}, {"minimum", type.smallest}, {"maximum", type.largest}}}};
      case KeyKind::kFlag:
        return {{"type", "boolean"}};
      case KeyKind::kTime:
        return time;
      case KeyKind::kTimes:
        return PairOf(time);
      case KeyKind::kLevel:
        return {{"anyOf", Json::array({Json{{"type", "integer"},
                                            {"minimum", static_cast<int64_t>(type.smallest)},
                                            {"maximum", static_cast<int64_t>(type.largest)}},
                                       Json{{"const", "any"}}})}};
      case KeyKind::kValues:
        return ValuesOf(Json::array({number, list}));
      case KeyKind::kOpenValues: {
        const Json any = {{"type", "object"},
                          {"additionalProperties", false},
                          {"properties", {{"any", PairOf({{"type", "integer"}})}}},
                          {"required", Json::array({"any"})}};
        return ValuesOf(Json::array({number, list, any}));
      }
      case KeyKind::kTable:
        return ObjectOf(type.section);
      case KeyKind::kTables:
        return {{"type", "array"}, {"items", ObjectOf(type.section)}};
      case KeyKind::kEither:
        return {
            {"anyOf", Json::array({ObjectOf(type.section),
                                   Json{{"type", "array"}, {"items", ObjectOf(type.several)}}})}};
      case KeyKind::kWish:
        return {{"anyOf", Json::array({Json{{"const", "prove"}}, ObjectOf(type.section)})}};
    }
    return Json::object();
  }

  Language language_;
  std::vector<KeySection> sections_;
};

}  // namespace

std::string ScenarioSchema(Language language) {
  return JsonText(SchemaWriter(language).Write(), 2) + '\n';
}

}  // namespace oncard::runtime
