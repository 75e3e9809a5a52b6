#include "session/schema_words.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace oncard::session::schema {
namespace {

Json Explained(Json type, std::string_view meaning) {
  if (meaning.empty()) return type;
  Json explained = {{"description", meaning}};
  // Beside a reference a description would make another type of it.
  if (type.contains("$ref")) {
    explained["allOf"] = Json::array({std::move(type)});
  } else {
    explained.update(type);
  }
  return explained;
}

}  // namespace

Json Text() { return {{"type", "string"}}; }
Json Flag() { return {{"type", "boolean"}}; }
Json Whole() { return {{"type", "integer"}}; }
Json Number() { return {{"type", "number"}}; }
Json Anything() { return Json::object(); }
Json Always(Json value) { return {{"const", std::move(value)}}; }
Json Words(const std::vector<std::string_view>& words) { return {{"enum", words}}; }
Json ListOf(Json item) { return {{"type", "array"}, {"items", std::move(item)}}; }
Json ByName(Json member) {
  return {{"type", "object"}, {"additionalProperties", std::move(member)}};
}
Json OneOf(std::vector<Json> types) { return {{"anyOf", std::move(types)}}; }
Json OrNull(Json type) { return OneOf({std::move(type), {{"type", "null"}}}); }
Json The(std::string_view part) { return {{"$ref", "#/$defs/" + std::string(part)}}; }

Member Has(std::string_view name, Json type, std::string_view meaning) {
  return {std::string(name), Explained(std::move(type), meaning), true};
}

Member MayHave(std::string_view name, Json type, std::string_view meaning) {
  return {std::string(name), Explained(std::move(type), meaning), false};
}

Members operator+(Members members, const Members& more) {
  std::ranges::copy(more, std::back_inserter(members));
  return members;
}

Json Object(const Members& members) {
  Json object = {{"type", "object"}, {"additionalProperties", false}};
  for (const Member& member : members) {
    object["properties"][member.name] = member.type;
    if (member.required) object["required"].push_back(member.name);
  }
  return object;
}

}  // namespace oncard::session::schema
