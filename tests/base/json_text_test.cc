#include "base/json_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace oncard {
namespace {

TEST(JsonText, ReplacesWhatIsNotUtf8InKeysAndValues) {
  // "轴" (axis) in GBK, and in UTF-8.
  EXPECT_EQ(JsonText({{"\xD6\xE1", "\xD6\xE1"}, {"\xE8\xBD\xB4", "\xE8\xBD\xB4"}}),
            "{\"\xEF\xBF\xBD\xEF\xBF\xBD\":\"\xEF\xBF\xBD\xEF\xBF\xBD\",\"\xE8\xBD\xB4\":"
            "\"\xE8\xBD\xB4\"}");
}

TEST(JsonText, EscapesControlCharacters) { EXPECT_EQ(JsonText({"\x1B\n"}), R"(["\u001b\n"])"); }

TEST(JsonText, IndentsWhenAsked) { EXPECT_EQ(JsonText({1, 2}, 2), "[\n  1,\n  2\n]"); }

TEST(JsonText, ReadsMessagesThatItHasWritten) {
  const std::vector<Message> written = {{"axis", "轴"}, {"", ""}};
  EXPECT_EQ(JsonText(JsonOfMessages(written)), R"([["axis","轴"],["",""]])");
  std::vector<Message> read;
  ASSERT_TRUE(ReadMessages(JsonOfMessages(written), &read));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].en, "axis");
  EXPECT_EQ(read[0].zh, "轴");
}

TEST(JsonText, ReadsNothingElseAsMessages) {
  for (const char* text : {"null", "{}", R"(["axis"])", R"([["axis"]])", R"([["axis", 1]])",
                           R"([["axis", "轴", ""]])", R"([[null, "轴"]])"}) {
    std::vector<Message> read;
    EXPECT_FALSE(ReadMessages(nlohmann::ordered_json::parse(text), &read)) << text;
  }
}

}  // namespace
}  // namespace oncard
