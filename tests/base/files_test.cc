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

TEST_F(FilesTest, KnowsFoldersFromFiles) {
  ASSERT_TRUE(WriteFileAtomically(Path("f"), "content").ok());
  EXPECT_TRUE(IsFolder(folder_.string()));
  EXPECT_FALSE(IsFolder(Path("f")));
  EXPECT_FALSE(IsFolder(Path("missing")));
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

TEST_F(FilesTest, TellsAMissingFileByItsCode) {
  EXPECT_EQ(ReadFile(Path("missing")).error().code, kNoSuchFile);
  EXPECT_NE(ReadFile(folder_.string()).error().code, kNoSuchFile);
}

TEST_F(FilesTest, ReadsAsManyBytesAsTheKindAllows) {
  constexpr FileKind kKind = {"a note", "便条", 100'000};
  ASSERT_TRUE(WriteFileAtomically(Path("f"), std::string(100'000, 'x')).ok());
  EXPECT_EQ(ReadFile(Path("f"), kKind).value().size(), 100'000u);
  ASSERT_TRUE(WriteFileAtomically(Path("f"), std::string(100'001, 'x')).ok());
  EXPECT_EQ(
      ReadFile(Path("f"), kKind).error().message.en,
      "cannot read '" + Path("f") + "': it has 100001 bytes or more; a note has at most 100000");
}

// The size is reported as 0 until the file is read, as it may be while another process writes it.
TEST_F(FilesTest, CountsTheBytesOfAFileThatGrowsWhileItIsRead) {
  constexpr FileKind kKind = {"a note", "便条", 10};
  EXPECT_NE(ReadFile("/proc/self/maps", kKind).error().message.en.find("at most 10"),
            std::string::npos);
}

TEST_F(FilesTest, ReadsNeitherDevicesNorPipes) {
  ASSERT_EQ(::mkfifo(Path("pipe").c_str(), 0600), 0);
  for (const std::string& path :
       {std::string("/dev/zero"), std::string("/dev/null"), Path("pipe")}) {
    const auto result = ReadFile(path);
    ASSERT_FALSE(result.ok()) << path;
    EXPECT_NE(result.error().message.en.find("not a regular file"), std::string::npos);
    EXPECT_NE(result.error().message.zh.find("不是普通文件"), std::string::npos);
  }
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

TEST_F(FilesTest, AFileOrFolderExistsOrNot) {
  ASSERT_TRUE(WriteFileAtomically(Path("f"), "x").ok());
  EXPECT_TRUE(FileExists(Path("f")));
  EXPECT_TRUE(FileExists(folder_.string()));
  EXPECT_FALSE(FileExists(Path("g")));
}

TEST_F(FilesTest, NamesAFileAsSeenFromAFolder) {
  EXPECT_EQ(NameFromFolder(Path("a/f.c"), Path("b")), "../a/f.c");
  EXPECT_EQ(NameFromFolder(Path("f.c"), folder_.string()), "f.c");
  // A relative name is relative to the current folder.
  EXPECT_EQ(NameFromFolder("f.c", std::filesystem::current_path().string()), "f.c");
}

}  // namespace
}  // namespace oncard
