#include "session/session.h"

#include <gmock/gmock.h>

#include <atomic>

#include "tests/session/session_support.h"

namespace oncard::session {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Walk To(Goal goal, int thread = 0) {
  Walk walk;
  walk.goal = goal;
  walk.thread = thread;
  return walk;
}

Stop Forward(const Walk& walk, Session* session) {
  const auto stop = session->Forward(walk, nullptr);
  EXPECT_TRUE(stop.ok()) << (stop.ok() ? "" : stop.error().message.en);
  return stop.ok() ? stop.value() : Stop{};
}

Stop Back(const Walk& walk, Session* session) {
  const auto stop = session->Back(walk);
  EXPECT_TRUE(stop.ok()) << (stop.ok() ? "" : stop.error().message.en);
  return stop.ok() ? stop.value() : Stop{};
}

// --- Forward -------------------------------------------------------------------------------------

TEST(Forward, AStepIsTheNextThingThatHappens) {
  Session session = SessionOf(kRace, kTwoThreads);
  EXPECT_EQ(Forward(To(Goal::kStep), &session).reason, StopReason::kGoal);
  EXPECT_EQ(session.run().moment(), 1);
}

TEST(Forward, TheOtherThreadsTakeTheirTurnsBeforeAStatement) {
  Session session = SessionOf(kRace, kTwoThreads);
  EXPECT_EQ(Forward(To(Goal::kStatement, 1), &session).thread, 1);
  EXPECT_EQ(session.run().machine().thread(0).executed, 1);
  EXPECT_EQ(session.run().machine().thread(1).executed, 1);
}

TEST(Forward, ALineEndsWhereTheNextOneBegins) {
  Session session = SessionOf("int x;\nint f()\n{\n  x = 1; x = 2;\n  x = 3;\n}\n");
  Forward(To(Goal::kLine), &session);
  EXPECT_EQ(session.run().machine().Line(0), 4);
  Forward(To(Goal::kLine), &session);
  EXPECT_EQ(session.run().machine().Line(0), 5);
  EXPECT_EQ(ValueOf("x", session.run()), 2);
  Forward(To(Goal::kLine), &session);
  EXPECT_EQ(session.run().Over(), runtime::RunOver::kQuiet);
}

TEST(Forward, ACycleGoesToItsEnd) {
  Session session = SessionOf(kMove, "until_ms = 5\n");
  Forward(To(Goal::kCycle), &session);
  EXPECT_EQ(session.run().moment(), 26);  // its beginning and 25 statements
  session.run().Step();
  Forward(To(Goal::kCycle), &session);
  EXPECT_EQ(session.run().controller().cycle(), 2);
  EXPECT_EQ(session.run().NextStep(), StepKind::kCycle);
}

TEST(Forward, ATimeIsRoundedUpToTheEndOfACycle) {
  Session session = SessionOf(kMove, "until_ms = 5\n");
  Walk walk = To(Goal::kTime);
  walk.time_us = 1001;
  Forward(walk, &session);
  EXPECT_EQ(session.run().controller().cycle(), 5);
}

TEST(Forward, GoesOnAfterTheEndOfTheRunUntilEverythingRests) {
  Session session = SessionOf(
      "int f()\n{\n  TTrapPrm trap;\n  GT_AxisOn(1);\n  GT_PrfTrap(1);\n  trap.acc = 1;\n"
      "  trap.dec = 1;\n  trap.velStart = 0;\n  trap.smoothTime = 0;\n"
      "  GT_SetTrapPrm(1, &trap);\n  GT_SetVel(1, 10);\n  GT_SetPos(1, 500);\n  "
      "GT_Update(1);\n}\n");
  EXPECT_EQ(Forward(To(Goal::kStop), &session).reason, StopReason::kEnd);
  EXPECT_LT(ValueOf("axis1.prfPos", session.run()), 10);
  EXPECT_EQ(Forward(To(Goal::kRest), &session).reason, StopReason::kGoal);
  EXPECT_EQ(ValueOf("axis1.prfPos", session.run()), 500);
  // 10 ms of acceleration and of deceleration, 50 pulses each, and 40 ms for the rest.
  EXPECT_EQ(session.run().controller().NowMs(), 60.25);
}

/// A walk to the end in pieces of this length; the number of them.
int ForwardToEnd(int64_t piece_us, Session* session) {
  Walk walk = To(Goal::kEnd);
  walk.time_us = piece_us;
  int pieces = 1;
  while (Forward(walk, session).reason == StopReason::kGoal) ++pieces;
  return pieces;
}

TEST(Forward, ARunEndsAtTheSameMomentInPiecesOfAnyLength) {
  for (const int64_t piece_us : {250, 7000, 1'000'000}) {
    // The axis travels 500 pulses after its thread has ended, which takes 60.25 ms as above.
    Session moving = SessionOf(
        "TTrapPrm trap;\nint main()\n{\n  GT_PrfTrap(1);\n  trap.acc = 1;\n  trap.dec = 1;\n"
        "  trap.velStart = 0;\n  trap.smoothTime = 0;\n  GT_SetTrapPrm(1, &trap);\n"
        "  GT_SetVel(1, 10);\n  GT_SetPos(1, 500);\n  GT_Update(1);\n}\n");
    EXPECT_EQ(ForwardToEnd(piece_us, &moving), 60'250 / piece_us + 1) << piece_us;
    EXPECT_EQ(moving.run().controller().NowMs(), 60.25) << piece_us;
    Session limited = SessionOf(kMove, "until_ms = 5\n");
    ForwardToEnd(piece_us, &limited);
    EXPECT_EQ(limited.run().controller().NowMs(), 5) << piece_us;
    // An axis that jogs is watched for a minute.
    Session jogging =
        SessionOf("int main()\n{\n  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n  GT_Update(1);\n}\n",
                  "limit_ms = 100000\n");
    ForwardToEnd(piece_us, &jogging);
    EXPECT_EQ(jogging.run().controller().NowMs(), 60'000.25) << piece_us;
  }
}

TEST(Forward, AnEndSaysWhatDoesNotHold) {
  Session session = SessionOf(kRace, "final = [\"x == 2\"]\n" + std::string(kTwoThreads));
  Walk walk = To(Goal::kEnd);
  walk.time_us = 1000;
  const Stop stop = Forward(walk, &session);
  ASSERT_EQ(stop.failed.size(), 1u);
  EXPECT_EQ(stop.failed[0].en, "final: x == 2 does not hold: x is 1");
}

TEST(Forward, ABudgetEndsEveryWalk) {
  Session session = SessionOf(kMove);
  for (const Goal goal : {Goal::kStop, Goal::kRest}) {
    Walk walk = To(goal);
    walk.budget = 1000;
    const int64_t start = session.run().moment();
    EXPECT_EQ(Forward(walk, &session).reason, StopReason::kBudget);
    EXPECT_EQ(session.run().moment(), start + 1000);
  }
}

TEST(Forward, ChecksWhatItIsAsked) {
  Session session = SessionOf(kRace, kTwoThreads);
  EXPECT_THAT(session.Forward(To(Goal::kStatement, 32), nullptr).error().message.en,
              HasSubstr("threads are 0 to 31"));
  EXPECT_THAT(session.Forward(To(Goal::kLine, 7), nullptr).error().message.en,
              HasSubstr("thread 7 does not run"));
  EXPECT_FALSE(session.Forward(To(Goal::kChange), nullptr).ok());
  EXPECT_FALSE(session.Back(To(Goal::kTime)).ok());
  EXPECT_FALSE(session.Back(To(Goal::kRest)).ok());
  Walk change = To(Goal::kChange);
  change.name = "y";
  EXPECT_THAT(session.Back(change).error().message.en, HasSubstr("nothing is named 'y'"));
}

TEST(Forward, TheEndSaysWhatDoesNotHold) {
  Session session =
      SessionOf(kRace, "expect = [\"x == 3\", \"x == 1\"]\nfinal = [\"x == 2\", \"x > 0\"]\n" +
                           std::string(kTwoThreads));
  const Stop stop = Forward(To(Goal::kStop), &session);
  EXPECT_EQ(stop.reason, StopReason::kEnd);
  ASSERT_EQ(stop.failed.size(), 2u);
  EXPECT_EQ(stop.failed[0].en, "x == 3 does not hold: x is 1");
  EXPECT_EQ(stop.failed[1].en, "final: x == 2 does not hold: x is 1");
}

TEST(Forward, JudgesAtTheEndWhatHasHeldAtSomeTime) {
  const std::string scenario =
      "eventually = [\"x == 1\", \"page0.a == 1\", \"x == 5\"]\n" + std::string(kTwoThreads);
  Session session = SessionOf(kRace, scenario);
  const Stop stop = Forward(To(Goal::kStop), &session);
  EXPECT_EQ(stop.reason, StopReason::kEnd);
  ASSERT_EQ(stop.failed.size(), 1u);
  EXPECT_EQ(stop.failed[0].en, "eventually: x == 5 held in no state of the run; at its end x is 1");
  EXPECT_EQ(stop.failed[0].zh, "eventually: x == 5 在整个运行中从未成立；结束时 x 为 1");

  // Going back and changing the run changes what has held.
  session.run().GoTo(3);
  ASSERT_TRUE(session.run().WriteVariable("x", 5).ok());
  EXPECT_TRUE(Forward(To(Goal::kStop), &session).failed.empty());
  session.run().GoTo(2);
  ASSERT_TRUE(session.run().StepThread(1 - session.run().NextThread()).ok());
  EXPECT_EQ(Forward(To(Goal::kStop), &session).failed.size(), 1u);
}

// The states after the end of the run do not count.
TEST(Forward, WhatHoldsAfterTheEndComesTooLate) {
  Session session =
      SessionOf(kRace, "until_ms = 5\neventually = [\"clock > 5\", \"clock == 5\"]\n" +
                           std::string(kTwoThreads));
  EXPECT_EQ(Forward(To(Goal::kStop), &session).failed.size(), 1u);
  Walk walk = To(Goal::kTime);
  walk.time_us = 3000;
  Forward(walk, &session);
  EXPECT_EQ(Forward(To(Goal::kStop), &session).failed.size(), 1u);
}

// A run that may last for ever does not end where it is cut.
TEST(Forward, JudgesNoEndWhereARunIsCut) {
  const std::string keys = "limit_ms = 2\nfinal = [\"n == 0\"]\n";
  Session limited = SessionOf(runtime::kSpin, keys);
  EXPECT_EQ(Forward(To(Goal::kStop), &limited).failed.size(), 1u);
  Session cut = SessionOf(runtime::kSpin, "livelock = \"any\"\n" + keys);
  EXPECT_EQ(Forward(To(Goal::kStop), &cut).failed.size(), 0u);
  EXPECT_EQ(cut.run().Over(), runtime::RunOver::kUntil);
}

TEST(Forward, SaysWhereAScheduleEnds) {
  Session recorded = SessionOf(kRace, kTwoThreads);
  recorded.run().AdvanceTo(4);
  const auto schedule = std::make_shared<const vm::Schedule>(recorded.run().Record());
  auto session = Session::Create(runtime::ScenarioForTest(kTwoThreads),
                                 runtime::CompileForTest(kRace), schedule);
  ASSERT_TRUE(session.ok());
  EXPECT_EQ(Forward(To(Goal::kStop), &session.value()).reason, StopReason::kScheduleEnd);
  EXPECT_EQ(Forward(To(Goal::kStop), &session.value()).reason, StopReason::kEnd);
}

// --- Back ----------------------------------------------------------------------------------------

class BackTest : public testing::Test {
 protected:
  BackTest() : session_(SessionOf(kMove, "until_ms = 20\n")) {}

  Session session_;
};

TEST_F(BackTest, OneStep) {
  session_.run().AdvanceTo(1500);
  EXPECT_EQ(Back(To(Goal::kStep), &session_).reason, StopReason::kGoal);
  EXPECT_EQ(session_.run().moment(), 1499);
  session_.run().GoTo(0);
  EXPECT_EQ(Back(To(Goal::kStep), &session_).reason, StopReason::kStart);
}

TEST_F(BackTest, ToTheBeginningOfTheCycle) {
  session_.run().AdvanceTo(60);  // in the third cycle: it begins at 52
  Back(To(Goal::kCycle), &session_);
  EXPECT_EQ(session_.run().moment(), 52);
  Back(To(Goal::kCycle), &session_);
  EXPECT_EQ(session_.run().moment(), 26);
}

TEST_F(BackTest, ToTheStatementOfAThread) {
  Session session = SessionOf(kRace, kTwoThreads);
  session.run().AdvanceTo(7);
  Back(To(Goal::kStatement, 0), &session);
  EXPECT_EQ(session.run().moment(), 5);
  Back(To(Goal::kStatement, 0), &session);
  EXPECT_EQ(session.run().moment(), 3);
}

TEST_F(BackTest, ToTheBeginningOfALine) {
  Session session = SessionOf("int x;\nint f()\n{\n  x = 1; x = 2;\n  x = 3;\n  x = 4;\n}\n");
  Forward(To(Goal::kStop), &session);
  std::vector<int> lines;
  for (int i = 0; i < 3; ++i) {
    Back(To(Goal::kLine), &session);
    lines.push_back(session.run().machine().Line(0));
  }
  EXPECT_THAT(lines, ElementsAre(6, 5, 4));
  EXPECT_EQ(ValueOf("x", session.run()), 0);
}

TEST_F(BackTest, ToTheLastStop) {
  StopWishes wishes;
  wishes.changes = {"n"};
  ASSERT_TRUE(session_.SetStops(wishes).ok());
  session_.run().AdvanceTo(1500);
  const double before = ValueOf("n", session_.run());
  EXPECT_EQ(Back(To(Goal::kStop), &session_).reason, StopReason::kChange);
  const double there = ValueOf("n", session_.run());
  EXPECT_GE(there, before - 1);
  EXPECT_EQ(Back(To(Goal::kStop), &session_).reason, StopReason::kChange);
  EXPECT_EQ(ValueOf("n", session_.run()), there - 1);
}

TEST_F(BackTest, ToTheStatementThatChangedAValue) {
  session_.run().AdvanceTo(1500);
  Walk walk = To(Goal::kChange);
  walk.name = "n";
  const double before = ValueOf("n", session_.run());
  Back(walk, &session_);
  // Just before it: the thread is at the statement, and the value is the old one.
  EXPECT_EQ(ValueOf("n", session_.run()), before - 1);
  EXPECT_EQ(session_.run().machine().Line(0), 17);
}

TEST_F(BackTest, WithoutAStopToTheStart) {
  session_.run().AdvanceTo(1500);
  EXPECT_EQ(Back(To(Goal::kStop), &session_).reason, StopReason::kStart);
  EXPECT_EQ(session_.run().moment(), 0);
}

TEST_F(BackTest, WalksEndWhereTheyAreWhenTheirEndIsWanted) {
  session_.run().AdvanceTo(1500);
  std::atomic<bool> wanted = true;
  session_.EndEarly(&wanted);
  EXPECT_EQ(Forward(To(Goal::kRest), &session_).reason, StopReason::kBudget);
  EXPECT_EQ(Back(To(Goal::kStop), &session_).reason, StopReason::kBudget);
  EXPECT_EQ(session_.run().moment(), 1500);
  wanted = false;
  EXPECT_EQ(Back(To(Goal::kStop), &session_).reason, StopReason::kStart);
}

TEST_F(BackTest, ABudgetEndsTheSearch) {
  Session session = SessionOf(kMove);
  session.run().AdvanceTo(100'000);
  Walk walk = To(Goal::kStop);
  walk.budget = 10'000;
  EXPECT_EQ(Back(walk, &session).reason, StopReason::kBudget);
  EXPECT_LE(session.run().moment(), 90'000);
  EXPECT_GT(session.run().moment(), 0);
}

// --- A statement of the user's choice ------------------------------------------------------------

TEST(StepThread, StopsLikeAWalk) {
  Session session = SessionOf(kRace, std::string("never = [\"x == 1\"]\n") + kTwoThreads);
  EXPECT_EQ(session.StepThread(1).value().reason, StopReason::kGoal);
  EXPECT_EQ(session.StepThread(1).value().reason, StopReason::kGoal);
  EXPECT_EQ(session.StepThread(1).value().reason, StopReason::kRequirement);
}

// --- Values over time ----------------------------------------------------------------------------

TEST(Trace, AnyValueCanBeAskedForAfterTheFact) {
  Session session = SessionOf(kMove, "until_ms = 100\n");
  Forward(To(Goal::kStop), &session);
  const uint64_t hash = session.run().controller().Hash();
  const auto channels = session.Trace({"axis1.prfVel", "n"}, 0, 100'000, 10);
  ASSERT_TRUE(channels.ok());
  ASSERT_EQ(channels.value().size(), 2u);
  const Session::Channel& velocity = channels.value()[0];
  EXPECT_EQ(velocity.name, "axis1.prfVel");
  ASSERT_EQ(velocity.least.size(), 10u);
  // 20 pulse/ms are reached after 40 ms at 0.5 pulse/ms2, before the last five parts.
  EXPECT_THAT(velocity.largest[9], DoubleEq(20));
  EXPECT_THAT(velocity.least[9], DoubleEq(20));
  EXPECT_EQ(velocity.least[0], 0);
  // The axis starts at 0.25 ms, and the last cycle of the part ends at 9.75 ms.
  EXPECT_THAT(velocity.largest[0], DoubleEq(4.75));
  EXPECT_EQ(session.run().controller().Hash(), hash);
}

TEST(Trace, KeepsTheSpikesOfManyCycles) {
  Session session = SessionOf(
      "int x;\nint f()\n{\n  GT_Delay(10);\n  x = 100;\n  GT_Delay(1);\n  x = 0;\n  GT_Delay(50);\n"
      "}\n");
  Forward(To(Goal::kStop), &session);
  const auto channels = session.Trace({"x"}, 0, 60'000, 2);
  ASSERT_TRUE(channels.ok());
  EXPECT_EQ(channels.value()[0].least[0], 0);
  EXPECT_EQ(channels.value()[0].largest[0], 100);
  EXPECT_EQ(channels.value()[0].largest[1], 0);
}

TEST(Trace, PartsWithoutACycleContinueTheValueBefore) {
  Session session = SessionOf(kMove, "until_ms = 1\n");
  Forward(To(Goal::kStop), &session);
  const auto channels = session.Trace({"n"}, 0, 1000, 9);  // five ends of cycles in nine parts
  ASSERT_TRUE(channels.ok());
  ASSERT_EQ(channels.value()[0].least.size(), 9u);
  EXPECT_EQ(channels.value()[0].least, channels.value()[0].largest);
}

TEST(Trace, RefusesNamesThatAreNotThere) {
  Session session = SessionOf("int a[3];\nint f()\n{\n  return 0;\n}\n");
  EXPECT_THAT(session.Trace({"b"}, 0, 1, 1).error().message.en, HasSubstr("nothing is named 'b'"));
  EXPECT_THAT(session.Trace({"a"}, 0, 1, 1).error().message.en, HasSubstr("array"));
}

}  // namespace
}  // namespace oncard::session
