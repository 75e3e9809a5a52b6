// Hosts in C# under Mono: what they call, how long they wait and what their structures look like.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

// The interface with a `long` of 32 bits.
#include "LookAheadEx.h"
#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;

const std::string kHosts = ONCARD_SOURCE_DIR "/tests/dotnet/";
const std::string kInclude = ONCARD_BUILD_DIR "/include/";
const std::string kScenario = kSamples + "/18_lines/lines.host.toml";

class DotnetTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* const tool : {"mcs", "mono"}) {
      if (RunProgram({"sh", "-c", std::string("command -v ") + tool}).exit_code != 0) {
        GTEST_SKIP() << tool << " is missing: install mono-mcs and mono-runtime";
      }
    }
  }

  /// Compiles a host of this folder with declarations to `name`.exe.
  void Compile(const std::string& name, const std::string& host, const std::string& declarations) {
    const ProcessResult built =
        RunProgram({"mcs", "-warnaserror", "-out:" + folder_.path() + "/" + name + ".exe",
                    kHosts + host, declarations});
    ASSERT_EQ(built.exit_code, 0) << built.out << built.err;
  }

  /// Runs it in the folder of the test, with options of `oncard exec` before it.
  ProcessResult Exec(const std::string& name, std::vector<std::string> options = {},
                     const std::vector<std::string>& environment = {}) const {
    options.insert(options.begin(), "exec");
    options.insert(options.end(), {"--", "mono", name + ".exe"});
    return RunOncard(options, folder_.path(), environment);
  }

  ScratchFolder folder_;
};

// --- Motion --------------------------------------------------------------------------------------

/// The call log of a host, and the record of its calls, which ends with the state of the card.
struct Traces {
  std::string log;
  std::string record;
};

/// Runs a host of samples/18_lines with the card's virtual clock alone: under oncard exec Mono
/// spends time by looking at the clock while it compiles.
Traces RunLines(const std::vector<std::string>& host, const ScratchFolder& folder) {
  const ProcessResult result = RunProgram(
      host, folder.path(),
      {"LD_LIBRARY_PATH=" ONCARD_BUILD_DIR "/lib", "ONCARD_CLOCK=virtual",
       "ONCARD_SCENARIO=" + kScenario, "ONCARD_LOG=calls:log.txt", "ONCARD_RECORD=host.calls"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return {folder.Read("log.txt"), folder.Read("host.calls")};
}

TEST_F(DotnetTest, AHostMovesAPathAsItsSampleInCDoes) {
  const Traces in_c = RunLines({ONCARD_BUILD_DIR "/samples/sample_18_lines"}, folder_);
  ASSERT_THAT(in_c.log.substr(0, 1000),
              HasSubstr("GT_LnXY(1, 100000, 173205, 100, 0.1, 0, 0) = 0"));
  for (const std::string& declarations : {kHosts + "declarations.cs", kInclude + "Gts.cs"}) {
    SCOPED_TRACE(declarations);
    Compile("lines", "lines.cs", declarations);
    const Traces in_csharp = RunLines({"mono", "lines.exe"}, folder_);
    // Too long for a comparison that shows the differences.
    EXPECT_TRUE(in_csharp.log == in_c.log);
    EXPECT_TRUE(in_csharp.record == in_c.record);
  }
  EXPECT_THAT(RunOncard({"replay", "host.calls"}, folder_.path()).out, HasSubstr("hash"));
}

TEST_F(DotnetTest, AHostMeetsAScenarioInVirtualTime) {
  Compile("lines", "lines.cs", kHosts + "declarations.cs");
  const ProcessResult result = Exec("lines", {"--scenario", kScenario});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
}

TEST_F(DotnetTest, TheLibraryOfWindowsBesideTheProgramDoesNotMatter) {
  Compile("lines", "lines.cs", kInclude + "Gts.cs");
  folder_.Write("gts.dll", "MZ, as a program for Windows begins");
  EXPECT_EQ(Exec("lines", {"--scenario", kScenario}).exit_code, 0);
}

TEST_F(DotnetTest, AHostMovesTwoCards) {
  Compile("cards", "cards.cs", kInclude + "GtsMulti.cs");
  const ProcessResult result = Exec("cards");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "100000 -60000\n1 3 -5\n");
}

// --- Time ----------------------------------------------------------------------------------------

TEST_F(DotnetTest, WaitsTakeVirtualTime) {
  Compile("times", "times.cs", kInclude + "Gts.cs");
  const ProcessResult result = Exec("times");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out,
            "010260101010260101\n"
            "Sleep 60000\n"
            "WaitOne 3000\n"
            "Set 700\n"
            "Monitor 250\n"
            "Timer 1500\n"
            "Stopwatch 6545\n"
            "2026-01-01 00:01\n");
}

// --- Structures ----------------------------------------------------------------------------------

TEST_F(DotnetTest, StructuresHaveTheSizesOfTheHeaderWithALongOf32Bits) {
  static_assert(sizeof(TCrdPrm::originPos) == 32);
  Compile("sizes", "sizes.cs", kInclude + "GtsMulti.cs");
  const ProcessResult result = Exec("sizes");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::string expected;
#define STRUCTURE(name, ...) expected += #name " " + std::to_string(sizeof(::name)) + "\n";
#include "gtcalls/gts/structures.def"
  EXPECT_EQ(result.out, expected);
}

}  // namespace
}  // namespace oncard::tools
