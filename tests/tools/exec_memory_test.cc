// The memory of a card that survives power-off, under `oncard exec` and in records of hosts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>
#include <vector>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;

/// Runs of the host `memory` in a folder of their own.
class ExecMemory : public testing::Test {
 protected:
  ProcessResult Host(const std::string& end, const std::vector<std::string>& options = {},
                     const std::string& variable = {}) const {
    std::vector<std::string> environment = {"ONCARD_LOG=calls"};
    if (!variable.empty()) environment.push_back("ONCARD_MRAM=" + variable);
    std::vector<std::string> command = {ONCARD_BUILD_DIR "/bin/oncard", "exec"};
    command.insert(command.end(), options.begin(), options.end());
    command.insert(command.end(), {"--", ONCARD_BUILD_DIR "/tests/runtime/memory", end});
    return RunProgram(command, folder_.path(), environment);
  }
  ProcessResult HostWithFile(const std::string& end) const { return Host(end, {}, "m.mram"); }

  ScratchFolder folder_;
};

TEST_F(ExecMemory, IsClearAtEachOpeningWithoutAFile) {
  EXPECT_EQ(Host("twice").out, "0\n0\n");
  EXPECT_EQ(Host("close").out, "0\n");
}

TEST_F(ExecMemory, SurvivesInTheFileOfTheVariable) {
  EXPECT_EQ(HostWithFile("close").out, "0\n");
  EXPECT_EQ(folder_.Read("m.mram"), "oncard-mram 1\n7 1\n");
  EXPECT_EQ(HostWithFile("twice").out, "1\n2\n");
  EXPECT_EQ(folder_.Read("m.mram"), "oncard-mram 1\n7 3\n");
}

TEST_F(ExecMemory, SurvivesAHostThatDoesNotCloseItsCard) {
  EXPECT_EQ(HostWithFile("leave").out, "0\n");
  EXPECT_EQ(HostWithFile("close").out, "1\n");
}

TEST_F(ExecMemory, OfAHostThatIsKilledIsAsBefore) {
  EXPECT_EQ(HostWithFile("close").out, "0\n");
  EXPECT_EQ(HostWithFile("abort").out, "1\n");
  EXPECT_EQ(folder_.Read("m.mram"), "oncard-mram 1\n7 1\n");
}

TEST_F(ExecMemory, IsNotWrittenByAChild) {
  EXPECT_EQ(HostWithFile("child").out, "0\n");
  EXPECT_EQ(HostWithFile("close").out, "0\n");
}

TEST_F(ExecMemory, OfAnotherCardHasAFileOfItsOwn) {
  EXPECT_EQ(HostWithFile("second").out, "0\n");
  EXPECT_EQ(folder_.Read("m.mram.1"), "oncard-mram 1\n7 1\n");
  EXPECT_EQ(HostWithFile("close").out, "0\n");
}

TEST_F(ExecMemory, IsNamedByAScenarioRelativeToItsFolder) {
  ASSERT_EQ(mkdir((folder_.path() + "/sub").c_str(), 0700), 0);
  folder_.Write("sub/s.toml", "mram = \"kept.mram\"\n");
  EXPECT_EQ(Host("close", {"--scenario=sub/s.toml"}).out, "0\n");
  EXPECT_EQ(folder_.Read("sub/kept.mram"), "oncard-mram 1\n7 1\n");
  EXPECT_EQ(Host("close", {"--scenario=sub/s.toml"}).out, "1\n");
  // The variable comes first.
  EXPECT_EQ(Host("close", {"--scenario=sub/s.toml"}, "m.mram").out, "0\n");
  EXPECT_EQ(folder_.Read("sub/kept.mram"), "oncard-mram 1\n7 2\n");
}

TEST_F(ExecMemory, ABadFileIsNamedAndLeftAsItIs) {
  folder_.Write("m.mram", "oncard-mram 1\n7 40000\n");
  const ProcessResult result = HostWithFile("close");
  EXPECT_EQ(result.out, "GT_Open = -6\n");
  EXPECT_THAT(result.err, HasSubstr("m.mram:2: expected an address from 0 to 4095 and a value from "
                                    "-32768 to 32767"));
  EXPECT_EQ(folder_.Read("m.mram"), "oncard-mram 1\n7 40000\n");
}

TEST_F(ExecMemory, ThatCannotBeWrittenFailsTheHost) {
  const ProcessResult result = Host("close", {}, "nowhere/m.mram");
  EXPECT_EQ(result.out, "0\n");
  EXPECT_EQ(result.exit_code, 120);
  EXPECT_THAT(result.err, HasSubstr("oncard: card 0: "));
  EXPECT_THAT(result.err, HasSubstr("nowhere/m.mram"));
}

TEST_F(ExecMemory, OfARecordIsThatAtItsBeginning) {
  ASSERT_EQ(HostWithFile("close").exit_code, 0);
  ASSERT_EQ(Host("close", {"--record=host.calls"}, "m.mram").out, "1\n");
  ASSERT_EQ(HostWithFile("close").out, "2\n");
  const ProcessResult replay = RunOncard({"replay", "host.calls"}, folder_.path());
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  const std::string record = folder_.Read("host.calls");
  EXPECT_THAT(record, HasSubstr(R"("mram":"oncard-mram 1\n7 1\n")"));
  std::string damaged = record;
  damaged.replace(damaged.find("7 1\\n"), 3, "7 x");
  folder_.Write("host.calls", damaged);
  EXPECT_THAT(RunOncard({"replay", "host.calls"}, folder_.path()).err,
              HasSubstr("host.calls:2: this is no line of a record of host calls"));
}

}  // namespace
}  // namespace oncard::tools
