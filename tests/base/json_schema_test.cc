// The checker that tests of schemas use.
#include "tests/base/json_schema.h"

#include <gtest/gtest.h>

namespace oncard {
namespace {

struct SchemaCase {
  const char* value;
  const char* mistake;
};

TEST(JsonSchema, SaysWhereAMistakeIs) {
  JsonSchema schema(JsonSchema::Json::parse(R"({
    "type": "object", "additionalProperties": false, "required": ["id"],
    "properties": {
      "id": {"type": "integer", "minimum": 1, "maximum": 9, "multipleOf": 2},
      "kind": {"enum": ["a", "b"]},
      "on": {"const": true},
      "parts": {"type": "array", "maxItems": 2, "items": {"$ref": "#/$defs/Part"}},
      "either": {"anyOf": [{"type": "string"}, {"type": "null"}]}},
    "$defs": {"Part": {"type": "object", "additionalProperties": {"type": "number"}}}})"));
  for (const auto& [value, mistake] :
       {SchemaCase{R"({"id": 4, "kind": "a", "on": true, "parts": [{"x": 0.5}], "either": null})",
                   ""},
        SchemaCase{"[]", ": [] has not the type \"object\""}, SchemaCase{"{}", ": 'id' is missing"},
        SchemaCase{R"({"id": 1.5})", "id: 1.5 has not the type \"integer\""},
        SchemaCase{R"({"id": 3})", "id: out of range"},
        SchemaCase{R"({"id": 0})", "id: out of range"},
        SchemaCase{R"({"id": 10})", "id: out of range"},
        SchemaCase{R"({"id": 4, "x": 1})", "x: unknown"},
        SchemaCase{R"({"id": 4, "kind": "c"})", R"(kind: "c" is not one of ["a","b"])"},
        SchemaCase{R"({"id": 4, "on": false})", "on: not true"},
        SchemaCase{R"({"id": 4, "parts": [{}, {"x": "y"}]})",
                   "parts[1].x: \"y\" has not the type \"number\""},
        SchemaCase{R"({"id": 4, "parts": [{}, {}, {}]})", "parts: 3 elements"},
        SchemaCase{R"({"id": 4, "either": 1})",
                   R"(either: 1 has not the type "string"; either: 1 has not the type "null")"}}) {
    EXPECT_EQ(schema.MistakeIn(JsonSchema::Json::parse(value), schema.root()), mistake) << value;
  }
}

TEST(JsonSchema, HasNoKeywordThatItDoesNotCheck) {
  JsonSchema schema(JsonSchema::Json::parse(R"({"type": "string", "pattern": "a"})"));
  EXPECT_EQ(schema.MistakeIn("b", schema.root()), "unknown keyword of the schema: pattern");
}

TEST(JsonSchema, KnowsWhichMembersWereUsed) {
  JsonSchema schema(JsonSchema::Json::parse(R"({
    "type": "object", "properties": {"a": {"type": "integer"}, "b": {"$ref": "#/$defs/Part"}},
    "$defs": {"Part": {"type": "object", "properties": {"c": {"type": "string"}}}}})"));
  EXPECT_EQ(schema.MistakeIn(JsonSchema::Json::parse(R"({"a": 1})"), schema.root()), "");
  EXPECT_EQ(schema.UnusedMembers(schema.root(), "Whole"),
            (std::set<std::string>{"Part.c", "Whole.b"}));
}

}  // namespace
}  // namespace oncard
