// JSON against a JSON Schema: as much of one as ours use. Anything else in it is a mistake.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace oncard {

class JsonSchema {
 public:
  using Json = nlohmann::ordered_json;

  explicit JsonSchema(Json root) : root_(std::move(root)) {}

  const Json& root() const { return root_; }

  /// Why a value is not what a part of this schema describes, with its place in the value; empty if
  /// it is. `where` is the place of the value.
  std::string MistakeIn(const Json& value, const Json& schema, const std::string& where = {}) {
    for (const auto& [keyword, _] : schema.items()) {
      if (!kKeywords.contains(keyword)) return "unknown keyword of the schema: " + keyword;
    }
    if (schema.contains("$ref")) return MistakeIn(value, *Referred(schema).second, where);
    if (schema.contains("allOf")) return MistakeIn(value, schema["allOf"].at(0), where);
    if (schema.contains("anyOf")) return MistakeInChoice(value, schema["anyOf"], where);
    if (schema.contains("const") && value != schema["const"]) {
      return fmt::format("{}: not {}", where, schema["const"].dump());
    }
    if (schema.contains("enum") && std::ranges::count(schema["enum"], value) != 1) {
      return fmt::format("{}: {} is not one of {}", where, value.dump(), schema["enum"].dump());
    }
    if (schema.contains("type") && !HasType(value, schema["type"].get<std::string>())) {
      return fmt::format("{}: {} has not the type {}", where, value.dump(), schema["type"].dump());
    }
    if (value.is_object()) return MistakeInObject(value, schema, where);
    if (value.is_array()) return MistakeInArray(value, schema, where);
    return value.is_number() && !IsInRange(value, schema) ? where + ": out of range" : "";
  }

  /// The members of a part of this schema, and of all that it refers to, that no value without
  /// mistakes has had; `name` is that of the part.
  std::set<std::string> UnusedMembers(const Json& schema, const std::string& name) const {
    std::set<std::string> unused;
    std::set<const Json*> visited;
    AddUnused(schema, name, &visited, &unused);
    return unused;
  }

 private:
  inline static const std::set<std::string, std::less<>> kKeywords = {
      "$defs",    "$ref",     "$schema",    "additionalProperties",
      "allOf",    "anyOf",    "const",      "description",
      "enum",     "items",    "maximum",    "maxItems",
      "minimum",  "minItems", "multipleOf", "properties",
      "required", "title",    "type"};

  static bool HasType(const Json& value, const std::string& type) {
    return (type == "integer" && value.is_number_integer()) ||
           (type == "number" && value.is_number()) || (type == "string" && value.is_string()) ||
           (type == "boolean" && value.is_boolean()) || (type == "array" && value.is_array()) ||
           (type == "object" && value.is_object()) || (type == "null" && value.is_null());
  }

  static bool IsInRange(const Json& value, const Json& schema) {
    return value >= schema.value("minimum", Json(-HUGE_VAL)) &&
           value <= schema.value("maximum", Json(HUGE_VAL)) &&
           (!schema.contains("multipleOf") ||
            value.get<int64_t>() % schema["multipleOf"].get<int64_t>() == 0);
  }

  std::string MistakeInChoice(const Json& value, const Json& choice, const std::string& where) {
    std::string mistakes;
    for (const Json& type : choice) {
      const std::string mistake = MistakeIn(value, type, where);
      if (mistake.empty()) return {};
      mistakes += (mistakes.empty() ? "" : "; ") + mistake;
    }
    return mistakes;
  }

  std::string MistakeInObject(const Json& value, const Json& schema, const std::string& where) {
    static const Json kNone = Json::object();
    const auto found = schema.find("properties");
    const Json& members = found == schema.end() ? kNone : *found;
    for (const auto& [name, member] : value.items()) {
      const std::string place = where.empty() ? name : where + '.' + name;
      const auto known = members.find(name);
      const Json other = schema.value("additionalProperties", Json(true));
      if (known == members.end() && other.is_boolean() && !other.get<bool>()) {
        return place + ": unknown";
      }
      if (known == members.end() && other.is_boolean()) continue;
      const std::string mistake = MistakeIn(member, known == members.end() ? other : *known, place);
      if (!mistake.empty()) return mistake;
    }
    for (const auto& name : schema.value("required", std::vector<std::string>())) {
      if (!value.contains(name)) return fmt::format("{}: '{}' is missing", where, name);
    }
    for (const auto& [name, _] : value.items()) {
      if (members.contains(name)) used_.insert(&members[name]);
    }
    return {};
  }

  std::string MistakeInArray(const Json& value, const Json& schema, const std::string& where) {
    if (value.size() < schema.value("minItems", size_t{0}) ||
        value.size() > schema.value("maxItems", value.size())) {
      return fmt::format("{}: {} elements", where, value.size());
    }
    if (!schema.contains("items")) return {};
    for (size_t i = 0; i < value.size(); ++i) {
      std::string mistake = MistakeIn(value[i], schema["items"], fmt::format("{}[{}]", where, i));
      if (!mistake.empty()) return mistake;
    }
    return {};
  }

  /// The part that a reference names, with its name.
  std::pair<std::string, const Json*> Referred(const Json& schema) const {
    const std::string pointer = schema["$ref"].get<std::string>().substr(1);  // without `#`
    return {pointer.substr(pointer.rfind('/') + 1), &root_.at(Json::json_pointer(pointer))};
  }

  void AddUnused(const Json& schema, const std::string& where, std::set<const Json*>* visited,
                 std::set<std::string>* unused) const {
    if (!visited->insert(&schema).second) return;
    if (schema.contains("$ref")) {
      const auto [name, part] = Referred(schema);
      AddUnused(*part, name, visited, unused);
    }
    if (schema.contains("properties")) {
      for (const auto& [name, member] : schema["properties"].items()) {
        const std::string place = where + '.' + name;
        if (!used_.contains(&member)) unused->insert(place);
        AddUnused(member, place, visited, unused);
      }
    }
    for (const char* keyword : {"items", "additionalProperties"}) {
      if (schema.contains(keyword)) AddUnused(schema[keyword], where, visited, unused);
    }
    for (const char* keyword : {"anyOf", "allOf"}) {
      if (!schema.contains(keyword)) continue;
      for (const Json& type : schema[keyword]) AddUnused(type, where, visited, unused);
    }
  }

  Json root_;
  std::set<const Json*> used_;
};

}  // namespace oncard
