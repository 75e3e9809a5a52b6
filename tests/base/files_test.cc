#include "base/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

namespace oncard {
namespace {

class FilesTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::path(testing::TempDir()) / ("oncard_files_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  size_t FileCount() const {
    size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_)) ++count;
    return count;
  }

  std::filesystem::path folder_;
};

TEST_F(FilesTest, WritesAndReadsBytesUnchanged) {
  const std::string bytes("a\0b\r\n\xff", 6);
  ASSERT_TRUE(WriteFileAtomically(Path("f"), bytes).ok());
  EXPECT_EQ(ReadFile(Path("f")).value(), bytes);
  EXPECT_EQ(FileCount(), 1u);
}

TEST_F(FilesTest, ReplacesAnExistingFile) {
  ASSERT_TRUE(WriteFileAtomically(Path("f"), "old").ok());
  ASSERT_TRUE(WriteFileAtomically(Path("f"), "new").ok());
  EXPECT_EQ(ReadFile(Path("f")).value(), "new");
}

TEST_F(FilesTest, SaysWhichFileIsMissing) {
  const auto result = ReadFile(Path("missing"));
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.en.find("missing"), std::string::npos);
  EXPECT_NE(result.error().message.zh.find("无法打开"), std::string::npos);
}

TEST_F(FilesTest, RefusesToReadAFolder) { EXPECT_FALSE(ReadFile(folder_.string()).ok()); }

TEST_F(FilesTest, LeavesNothingBehindWhenTheTargetIsAFolder) {
  std::filesystem::create_directories(folder_ / "target");
  EXPECT_FALSE(WriteFileAtomically(Path("target"), "x").ok());
  EXPECT_EQ(FileCount(), 1u);
}

TEST_F(FilesTest, WritesNeitherOfAPairWhenTheSecondCannotBeWritten) {
  ASSERT_TRUE(WriteFileAtomically(Path("x.bin"), "old").ok());
  EXPECT_FALSE(WritePairAtomically(Path("x.bin"), "new", Path("no_folder/x.ini"), "new").ok());
  EXPECT_EQ(ReadFile(Path("x.bin")).value(), "old");
  EXPECT_EQ(FileCount(), 1u);
}

TEST_F(FilesTest, WritesBothOfAPair) {
  ASSERT_TRUE(WritePairAtomically(Path("x.bin"), "1", Path("x.ini"), "2").ok());
  EXPECT_EQ(ReadFile(Path("x.bin")).value(), "1");
  EXPECT_EQ(ReadFile(Path("x.ini")).value(), "2");
}

}  // namespace
}  // namespace oncard
