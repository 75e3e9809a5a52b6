#include "runtime/host/waiting_threads.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <semaphore>
#include <thread>
#include <vector>

namespace oncard::runtime {
namespace {

ThreadId OwnId() { return static_cast<ThreadId>(::syscall(SYS_gettid)); }

/// Asks until this is the answer: a thread needs a moment to fall asleep or to end.
bool WaitInTheEnd(WaitingThreads* threads, Waits wait = Waits::kForThreads) {
  for (int look = 0; look < 1'000'000; ++look) {
    if (threads->OthersWait({}, {}) == wait) return true;
    std::this_thread::yield();
  }
  return false;
}

/// A thread that waits for a lock until the end of the object.
class WaitingThread {
 public:
  WaitingThread() : lock_(mutex_), thread_([this] { Wait(); }) {
    while (id_ == 0) std::this_thread::yield();
  }
  ~WaitingThread() { End(); }
  ThreadId id() const { return id_; }
  /// Lets it work until it is to wait.
  void Work() {
    works_ = true;
    lock_.unlock();
    while (!works_now_) std::this_thread::yield();
    lock_.lock();
  }
  void StopWorking() { works_ = false; }
  void End() {
    works_ = false;
    ends_ = true;
    if (lock_.owns_lock()) lock_.unlock();
    if (thread_.joinable()) thread_.join();
  }

 private:
  void Wait() {
    id_ = OwnId();
    while (!ends_) {
      { const std::lock_guard wait(mutex_); }
      while (works_) works_now_ = true;
      works_now_ = false;
    }
  }

