// Every warning of the card's supervisor in every command that runs programs, and in the session
// that the page and the debuggers use. What each is about: tests/runtime/supervisor_test.cc.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>

#include "runtime/observe/card_warnings.h"
#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

using Json = nlohmann::json;

/// How lines with warnings of the supervisor begin; the compiler's begin with a place.
constexpr const char* kLine = "oncard: warning: ";

/// A program whose statements begin in line 4, and its scenario.
struct WarnedRun {
  const char* name;   ///< of the warning, the only one
  const char* place;  ///< how its text begins
  const char* statements;
  const char* scenario = "";
};

constexpr WarnedRun kRuns[] = {
    {"drive-off", "p.c:6: thread 0 f: axis 1 moves while",
     "  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n  GT_Update(1);\n  GT_Stop(1, 1);\n"},
    {"update-mask", "p.c:7: thread 0 f: the mask starts axis 1, 2",
     "  GT_PrfTrap(3);\n  GT_SetVel(3, 10);\n  GT_SetPos(3, 100);\n  GT_Update(3);\n"},
    {"no-velocity", "p.c:6: thread 0 f: axis 1 is started without a velocity",
     "  GT_PrfTrap(1);\n  GT_SetPos(1, 100);\n  GT_Update(1);\n"},
    {"two-threads", "p.c:16: thread 1 g: axis 1 gets a target",
     "  GT_PrfTrap(1);\n  GT_SetVel(1, 10);\n  GT_SetPos(1, 100);\n  GT_Delay(20);\n"
     "  GT_SetPos(1, 0);\n  return 0;\n}\nint g()\n{\n  GT_Delay(10);\n\n\n"
     "  GT_SetPos(1, 50);\n",
     "[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 1\nfunction = \"g\"\n"},
    {"period-overrun",
     "p.c:", "  i = 0;\nlbl:\n  i = i + 1;\n  more = i < 200;\n  if (more) goto lbl;\n",
     "until_ms = 10\n[[thread]]\nfunction = \"f\"\nperiod_ms = 1\n"},
    {"axis-stopped", "p.c:8: thread 0 f: axis 1 passed its positive soft limit 1 at",
     "  GT_AxisOn(1);\n  GT_SetSoftLimit(1, 1, -1);\n  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n"
     "  GT_Update(1);\n  GT_Delay(50);\n"},
    {"axis-limit", "p.c:7: thread 0 f: axis 1 is planned with",
     "  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n  GT_Update(1);\n"
     "  GT_Delay(20);\n  GT_Stop(1, 1);\n  GT_Delay(5);\n",
     "[[world.axis]]\naxis = 1\nmax_vel = 5\n"},
    {"work-left", "p.c:7: thread 0 f: axis 1 still moves at the end",
     "  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n  GT_Update(1);\n"},
};

class CardWarningTest : public ::testing::TestWithParam<WarnedRun> {
 protected:
  void SetUp() override {
    folder_.Write("p.c", std::string("int i, more;\nint f()\n{\n") + GetParam().statements +
                             "  return 0;\n}\n");
    folder_.Write("s.toml", std::string("program = \"p.c\"\n") + GetParam().scenario);
  }
  ProcessResult Run(const std::vector<std::string>& arguments) const {
    return RunOncard(arguments, folder_.path());
  }
  std::string ending() const { return std::string(" [") + GetParam().name + "]"; }

  const ScratchFolder folder_;
};

TEST_P(CardWarningTest, IsTheOnlyOneOfItsRun) {
  const std::string err = Run({"run", "s.toml"}).err;
  const size_t first = err.find(kLine);
  ASSERT_NE(first, std::string::npos) << err;
  EXPECT_EQ(err.find(kLine, first + 1), std::string::npos) << err;
  EXPECT_THAT(err.substr(first), StartsWith(std::string(kLine) + GetParam().place));
  EXPECT_THAT(err, HasSubstr(ending() + "\n"));
}

TEST_P(CardWarningTest, IsGivenByTestAndExploreAndInReports) {
  EXPECT_THAT(Run({"test", "s.toml"}).out,
              HasSubstr(std::string("     warning: ") + GetParam().place));
  EXPECT_THAT(Run({"explore", "s.toml"}).err, HasSubstr(std::string(kLine) + GetParam().place));
  const Json report = Json::parse(Run({"run", "--format=json", "s.toml"}).out);
  ASSERT_EQ(report["warnings"].size(), 1u);
  EXPECT_THAT(report["warnings"][0].get<std::string>(), HasSubstr(ending()));
}

TEST_P(CardWarningTest, FailsWhatIsStrictAndCanBeSwitchedOff) {
  // 5: explored up to until_ms only.
  const auto passed = ::testing::AnyOf(0, 5);
  for (const std::string command : {"run", "test", "explore"}) {
    EXPECT_THAT(Run({command, "s.toml"}).exit_code, passed) << command;
    EXPECT_EQ(Run({command, "--strict-commands", "s.toml"}).exit_code, 1) << command;
    const ProcessResult silent =
        Run({command, "--strict-commands", std::string("-Wno-") + GetParam().name, "s.toml"});
    EXPECT_THAT(silent.exit_code, passed) << command << silent.out << silent.err;
  }
}

TEST_P(CardWarningTest, IsShownByTheSession) {
  folder_.Write("requests",
                "{\"request\":\"load\",\"arguments\":{\"main\":\"s.toml\"}}\n"
                "{\"request\":\"forward\",\"arguments\":{\"goal\":\"stop\"}}\n"
                "{\"request\":\"state\"}\n");
  const ProcessResult result =
      RunProgram({"sh", "-c", ONCARD_BUILD_DIR "/bin/oncard debug --stdio < requests | tail -n 1"},
                 folder_.path());
  const Json answer = Json::parse(result.out);
  const Json& warnings = answer["result"]["warnings"];
  ASSERT_EQ(warnings.size(), 1u) << result.out;
  EXPECT_EQ(warnings[0]["name"], GetParam().name);
}

INSTANTIATE_TEST_SUITE_P(, CardWarningTest, ::testing::ValuesIn(kRuns), [](const auto& row) {
  std::string name = row.param.name;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(CardWarnings, AreAllTriedInEveryCommand) {
  for (const runtime::CardWarningInfo& info : runtime::CardWarningTable()) {
    const auto tried = [&](const WarnedRun& run) { return info.name == run.name; };
    EXPECT_TRUE(std::ranges::any_of(kRuns, tried)) << info.name;
  }
}

}  // namespace
}  // namespace oncard::tools
