// Writing: what it does not change, what it leaves behind, and several writers at the same time.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <thread>
#include <vector>

#include "base/files.h"

namespace oncard {
namespace {

class FileWriterTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "oncard_writer_XXXXXX";
    folder_ = ::mkdtemp(pattern.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  static mode_t ModeOf(const std::string& path) {
    struct stat info = {};
    ::stat(path.c_str(), &info);
    return info.st_mode & 07777;
  }

  std::filesystem::path folder_;
};

using Strings = std::vector<std::string>;

TEST_F(FileWriterTest, KeepsTheModeOfAnOldFile) {
  for (const mode_t mode : {0600u, 0640u, 0755u}) {
    ASSERT_TRUE(WriteFileAtomically(Path("f"), "old").ok());
    ASSERT_EQ(::chmod(Path("f").c_str(), mode), 0);
    ASSERT_TRUE(WriteFileAtomically(Path("f"), "new").ok());
    EXPECT_EQ(ModeOf(Path("f")), mode);
    EXPECT_EQ(ReadFile(Path("f")).value(), "new");
  }
}

TEST_F(FileWriterTest, MakesNewFilesAsTheCreationMaskSays) {
  const mode_t mask = ::umask(027);
  const bool written = WriteFileAtomically(Path("f"), "new").ok();
  ::umask(mask);
  ASSERT_TRUE(written);
  EXPECT_EQ(ModeOf(Path("f")), 0640u);
}

TEST_F(FileWriterTest, FollowsALinkAndKeepsIt) {
  std::filesystem::create_directory(folder_ / "other");
  ASSERT_TRUE(WriteFileAtomically(Path("other/f"), "old").ok());
  for (const char* target : {"other/f", "other/new"}) {
    std::filesystem::remove(folder_ / "link");
    std::filesystem::create_symlink(target, folder_ / "link");
    ASSERT_TRUE(WriteFileAtomically(Path("link"), "through").ok()) << target;
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link")) << target;
    EXPECT_EQ(ReadFile(Path(target)).value(), "through");
  }
}

TEST_F(FileWriterTest, LeavesNoEmptyTargetOfALinkThatCannotBeWritten) {
  std::filesystem::create_symlink("no_folder/f", folder_ / "link");
  EXPECT_FALSE(WriteFileAtomically(Path("link"), "x").ok());
  EXPECT_EQ(Names(), Strings{"link"});
}

TEST_F(FileWriterTest, WritesToAPipeWithoutReplacingIt) {
  ASSERT_EQ(::mkfifo(Path("pipe").c_str(), 0600), 0);
  std::string received;
  std::thread reader([&received, path = Path("pipe")] {
    const int pipe = ::open(path.c_str(), O_RDONLY);
    char buffer[64];
    for (ssize_t count = 0; (count = ::read(pipe, buffer, sizeof buffer)) > 0;) {
      received.append(buffer, static_cast<size_t>(count));
    }
    ::close(pipe);
  });
  EXPECT_TRUE(WriteFileAtomically(Path("pipe"), "text").ok());
  reader.join();
  EXPECT_EQ(received, "text");
  EXPECT_TRUE(std::filesystem::is_fifo(folder_ / "pipe"));
}

TEST_F(FileWriterTest, WritesToADeviceWithoutReplacingIt) {
  EXPECT_TRUE(WriteFileAtomically("/dev/null", "text").ok());
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  const auto full = WriteFileAtomically("/dev/full", "text");
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().message.en, "cannot write '/dev/full': No space left on device");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(FileWriterTest, WritesContentThatIsMadeInPieces) {
  const TextSource pieces = [](const TextSink& sink) {
    for (const char* piece : {"a", "", "bc"}) sink(piece);
  };
  ASSERT_TRUE(WriteFileAtomically(Path("f"), pieces).ok());
  EXPECT_EQ(ReadFile(Path("f")).value(), "abc");
}

// The first piece fits, the second one does not.
TEST_F(FileWriterTest, LeavesTheOldFileWhenOnePieceCannotBeWritten) {
  ASSERT_TRUE(WriteFileAtomically(Path("f"), "old").ok());
  rlimit before = {};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small = {1000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  int made = 0;
  const auto written = WriteFileAtomically(Path("f"), [&made](const TextSink& sink) {
    for (; made < 3; ++made) sink(std::string(600, 'x'));
  });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().message.en, "cannot write '" + Path("f") + "': File too large");
  EXPECT_EQ(made, 3);
  EXPECT_EQ(ReadFile(Path("f")).value(), "old");
  EXPECT_EQ(Names(), Strings{"f"});
}

TEST_F(FileWriterTest, SaysWhyADeviceDoesNotTakeOnePiece) {
  const auto full = WriteFileAtomically("/dev/full", [](const TextSink& sink) {
    for (const char* piece : {"", "text", "more"}) sink(piece);
  });
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().message.en, "cannot write '/dev/full': No space left on device");
}

TEST_F(FileWriterTest, LeavesAReadOnlyFileAlone) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  ASSERT_TRUE(WriteFileAtomically(Path("f"), "old").ok());
  ASSERT_EQ(::chmod(Path("f").c_str(), 0444), 0);
  EXPECT_FALSE(WriteFileAtomically(Path("f"), "new").ok());
  EXPECT_EQ(ReadFile(Path("f")).value(), "old");
}

TEST_F(FileWriterTest, TakesNamesAsLongAsTheFileSystemDoes) {
  const std::string name(255, 'n');
  EXPECT_TRUE(WriteFileAtomically(Path(name), "x").ok());
  EXPECT_EQ(Names(), Strings{name});
}

