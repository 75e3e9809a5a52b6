// Host programs as tests: `oncard test` builds and runs the host that a scenario names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Json = nlohmann::json;

// Moves axis 1 to 100, which takes less than 50 ms, and ends with its number of arguments.
constexpr const char* kMove = R"(#include "gts.h"
int main(int count, char** words) {
  TTrapPrm trap = {1, 1, 0, 0};
  long status;
  (void)words;
  GT_Open(0, 1);
  GT_AxisOn(1);
  GT_PrfTrap(1);
  GT_SetTrapPrm(1, &trap);
  GT_SetPos(1, 100);
  GT_SetVel(1, 10);
  GT_Update(1);
  do {
    GT_GetSts(1, &status, 1, NULL);
  } while (status & 0x400);
  GT_Close();
  return count - 1;
}
)";

class HostTestsTest : public testing::Test {
 protected:
  HostTestsTest() { scratch_.Write("t/host.c", kMove); }

  void Write(const std::string& name, const std::string& host,
             const std::string& expect = "axis1.prfPos == 100") {
    scratch_.Write("t/" + name, "host = " + host + "\nexpect = [\"" + expect + "\"]\n");
  }
  ProcessResult Test(std::vector<std::string> arguments,
                     const std::vector<std::string>& environment = {}) {
    arguments.insert(arguments.begin(), "test");
    return RunOncard(arguments, scratch_.path(), environment);
  }
  /// The only test of a report.
  Json OnlyTest(std::vector<std::string> arguments) {
    arguments.emplace_back("--format=json");
    return Json::parse(Test(arguments).out).at("tests").at(0);
  }
  const ScratchFolder scratch_;
};

constexpr const char* kSource = "{ source = \"host.c\" }";

