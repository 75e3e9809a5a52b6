#include "session/stops.h"

#include <gmock/gmock.h>

#include "tests/session/session_support.h"

namespace oncard::session {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kLoop =
    "int n;\n"
    "int f()\n"
    "{\n"
    "  int c;\n"
    "loop:\n"
    "  n = n + 1;\n"  // line 6
    "  c = n < 5;\n"
    "  if (c) goto loop;\n"  // line 8
    "\n"
    "  return n;\n"  // line 10
    "}\n";

LineStop Line(int line) {
  LineStop stop;
  stop.line = line;
  return stop;
}

LineStop Statement(const std::string& function, int position) {
  LineStop stop;
  stop.function = function;
  stop.position = position;
  return stop;
}

/// Walks to the next stop.
Stop Next(Session* session, std::vector<LogLine>* log = nullptr) {
  const auto stop = session->Forward({}, log);
  EXPECT_TRUE(stop.ok());
  return stop.ok() ? stop.value() : Stop{};
}

void Set(const StopWishes& wishes, Session* session) {
  const auto set = session->SetStops(wishes);
  EXPECT_TRUE(set.ok()) << (set.ok() ? "" : set.error().message.en);
}

std::string ErrorOf(const StopWishes& wishes) {
  Session session = SessionOf(kLoop);
  const auto set = session.SetStops(wishes);
  return set.ok() ? std::string() : set.error().message.en;
}

// --- Lines ---------------------------------------------------------------------------------------

TEST(Stops, StopBeforeEveryPassOfALine) {
  Session session = SessionOf(kLoop);
  StopWishes wishes;
  wishes.lines = {Line(6)};
  Set(wishes, &session);
  for (int pass = 0; pass < 5; ++pass) {
    const Stop stop = Next(&session);
    EXPECT_EQ(stop.reason, StopReason::kLine);
    EXPECT_EQ(stop.thread, 0);
    EXPECT_EQ(stop.number, 0);
    EXPECT_EQ(session.run().machine().Line(0), 6);
    EXPECT_EQ(ValueOf("n", session.run()), pass);
  }
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
}

TEST(Stops, ALineWithoutStatementIsMovedToTheNextOne) {
  Session session = SessionOf(kLoop);
  StopWishes wishes;
  wishes.lines = {Line(9), Line(1)};
  Set(wishes, &session);
  EXPECT_THAT(session.stops().lines(), ElementsAre(10, 6));
  wishes.lines = {Line(12)};
  EXPECT_THAT(ErrorOf(wishes), HasSubstr("no statement"));
  wishes.lines = {Line(6)};
  wishes.lines[0].file = "other.c";
  EXPECT_THAT(ErrorOf(wishes), HasSubstr("no statement of other.c"));
}

TEST(Stops, ALineCanHaveACondition) {
  Session session = SessionOf(kLoop);
  StopWishes wishes;
  wishes.lines = {Line(8)};
  wishes.lines[0].condition = "n == 3";
  Set(wishes, &session);
  EXPECT_EQ(Next(&session).reason, StopReason::kLine);
  EXPECT_EQ(ValueOf("n", session.run()), 3);
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
  wishes.lines[0].condition = "m == 3";
  EXPECT_THAT(ErrorOf(wishes), HasSubstr("nothing is named 'm'"));
}

TEST(Stops, HitsAreCountedOnceEvenWhenTheyArePassedAgain) {
  Session session = SessionOf(kLoop);
  StopWishes wishes;
  wishes.lines = {Line(8)};
  wishes.lines[0].hits = 4;
  Set(wishes, &session);
  EXPECT_EQ(Next(&session).reason, StopReason::kLine);
  EXPECT_EQ(ValueOf("n", session.run()), 4);
  session.run().GoTo(0);
  EXPECT_EQ(Next(&session).reason, StopReason::kLine);
  EXPECT_EQ(ValueOf("n", session.run()), 4);
}

TEST(Stops, ALineCanLogInsteadOfStopping) {
  Session session = SessionOf(kLoop);
  StopWishes wishes;
  wishes.lines = {Line(8)};
  wishes.lines[0].log = "n is {n}, c {page0.c}";
  Set(wishes, &session);
  std::vector<LogLine> log;
  EXPECT_EQ(Next(&session, &log).reason, StopReason::kEnd);
  ASSERT_EQ(log.size(), 5u);
  EXPECT_EQ(log[0].text, "n is 1, c 1");
  EXPECT_EQ(log[4].text, "n is 5, c 0");
  wishes.lines[0].log = "n is {n";
  EXPECT_THAT(ErrorOf(wishes), HasSubstr("not closed"));
  wishes.lines[0].log = "{m}";
  EXPECT_THAT(ErrorOf(wishes), HasSubstr("nothing is named 'm'"));
}

TEST(Stops, ALineCanBelongToOneThread) {
  Session session = SessionOf(kRace, kTwoThreads);
  StopWishes wishes;
  wishes.lines = {Line(6)};
  wishes.lines[0].thread = 1;
  Set(wishes, &session);
  EXPECT_EQ(Next(&session).thread, 1);
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
}

TEST(Stops, AThreadThatSleepsArrivesWhenItWakes) {
  Session session = SessionOf("int x;\nint f()\n{\n  GT_Delay(3);\n  x = 1;\n  return 0;\n}\n");
  StopWishes wishes;
  wishes.lines = {Line(5)};
  Set(wishes, &session);
  EXPECT_EQ(Next(&session).reason, StopReason::kLine);
  EXPECT_GE(session.run().controller().cycle(), 3);
  EXPECT_EQ(session.run().machine().Line(0), 5);
}

TEST(Stops, APeriodicThreadArrivesAtItsFirstLineEachTime) {
  Session session = SessionOf("int n;\nint f()\n{\n  n = n + 1;\n}\n",
                              "until_ms = 10\n[[thread]]\nfunction = \"f\"\nperiod_ms = 3\n");
  StopWishes wishes;
  wishes.lines = {Line(4)};
  Set(wishes, &session);
  int stops = 0;
  while (Next(&session).reason == StopReason::kLine) ++stops;
  EXPECT_EQ(stops, 4);  // at 0, 3, 6 and 9 ms
}

// --- Statements ----------------------------------------------------------------------------------

TEST(Stops, StopBeforeAStatementWithinALine) {
  Session session = SessionOf("int x;\nint f()\n{\n  x = 1; x = 2; x = 3;\n  return x;\n}\n");
  StopWishes wishes;
  wishes.lines = {Statement("f", 2)};
  Set(wishes, &session);
  EXPECT_THAT(session.stops().lines(), ElementsAre(4));
  const Stop stop = Next(&session);
  EXPECT_EQ(stop.reason, StopReason::kLine);
  EXPECT_EQ(stop.number, 0);
  EXPECT_EQ(ValueOf("x", session.run()), 2);
  EXPECT_EQ(session.run().machine().thread(0).pc, 2);
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
}

TEST(Stops, AStatementIsThatOfItsFunction) {
  Session session =
      SessionOf("int x;\nint f()\n{\n  x = 1;\n}\nint g()\n{\n  x = 2;\n}\n",
                "[[thread]]\nfunction = \"f\"\n[[thread]]\nthread = 1\nfunction = \"g\"\n");
  StopWishes wishes;
  wishes.lines = {Statement("g", 0)};
  Set(wishes, &session);
  EXPECT_EQ(Next(&session).thread, 1);
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
}

TEST(Stops, AStatementHasTheOptionsOfALine) {
  Session session = SessionOf(kLoop);
  StopWishes wishes;
  wishes.lines = {Statement("f", 1), Statement("f", 1), Statement("f", 1)};
  wishes.lines[0].thread = 1;  // there is only thread 0
  wishes.lines[1].log = "n is {n}";
  wishes.lines[2].condition = "n != 2";
  wishes.lines[2].hits = 3;
  Set(wishes, &session);
  std::vector<LogLine> log;
  EXPECT_EQ(Next(&session, &log).number, 2);
  EXPECT_EQ(ValueOf("n", session.run()), 4);  // 1, 3, 4
  EXPECT_EQ(log.size(), 4u);
}

TEST(Stops, AThreadThatSleepsWithinALineArrivesAtItsStatementWhenItWakes) {
  Session session = SessionOf("int x;\nint f()\n{\n  GT_Delay(3); x = 1;\n  return 0;\n}\n");
  StopWishes wishes;
  wishes.lines = {Statement("f", 1)};
  Set(wishes, &session);
  EXPECT_EQ(Next(&session).reason, StopReason::kLine);
  EXPECT_GE(session.run().controller().cycle(), 3);
  EXPECT_EQ(ValueOf("x", session.run()), 0);
  // For a line, that is no arrival.
  session.run().GoTo(0);
  wishes.lines = {Line(4)};
  Set(wishes, &session);
  EXPECT_EQ(Next(&session).reason, StopReason::kLine);
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
}

TEST(Stops, AStatementThatDoesNotExistIsRefused) {
  StopWishes wishes;
  wishes.lines = {Statement("ff", 0)};
  EXPECT_EQ(ErrorOf(wishes), "the program has no function 'ff'; did you mean 'f'?");
  // The loop has 4 statements.
  wishes.lines = {Statement("f", 4)};
  EXPECT_EQ(ErrorOf(wishes), "f has no statement at position 4: it has 4 statements, from 0 on");
  wishes.lines = {Statement("f", 3)};
  EXPECT_EQ(ErrorOf(wishes), "");
}

// --- Values and conditions -----------------------------------------------------------------------

TEST(Stops, StopAfterAChangeOfAVariable) {
  Session session = SessionOf(kRace, kTwoThreads);
  StopWishes wishes;
  wishes.changes = {"page1.a", "x"};
  Set(wishes, &session);
  const Stop local = Next(&session);
  EXPECT_EQ(local.reason, StopReason::kChange);
  EXPECT_EQ(local.number, 0);
  EXPECT_EQ(local.thread, 1);
  EXPECT_EQ(local.text.en, "page1.a has changed from 0 to 1");
  const Stop global = Next(&session);
  EXPECT_EQ(global.number, 1);
  EXPECT_EQ(global.thread, 0);
  EXPECT_EQ(global.text.en, "x has changed from 0 to 1");
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
}

TEST(Stops, StopWhenAConditionBecomesTrue) {
  Session session = SessionOf(kMove, "until_ms = 400\n");
  StopWishes wishes;
  wishes.conditions = {"axis1.prfPos > 1000"};
  Set(wishes, &session);
  const Stop stop = Next(&session);
  EXPECT_EQ(stop.reason, StopReason::kCondition);
  EXPECT_EQ(stop.text.en, "axis1.prfPos > 1000 has become true");
  EXPECT_GT(ValueOf("axis1.prfPos", session.run()), 1000);
  // At 20 pulse/ms the position of the cycle before is at most 5 pulses smaller.
  EXPECT_LE(ValueOf("axis1.prfPos", session.run()), 1005);
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
}

// --- What goes wrong -----------------------------------------------------------------------------

constexpr const char* kFault =
    "int a[3];\nint i;\nint f()\n{\n  GT_AxisOn(9);\n  i = 7;\n  a[i] = 1;\n  return 0;\n}\n";

TEST(Stops, StopAtRefusedCommandsAndFaults) {
  Session session = SessionOf(kFault);
  const Stop refusal = Next(&session);
  EXPECT_EQ(refusal.reason, StopReason::kRefusal);
  EXPECT_THAT(refusal.text.en, HasSubstr("GT_AxisOn(9) = 7"));
  EXPECT_EQ(session.run().machine().Line(0), 6);
  const Stop fault = Next(&session);
  EXPECT_EQ(fault.reason, StopReason::kFault);
  EXPECT_THAT(fault.text.en, HasSubstr("index 7 is out of bounds"));
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
}

TEST(Stops, DoNotStopThereIfThatIsNotWanted) {
  Session session = SessionOf(kFault);
  StopWishes wishes;
  wishes.faults = false;
  wishes.refusals = false;
  Set(wishes, &session);
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
}

TEST(Stops, StopAtWarningsInBothDirectionsIfThatIsWanted) {
  Session session = SessionOf(kUnpowered);
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
  session.run().GoTo(0);
  StopWishes wishes;
  wishes.warnings = true;
  Set(wishes, &session);
  const Stop first = Next(&session);
  EXPECT_EQ(first.reason, StopReason::kWarning);
  EXPECT_EQ(first.thread, 0);
  EXPECT_EQ(first.text.en,
            "p.c:6: thread 0 f: axis 1 moves while its drive is off, call GT_AxisOn first "
            "[drive-off]");
  const int64_t warned = session.run().moment();
  // With the statement that moves it.
  session.run().GoTo(warned - 1);
  EXPECT_EQ(session.run().machine().Line(0), 6);
  session.run().GoTo(warned);
  const Stop at_end = Next(&session);
  EXPECT_EQ(at_end.reason, StopReason::kWarning);
  EXPECT_THAT(at_end.text.en, HasSubstr("axis 1 still moves at the end"));
  EXPECT_TRUE(session.run().Over());
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
  const auto back = session.Back({});
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back.value().reason, StopReason::kWarning);
  EXPECT_EQ(back.value().text.en, first.text.en);
  EXPECT_EQ(session.run().moment(), warned);
  EXPECT_EQ(session.Back({}).value().reason, StopReason::kStart);
}

