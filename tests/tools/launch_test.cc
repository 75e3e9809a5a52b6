// The templates that explore in parts (tools/launch): each gives the counts of a search that is not
// split.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using testing::HasSubstr;

const std::string kTemplates = ONCARD_SOURCE_DIR "/tools/launch/";

/// Three threads that each increment `x`: 36 traces, 30 of which lose an update.
constexpr const char* kIncrements =
    "int x;\n//@ final: x == 3\n"
    "int t0() {\n  int t;\n  t = x;\n  t = t + 1;\n  x = t;\n  return 0;\n}\n"
    "int t1() {\n  int t;\n  t = x;\n  t = t + 1;\n  x = t;\n  return 0;\n}\n"
    "int t2() {\n  int t;\n  t = x;\n  t = t + 1;\n  x = t;\n  return 0;\n}\n";

/// Runs it with the oncard of this build in PATH.
ProcessResult RunTemplate(const std::vector<std::string>& words, const ScratchFolder& scratch,
                          const std::vector<std::string>& variables = {}) {
  std::vector<std::string> command = {"env", "PATH=" ONCARD_BUILD_DIR "/bin:/usr/bin:/bin"};
  command.insert(command.end(), variables.begin(), variables.end());
  command.insert(command.end(), words.begin(), words.end());
  return RunProgram(command, scratch.path());
}

bool Installed(const std::string& program) {
  return RunProgram({"sh", "-c", "command -v " + program}).exit_code == 0;
}

void ExpectWholeSearch(const ScratchFolder& scratch) {
  const ProcessResult merged = RunProgram(
      {"sh", "-c", ONCARD_BUILD_DIR "/bin/oncard explore --format=json --merge *.search"},
      scratch.path());
  const auto json = nlohmann::json::parse(merged.out);
  EXPECT_EQ(json["verdict"], "FAILED");
  EXPECT_EQ(json["traces"], 36);
  EXPECT_EQ(json["bad_traces"], 30);
}

TEST(LaunchTest, LocalProcesses) {
  const ScratchFolder scratch;
  scratch.Write("inc.c", kIncrements);
  const ProcessResult result =
      RunTemplate({kTemplates + "explore_local.sh", "inc.c", "3"}, scratch);
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(result.out, HasSubstr("dpor: 36 executions"));
  ExpectWholeSearch(scratch);
}

TEST(LaunchTest, LocalProcessesPassOptionsOn) {
  const ScratchFolder scratch;
  scratch.Write("inc.c", kIncrements);
  const ProcessResult result = RunTemplate(
      {kTemplates + "explore_local.sh", "inc.c", "2", "--engine", "random", "--runs", "100"},
      scratch);
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(result.out, HasSubstr("random: 100 runs"));
}

/// A card, and a choice of four values.
void WriteCard(const ScratchFolder& scratch) {
  scratch.Write("card.c",
                "int g, x;\n//@ input: x = 1..4\n//@ final: g == 2 * x\n"
                "int t0() {\n  GT_AxisOn(1);\n  g = g + x;\n  return 0;\n}\n"
                "int t1() {\n  g = g + x;\n  return 0;\n}\n");
}

void ExpectWholeCardSearch(const ScratchFolder& scratch, const std::string& merged) {
  const auto whole =
      RunProgram({ONCARD_BUILD_DIR "/bin/oncard", "explore", "card.c"}, scratch.path());
  EXPECT_EQ(whole.exit_code, 0);
  EXPECT_EQ(merged, whole.out);
}

TEST(LaunchTest, LocalProcessesForACardWithChoices) {
  const ScratchFolder scratch;
  WriteCard(scratch);
  const ProcessResult result =
      RunTemplate({kTemplates + "explore_local.sh", "card.c", "3"}, scratch);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  ExpectWholeCardSearch(scratch, result.out);
}

TEST(LaunchTest, TasksOfASlurmJobArrayForACardWithChoices) {
  const ScratchFolder scratch;
  WriteCard(scratch);
  for (const char* task : {"1", "2", "3"}) {
    const ProcessResult result =
        RunTemplate({"sh", kTemplates + "explore_slurm.sh", "card.c"}, scratch,
                    {std::string("SLURM_ARRAY_TASK_ID=") + task, "SLURM_ARRAY_TASK_MAX=3"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  const ProcessResult merged = RunProgram(
      {"sh", "-c", ONCARD_BUILD_DIR "/bin/oncard explore --merge *.search"}, scratch.path());
  ExpectWholeCardSearch(scratch, merged.out);
}

TEST(LaunchTest, GnuParallel) {
  if (!Installed("parallel")) GTEST_SKIP() << "the package parallel is not installed";
  const ScratchFolder scratch;
  scratch.Write("inc.c", kIncrements);
  const ProcessResult result =
      RunTemplate({kTemplates + "explore_parallel.sh", "inc.c", "3"}, scratch);
  EXPECT_EQ(result.exit_code, 1) << result.err;
  ExpectWholeSearch(scratch);
}

// Runs the tasks of a job array, with the variables that Slurm sets.
TEST(LaunchTest, TasksOfASlurmJobArray) {
  const ScratchFolder scratch;
  scratch.Write("inc.c", kIncrements);
  for (const char* task : {"1", "2", "3"}) {
    const ProcessResult result =
        RunTemplate({"sh", kTemplates + "explore_slurm.sh", "inc.c"}, scratch,
                    {std::string("SLURM_ARRAY_TASK_ID=") + task, "SLURM_ARRAY_TASK_MAX=3"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  ExpectWholeSearch(scratch);
}

TEST(LaunchTest, SlurmJobArray) {
  if (!Installed("sbatch") || RunProgram({"sinfo"}).exit_code != 0) {
    GTEST_SKIP() << "the package slurm-wlm is not installed, or no controller runs";
  }
  const ScratchFolder scratch;
  scratch.Write("inc.c", kIncrements);
  const ProcessResult result = RunTemplate(
      {"sbatch", "--wait", "--array=1-3", kTemplates + "explore_slurm.sh", "inc.c"}, scratch);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  ExpectWholeSearch(scratch);
}

}  // namespace
}  // namespace oncard::tools
