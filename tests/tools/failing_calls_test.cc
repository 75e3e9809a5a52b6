// Files are written while any system call fails or memory runs out at any point: the old files
// remain, or the new ones exist; success means the new ones; and nothing else remains in the
// folder.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

constexpr const char* kOld = "int v;\nint t0() { v = 1; return v; }\n";
constexpr const char* kNew = "int v, w;\nint t0() { v = 2; w = 3; return w; }\n";
constexpr int kMostRuns = 400;

ProcessResult RunFailing(const std::vector<std::string>& arguments, const std::string& folder,
                         const std::string& call, int at) {
  return RunOncard(
      arguments, folder,
      {"LD_PRELOAD=" ONCARD_FAILING_CALLS, fmt::format("ONCARD_FAIL={}:{}", call, at)});
}

size_t FileCount(const std::string& folder) {
  const std::filesystem::directory_iterator entries(folder);
  return static_cast<size_t>(std::distance(begin(entries), end(entries)));
}

class FailingCallTest : public testing::TestWithParam<const char*> {};

TEST_P(FailingCallTest, LeavesOnePairOfObjectFiles) {
  const ScratchFolder folder;
  folder.Write("p.c", kNew);
  ASSERT_EQ(RunOncard({"build", "p.c"}, folder.path()).exit_code, 0);
  const std::string new_pair = folder.Read("p.bin") + folder.Read("p.ini");
  folder.Write("p.c", kOld);
  ASSERT_EQ(RunOncard({"build", "p.c"}, folder.path()).exit_code, 0);
  const std::string old_bin = folder.Read("p.bin");
  const std::string old_ini = folder.Read("p.ini");
  folder.Write("p.c", kNew);
  int at = 1;
  for (int runs = 0;; ++runs) {
    ASSERT_LT(runs, kMostRuns);
    folder.Write("p.bin", old_bin);
    folder.Write("p.ini", old_ini);
    const ProcessResult result = RunFailing({"build", "p.c"}, folder.path(), GetParam(), at);
    const std::string pair = folder.Read("p.bin") + folder.Read("p.ini");
    EXPECT_EQ(FileCount(folder.path()), 3u) << GetParam() << ':' << at;
    if (result.exit_code == 0) {
      EXPECT_EQ(pair, new_pair) << GetParam() << ':' << at;
    } else {
      EXPECT_TRUE(pair == old_bin + old_ini || pair == new_pair) << GetParam() << ':' << at;
    }
    if (result.err.find("injected") == std::string::npos) {
      EXPECT_EQ(result.exit_code, 0) << result.err;
      EXPECT_GT(at, 1) << "the call was not made at all";
      break;
    }
    // There are many allocations; the first ones are tested one by one, then ever fewer of them.
    at += 1 + at / 16;
  }
}

TEST_P(FailingCallTest, LeavesOneSchedule) {
  const ScratchFolder folder;
  folder.Write("p.c", kNew);
  const std::vector<std::string> arguments = {"run", "p.c", "--record", "p.schedule"};
  ASSERT_EQ(RunOncard(arguments, folder.path()).exit_code, 0);
  const std::string new_text = folder.Read("p.schedule");
  int at = 1;
  for (int runs = 0;; ++runs) {
    ASSERT_LT(runs, kMostRuns);
    folder.Write("p.schedule", "old");
    const ProcessResult result = RunFailing(arguments, folder.path(), GetParam(), at);
    const std::string text = folder.Read("p.schedule");
    EXPECT_EQ(FileCount(folder.path()), 2u) << GetParam() << ':' << at;
    EXPECT_TRUE(text == new_text || (text == "old" && result.exit_code != 0))
        << GetParam() << ':' << at;
    if (result.err.find("injected") == std::string::npos) break;
    at += 1 + at / 16;
  }
}

INSTANTIATE_TEST_SUITE_P(Calls, FailingCallTest,
                         testing::Values("open", "write", "short_write", "fsync", "fchmod", "flock",
                                         "rename", "malloc"),
                         [](const auto& row) { return std::string(row.param); });

}  // namespace
}  // namespace oncard::tools
