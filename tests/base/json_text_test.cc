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

}  // namespace
}  // namespace oncard
