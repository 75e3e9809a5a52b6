// The help of every command is a golden file: a change of the command line is visible in review.
#include <gtest/gtest.h>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

const char* const kCommands[] = {"build", "check",  "explain", "run",     "test",   "replay",
                                 "dump",  "verify", "exec",    "explore", "doctor", "schema"};

class HelpTest : public testing::TestWithParam<const char*> {};

TEST_P(HelpTest, IsGoldenInEnglish) {
  const ProcessResult result = RunOncard({GetParam(), "--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  ExpectGolden(std::string("help_") + GetParam() + ".txt", result.out);
}

TEST_P(HelpTest, SpeaksChinese) {
  const ProcessResult result = RunOncard({"--lang=zh", GetParam(), "--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.out.find("显示本帮助"), std::string::npos) << result.out;
}

INSTANTIATE_TEST_SUITE_P(Commands, HelpTest, testing::ValuesIn(kCommands),
                         [](const auto& name) { return std::string(name.param); });

TEST(Help, OfTheRootIsGoldenInBothLanguages) {
  ExpectGolden("help.txt", RunOncard({"--help"}).out);
  ExpectGolden("help_zh.txt", RunOncard({"--lang=zh", "--help"}).out);
}

TEST(Help, NamesEveryCommand) {
  const std::string help = RunOncard({"--help"}).out;
  for (const char* command : kCommands) {
    EXPECT_NE(help.find(std::string("\n  ") + command + " "), std::string::npos) << command;
  }
}

TEST(Help, HidesWhatPackagersUse) {
  EXPECT_EQ(RunOncard({"--help"}).out.find("completion"), std::string::npos);
}

TEST(Language, FollowsTheLocaleUnlessTold) {
  EXPECT_NE(RunOncard({"--help"}, "", {"LC_ALL=zh_CN.UTF-8"}).out.find("用法"), std::string::npos);
  EXPECT_NE(RunOncard({"--help", "--lang=en"}, "", {"LC_ALL=zh_CN.UTF-8"}).out.find("Usage"),
            std::string::npos);
}

TEST(Version, IsOneLine) {
  const ProcessResult result = RunOncard({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out.rfind("oncard ", 0), 0u);
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1);
}

struct MistakeCase {
  std::vector<std::string> arguments;
  const char* says;
};

class MistakeTest : public testing::TestWithParam<MistakeCase> {};

TEST_P(MistakeTest, ExitsWithTwoAndSaysWhere) {
  const ProcessResult result = RunOncard(GetParam().arguments);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find(GetParam().says), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("--help"), std::string::npos) << result.err;
}

INSTANTIATE_TEST_SUITE_P(Mistakes, MistakeTest,
                         testing::Values(MistakeCase{{}, "subcommand"}, MistakeCase{{"fly"}, "fly"},
                                         MistakeCase{{"build"}, "sources"},
                                         MistakeCase{{"run", "--rate=0", "x.c"}, "--rate"},
                                         MistakeCase{{"run", "--cycle=300", "x.c"}, "125"},
                                         MistakeCase{{"run", "--until=nan", "x.c"}, "nan"},
                                         MistakeCase{{"run", "--until=-1", "x.c"}, "-1"},
                                         MistakeCase{{"run", "--trace=x.png", "x.c"}, ".vcd"},
                                         MistakeCase{{"check", "--diagnostics=xml", "x.c"}, "xml"},
                                         MistakeCase{{"build", "--double=8.8", "x.c"}, "8.8"},
                                         MistakeCase{{"--lang=fr", "doctor"}, "fr"}));

TEST(Mistake, IsReportedInChinese) {
  const ProcessResult result = RunOncard({"--lang=zh", "build"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("缺少必需的参数"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace oncard::tools
