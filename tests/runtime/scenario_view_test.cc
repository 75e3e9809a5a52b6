// How the machine of a scenario looks: its keys.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/scenario/file/scenario.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;

constexpr char kViewHeader[] = "program = \"x.c\"\naxes = 4\n";

ViewSetup ParsedView(const std::string& text) {
  auto scenario = ParseScenario(kViewHeader + text, "s.toml");
  EXPECT_TRUE(scenario.ok()) << (scenario.ok() ? "" : scenario.error().message.en);
  return scenario.ok() ? scenario.value().view : ViewSetup();
}

std::string ViewError(const std::string& text) {
  const auto scenario = ParseScenario(kViewHeader + text, "s.toml");
  EXPECT_FALSE(scenario.ok());
  return scenario.ok() ? "" : scenario.error().message.en;
}

constexpr char kPlotter[] = R"(
[view]
title = "Plotter"
title_zh = "绘图仪"
kind = "xy"
x = 2
y = 1
z = 4
turn = 360.0

[[view.pin]]
type = "gpo"
index = 16
name = "Pen"
name_zh = "笔"

[[view.pin]]
index = 3
name = "Paper"
)";

TEST(ScenarioView, HasTheKeysOfTheFile) {
  const ViewSetup view = ParsedView(kPlotter);
  EXPECT_EQ(view, (ViewSetup{"Plotter",
                             "绘图仪",
                             "xy",
                             2,
                             1,
                             4,
                             360,
                             {{"gpo", 16, "Pen", "笔"}, {"gpi", 3, "Paper", ""}}}));
  EXPECT_EQ(ParsedView(""), ViewSetup());
}

TEST(ScenarioView, IsWrittenAndReadBack) {
  const auto scenario = ParseScenario(std::string(kViewHeader) + kPlotter, "s.toml");
  ASSERT_TRUE(scenario.ok());
  const std::string text = FormatScenario(scenario.value());
  const auto again = ParseScenario(text, "s.toml");
  ASSERT_TRUE(again.ok()) << again.error().message.en;
  EXPECT_EQ(again.value().view, scenario.value().view);
  EXPECT_EQ(FormatScenario(again.value()), text);
}

TEST(ScenarioView, LooksAtOneAxisWhereItIsNoTable) {
  EXPECT_EQ(ParsedView("[view]\nkind = \"rotary\"\nx = 2\n").x, 2);
}

TEST(ScenarioView, NamesPinsOfTwoWordsThatHaveTheSameNumber) {
  const char* const pins = R"([[view.pin]]
index = 3
name = "a"
[[view.pin]]
type = "gpo"
index = 3
name = "b"
)";
  EXPECT_EQ(ParsedView(pins).pins.size(), 2u);
}

TEST(ScenarioView, SaysOnceWhatIsWrong) {
  for (const char* text : {"[view]\nx = 13\n", "[view]\nx = 5\n"}) {
    const std::string error = ViewError(text);
    EXPECT_EQ(error.find("'x'"), error.rfind("'x'")) << error;
  }
}

TEST(ScenarioView, SaysWhatIsWrong) {
  struct {
    const char* text;
    const char* error;
  } const cases[] = {
      {"[view]\nkind = \"xz\"\n", "'kind' must be"},
      {"[view]\nx = 5\n", "'x' must be a whole number from 1 to 4"},
      {"[view]\nz = 0\n", "'z' must be a whole number from 1 to"},
      {"[view]\nturn = 0\n", "'turn' must be a number from 0.001 to"},
      {"[view]\ntitel = \"a\"\n", "did you mean 'title'?"},
      {"[[view.pin]]\nname = \"a\"\n", "'index' is missing: a pin is named as in { type = "},
      {"[[view.pin]]\nindex = 1\n", "'name' is missing"},
      {"[[view.pin]]\nindex = 17\nname = \"a\"\n", "'index' must be a whole number from 1 to 16"},
      {"[view]\nkind = \"xy\"\nx = 2\n", "different axes, not 2, 2 and 0"},
      {"[view]\nkind = \"xy\"\nz = 1\n", "different axes, not 1, 2 and 1"},
      {"[[view.pin]]\nindex = 3\nname = \"a\"\n[[view.pin]]\nindex = 3\nname = \"b\"\n",
       "gpi 3 is named twice: 'a' and 'b'"},
      {"[[view.pin]]\ntype = \"gpio\"\nindex = 1\nname = \"a\"\n", "'type' must be"},
  };
  for (const auto& c : cases) EXPECT_THAT(ViewError(c.text), HasSubstr(c.error)) << c.text;
}

}  // namespace
}  // namespace oncard::runtime