TEST(Stops, StopWhereRequirementsStopHolding) {
  Session session = SessionOf(kLoop, "always = [\"n < 3\"]\nnever = [\"n == 5\"]\n");
  const Stop always = Next(&session);
  EXPECT_EQ(always.reason, StopReason::kRequirement);
  EXPECT_EQ(always.text.en, "always: n < 3 does not hold: n is 3");
  EXPECT_EQ(Next(&session).text.en, "never: n == 5 does not hold: n is 5");
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
}

// x is 1 from 0.25 ms on, y from 2.25 ms on: a delay of 2 ms later.
constexpr const char* kAnswer =
    "int x, y;\nint f()\n{\n  x = 1;\n  GT_Delay(2);\n  y = 1;\n  x = 0;\n  return 0;\n}\n";

TEST(Stops, StopAtTheFirstStateThatIsTooLate) {
  Session session = SessionOf(kAnswer,
                              "within = [{ after = \"x == 1\", then = \"y == 1\", ms = 2 },\n"
                              "  { after = \"x == 1\", then = \"y == 1\", ms = 1.5 }]\n");
  const Stop late = Next(&session);
  EXPECT_EQ(late.reason, StopReason::kRequirement);
  EXPECT_EQ(late.text.en,
            "within 1.5 ms: x == 1 -> y == 1 does not hold: 'x == 1' held at 0.25 ms, and 'y == 1' "
            "did not within 1.5 ms; too late at 2 ms: y is 0");
  const int64_t moment = session.run().moment();
  EXPECT_EQ(Next(&session).reason, StopReason::kEnd);
  // The same on the way back, and once more forward.
  EXPECT_EQ(session.Back({}).value().reason, StopReason::kRequirement);
  EXPECT_EQ(session.run().moment(), moment);
  EXPECT_EQ(session.Back({}).value().reason, StopReason::kStart);
  EXPECT_EQ(Next(&session).text.en, late.text.en);
  EXPECT_EQ(session.run().moment(), moment);
}