  std::mutex mutex_;
  std::unique_lock<std::mutex> lock_;
  std::atomic<ThreadId> id_ = 0;
  std::atomic<bool> works_ = false;
  std::atomic<bool> works_now_ = false;
  std::atomic<bool> ends_ = false;
  std::thread thread_;
};

TEST(WaitingThreadsTest, ASingleThreadHasNobodyToLookAt) {
  WaitingThreads threads;
  EXPECT_EQ(threads.OthersWait({}, {}), Waits::kForThreads);
  EXPECT_EQ(threads.work().listings, 0);
  EXPECT_EQ(threads.work().looks, 0);
}

TEST(WaitingThreadsTest, WhoIsKnownToSleepIsNotLookedAt) {
  const WaitingThread one;
  const WaitingThread other;
  const ThreadId asleep[] = {one.id(), other.id()};
  WaitingThreads threads;
  for (int look = 0; look < 10; ++look)
    EXPECT_EQ(threads.OthersWait(asleep, {}), Waits::kForThreads);
  EXPECT_EQ(threads.work().listings, 0);
  EXPECT_EQ(threads.work().looks, 0);
}

TEST(WaitingThreadsTest, AThreadThatWorksDoesNotWait) {
  WaitingThread thread;
  WaitingThreads threads;
  EXPECT_TRUE(WaitInTheEnd(&threads));
  thread.Work();
  for (int look = 0; look < 100; ++look) EXPECT_EQ(threads.OthersWait({}, {}), Waits::kNot);
  thread.StopWorking();
  EXPECT_TRUE(WaitInTheEnd(&threads));
}

TEST(WaitingThreadsTest, AThreadThatReadsWaitsForWhatComesFromOutside) {
  int pipe[2] = {-1, -1};
  ASSERT_EQ(::pipe(pipe), 0);
  const WaitingThread other;
  std::thread reader([&] {
    char character = 0;
    EXPECT_EQ(::read(pipe[0], &character, 1), 1);
  });
  WaitingThreads threads;
  EXPECT_TRUE(WaitInTheEnd(&threads, Waits::kForOutside));
  EXPECT_EQ(::write(pipe[1], "x", 1), 1);
  reader.join();
  EXPECT_TRUE(WaitInTheEnd(&threads, Waits::kForThreads));
  for (const int end : pipe) ::close(end);
}

TEST(WaitingThreadsTest, AThreadInSlicesThatWorksDoesNotWaitEither) {
  WaitingThread thread;
  const ThreadId in_slices[] = {thread.id()};
  thread.Work();
  WaitingThreads threads;
  for (int look = 0; look < 100; ++look) EXPECT_EQ(threads.OthersWait({}, in_slices), Waits::kNot);
}

TEST(WaitingThreadsTest, ThreadsThatGoOnWaitingAreLookedAtOnceEachTime) {
  const WaitingThread one;
  const WaitingThread other;
  WaitingThreads threads;
  ASSERT_TRUE(WaitInTheEnd(&threads));
  const WaitingThreads::Work before = threads.work();
  for (int look = 0; look < 10; ++look) EXPECT_EQ(threads.OthersWait({}, {}), Waits::kForThreads);
  EXPECT_EQ(threads.work().looks - before.looks, 2 * 10);
  EXPECT_EQ(threads.work().listings, before.listings);
}

TEST(WaitingThreadsTest, ThreadsThatComeAndGoAreListedAnew) {
  WaitingThreads threads;
  auto first = std::make_unique<WaitingThread>();
  const WaitingThread second;
  EXPECT_TRUE(WaitInTheEnd(&threads));
  // One ends and another begins between two looks: their number stays.
  first->End();
  WaitingThread third;
  third.Work();
  for (int look = 0; look < 100; ++look) EXPECT_EQ(threads.OthersWait({}, {}), Waits::kNot);
  third.StopWorking();
  EXPECT_TRUE(WaitInTheEnd(&threads));
}

/// How often all threads seemed to wait while `work`, in a thread that is woken for it, was not
/// done.
int WrongAnswers(const std::function<void()>& work) {
  std::atomic<bool> works = false;
  std::atomic<bool> ends = false;
  std::binary_semaphore begin(0);
  std::thread worker([&] {
    for (begin.acquire(); !ends; begin.acquire()) {
      work();
      works = false;
    }
  });
  WaitingThreads threads;
  int wrong = 0;
  for (int round = 0; round < 3000; ++round) {
    works = true;
    begin.release();
    while (works) {
      // If there is still work afterwards, there was some all the time.
      if (threads.OthersWait({}, {}) != Waits::kNot && works) ++wrong;
    }
  }
  ends = true;
  begin.release();
  worker.join();
  return wrong;
}

void Compute() {
  for (int step = 0; step < 50'000; ++step) std::atomic_signal_fence(std::memory_order_seq_cst);
}

TEST(WaitingThreadsTest, AThreadThatWasWokenDoesNotWaitBeforeItRuns) {
  EXPECT_EQ(WrongAnswers(Compute), 0);
}

// Its parent waits for it; it was not there yet when the threads were counted.
TEST(WaitingThreadsTest, AThreadThatBeginsDuringTheLookDoesNotWait) {
  EXPECT_EQ(WrongAnswers([] { std::thread(Compute).join(); }), 0);
}

TEST(WaitingThreadsTest, AThreadThatIsLeftOutMayWork) {
  std::atomic<bool> left_out = false;
  std::atomic<bool> ends = false;
  std::thread worker([&] {
    const LeftOutThread own;
    left_out = true;
    while (!ends) {
    }
  });
  while (!left_out) std::this_thread::yield();
  WaitingThreads threads;
  EXPECT_EQ(threads.OthersWait({}, {}), Waits::kForThreads);
  const WaitingThread other;
  EXPECT_TRUE(WaitInTheEnd(&threads));
  ends = true;
  worker.join();
}

TEST(WaitingThreadsTest, ManyThreadsAreLookedAtWithoutKeepingAllFilesOpen) {
  std::vector<std::unique_ptr<WaitingThread>> many;
  for (int i = 0; i < 100; ++i) many.push_back(std::make_unique<WaitingThread>());
  WaitingThreads threads;
  EXPECT_TRUE(WaitInTheEnd(&threads));
  many.back()->Work();
  EXPECT_EQ(threads.OthersWait({}, {}), Waits::kNot);
  many.back()->StopWorking();
}

TEST(WaitingThreadsTest, SurvivesAHostThatClosesAllDescriptors) {
  WaitingThread thread;
  WaitingThreads threads;
  ASSERT_TRUE(WaitInTheEnd(&threads));
  // The host then opens files of its own, which get the same numbers.
  ::syscall(SYS_close_range, 700u, 1023u, 0u);
  std::vector<int> of_host;
  for (int i = 0; i < 16; ++i) {
    const int low = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    of_host.push_back(::fcntl(low, F_DUPFD_CLOEXEC, 768));
    ::close(low);
  }
  EXPECT_TRUE(WaitInTheEnd(&threads));
  thread.Work();
  EXPECT_EQ(threads.OthersWait({}, {}), Waits::kNot);
  thread.StopWorking();
  for (const int descriptor : of_host) EXPECT_EQ(::close(descriptor), 0) << "closed by us";
}

TEST(WaitingThreadsTest, AChildHasItsOwnThreads) {
  WaitingThread thread;
  WaitingThreads threads;
  ASSERT_TRUE(WaitInTheEnd(&threads));
  thread.Work();
  ASSERT_EQ(threads.OthersWait({}, {}), Waits::kNot);
  const pid_t child = ::fork();
  if (child == 0) ::_exit(threads.OthersWait({}, {}) == Waits::kForThreads ? 0 : 1);
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  thread.StopWorking();
}

}  // namespace
}  // namespace oncard::runtime