TEST_F(FileWriterTest, RemovesTemporaryFilesOfKilledWritersOnly) {
  const std::string dead = ".oncard-00000000000000aa.tmp";
  const std::string alive = ".oncard-00000000000000bb.tmp";
  const std::string foreign = ".oncard-notes";
  for (const std::string& name : {dead, alive, foreign}) {
    ::close(::open(Path(name).c_str(), O_WRONLY | O_CREAT, 0600));
  }
  const int writer = ::open(Path(alive).c_str(), O_WRONLY);
  ASSERT_EQ(::flock(writer, LOCK_EX), 0);
  ASSERT_TRUE(WriteFileAtomically(Path("f"), "x").ok());
  EXPECT_EQ(Names(), (Strings{alive, foreign, "f"}));
  ::close(writer);
}

TEST_F(FileWriterTest, RemovesOnlyNamesThatAWriterGives) {
  const Strings foreign = {".oncard-.tmp",
                           ".oncard-00000000000000AA.tmp",
                           ".oncard-00000000000000aa0.tmp",
                           ".oncard-000000000000aa.tmp",
                           ".oncard-my-own-notes-of2.tmp",
                           ".oncard-tmp"};
  for (const std::string& name : foreign) {
    ::close(::open(Path(name).c_str(), O_WRONLY | O_CREAT, 0600));
  }
  ASSERT_TRUE(WriteFileAtomically(Path("f"), "x").ok());
  for (const std::string& name : foreign) EXPECT_TRUE(std::filesystem::exists(Path(name))) << name;
}

TEST_F(FileWriterTest, FollowsNoLinkInPlaceOfATemporaryFile) {
  ASSERT_TRUE(WriteFileAtomically(Path("victim"), "kept").ok());
  std::filesystem::create_symlink("victim", folder_ / ".oncard-00000000000000aa.tmp");
  ASSERT_TRUE(WriteFileAtomically(Path("f"), "x").ok());
  EXPECT_EQ(ReadFile(Path("victim")).value(), "kept");
}

// Each child is ended by SIGTERM at some point while it writes.
TEST_F(FileWriterTest, LeavesNothingBehindWhenItIsTerminated) {
  const std::string content(1 << 20, 'x');
  for (int round = 0; round < 20; ++round) {
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      for (int i = 0;; ++i) {
        static_cast<void>(WriteFileAtomically(Path("f"), content));
        if (i == round % 4) static_cast<void>(::write(ready[1], "x", 1));
      }
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    ::kill(child, SIGTERM);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(WTERMSIG(status), SIGTERM);
    ::close(ready[0]);
    ::close(ready[1]);
    ASSERT_EQ(Names(), Strings{"f"});
    EXPECT_EQ(ReadFile(Path("f")).value(), content);
  }
}

// Children are killed at some point while they write pairs that contain the number of the round.
// Afterwards there must be a matching pair or none.
TEST_F(FileWriterTest, NeverMixesPairsWhenItIsKilled) {
  for (int round = 0; round < 20; ++round) {
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      for (int i = 0;; ++i) {
        const std::string text = std::to_string(round) + "." + std::to_string(i);
        static_cast<void>(WritePairAtomically(Path("p.bin"), text, Path("p.ini"), text));
        if (i == 3) static_cast<void>(::write(ready[1], "x", 1));
      }
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(ready[0]);
    ::close(ready[1]);
    const FilePair pair = ReadPair(Path("p.bin"), Path("p.ini"), kObjectKind);
    if (pair.first.ok() && pair.second.ok()) {
      EXPECT_EQ(pair.first.value(), pair.second.value());
    } else {
      EXPECT_FALSE(pair.second.ok()) << "the second is what is missing then";
    }
  }
  ASSERT_TRUE(WritePairAtomically(Path("p.bin"), "a", Path("p.ini"), "a").ok());
  EXPECT_EQ(Names(), (Strings{"p.bin", "p.ini"}));
}

TEST_F(FileWriterTest, LetsManyWriteOnePairAtOnce) {
  constexpr int kWriters = 8;
  constexpr int kWrites = 20;
  std::vector<int> written(kWriters);
  std::vector<std::thread> writers;
  for (int writer = 0; writer < kWriters; ++writer) {
    writers.emplace_back([this, writer, &written] {
      for (int i = 0; i < kWrites; ++i) {
        const std::string text = std::to_string(writer) + "." + std::to_string(i);
        const bool ok = WritePairAtomically(Path("p.bin"), text, Path("p.ini"), text).ok();
        const FilePair pair = ReadPair(Path("p.bin"), Path("p.ini"), kObjectKind);
        const bool whole =
            pair.first.ok() && pair.second.ok() && pair.first.value() == pair.second.value();
        written[static_cast<size_t>(writer)] += ok && whole ? 1 : 0;
      }
    });
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(written, std::vector<int>(kWriters, kWrites));
  EXPECT_EQ(Names(), (Strings{"p.bin", "p.ini"}));
}

TEST_F(FileWriterTest, PutsTheFirstOfAPairBackWhenTheSecondIsAFolder) {
  ASSERT_TRUE(WriteFileAtomically(Path("p.bin"), "old").ok());
  std::filesystem::create_directory(folder_ / "p.ini");
  EXPECT_FALSE(WritePairAtomically(Path("p.bin"), "new", Path("p.ini"), "new").ok());
  EXPECT_EQ(ReadFile(Path("p.bin")).value(), "old");
  EXPECT_EQ(Names(), (Strings{"p.bin", "p.ini"}));
}

}  // namespace
}  // namespace oncard
