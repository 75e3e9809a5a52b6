#include "runtime/scenario/file/key_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;

TEST(KeyScriptTest, MomentsAndCharacters) {
  EXPECT_EQ(ParseKeyScript("").value(), std::vector<KeyPress>{});
  EXPECT_EQ(ParseKeyScript("1000:q").value(), (std::vector<KeyPress>{{1'000'000, "q"}}));
  EXPECT_EQ(ParseKeyScript("1000:q,500.5:ab,0:::").value(),
            (std::vector<KeyPress>{{0, "::"}, {500'500, "ab"}, {1'000'000, "q"}}));
}

TEST(KeyScriptTest, Escapes) {
  EXPECT_EQ(ParseKeyScript(R"(1:\r\n\t\e\\\,\x41\xe9)").value(),
            (std::vector<KeyPress>{{1000, "\r\n\t\x1b\\,A\xe9"}}));
}

TEST(KeyScriptTest, AnythingElseIsRefusedWithAnExample) {
  for (const char* text : {"q", "5", "5:", ":q", "-1:q", "5:q,", ",5:q", "5:q 6:r,x", "nan:q",
                           "2e9:q", R"(5:\)", R"(5:\q)", R"(5:\x4)", R"(5:\xzz)", "5:q,,6:r"}) {
    const auto keys = ParseKeyScript(text);
    ASSERT_FALSE(keys.ok()) << text;
    EXPECT_THAT(keys.error().message.en, HasSubstr("500:a,1000:q")) << text;
    EXPECT_THAT(keys.error().message.zh, HasSubstr("500:a,1000:q")) << text;
  }
}

}  // namespace
}  // namespace oncard::runtime
