#include "runtime/host/virtual_time.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace oncard::runtime {
namespace {

constexpr int64_t kMs = 1'000'000;

TEST(VirtualTimeTest, PassesWithWhatIsDone) {
  VirtualTime time;
  EXPECT_EQ(time.NowNs(), 0);
  EXPECT_EQ(time.Pass(50), 50);
  EXPECT_EQ(time.Pass(7), 57);
  EXPECT_EQ(time.NowNs(), 57);
}

TEST(VirtualTimeTest, JumpsToTheEndOfALonelySleep) {
  VirtualTime time;
  time.SleepUntil(10'000 * kMs);
  EXPECT_EQ(time.NowNs(), 10'000 * kMs);
  time.SleepUntil(9'000 * kMs);  // that time has passed
  EXPECT_EQ(time.NowNs(), 10'000 * kMs);
}

/// What three threads see that sleep until moments in turn.
std::vector<std::string> TakeTurns() {
  VirtualTime time;
  std::mutex mutex;
  std::vector<std::string> order;
  const auto sleep = [&](const char* name, std::vector<int64_t> moments) {
    for (const int64_t moment : moments) {
      time.SleepUntil(moment * kMs);
      const std::lock_guard lock(mutex);
      order.push_back(name + std::to_string(time.NowNs() / kMs));
    }
  };
  // This thread waits in join() and the three take turns.
  std::thread a(sleep, "a", std::vector<int64_t>{10, 40, 50});
  std::thread b(sleep, "b", std::vector<int64_t>{20, 30, 80});
  std::thread c(sleep, "c", std::vector<int64_t>{25, 60, 70});
  a.join();
  b.join();
  c.join();
  return order;
}

// Again and again: a thread that was woken and waits for a lock must not look asleep.
TEST(VirtualTimeTest, SleepersWakeInTheOrderOfTheirMoments) {
  const std::vector<std::string> order = {"a10", "b20", "c25", "b30", "a40",
                                          "a50", "c60", "c70", "b80"};
  for (int round = 0; round < 200; ++round) ASSERT_EQ(TakeTurns(), order) << round;
}

TEST(VirtualTimeTest, DoesNotJumpWhileAThreadWorks) {
  std::atomic<Waits> waits = Waits::kNot;
  VirtualTime time([&](auto, auto) { return waits.load(); });
  std::thread sleeper([&] { time.SleepUntil(100 * kMs); });
  for (int step = 0; step < 50; ++step) {
    EXPECT_EQ(time.Pass(kMs), (step + 1) * kMs);
    std::this_thread::yield();
  }
  EXPECT_EQ(time.NowNs(), 50 * kMs);
  waits = Waits::kForThreads;
  sleeper.join();
  EXPECT_EQ(time.NowNs(), 100 * kMs);
}

TEST(VirtualTimeTest, DoesNotRunPastASleeper) {
  VirtualTime time([](auto, auto) { return Waits::kNot; });
  std::vector<int64_t> woken;
  std::atomic<bool> ready = false;
  std::thread sleeper([&] {
    ready = true;
    for (int64_t moment = 10; moment <= 50; moment += 10) {
      time.SleepUntil(moment * kMs);
      woken.push_back(time.NowNs() / kMs);
    }
  });
  while (!ready) std::this_thread::yield();
  while (time.NowNs() < 60 * kMs) time.Pass(kMs / 10);
  sleeper.join();
  // The thread that lets time pass runs at the same time as the sleeper that it woke, hence the
  // tolerance.
  ASSERT_EQ(woken.size(), 5u);
  for (size_t i = 0; i < woken.size(); ++i) {
    EXPECT_GE(woken[i], static_cast<int64_t>(10 * (i + 1)));
  }
}

TEST(VirtualTimeTest, EndsAWaitAtItsDeadlineWhenNobodyElseGoesOn) {
  VirtualTime time([](auto, auto) { return Waits::kForThreads; });
  const VirtualTime::Wait wait = time.BeginWait(100 * kMs);
  EXPECT_EQ(time.NextSliceNs(wait), 0);
  EXPECT_EQ(time.NowNs(), 0) << "what it waits for may come at the last look";
  time.EndWait(wait, true);
  EXPECT_EQ(time.NowNs(), 100 * kMs);
}

TEST(VirtualTimeTest, AWaitThatEndsEarlyLetsNoTimePass) {
  VirtualTime time([](auto, auto) { return Waits::kForThreads; });
  const VirtualTime::Wait wait = time.BeginWait(100 * kMs);
  time.EndWait(wait, false);
  EXPECT_EQ(time.NowNs(), 0);
  time.SleepUntil(200 * kMs);  // is not delayed by it
  EXPECT_EQ(time.NowNs(), 200 * kMs);
}

TEST(VirtualTimeTest, AWaitGoesOnWhileAThreadWorksOrAnotherDeadlineIsEarlier) {
  Waits others_wait = Waits::kNot;
  VirtualTime time([&](auto, auto) { return others_wait; });
  const VirtualTime::Wait late = time.BeginWait(100 * kMs);
  EXPECT_GT(time.NextSliceNs(late), 0);
  others_wait = Waits::kForThreads;
  const VirtualTime::Wait early = time.BeginWait(50 * kMs);
  EXPECT_GT(time.NextSliceNs(late), 0);
  EXPECT_EQ(time.NextSliceNs(early), 0);
  time.EndWait(early, true);
  EXPECT_EQ(time.NowNs(), 50 * kMs);
  EXPECT_EQ(time.NextSliceNs(late), 0);
  time.EndWait(late, true);
}

// Its thread cannot end the wait before the handler has returned.
TEST(VirtualTimeTest, PassesAWaitThatAHandlerHasInterrupted) {
  VirtualTime time([](auto, auto) { return Waits::kNot; });
  const VirtualTime::Wait wait = time.BeginWait(10 * kMs);
  std::atomic<bool> passed = false;
  std::thread other([&] {
    time.Pass(20 * kMs);
    passed = true;
  });
  while (time.NowNs() < 20 * kMs) std::this_thread::yield();
  EXPECT_FALSE(passed);
  time.LetOthersPass();
  other.join();
  EXPECT_EQ(time.NextSliceNs(wait), 0);
  time.EndWait(wait, true);
  EXPECT_EQ(time.NowNs(), 20 * kMs);
}

// As two threads that wait for a signal each, whose handlers look at the clock.
TEST(VirtualTimeTest, HandlersThatLetTimePassDoNotWaitForEachOther) {
  VirtualTime time([](auto, auto) { return Waits::kNot; });
  std::atomic<int> waiting = 0;
  const auto handle = [&] {
    const VirtualTime::Wait wait = time.BeginWait(10 * kMs);
    ++waiting;
    while (waiting < 2) std::this_thread::yield();
    time.Pass(20 * kMs);
    EXPECT_EQ(time.NextSliceNs(wait), 0);
    time.EndWait(wait, true);
  };
  std::thread other(handle);
  handle();
  other.join();
  EXPECT_EQ(time.NowNs(), 40 * kMs);
}

TEST(VirtualTimeTest, WaitsForAWaitThatGoesOnAfterAHandler) {
  VirtualTime time([](auto, auto) { return Waits::kNot; });
  const VirtualTime::Wait wait = time.BeginWait(10 * kMs);
  time.LetOthersPass();
  EXPECT_GT(time.NextSliceNs(wait), 0);
  std::atomic<bool> passed = false;
  std::thread other([&] {
    time.Pass(20 * kMs);
    passed = true;
  });
  while (time.NowNs() < 20 * kMs) std::this_thread::yield();
  EXPECT_FALSE(passed);
  time.EndWait(wait, true);
  other.join();
}

TEST(VirtualTimeTest, AHandlerMaySleepBeyondTheWaitThatItInterrupts) {
  VirtualTime time([](auto, auto) { return Waits::kForThreads; });
  const VirtualTime::Wait wait = time.BeginWait(10 * kMs);
  EXPECT_EQ(time.SleepUntil(50 * kMs), 0);
  EXPECT_EQ(time.NowNs(), 50 * kMs);
  const VirtualTime::Wait of_handler = time.BeginWait(70 * kMs);
  EXPECT_EQ(time.NextSliceNs(of_handler), 0);
  time.EndWait(of_handler, true);
  EXPECT_EQ(time.NextSliceNs(wait), 0) << "its deadline has passed";
  time.EndWait(wait, true);
  EXPECT_EQ(time.NowNs(), 70 * kMs);
}

TEST(VirtualTimeTest, AChildGoesOnWithTheWaitInWhichItWasForked) {
  VirtualTime time([](auto, auto) { return Waits::kForThreads; });
  const VirtualTime::Wait wait = time.BeginWait(10 * kMs);
  time.LockForFork();
  time.BecomeChild();
  EXPECT_EQ(time.NextSliceNs(wait), 0);
  time.EndWait(wait, true);
  EXPECT_EQ(time.NowNs(), 10 * kMs);
}

TEST(VirtualTimeTest, EndsWithTheLastMomentInsteadOfOverflowing) {
  VirtualTime time([](auto, auto) { return Waits::kForThreads; });
  EXPECT_EQ(time.After(INT64_MAX), VirtualTime::kEndNs);
  time.SleepUntil(time.After(INT64_MAX));
  EXPECT_EQ(time.NowNs(), VirtualTime::kEndNs);
  EXPECT_EQ(time.Pass(INT64_MAX), VirtualTime::kEndNs);
}

// --- Waits for other threads ---------------------------------------------------------------------

TEST(VirtualTimeTest, AThreadThatWaitsForAChangeSleepsAtMostToItsDeadline) {
  VirtualTime time;
  const std::atomic<int> word = 3;
  EXPECT_EQ(time.SleepOn(word, 3, 100 * kMs), VirtualTime::Woken::kAtDeadline);
  EXPECT_EQ(time.NowNs(), 100 * kMs);
  EXPECT_EQ(time.SleepOn(word, 2, 200 * kMs), VirtualTime::Woken::kByThread) << "it has changed";
  EXPECT_EQ(time.NowNs(), 100 * kMs);
}

// Three threads wait for the same; the last one to begin has the first deadline.
TEST(VirtualTimeTest, WakesThreadsInTheOrderInWhichTheyBeganToWait) {
  VirtualTime time;
  std::atomic<int> word = 0;
  std::vector<std::string> order;
  std::vector<std::thread> threads;
  for (const int number : {1, 2, 3}) {
    threads.emplace_back([&, number] {
      time.SleepUntil(number * kMs);
      time.SleepOn(word, 0, (100 - number) * kMs);
      order.push_back(std::to_string(number) + " at " + std::to_string(time.NowNs() / kMs));
    });
  }
  for (int moment = 10; moment <= 20; moment += 10) {
    time.SleepUntil(moment * kMs);
    time.Wake(word, false);
  }
  time.SleepUntil(30 * kMs);
  time.Wake(word, true);
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(order, (std::vector<std::string>{"1 at 10", "2 at 20", "3 at 30"}));
}

TEST(VirtualTimeTest, TheFirstSleeperCanBeWokenEarly) {
  VirtualTime time;
  std::vector<int64_t> left_ms;
  std::thread early([&] { left_ms.push_back(time.SleepUntil(50 * kMs) / kMs); });
  std::thread late([&] { left_ms.push_back(time.SleepUntil(60 * kMs) / kMs); });
  time.SleepUntil(20 * kMs);
  time.WakeFirst();
  early.join();
  late.join();
  EXPECT_EQ(left_ms, (std::vector<int64_t>{30, 0}));
}

/// Acts at some instants, and wakes a thread at the last one.
class Visitor final : public WakeUps {
 public:
  Visitor(VirtualTime* time, std::vector<int64_t> instants_ms)
      : time_(*time), instants_ms_(std::move(instants_ms)) {
    time_.ListenTo(this);
  }

  int64_t NextNs() override {
    return next_ == instants_ms_.size() ? VirtualTime::kNeverNs : instants_ms_[next_] * kMs;
  }
  void Act() override {
    acted_ms.push_back(time_.NowNs() / kMs);
    if (++next_ < instants_ms_.size()) return;
    ++word;
    time_.Wake(word, true);
  }

  std::atomic<int> word = 0;
  std::vector<int64_t> acted_ms;

 private:
  VirtualTime& time_;
  const std::vector<int64_t> instants_ms_;
  size_t next_ = 0;
};

TEST(VirtualTimeTest, ASourceActsAtItsInstantsWhileEveryThreadWaits) {
  VirtualTime time;
  Visitor visitor(&time, {10, 20, 45});
  int64_t woken_ms = 0;
  std::thread waiter([&] {
    EXPECT_EQ(time.SleepOn(visitor.word, 0, VirtualTime::kNeverNs), VirtualTime::Woken::kByThread);
    woken_ms = time.NowNs() / kMs;
  });
  time.SleepUntil(50 * kMs);
  waiter.join();
  EXPECT_EQ(time.NowNs(), 50 * kMs);
  EXPECT_EQ(visitor.acted_ms, (std::vector<int64_t>{10, 20, 45}));
  EXPECT_EQ(woken_ms, 45);
}

TEST(VirtualTimeTest, AWaitWithADeadlineDoesNotPassWhereASourceActs) {
  VirtualTime time([](auto, auto) { return Waits::kForThreads; });
  Visitor visitor(&time, {10, 20});
  const VirtualTime::Wait wait = time.BeginWait(30 * kMs);
  EXPECT_GT(time.NextSliceNs(wait), 0) << "the source has woken those who wait for it";
  EXPECT_EQ(visitor.acted_ms, (std::vector<int64_t>{10, 20}));
  EXPECT_EQ(time.NextSliceNs(wait), 0);
  time.EndWait(wait, true);
  EXPECT_EQ(time.NowNs(), 30 * kMs);
}

TEST(VirtualTimeTest, AWaitThatNobodyCanEndIsGivenUp) {
  VirtualTime time([](auto, auto) { return Waits::kForThreads; });
  const std::atomic<int> word = 0;
  EXPECT_EQ(time.SleepOn(word, 0, VirtualTime::kNeverNs), VirtualTime::Woken::kNever);
  EXPECT_EQ(time.NowNs(), 0);
}

TEST(VirtualTimeTest, AWaitIsNotGivenUpWhileSomethingMayComeFromOutside) {
  std::atomic<int> looks = 0;
  VirtualTime time([&](auto, auto) {
    ++looks;
    return Waits::kForOutside;
  });
  std::atomic<int> word = 0;
  std::thread waiter([&] {
    EXPECT_EQ(time.SleepOn(word, 0, VirtualTime::kNeverNs), VirtualTime::Woken::kByThread);
  });
  while (looks < 10) std::this_thread::yield();
  ++word;
  time.Wake(word, true);
  waiter.join();
}

}  // namespace
}  // namespace oncard::runtime