TEST(Stops, TellAtTheEndWhatIsStillOwed) {
  Session session = SessionOf(kAnswer, "leads = [\"x == 1 -> y == 1\", \"y == 1 -> x == 1\"]\n");
  const Stop end = Next(&session);
  EXPECT_EQ(end.reason, StopReason::kEnd);
  ASSERT_EQ(end.failed.size(), 1u);
  EXPECT_EQ(end.failed[0].en,
            "leads: y == 1 -> x == 1 does not hold: 'y == 1' held at 2.25 ms, and 'x == 1' neither "
            "then nor later: x is 0");
}

// It says what was there before the statement, which has been executed then; back and forward
// again.
TEST(Stops, StopWhereAnAssertDidNotHold) {
  Session session =
      SessionOf("int n;\nint f()\n{\n  n = 7;\n  //@ assert: n < 5\n  n = 1;\n  return n;\n}\n");
  for (int pass = 0; pass < 2; ++pass) {
    const Stop stop = Next(&session);
    EXPECT_EQ(stop.reason, StopReason::kRequirement);
    EXPECT_EQ(stop.thread, 0);
    EXPECT_THAT(stop.text.en, HasSubstr("assert: n < 5 does not hold at "));
    EXPECT_THAT(stop.text.en, HasSubstr(":6 in thread 0: n is 7"));
    EXPECT_EQ(ValueOf("n", session.run()), 1);
    ASSERT_TRUE(session.Back({}).ok());
  }
}

TEST(Stops, StopAtAnExpectationThatDoesNotHoldAtItsInstant) {
  Session session = SessionOf(kLoop, "expect = [\"n == 4 @ 1ms\"]\n");
  const Stop stop = Next(&session);
  EXPECT_EQ(stop.reason, StopReason::kRequirement);
  EXPECT_THAT(stop.text.en, HasSubstr("n == 4 @ 1ms: n is 5"));
}

TEST(Stops, ARequirementThatDoesNotFitIsRefused) {
  const auto session = Session::Create(runtime::ScenarioForTest("always = [\"m == 1\"]\n"),
                                       runtime::CompileForTest(kLoop));
  ASSERT_FALSE(session.ok());
  EXPECT_THAT(session.error().message.en, HasSubstr("nothing is named 'm'"));
}

}  // namespace
}  // namespace oncard::session
