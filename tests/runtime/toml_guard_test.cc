#include "runtime/scenario/file/toml_guard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/limits.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;

const std::string kDeep(kTomlDepthMax + 1, '[');
const std::string kLong(kTomlKeyPartMax, '.');

TEST(TomlGuard, CountsNothingInStringsAndComments) {
  for (const std::string& text :
       std::vector<std::string>{"a = \"" + kDeep + "\"", "a = '" + kDeep + "'", "a = 1 # " + kDeep,
                                "a = \"\"\"\n" + kLong + "\n\"\"\"", "a = '''\n" + kLong + "\n'''",
                                "\"" + kLong + "\" = 1", "a = \"\\\"" + kDeep + "\"",
                                "\xEF\xBB\xBF"
                                "a = '\xC3\xA9' # \xC3\xA9"}) {
    EXPECT_FALSE(CheckToml(text)) << text;
  }
}

TEST(TomlGuard, FindsWhatFollowsAString) {
  for (const std::string before :
       {"\"\\\\\"", "\"\"", "''", "'\\'", "\"\"\"a\"\"\"\"\"", "'''a''''", "\"\"\"\\\"\"\"\"",
        "\"not closed\n", "1 # comment\n"}) {
    EXPECT_TRUE(CheckToml("a = " + before + kDeep)) << before;
    EXPECT_TRUE(CheckToml("a = " + before + kLong)) << before;
    EXPECT_TRUE(CheckToml("a = " + before + "\xC3\xA9")) << before;
  }
}

// A quote inside a bare value does not begin a string: toml++ reads all of it as one word.
TEST(TomlGuard, RefusesLettersBeyondAsciiInBareValues) {
  for (const std::string text :
       {"a = 0B\"\xC3\xBB\"", "a = =\"\xC3\xBB\"", "a = [1, 2'\xC3\xBB']", "a = [b=\"\xC3\xBB\"]",
        "a = {b = t\"\xC3\xBB\"}", "a = [[1], \n0\"\xC3\xBB\"]"}) {
    const auto refusal = CheckToml(text);
    ASSERT_TRUE(refusal.has_value()) << text;
    EXPECT_EQ(text[text.rfind('\n') + refusal->column], '\xC3') << text;
  }
}

TEST(TomlGuard, LetsStringsBeginWhereTomlDoes) {
  for (const std::string text :
       {"a=\"\xC3\xBB\"", "a = {b=\"\xC3\xBB\",c='\xC3\xBB'}", "a=[\"\xC3\xBB\",'\xC3\xBB']",
        "a = [{b=\"\xC3\xBB\"},\n # \xC3\xBB\n{\"\xC3\xBB\"=1}]", "a.\"\xC3\xBB\" = 1",
        "[a.\"\xC3\xBB\"]\n\"\xC3\xBB\"=true\nb=\"\xC3\xBB\""}) {
    EXPECT_FALSE(CheckToml(text)) << text;
  }
}

TEST(TomlGuard, CountsThePartsOfEachKeyAnew) {
  std::string text;
  for (size_t i = 0; i < 2 * kTomlKeyPartMax; ++i) text += "a.b = [1.5, 2.5]\n[c.d]\n";
  EXPECT_FALSE(CheckToml(text));
}

TEST(TomlGuard, SaysThePlace) {
  const auto refusal = CheckToml("a = 1\nb" + kLong);
  ASSERT_TRUE(refusal.has_value());
  EXPECT_EQ(refusal->line, 2u);
  EXPECT_EQ(refusal->column, 1 + kTomlKeyPartMax);
  EXPECT_THAT(refusal->message.zh, HasSubstr("32"));
}

}  // namespace
}  // namespace oncard::runtime
