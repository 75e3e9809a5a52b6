#include "base/message.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace oncard {
namespace {

TEST(Message, FormatsBothLanguagesFromTheSameArguments) {
  const Message message = MakeMessage("{0} of {1}", "{1} 之 {0}", 1, 2);
  EXPECT_EQ(message.In(Language::kEnglish), "1 of 2");
  EXPECT_EQ(message.In(Language::kChinese), "2 之 1");
}

struct EnvironmentCase {
  const char* own;
  const char* lc_all;
  const char* lc_messages;
  const char* lang;
  Language expected;
};

class LanguageFromEnvironmentTest : public testing::TestWithParam<EnvironmentCase> {};

TEST_P(LanguageFromEnvironmentTest, FirstSetVariableDecides) {
  const EnvironmentCase& c = GetParam();
  ::setenv("ONCARD_LANG", c.own, 1);
  ::setenv("LC_ALL", c.lc_all, 1);
  ::setenv("LC_MESSAGES", c.lc_messages, 1);
  ::setenv("LANG", c.lang, 1);
  EXPECT_EQ(LanguageFromEnvironment(), c.expected);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, LanguageFromEnvironmentTest,
    testing::Values(EnvironmentCase{"", "", "", "", Language::kEnglish},
                    EnvironmentCase{"", "", "", "zh_CN.UTF-8", Language::kChinese},
                    EnvironmentCase{"", "", "en_US.UTF-8", "zh_CN.UTF-8", Language::kEnglish},
                    EnvironmentCase{"", "zh_TW.UTF-8", "en_US.UTF-8", "C", Language::kChinese},
                    EnvironmentCase{"en", "zh_TW.UTF-8", "", "", Language::kEnglish}));

}  // namespace
}  // namespace oncard
