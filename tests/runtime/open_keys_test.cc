// Keys that leave something open: how they are read and written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/scenario/file/scenario.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;

TEST(OpenKeys, AreWrittenAsTheyAreRead) {
  const std::string text =
      "program = \"p.c\"\nglobals = { n = { any = [1, 10] } }\n"
      "[[thread]]\nfunction = \"f\"\ninit = { k = { any = [-2, 2] } }\n"
      "[[world.fault]]\nkind = \"alarm\"\naxis = 1\nbetween_ms = [1.5, 2]\n"
      "[[world.input]]\nindex = 1\nvalue = \"any\"\nbetween_ms = [10, 40]\n";
  const auto read = ParseScenario(text, "t.toml");
  ASSERT_TRUE(read.ok()) << read.error().message.en;
  const std::string written = FormatScenario(read.value());
  EXPECT_THAT(written, HasSubstr("\"n\" = { any = [1, 10] }"));
  EXPECT_THAT(written, HasSubstr("init = { \"k\" = { any = [-2, 2] } }"));
  EXPECT_THAT(written, HasSubstr("value = \"any\"\nbetween_ms = [10, 40]\n"));
  const auto again = ParseScenario(written, "t.toml");
  ASSERT_TRUE(again.ok()) << again.error().message.en;
  EXPECT_EQ(FormatScenario(again.value()), written);
  EXPECT_EQ(again.value().world, read.value().world);
}

struct WrongOpenKey {
  const char* scenario;
  const char* message;
};

class WrongOpenKeys : public ::testing::TestWithParam<WrongOpenKey> {};

TEST_P(WrongOpenKeys, AreRefused) {
  const auto read =
      ParseScenario(std::string("program = \"p.c\"\n") + GetParam().scenario, "t.toml");
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().message.en, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongOpenKeys,
    ::testing::Values(
        WrongOpenKey{"[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = [40, 10]\n",
                     "the earlier one first, as in [10, 40]"},
        WrongOpenKey{"[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = 10\n",
                     "'between_ms' must be two times in ms"},
        WrongOpenKey{"[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = [1, 2, 3]\n",
                     "'between_ms' must be two times in ms"},
        WrongOpenKey{"[[world.input]]\nindex = 1\nvalue = 1\nbetween_ms = [1, 2]\nat_ms = 1\n",
                     "'at_ms' and 'between_ms' exclude each other"},
        WrongOpenKey{"[[world.fault]]\nkind = \"stall\"\naxis = 1\nbetween_ms = [1, 5]\nuntil_ms = "
                     "4\n",
                     "'until_ms' must be later than the end of 'between_ms'"},
        WrongOpenKey{"[[world.input]]\nvalue = \"any\"\n", "'index' is missing"},
        WrongOpenKey{"[[world.input]]\nindex = 1\nvalue = \"some\"\n",
                     "'value' must be a whole number from 0 to 1"},
        WrongOpenKey{"globals = { n = { any = [3, 1] } }\n", "the smaller one first"},
        WrongOpenKey{"globals = { n = { any = [1, 2.5] } }\n", "two whole numbers"},
        WrongOpenKey{"globals = { n = { any = [1, 2, 3] } }\n", "two whole numbers"},
        WrongOpenKey{"globals = { n = { all = [1, 2] } }\n", "as in { any = [1, 10] }"},
        WrongOpenKey{"[[host]]\nset = { n = { any = [1, 2] } }\n",
                     "'n' must be a number or a list of numbers"}));

}  // namespace
}  // namespace oncard::runtime
