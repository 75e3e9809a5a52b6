#include "base/json_reader.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace oncard {
namespace {

/// An object with keys 0, 1, ... and the same value for each.
std::string ObjectOf(size_t keys, const std::string& value) {
  std::string text = "{";
  for (size_t i = 0; i < keys; ++i) text += fmt::format("{}\"{}\":{}", i == 0 ? "" : ",", i, value);
  return text + "}";
}

TEST(JsonReaderTest, KeepsTheOrderOfKeys) {
  const auto json = ReadJson(R"({"b": [1, 2.5, "x", null], "a": {"c": true}})");
  EXPECT_EQ(json.dump(), R"({"b":[1,2.5,"x",null],"a":{"c":true}})");
}

TEST(JsonReaderTest, DiscardsWhatIsNotJson) {
  for (const char* text : {"", "{", "[1,]", "{\"a\":1} x", "\xff"}) {
    EXPECT_TRUE(ReadJson(text).is_discarded()) << text;
  }
}

TEST(JsonReaderTest, LimitsTheKeysOfEachObject) {
  EXPECT_EQ(ReadJson(ObjectOf(kJsonKeysMax, "0")).size(), kJsonKeysMax);
  EXPECT_TRUE(ReadJson(ObjectOf(kJsonKeysMax + 1, "0")).is_discarded());
  const std::string half = ObjectOf(kJsonKeysMax / 2 + 1, "0");
  EXPECT_FALSE(ReadJson("[" + half + "," + half + "]").is_discarded());
  EXPECT_TRUE(ReadJson("[" + ObjectOf(kJsonKeysMax + 1, "{}") + "]").is_discarded());
}

TEST(JsonReaderTest, LimitsTheKeysOfTheShortestObject) {
  std::string text = "{\"\":0";
  for (size_t keys = 1; keys < kJsonKeysMax; ++keys) text += ",\"\":0";
  EXPECT_TRUE(ReadJson(text + "}").is_object());
  EXPECT_TRUE(ReadJson(text + ",\"\":0}").is_discarded());
}

}  // namespace
}  // namespace oncard
