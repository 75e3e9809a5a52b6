// Stops at data races (session/race_watch.h).
#include "session/race_watch.h"

#include <gmock/gmock.h>

#include "tests/session/session_support.h"

namespace oncard::session {
namespace {

using ::testing::ElementsAre;

/// The texts of the races at which a session stops on its way forward.
std::vector<std::string> RacesOnTheWay(Session* session) {
  std::vector<std::string> races;
  for (;;) {
    const auto stop = session->Forward({}, nullptr);
    if (!stop.ok() || stop.value().reason != StopReason::kRace) break;
    races.push_back(stop.value().text.en);
  }
  return races;
}

Result<void> Watch(Session* session) {
  StopWishes wishes;
  wishes.races = true;
  return session->SetStops(wishes);
}

std::vector<std::string> RacesOf(const std::string& program, const std::string& scenario) {
  Session session = SessionOf(program, scenario);
  EXPECT_TRUE(Watch(&session).ok());
  return RacesOnTheWay(&session);
}

// Thread 0 runs first: its write in line 7 is not ordered with the accesses of thread 1.
TEST(RaceWatchTest, EachPairOfStatementsIsToldOnce) {
  const std::string scenario = std::string("schedule = \"rr:3\"\n") + kTwoThreads;
  EXPECT_THAT(
      RacesOf(kRace, scenario),
      ElementsAre("data race: thread 0 writes x in line 7, thread 1 reads it in line 5, and "
                  "nothing orders the two",
                  "data race: thread 0 writes x in line 7, thread 1 writes it in line 7, and "
                  "nothing orders the two"));
}

constexpr const char* kHandOver =
    "int x, flag;\n"
    "int t0()\n"
    "{\n"
    "  x = 1;\n"
    "  flag = 1;\n"
    "}\n"
    "int t1()\n"
    "{\n"
    "  int f, r;\n"
    "loop:\n"
    "  f = flag;\n"
    "  if (f) goto done;\n"
    "  goto loop;\n"
    "done:\n"
    "  r = x;\n"
    "}\n";
constexpr const char* kBoth =
    "[[thread]]\nfunction = \"t0\"\n[[thread]]\nthread = 1\nfunction = \"t1\"\n";

TEST(RaceWatchTest, VariablesOfSyncOrder) {
  EXPECT_THAT(RacesOf(kHandOver, kBoth),
              ElementsAre("data race: thread 1 reads flag in line 11, thread 0 writes it in line "
                          "5, and nothing orders the two",
                          "data race: thread 0 writes x in line 4, thread 1 reads it in line 15, "
                          "and nothing orders the two"));
  EXPECT_THAT(RacesOf(kHandOver, std::string("sync = [\"flag\"]\n") + kBoth), ElementsAre());
}

TEST(RaceWatchTest, AScenarioThatForbidsRacesWatches) {
  Session session = SessionOf(kHandOver, std::string("races = \"none\"\n") + kBoth);
  EXPECT_EQ(RacesOnTheWay(&session), RacesOf(kHandOver, kBoth));
}

TEST(RaceWatchTest, AnUnknownVariableOfSyncIsRefused) {
  Session session = SessionOf(kHandOver, std::string("sync = [\"flags\"]\n") + kBoth);
  const auto watching = Watch(&session);
  ASSERT_FALSE(watching.ok());
  EXPECT_THAT(watching.error().message.en, ::testing::HasSubstr("'flags'"));
}

// Thread 1 waits first: it goes on when thread 0 has written the variable.
TEST(RaceWatchTest, AWaitOrdersWithTheWriteThatEndsIt) {
  const std::string program =
      "int x, go;\n"
      "int t0()\n{\n  GT_Delay(3);\n  x = 1;\n  go = 1;\n}\n"
      "int t1()\n{\n  int r;\n  GT_WaitForVarEq(&go, 1);\n  r = x;\n}\n";
  EXPECT_THAT(RacesOf(program, kBoth), ElementsAre());
}

TEST(RaceWatchTest, TimeAloneOrdersNothing) {
  const std::string program =
      "int x;\n"
      "int t0()\n{\n  x = 1;\n}\n"
      "int t1()\n{\n  int r;\n  GT_Delay(9);\n  r = x;\n}\n";
  EXPECT_THAT(RacesOf(program, kBoth),
              ElementsAre("data race: thread 0 writes x in line 4, thread 1 reads it in line 10, "
                          "and nothing orders the two"));
}

TEST(RaceWatchTest, ThreadsThatSetOneAxisWithoutAnOrderAreTold) {
  const std::string owners =
      "int f;\n"
      "int t0()\n{\n  GT_SetVel(2, 5);\n  GT_SetDoBit(12, 1, 1);\n  f = 1;\n}\n"
      "int t1()\n{\n  GT_SetDoBit(12, 2, 1);\n  GT_WaitForVarEq(&f, 1);\n  GT_Stop(2, 0);\n}\n";
  EXPECT_THAT(RacesOf(owners, kBoth), ElementsAre());
  const std::string without =
      "int t0()\n{\n  GT_SetVel(2, 5);\n}\nint t1()\n{\n  GT_Delay(3);\n  GT_Stop(2, 0);\n}\n";
  EXPECT_THAT(RacesOf(without, kBoth),
              ElementsAre("threads 0 and 1 both command axis 2: GT_SetVel in line 3, GT_Stop in "
                          "line 8; nothing orders them"));
}

TEST(RaceWatchTest, WhatWasBeforeTheWatchCountsToo) {
  Session session = SessionOf(kHandOver, kBoth);
  while (session.run().machine().thread(0).executed == 0) session.run().Step();
  const int64_t present = session.run().moment();
  ASSERT_TRUE(Watch(&session).ok());
  EXPECT_EQ(session.run().moment(), present);
  EXPECT_EQ(RacesOnTheWay(&session), RacesOf(kHandOver, kBoth));
}

TEST(RaceWatchTest, TheSameRacesAreMetOnTheWayBack) {
  Session session = SessionOf(kHandOver, kBoth);
  ASSERT_TRUE(Watch(&session).ok());
  const std::vector<std::string> forward = RacesOnTheWay(&session);
  // A stop lies strictly before the present.
  Walk cycle;
  cycle.goal = Goal::kCycle;
  ASSERT_TRUE(session.Forward(cycle, nullptr).ok());
  std::vector<std::string> back;
  for (;;) {
    const auto stop = session.Back({});
    ASSERT_TRUE(stop.ok());
    if (stop.value().reason != StopReason::kRace) break;
    back.insert(back.begin(), stop.value().text.en);
  }
  EXPECT_EQ(back, forward);
  EXPECT_EQ(RacesOnTheWay(&session), forward);
}

// In the cycles of the delay no thread can execute a statement.
TEST(RaceWatchTest, MomentsAreTheSameAsWithoutIt) {
  const std::string program =
      "int x;\n"
      "int t0()\n{\n  x = 1;\n  GT_Delay(3);\n  x = 2;\n}\n"
      "int t1()\n{\n  int r;\n  GT_Delay(9);\n  r = x;\n}\n";
  Session plain = SessionOf(program, kBoth);
  Session watched = SessionOf(program, kBoth);
  ASSERT_TRUE(Watch(&watched).ok());
  ASSERT_TRUE(plain.Forward({}, nullptr).ok());
  RacesOnTheWay(&watched);
  ASSERT_EQ(watched.run().head(), plain.run().head());
  for (int64_t moment = plain.run().head(); moment >= 0; --moment) {
    plain.run().GoTo(moment);
    watched.run().GoTo(moment);
    EXPECT_EQ(watched.run().controller().Hash(), plain.run().controller().Hash()) << moment;
  }
}

TEST(RaceWatchTest, ARecordingStaysTheSame) {
  Session plain = SessionOf(kHandOver, kBoth);
  Session watched = SessionOf(kHandOver, kBoth);
  ASSERT_TRUE(Watch(&watched).ok());
  EXPECT_TRUE(plain.Forward({}, nullptr).ok());
  RacesOnTheWay(&watched);
  EXPECT_EQ(vm::FormatSchedule(watched.run().Record()), vm::FormatSchedule(plain.run().Record()));
}

}  // namespace
}  // namespace oncard::session
