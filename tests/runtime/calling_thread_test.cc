#include "runtime/host/calling_thread.h"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

namespace oncard::runtime {
namespace {

bool KnowsItsNumbers() {
  return CallingThread() == static_cast<ThreadId>(::syscall(SYS_gettid)) &&
         CallingProcess() == ::getpid();
}

TEST(CallingThreadTest, EachThreadHasItsOwnNumber) {
  for (int call = 0; call < 2; ++call) EXPECT_TRUE(KnowsItsNumbers()) << call;
  bool other_knows = false;
  std::thread([&other_knows] { other_knows = KnowsItsNumbers(); }).join();
  EXPECT_TRUE(other_knows);
  EXPECT_TRUE(KnowsItsNumbers());
}

/// The exit status of a child process that is made by `fork`: 0 if it and a child of its own, which
/// is made in the same way, know their numbers.
template <typename Fork>
int StatusOfChild(const Fork& fork, int generations) {
  const pid_t child = fork();
  if (child == 0) {
    const bool knows = KnowsItsNumbers();
    ::_exit(!knows ? 1 : generations > 1 ? StatusOfChild(fork, generations - 1) : 0);
  }
  int status = -1;
  return ::waitpid(child, &status, 0) == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(CallingThreadTest, AChildProcessHasItsOwnNumbers) {
  ASSERT_TRUE(KnowsItsNumbers());
  EXPECT_EQ(StatusOfChild(::fork, 2), 0);
  EXPECT_TRUE(KnowsItsNumbers());
}

// As a library does that makes processes without the C library, and runs no handler of
// pthread_atfork().
TEST(CallingThreadTest, AChildThatTheCLibraryDoesNotKnowHasItsOwnNumbers) {
  ASSERT_TRUE(KnowsItsNumbers());
  const auto clone = [] {
    return static_cast<pid_t>(::syscall(SYS_clone, SIGCHLD, nullptr, nullptr, nullptr, nullptr));
  };
  EXPECT_EQ(StatusOfChild(clone, 2), 0);
}

}  // namespace
}  // namespace oncard::runtime
