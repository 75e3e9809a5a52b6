// The help of every command is a golden file: a change of the command line is visible in review.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

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
  EXPECT_THAT(result.out, HasSubstr("显示本帮助"));
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
    EXPECT_THAT(help, HasSubstr(std::string("\n  ") + command + " ")) << command;
  }
}

TEST(Help, HidesWhatPackagersUse) {
  EXPECT_THAT(RunOncard({"--help"}).out, Not(HasSubstr("completion")));
}

TEST(Language, FollowsTheLocaleUnlessTold) {
  EXPECT_THAT(RunOncard({"--help"}, "", {"LC_ALL=zh_CN.UTF-8"}).out, HasSubstr("用法"));
  EXPECT_THAT(RunOncard({"--help", "--lang=en"}, "", {"LC_ALL=zh_CN.UTF-8"}).out,
              HasSubstr("Usage"));
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
  EXPECT_THAT(result.err, HasSubstr(GetParam().says));
  EXPECT_THAT(result.err, HasSubstr("--help"));
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
  EXPECT_THAT(result.err, HasSubstr("缺少必需的参数"));
}

// --- Words that are no option ------------------------------------------------------------------

struct WrongOption {
  std::vector<std::string> words;
  const char* said;
};

class WrongOptionTest : public testing::TestWithParam<WrongOption> {};

TEST_P(WrongOptionTest, IsNamedWithTheNearestOne) {
  const ProcessResult result = RunOncard(GetParam().words);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, testing::StartsWith(std::string("oncard: ") + GetParam().said + '\n'));
}

INSTANTIATE_TEST_SUITE_P(
    Words, WrongOptionTest,
    testing::Values(
        WrongOption{{"run", "s.c", "--untill", "5"},
                    "there is no option '--untill'; did you mean '--until'?"},
        WrongOption{{"run", "s.c", "--untill=5"},
                    "there is no option '--untill'; did you mean '--until'?"},
        WrongOption{{"run", "--untill=5"},
                    "there is no option '--untill'; did you mean '--until'?"},
        WrongOption{{"run", "s.c", "-until", "5"},
                    "there is no option '-until'; did you mean '--until'?"},
        WrongOption{{"build", "s.c", "--structurd"},
                    "there is no option '--structurd'; did you mean '--structured'?"},
        WrongOption{{"check", "s.c", "--fixx"},
                    "there is no option '--fixx'; did you mean '--fix'?"},
        WrongOption{{"lower", "s.c", "--ouput", "o.c"},
                    "there is no option '--ouput'; did you mean '--output'?"},
        WrongOption{{"test", "a", "--job=2"}, "there is no option '--job'; did you mean '--jobs'?"},
        WrongOption{{"explore", "a", "--timee=2"},
                    "there is no option '--timee'; did you mean '--time'?"},
        WrongOption{{"exec", "--senario=x", "--", "ls"},
                    "there is no option '--senario'; did you mean '--scenario'?"},
        WrongOption{{"doctor", "--langg=zh"},
                    "there is no option '--langg'; did you mean '--lang'?"},
        WrongOption{{"--verson"}, "there is no option '--verson'; did you mean '--version'?"},
        WrongOption{{"run", "s.c", "-q"}, "there is no option '-q'"},
        WrongOption{{"--lang=zh", "run", "s.c", "--untill"},
                    "没有选项“--untill”；是否为“--until”？"}));

}  // namespace
}  // namespace oncard::tools
