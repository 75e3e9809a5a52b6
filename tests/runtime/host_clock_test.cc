#include "runtime/host/host_clock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;

constexpr int64_t kMillisecondNs = 1'000'000;

TEST(ClockSettingTest, ReadsEveryForm) {
  const ClockSetting real{ClockKind::kReal, 1};
  EXPECT_EQ(ParseClockSetting("").value(), real);
  EXPECT_EQ(ParseClockSetting("real").value(), real);
  EXPECT_EQ(ParseClockSetting("real:1").value(), real);
  EXPECT_EQ(ParseClockSetting("real:0.5").value(), (ClockSetting{ClockKind::kReal, 0.5}));
  EXPECT_EQ(ParseClockSetting("real:1000000").value(), (ClockSetting{ClockKind::kReal, 1e6}));
  EXPECT_EQ(ParseClockSetting("virtual").value(), (ClockSetting{ClockKind::kVirtual, 1}));
}

TEST(ClockSettingTest, RefusesEverythingElse) {
  for (const std::string text : {"Real", "virtual ", "virtual:2", "real:", "real:0", "real:-1",
                                 "real:1000001", "real:1x", "real:nan", "real:inf", "fast"}) {
    const auto setting = ParseClockSetting(text);
    ASSERT_FALSE(setting.ok()) << text;
    EXPECT_THAT(setting.error().message.en, HasSubstr("'" + text + "'"));
    EXPECT_THAT(setting.error().message.zh, HasSubstr("'" + text + "'"));
  }
}

TEST(HostClockTest, VirtualTimeIsTheCostOfTheCallsAndWhatTheHostLetPass) {
  VirtualTime time;
  time.Pass(7'000'000);  // before the card is opened
  HostClock clock({ClockKind::kVirtual, 1}, HostClock::SteadyNanoseconds, time);
  EXPECT_EQ(clock.TakeUs(50), 50);
  EXPECT_EQ(clock.TakeUs(1000), 1000);
  EXPECT_EQ(clock.TakeUs(0), 0);
  time.Pass(2'000'700);
  EXPECT_EQ(clock.TakeUs(50), 2050);
  time.Pass(300);  // with the remaining 700 ns, a microsecond
  EXPECT_EQ(clock.TakeUs(0), 1);
}

TEST(HostClockTest, VirtualTimeTellsWhenMicrosecondsWillHavePassed) {
  VirtualTime time;
  time.Pass(7'000'900);
  HostClock clock({ClockKind::kVirtual, 1}, HostClock::SteadyNanoseconds, time);
  EXPECT_EQ(clock.TakeUs(50), 50);
  const int64_t earliest_ns = clock.EarliestNs(3);
  EXPECT_EQ(earliest_ns, 7'053'900);
  time.Pass(earliest_ns - time.NowNs() - 1);
  EXPECT_EQ(clock.TakeUs(0), 2);
  time.Pass(1);
  EXPECT_EQ(clock.TakeUs(0), 1);
}

TEST(HostClockTest, RealTimeMayPassAtAnyMoment) {
  HostClock clock({ClockKind::kReal, 1}, [] { return 5 * kMillisecondNs; });
  EXPECT_EQ(clock.EarliestNs(3), 0);
}

TEST(HostClockTest, CardsShareTheVirtualTime) {
  VirtualTime time;
  HostClock first({ClockKind::kVirtual, 1}, HostClock::SteadyNanoseconds, time);
  HostClock second({ClockKind::kVirtual, 1}, HostClock::SteadyNanoseconds, time);
  EXPECT_EQ(first.TakeUs(1000), 1000);
  EXPECT_EQ(second.TakeUs(50), 1050);
  EXPECT_EQ(first.TakeUs(50), 100);
}

TEST(HostClockTest, RealTimeIsWhatPassedOnTheWallWhateverTheCost) {
  int64_t now = 5 * kMillisecondNs;
  HostClock clock({ClockKind::kReal, 1}, [&now] { return now; });
  EXPECT_EQ(clock.TakeUs(50), 0);
  now += 3 * kMillisecondNs;
  EXPECT_EQ(clock.TakeUs(1000), 3000);
  EXPECT_EQ(clock.TakeUs(1000), 0);
}

TEST(HostClockTest, RealTimeIsScaled) {
  int64_t now = 0;
  HostClock fast({ClockKind::kReal, 1000}, [&now] { return now; });
  now = kMillisecondNs;
  EXPECT_EQ(fast.TakeUs(50), 1'000'000);
  HostClock slow({ClockKind::kReal, 0.25}, [&now] { return now; });
  now += kMillisecondNs;
  EXPECT_EQ(slow.TakeUs(50), 250);
}

TEST(HostClockTest, PartsOfAMicrosecondAreNotLost) {
  int64_t now = 0;
  HostClock clock({ClockKind::kReal, 1}, [&now] { return now; });
  int64_t passed = 0;
  for (int call = 0; call < 1000; ++call) {
    now += 250;  // a quarter of a microsecond
    passed += clock.TakeUs(50);
  }
  EXPECT_EQ(passed, 250);
}

TEST(HostClockTest, ALongGapIsCutAndForgotten) {
  int64_t now = 0;
  HostClock clock({ClockKind::kReal, 1}, [&now] { return now; });
  now = int64_t{24} * 3600 * 1'000'000'000;
  EXPECT_EQ(clock.TakeUs(50), kCatchUpLimitUs);
  EXPECT_EQ(clock.TakeUs(50), 0);
  now += kMillisecondNs;
  EXPECT_EQ(clock.TakeUs(50), 1000);
}

TEST(HostClockTest, TheTimeOfCatchingUpCountsWhileTheComputerIsFastEnough) {
  int64_t now = 0;
  HostClock clock({ClockKind::kReal, 1}, [&now] { return now; });
  now = 10 * kMillisecondNs;
  EXPECT_EQ(clock.TakeUs(50), 10'000);
  now += kMillisecondNs;  // simulating 10 ms took 1 ms
  clock.CaughtUp();
  EXPECT_EQ(clock.TakeUs(50), 1000);
  now += kBehindLimitNs;  // the operating system was busy with something else
  clock.CaughtUp();
  EXPECT_EQ(clock.TakeUs(50), 100'000);
}

TEST(HostClockTest, AComputerThatIsTooSlowFallsBehind) {
  int64_t now = 0;
  HostClock clock({ClockKind::kReal, 1000}, [&now] { return now; });
  for (int call = 0; call < 10; ++call) {
    now += kMillisecondNs;  // the host's own time between two calls
    EXPECT_EQ(clock.TakeUs(50), 1'000'000) << call;
    now += kBehindLimitNs + 1;  // simulating one second took 100 ms instead of 1
    clock.CaughtUp();
  }
}

TEST(HostClockTest, TheLongestGapAtTheLargestScaleDoesNotOverflow) {
  int64_t now = 0;
  HostClock clock({ClockKind::kReal, kClockScaleMax}, [&now] { return now; });
  now = INT64_MAX;
  EXPECT_EQ(clock.TakeUs(50), kCatchUpLimitUs);
}

TEST(HostClockTest, TheSteadyClockNeverGoesBack) {
  const int64_t first = HostClock::SteadyNanoseconds();
  EXPECT_GE(HostClock::SteadyNanoseconds(), first);
}

}  // namespace
}  // namespace oncard::runtime
