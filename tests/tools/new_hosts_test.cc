// Projects of oncard new with a host program: each is built, run and tested as its README says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;

const std::string kNewLib = ONCARD_BUILD_DIR "/lib";
const std::string kNewInclude = ONCARD_BUILD_DIR "/include";
/// Five calls of 50 us and GT_Update with 1 ms come before the move of 1200 ms, which ends in the
/// cycle after 1201.25 ms; the clock counts whole ms.
constexpr const char* kArrived = "at 50000 after 1201 ms\n";

class NewHosts : public testing::Test {
 protected:
  void Make(const std::string& host) {
    const ProcessResult made = RunOncard({"new", "drill", "--host=" + host}, folder_.path());
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  std::string Project() const { return folder_.path() + "/drill"; }

  /// Runs a program in the project, with the oncard of the build and a variable.
  ProcessResult RunWith(const std::string& variable, std::vector<std::string> command) const {
    command.insert(command.begin(),
                   {"env", "PATH=" ONCARD_BUILD_DIR "/bin:/usr/bin:/bin", variable});
    return RunProgram(command, Project());
  }
  static bool IsThere(const std::string& program) {
    return RunProgram({"sh", "-c", "command -v " + program}).exit_code == 0;
  }
  const ScratchFolder folder_;
};

TEST_F(NewHosts, InCAndCppPassTheirTests) {
  for (const char* const host : {"c", "cpp"}) {
    SCOPED_TRACE(host);
    Make(host);
    const ProcessResult tested = RunOncard({"test", "."}, Project());
    EXPECT_EQ(tested.exit_code, 0) << tested.out;
    EXPECT_EQ(tested.out, "ok   ./drill.host.toml\nok   ./drill.toml\n2 passed, 0 failed\n");
    std::filesystem::remove_all(Project());
  }
}

TEST_F(NewHosts, InCAndCppCompileWithoutWarnings) {
  const std::vector<std::string> compilers[] = {{"cc", "-std=c99", "drill_host.c"},
                                                {"c++", "-std=c++11", "drill_host.cpp"}};
  for (std::vector<std::string> line : compilers) {
    SCOPED_TRACE(line[0]);
    Make(line[0] == "cc" ? "c" : "cpp");
    line.insert(line.end(), {"-Wall", "-Wextra", "-Werror", "-I" + kNewInclude, "-L" + kNewLib,
                             "-lgts", "-o", "host"});
    const ProcessResult built = RunProgram(line, Project());
    ASSERT_EQ(built.exit_code, 0) << built.err;
    const ProcessResult run =
        RunOncard({"exec", "--scenario", "drill.host.toml", "--", "./host"}, Project());
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, kArrived);
    std::filesystem::remove_all(Project());
  }
}

TEST_F(NewHosts, InCsharpPassesItsTests) {
  for (const char* const tool : {"mcs", "mono"}) {
    if (!IsThere(tool)) GTEST_SKIP() << tool << " is missing: install mono-mcs and mono-runtime";
  }
  Make("cs");
  const ProcessResult tested = RunWith("GTS_CS=" + kNewInclude + "/Gts.cs", {"sh", "test.sh"});
  EXPECT_EQ(tested.exit_code, 0) << tested.out << tested.err;
  EXPECT_THAT(tested.out,
              HasSubstr("ok   ./drill.host.toml\nok   ./drill.toml\n2 passed, 0 failed\n"));
}

TEST_F(NewHosts, InPythonPassesItsTests) {
  Make("python");
  const std::string package = "PYTHONPATH=" ONCARD_BUILD_DIR "/python";
  if (RunWith(package, {"python3", "-c", "import oncard, pytest"}).exit_code != 0) {
    GTEST_SKIP() << "the package for Python or pytest is missing: run './x python'";
  }
  const ProcessResult tested = RunWith(package, {"sh", "test.sh"});
  EXPECT_EQ(tested.exit_code, 0) << tested.out << tested.err;
  EXPECT_THAT(tested.out, HasSubstr("2 passed"));
  const ProcessResult driven = RunWith(package, {"python3", "drive_drill.py"});
  EXPECT_EQ(driven.out, "600.25 ms: 25000.0 pulses, 50.0 pulse/ms\n") << driven.err;
}

}  // namespace
}  // namespace oncard::tools
