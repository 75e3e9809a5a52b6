// Files are written while any system call fails or memory runs out at any point: the old files
// remain, or the new ones exist; success means the new ones; and nothing else remains in the
// folder.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

constexpr const char* kOld = "int v;\nint t0() { v = 1; return v; }\n";
constexpr const char* kNew = "int v, w;\nint t0() { v = 2; w = 3; return w; }\n";

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

/// Tests every call of a kind that there may be: the first ones one by one, then ever fewer of
/// them, because there are many allocations, and the last ones, while the files are written, one by
/// one. `test` lets a call fail and returns false if there is no such call.
void TestCalls(const std::function<bool(int at)>& test) {
  int last = 0;
  int beyond = 1;
  for (; test(beyond); beyond += 1 + beyond / 16) last = beyond;
  EXPECT_GT(last, 0) << "the call was not made at all";
  while (beyond - last > 1) {
    const int middle = (last + beyond) / 2;
    (test(middle) ? last : beyond) = middle;
  }
  constexpr int kLastOnes = 100;
  for (int at = std::max(1, last - kLastOnes); at < last; ++at) test(at);
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
  TestCalls([&](int at) {
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
    const bool failed = result.err.find("injected") != std::string::npos;
    EXPECT_TRUE(failed || result.exit_code == 0) << result.err;
    return failed;
  });
}

TEST_P(FailingCallTest, LeavesNoHalfOfANewPair) {
  if (GetParam() == std::string("fchmod")) GTEST_SKIP() << "a new file takes over no mode";
  const ScratchFolder folder;
  folder.Write("p.c", kNew);
  TestCalls([&](int at) {
    std::filesystem::remove(folder.path() + "/p.bin");
    std::filesystem::remove(folder.path() + "/p.ini");
    const ProcessResult result = RunFailing({"build", "p.c"}, folder.path(), GetParam(), at);
    EXPECT_EQ(FileCount(folder.path()), result.exit_code == 0 ? 3u : 1u) << GetParam() << ':' << at;
    return result.err.find("injected") != std::string::npos;
  });
}

TEST_P(FailingCallTest, LeavesOneSchedule) {
  const ScratchFolder folder;
  folder.Write("p.c", kNew);
  const std::vector<std::string> arguments = {"run", "p.c", "--record", "p.schedule"};
  ASSERT_EQ(RunOncard(arguments, folder.path()).exit_code, 0);
  const std::string new_text = folder.Read("p.schedule");
  TestCalls([&](int at) {
    folder.Write("p.schedule", "old");
    const ProcessResult result = RunFailing(arguments, folder.path(), GetParam(), at);
    const std::string text = folder.Read("p.schedule");
    EXPECT_EQ(FileCount(folder.path()), 2u) << GetParam() << ':' << at;
    EXPECT_TRUE(text == new_text || (text == "old" && result.exit_code != 0))
        << GetParam() << ':' << at;
    return result.err.find("injected") != std::string::npos;
  });
}

INSTANTIATE_TEST_SUITE_P(Calls, FailingCallTest,
                         testing::Values("open", "write", "short_write", "fsync", "fchmod", "flock",
                                         "rename", "malloc"),
                         [](const auto& row) { return std::string(row.param); });

}  // namespace
}  // namespace oncard::tools