TEST_F(HostTestsTest, ABuiltHostIsATest) {
  Write("a.host.toml", kSource);
  Write("b.host.toml", kSource, "axis1.prfPos == 99");
  const ProcessResult result = Test({"t"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out,
            "ok   t/a.host.toml\n"
            "FAIL t/b.host.toml\n"
            "     card 0: 'axis1.prfPos == 99' does not hold: axis1.prfPos is 100.0\n"
            "1 passed, 1 failed\n");
  EXPECT_THAT(Test({"--lang=zh", "t"}).out, HasSubstr("卡 0：“axis1.prfPos == 99”不成立："));
  EXPECT_FALSE(scratch_.Has("t/host")) << "the folder stays as it was";
}

TEST_F(HostTestsTest, AnyNameWillDo) {
  Write("a.toml", kSource);
  EXPECT_EQ(Test({"t"}).out, "ok   t/a.toml\n1 passed, 0 failed\n");
}

TEST_F(HostTestsTest, StandsInEveryReport) {
  Write("b.toml", kSource, "axis1.prfPos == 99");
  const char* failure = "card 0: 'axis1.prfPos == 99' does not hold: axis1.prfPos is 100.0";
  EXPECT_THAT(Test({"t", "--format=tap"}).out,
              HasSubstr(std::string("not ok 1 - t/b.toml\n# ") + failure + '\n'));
  EXPECT_THAT(Test({"t", "--format=csv"}).out, HasSubstr(std::string(",\"") + failure + '"'));
  const std::string junit = Test({"t", "--format=junit"}).out;
  EXPECT_THAT(junit, HasSubstr(std::string("<failure message=\"") + failure + "\"/>"));
  // 10 pulse/ms for 100 pulses with 10 ms each to accelerate and brake: 20 ms, in virtual time.
  EXPECT_THAT(junit, testing::ContainsRegex("name=\"t/b\\.toml\" time=\"0\\.02[0-9]+\""));
  EXPECT_EQ(OnlyTest({"t"})["failures"][0], std::string(failure));
}

TEST_F(HostTestsTest, ItsExitCodeCounts) {
  Write("a.toml", "{ source = \"host.c\", arguments = [\"1\", \"2\"] }");
  EXPECT_EQ(OnlyTest({"t"})["failures"][0], "'host.c' ended with the exit code 2");
  scratch_.Write("t/host.c",
                 "#include <stdio.h>\n#include <stdlib.h>\n"
                 "int main(void) { puts(\"one\\ntwo\"); fflush(stdout); abort(); }\n");
  EXPECT_EQ(OnlyTest({"t"})["failures"].back(),
            "'host.c' was ended by a signal (Aborted); its output ends with:\n    one\n    two");
}

TEST_F(HostTestsTest, ShowsWhyItCannotBeBuilt) {
  Write("a.toml", kSource);
  scratch_.Write("t/host.c", "#include \"gts.h\"\nint main(void) { return missing; }\n");
  const std::string failure = OnlyTest({"t"})["failures"][0];
  EXPECT_THAT(failure, StartsWith("'host.c' cannot be compiled; its output ends with:\n"));
  EXPECT_THAT(failure, HasSubstr("host.c:2"));
  EXPECT_THAT(failure, HasSubstr("missing"));
}

TEST_F(HostTestsTest, TakesOptionsOfTheCompiler) {
  scratch_.Write("more/value.h", "#define VALUE 3\n");
  scratch_.Write("t/host.c", "#include \"value.h\"\nint main(void) { return VALUE - WANTED; }\n");
  scratch_.Write("t/a.toml",
                 "host = { source = \"host.c\", flags = [\"-I../more\", \"-DWANTED=3\"] }\n");
  EXPECT_EQ(Test({"t"}).out, "ok   t/a.toml\n1 passed, 0 failed\n");
}

TEST_F(HostTestsTest, ShowsWarningsOfTheCompiler) {
  Write("a.toml", "{ source = \"host.c\", flags = [\"-Wall\"] }");
  scratch_.Write("t/host.c", std::string("static int unused;\n") + kMove);
  const Json test = OnlyTest({"t"});
  EXPECT_EQ(test["status"], "passed");
  EXPECT_THAT(std::string(test["warnings"][0]), StartsWith("the compiler says:\n    "));
}

TEST_F(HostTestsTest, MayBeInCpp) {
  Write("a.toml", "{ source = \"host.cpp\" }");
  scratch_.Write("t/host.cpp", "#include <windows.h>\n#include <cstdlib>\n" + std::string(kMove));
  EXPECT_EQ(OnlyTest({"t"})["status"], "passed") << OnlyTest({"t"});
}

TEST_F(HostTestsTest, ACommandRunsInItsFolder) {
  scratch_.Write("t/here", "");
  scratch_.Write("t/a.toml", "host = { command = [\"test\", \"-e\", \"here\"] }\n");
  EXPECT_EQ(Test({"t"}).out, "ok   t/a.toml\n1 passed, 0 failed\n");
  scratch_.Write("t/a.toml", "host = { command = [\"./none\"] }\n");
  const Json test = OnlyTest({"t"});
  EXPECT_EQ(test["status"], "failed");
  EXPECT_THAT(std::string(test["failures"][0]), HasSubstr("cannot run './none'"));
}

// The file of the bus is looked for in the folder of the program, which is built elsewhere.
TEST_F(HostTestsTest, FindsTheEniFileBesideItsSource) {
  scratch_.Write("t/host.c",
                 "#include \"gts.h\"\nint main(void) {\n  GT_Open(CHANNEL_PCI_ECAT, 1);\n"
                 "  return GT_InitEcatComm() == -8 ? 0 : 1;\n}\n");
  scratch_.Write("t/a.toml", "host = { source = \"host.c\" }\n[[ethercat.slave]]\n");
  EXPECT_EQ(OnlyTest({"t"})["status"], "failed") << "without a file the slaves are as expected";
  scratch_.Write("t/Gecat.eni", "damaged");
  EXPECT_EQ(OnlyTest({"t"})["status"], "passed") << OnlyTest({"t"});
}

TEST_F(HostTestsTest, ReadsNothing) {
  scratch_.Write("t/a.toml", "host = { command = [\"sh\", \"-c\", \"! read x\"] }\n");
  EXPECT_EQ(OnlyTest({"t"})["status"], "passed");
}

TEST_F(HostTestsTest, IsEndedWithAllItHasStarted) {
  scratch_.Write("t/a.toml",
                 "host = { command = [\"sh\", \"-c\", \"echo begun; while true; do :; done\"] }\n");
  EXPECT_EQ(OnlyTest({"t", "--timeout=1"})["failures"][0],
            "it took longer than 1 s: --timeout sets the limit");
}

TEST_F(HostTestsTest, ItsTemporaryFolderMayBeRelative) {
  Write("a.toml", kSource);
  scratch_.Write("temporary/file", "");
  EXPECT_EQ(Test({"t"}, {"TMPDIR=temporary"}).out, "ok   t/a.toml\n1 passed, 0 failed\n");
}

TEST_F(HostTestsTest, FailsWithoutATemporaryFolder) {
  Write("a.toml", kSource);
  EXPECT_EQ(Test({"t"}, {"TMPDIR=" + scratch_.path() + "/none"}).out,
            "FAIL t/a.toml\n"
            "     no temporary folder can be made for it\n"
            "0 passed, 1 failed\n");
  EXPECT_FALSE(std::filesystem::exists("/0")) << "the name of the test's folder in it";
}

TEST_F(HostTestsTest, OtherHostsTakeItsPlace) {
  Write("a.toml", kSource);
  scratch_.Write("t/b.host.toml", "expect = [\"axis1.prfPos == 100\"]\n");
  scratch_.Write("t/c.toml", "host = { command = [\"true\"] }\n");
  scratch_.Write("hand-in/ann.c", kMove);
  const ProcessResult result = Test({"t", "--program=hand-in/*.c"});
  EXPECT_EQ(result.out,
            "ok   t/a.toml: hand-in/ann.c\n"
            "ok   t/b.host.toml: hand-in/ann.c\n"
            "FAIL t/c.toml: hand-in/ann.c\n"
            "     the host is a command, which --program cannot replace: name a 'source' in "
            "'host'\n"
            "2 passed, 1 failed\n");
}

// Nothing is skipped without a word.
TEST_F(HostTestsTest, WithoutAHostItIsCounted) {
  scratch_.Write("t/a.host.toml", "expect = [\"axis1.prfPos == 100\"]\n");
  const ProcessResult result = Test({"t"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(
      result.out,
      "skip t/a.host.toml\n"
      "     skipped: it names no host program: add host = { source = \"host.c\" } or host = { "
      "command = [\"./host\"] } to the file\n"
      "0 passed, 0 failed, 1 skipped\n");
  EXPECT_THAT(Test({"t", "--format=tap"}).out, HasSubstr("ok 1 - t/a.host.toml # SKIP skipped: "));
  EXPECT_THAT(Test({"t", "--format=csv"}).out, HasSubstr("\"t/a.host.toml\",\"\",skipped,"));
  EXPECT_THAT(Test({"t", "--format=junit"}).out, HasSubstr("<skipped message=\"skipped: "));
  EXPECT_EQ(OnlyTest({"t"})["status"], "skipped");
}

TEST_F(HostTestsTest, RefusedCommandsAreWarningsOrFailures) {
  scratch_.Write("t/host.c",
                 "#include \"gts.h\"\nint main(void) {\n  GT_Open(0, 1);\n"
                 "  GT_AxisOn(99);\n  GT_Close();\n  return 0;\n}\n");
  scratch_.Write("t/a.toml", "host = { source = \"host.c\" }\n");
  EXPECT_THAT(std::string(OnlyTest({"t"})["warnings"][0]), HasSubstr("GT_AxisOn(99) = 7"));
  EXPECT_THAT(std::string(OnlyTest({"t", "--strict-commands"})["failures"][0]),
              HasSubstr("GT_AxisOn(99) = 7"));
}

// --- The end of the command ----------------------------------------------------------------------

/// The processes that a process has started.
std::vector<pid_t> ChildrenOf(pid_t process) {
  const std::string id = std::to_string(process);
  std::ifstream list("/proc/" + id + "/task/" + id + "/children");
  std::vector<pid_t> children;
  for (pid_t child = 0; list >> child;) children.push_back(child);
  return children;
}

/// Waits until there is one.
pid_t ChildOf(pid_t process) {
  for (int look = 0; look < 1000; ++look) {
    const auto children = ChildrenOf(process);
    if (!children.empty()) return children.front();
    ::usleep(10'000);
  }
  return 0;
}

/// Waits until the process has ended.
bool Ends(pid_t process) {
  for (int look = 0; look < 1000; ++look) {
    std::ifstream status("/proc/" + std::to_string(process) + "/stat");
    std::string id, name, state;
    if (!(status >> id >> name >> state) || state == "Z") return true;
    ::usleep(10'000);
  }
  return false;
}

TEST_F(HostTestsTest, NothingSurvivesTheDeathOfTheCommand) {
  scratch_.Write("t/a.toml", "host = { command = [\"sh\", \"-c\", \"while true; do :; done\"] }\n");
  RunningOncard oncard({"test", scratch_.path() + "/t", "--timeout=0"});
  const pid_t test = ChildOf(oncard.process());
  const pid_t host = ChildOf(test);
  ASSERT_GT(host, 0);
  EXPECT_EQ(oncard.Stop(SIGKILL), 128 + SIGKILL);
  EXPECT_TRUE(Ends(test));
  EXPECT_TRUE(Ends(host));
}

}  // namespace
}  // namespace oncard::tools
