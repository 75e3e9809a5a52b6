#include "tools/memory_use.h"

#include <gtest/gtest.h>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

constexpr int64_t kMiB = 1024 * 1024;

TEST(MemoryUse, OfThisProcessIsMoreThanItHolds) {
  const std::vector<char> held(32 * kMiB, 'x');
  EXPECT_GT(MemoryInUse(), 32 * kMiB);
  EXPECT_LT(MemoryInUse(), int64_t{1} << 40) << held.size();
}

class MemoryLeftTest : public testing::Test {
 protected:
  std::optional<int64_t> Left() const { return MemoryLeft(folder_.path()); }

  const ScratchFolder folder_;
};

TEST_F(MemoryLeftTest, IsUnknownWithoutTheFiles) { EXPECT_EQ(Left(), std::nullopt); }

TEST_F(MemoryLeftTest, IsWhatTheComputerHas) {
  folder_.Write("proc/meminfo", "MemTotal: 4096 kB\nMemFree: 100 kB\nMemAvailable: 2048 kB\n");
  EXPECT_EQ(Left(), 2 * kMiB);
  folder_.Write("sys/fs/cgroup/memory.max", "max\n");
  folder_.Write("sys/fs/cgroup/memory.current", "500000\n");
  EXPECT_EQ(Left(), 2 * kMiB);
}

TEST_F(MemoryLeftTest, IsNoMoreThanTheContainerHas) {
  folder_.Write("proc/meminfo", "MemAvailable: 2048 kB\n");
  folder_.Write("sys/fs/cgroup/memory.max", "1000000\n");
  folder_.Write("sys/fs/cgroup/memory.current", "900000\n");
  EXPECT_EQ(Left(), 100'000);
  // Files that are kept in memory give way.
  folder_.Write("sys/fs/cgroup/memory.stat", "anon 50000\ninactive_file 200000\n");
  EXPECT_EQ(Left(), 300'000);
  folder_.Write("sys/fs/cgroup/memory.current", "2000000\n");
  EXPECT_EQ(Left(), 0);
}

}  // namespace
}  // namespace oncard::tools
