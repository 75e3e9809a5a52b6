#include "runtime/host/mapped_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>

#include "base/descriptor.h"
#include "base/files.h"

namespace oncard::runtime {
namespace {

constexpr size_t kMegabyte = size_t{1} << 20;

class MappedFileTest : public testing::Test {
 protected:
  MappedFileTest() { std::remove(path_.c_str()); }
  ~MappedFileTest() override { std::remove(path_.c_str()); }

  std::string Content() const { return ReadFile(path_).value(); }
  /// What was appended to the file, without the zero bytes.
  std::string Appended() const {
    const std::string content = Content();
    return content.substr(0, content.find_last_not_of('\0') + 1);
  }

  const std::string path_ = testing::TempDir() + "oncard_mapped_file_test";
};

/// How a child process that does this ends.
int StatusOf(const std::function<void()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  int status = -1;
  return ::waitpid(child, &status, 0) == child ? status : -1;
}

std::string Lines(int count) {
  std::string lines;
  for (int line = 0; line < count; ++line) lines += "line " + std::to_string(line) + '\n';
  return lines;
}

void AppendLines(int count, MappedFile* file) {
  for (int line = 0; line < count; ++line) {
    if (!file->Append("line " + std::to_string(line) + '\n')) ::_exit(1);
  }
}

TEST_F(MappedFileTest, HasWhatWasAppendedAndNothingElse) {
  ASSERT_TRUE(WriteFileAtomically(path_, std::string(3 * kMegabyte, 'x')).ok());
  for (int run = 0; run < 2; ++run) {  // the second replaces the file of the first
    MappedFile file;
    ASSERT_TRUE(file.Open(path_));
    EXPECT_TRUE(file.Append("one\n"));
    EXPECT_TRUE(file.Append(""));
    EXPECT_TRUE(file.Append("two\n"));
    EXPECT_EQ(Appended(), "one\ntwo\n") << "at once";
    file.Finish();
    EXPECT_EQ(Content(), "one\ntwo\n");
  }
}

TEST_F(MappedFileTest, GrowsOverTheEndOfWhatIsMapped) {
  std::string all;
  MappedFile file;
  ASSERT_TRUE(file.Open(path_));
  // Also by more than is mapped at a time, and to the very end of it.
  for (const size_t size : {kMegabyte - 10, size_t{20}, 3 * kMegabyte - 10, size_t{1}, size_t{7}}) {
    all.append(size - 1, static_cast<char>('a' + size % 26)) += '\n';
    EXPECT_TRUE(file.Append(std::string_view(all).substr(all.size() - size)));
  }
  file.Finish();
  EXPECT_EQ(Content(), all);
}

TEST_F(MappedFileTest, CanBeAppendedToAfterItsEnd) {
  MappedFile file;
  ASSERT_TRUE(file.Open(path_));
  EXPECT_TRUE(file.Append("one\n"));
  file.Finish();
  EXPECT_TRUE(file.Append("two\n"));
  file.Finish();
  EXPECT_EQ(Content(), "one\ntwo\n");
}

TEST_F(MappedFileTest, KeepsWhatAKilledProcessHasAppended) {
  const int status = StatusOf([this] {
    MappedFile file;
    if (!file.Open(path_)) return;
    AppendLines(200'000, &file);
    ::raise(SIGKILL);
  });
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(Appended(), Lines(200'000));
  EXPECT_EQ(Content().size() % kMegabyte, 0u) << "was not written through memory";
}

TEST_F(MappedFileTest, IsWrittenWhereItCannotBeMapped) {
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  const Descriptor reader(::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  MappedFile file;
  ASSERT_TRUE(file.Open(path_));
  EXPECT_TRUE(file.Append("one\n"));
  file.Finish();
  EXPECT_TRUE(file.Append("two\n"));
  char read[16];
  const ssize_t size = ::read(reader.get(), read, sizeof read);
  EXPECT_EQ(std::string_view(read, static_cast<size_t>(size)), "one\ntwo\n");
}

TEST_F(MappedFileTest, SaysWhatCannotBeWritten) {
  MappedFile file;
  EXPECT_FALSE(file.Open("/nowhere/file"));
  EXPECT_EQ(errno, ENOENT);
  EXPECT_FALSE(file.is_open());
  ASSERT_TRUE(file.Open("/dev/full"));
  EXPECT_FALSE(file.Append("one\n"));
}

TEST_F(MappedFileTest, GoesAsFarAsTheLimitOfTheProcess) {
  constexpr size_t kLimit = kMegabyte + kMegabyte / 2;
  const int status = StatusOf([this] {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit = {kLimit, kLimit};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    MappedFile file;
    const std::string half(kMegabyte / 2, 'x');
    bool good = file.Open(path_);
    for (int part = 0; part < 3; ++part) good = good && file.Append(half);
    if (!good || file.Append("y")) ::_exit(1);
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(Content(), std::string(kLimit, 'x'));
}

TEST_F(MappedFileTest, IsWrittenByOneProcessAtATime) {
  {
    MappedFile file;
    ASSERT_TRUE(file.Open(path_));
    ASSERT_TRUE(file.Append("one\n"));
    MappedFile other;
    EXPECT_FALSE(other.Open(path_));
    EXPECT_EQ(errno, EWOULDBLOCK);
    EXPECT_EQ(Appended(), "one\n");
  }
  MappedFile other;
  EXPECT_TRUE(other.Open(path_));
}

TEST_F(MappedFileTest, IsLeftToTheParentByAChild) {
  MappedFile file;
  ASSERT_TRUE(file.Open(path_));
  ASSERT_TRUE(file.Append("one\n"));
  const int status = StatusOf([&file] {
    file.Abandon();
    file.Finish();
    if (file.is_open()) ::_exit(1);
  });
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(file.Append("two\n"));
  EXPECT_EQ(Content().size(), kMegabyte);
  EXPECT_EQ(Appended(), "one\ntwo\n");
}

TEST_F(MappedFileTest, WritesIntoNoFileOfAHostThatHasClosedItsDescriptor) {
  const std::string of_host = path_ + "_of_host";
  MappedFile file;
  ASSERT_TRUE(file.Open(path_));
  ASSERT_TRUE(file.Append("one\n"));
  ::syscall(SYS_close_range, 700u, 1023u, 0u);
  const int low = ::open(of_host.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  const int high = ::fcntl(low, F_DUPFD_CLOEXEC, 768);
  EXPECT_TRUE(file.Append("two\n")) << "what is mapped needs no descriptor";
  EXPECT_FALSE(file.Append(std::string(kMegabyte, 'x')));
  EXPECT_EQ(Appended(), "one\ntwo\n");
  EXPECT_EQ(ReadFile(of_host).value(), "");
  EXPECT_EQ(::close(low) + ::close(high), 0) << "closed by us";
  std::remove(of_host.c_str());
}

}  // namespace
}  // namespace oncard::runtime
