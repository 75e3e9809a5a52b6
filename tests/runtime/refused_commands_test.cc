// Refused commands of threads in runs of scenarios.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/sim/refused_commands.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<std::string> Texts(const std::vector<Message>& messages) {
  std::vector<std::string> texts;
  for (const Message& message : messages) texts.push_back(message.en);
  return texts;
}

// The code of the first call is overwritten by the second; line 8 is executed three times.
constexpr const char* kRefused =
    "int f()\n{\n  int n;\n  int cc;\n  GT_AxisOn(9);\n  GT_AxisOn(1);\nlbl:\n  GT_AxisOff(9);\n"
    "  n = n + 1;\n  cc = n < 3;\n  if (cc) goto lbl;\n  return 0;\n}\n";

TEST(RefusedCommands, AreWarnedOfOncePerPlace) {
  const ScenarioResult result = RunForTest(kRefused, "");
  EXPECT_TRUE(result.passed());
  const std::vector<std::string> warnings = Texts(result.warnings);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_THAT(warnings[0], StartsWith("p.c:5: thread 0 f: GT_AxisOn(9) = 7: "));
  EXPECT_THAT(warnings[0], HasSubstr(" (at 0.25 ms)"));
  EXPECT_THAT(warnings[1], StartsWith("p.c:8: thread 0 f: GT_AxisOff(9) = "));
  EXPECT_THAT(warnings[1], HasSubstr(" (first at 0.25 ms, 3 times)"));
}

TEST(RefusedCommands, FailARunThatIsStrict) {
  RunOptions options;
  options.strict_commands = true;
  const ScenarioResult result = RunForTest(kRefused, "", options);
  EXPECT_EQ(result.failures.size(), 2u);
  EXPECT_TRUE(result.warnings.empty());
  EXPECT_TRUE(RunForTest("int f()\n{\n  GT_AxisOn(1);\n  return 0;\n}\n", "", options).passed());
}

// The place is that of the call, whatever instructions precede it.
TEST(RefusedCommands, AreFoundAtTheirPlaceInLaterFunctions) {
  const ScenarioResult result = RunForTest(
      "int a;\nint f()\n{\n  return 1;\n}\nint g(int k)\n{\n  a = k + 1;\n  a = a * 2;\n"
      "  GT_AxisOn(9);\n  return a;\n}\n",
      "[[thread]]\nthread = 3\nfunction = \"g\"\n");
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_THAT(result.warnings[0].en, StartsWith("p.c:10: thread 3 g: GT_AxisOn(9) = 7"));
}

// The other runs have met the places 9, 3 and 7, in this order.
TEST(RefusedCommands, OfOtherRunsComeBehindInTheirOrder) {
  const auto at = [](int64_t first_us, int64_t count) {
    RefusedCommand refused;
    refused.first_us = first_us;
    refused.count = count;
    return refused;
  };
  std::map<int, size_t> places = {{7, 0}};
  std::vector<RefusedCommand> all = {at(300, 2)};
  IncludeFound({{9, 0}, {3, 1}, {7, 2}}, std::vector{at(50, 1), at(60, 1), at(100, 3)}, &places,
               &all);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].first_us, 100);
  EXPECT_EQ(all[0].count, 5);
  EXPECT_EQ(all[1].first_us, 50);
  EXPECT_EQ(all[2].first_us, 60);
  EXPECT_EQ(places.at(3), 2u);
}

}  // namespace
}  // namespace oncard::runtime
