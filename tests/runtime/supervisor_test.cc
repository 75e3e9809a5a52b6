// What the supervisor warns of, and what it does not.
#include "runtime/observe/supervisor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "runtime/scenario/run/scenario_card.h"
#include "runtime/scenario/run/scenario_start.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

std::vector<std::string> WarningsOf(const std::string& program, const std::string& scenario = "",
                                    const RunOptions& options = {}) {
  std::vector<std::string> texts;
  for (const Message& message : RunForTest(program, scenario, options).warnings) {
    texts.push_back(message.en);
  }
  return texts;
}

/// A function whose statements begin in line 4.
std::string Program(const std::string& statements) {
  return "int sts, clock, moving;\nint f()\n{\n" + statements + "  return 0;\n}\n";
}

/// Waits until an axis rests.
std::string WaitFor(int axis) {
  const std::string n = std::to_string(axis);
  return "lbl" + n + ":\n  GT_GetSts(" + n +
         ", &sts, 1, &clock);\n  moving = sts & 0x400;\n  if (moving) goto lbl" + n + ";\n";
}

/// Axis 1 jogs for 50 ms, and goes on.
const std::string kJogging =
    "  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n  GT_Update(1);\n  GT_Delay(50);\n";

// --- drive-off -----------------------------------------------------------------------------------

TEST(DriveOff, IsWarnedOfWhereTheMotionStarts) {
  const auto warnings =
      WarningsOf(Program("  GT_PrfTrap(2);\n  GT_SetVel(2, 10);\n"
                         "  GT_SetPos(2, 100);\n  GT_Update(2);\n" +
                         WaitFor(2)));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], StartsWith("p.c:7: thread 0 f: axis 2 moves while its drive is off"));
  EXPECT_THAT(warnings[0], HasSubstr(" [drive-off]"));
}

TEST(DriveOff, IsNothingOfAnAxisThatIsOn) {
  EXPECT_THAT(WarningsOf(Program("  GT_AxisOn(2);\n  GT_PrfTrap(2);\n  GT_SetVel(2, 10);\n"
                                 "  GT_SetPos(2, 100);\n  GT_Update(2);\n" +
                                 WaitFor(2))),
              IsEmpty());
}

TEST(DriveOff, IsNothingOfAMasterThatOnlyLeads) {
  EXPECT_THAT(
      WarningsOf(Program("  GT_AxisOn(2);\n  GT_PrfGear(2, 0);\n  GT_SetGearMaster(2, 1, 2, 0);\n"
                         "  GT_SetGearRatio(2, 1, 1, 0);\n  GT_GearStart(2);\n"
                         "  GT_PrfTrap(1);\n  GT_SetVel(1, 10);\n  GT_SetPos(1, 100);\n"
                         "  GT_Update(1);\n" +
                         WaitFor(1) + "  GT_Stop(2, 0);\n")),
      IsEmpty());
}

TEST(DriveOff, IsToldOncePerPlace) {
  const auto warnings = WarningsOf(
      "int sts, clock, moving, n, more;\nint f()\n{\n  GT_PrfTrap(1);\n  GT_SetVel(1, 10);\n"
      "again:\n  n = n + 1;\n  GT_SetPos(1, n);\n  GT_Update(1);\n" +
      WaitFor(1) + "  more = n < 3;\n  if (more) goto again;\n  return 0;\n}\n");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr(", 3 times)"));
}

TEST(DriveOff, IsToldOfEachAxisThatACallStarts) {
  const auto warnings =
      WarningsOf(Program("  GT_PrfTrap(1);\n  GT_PrfTrap(2);\n  GT_SetVel(1, 10);\n"
                         "  GT_SetVel(2, 10);\n  GT_SetPos(1, 100);\n  GT_SetPos(2, 100);\n"
                         "  GT_Update(3);\n" +
                         WaitFor(1) + WaitFor(2)));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("axis 1 moves while its drive is off"),
                                    HasSubstr("axis 2 moves while its drive is off")));
  for (const std::string& warning : warnings) {
    EXPECT_THAT(warning, Not(HasSubstr("times")));
  }
}

/// Lines through points, on axes 1 and 2.
void AppendLines(const std::vector<motion::Coordinates>& points, motion::MotionCore* core) {
  motion::CrdParameters parameters;
  parameters.dimension = 2;
  parameters.coordinates = {1, 2};
  parameters.velocity_max = 100;
  parameters.acceleration_max = 10;
  core->CrdAt(0).SetUp(parameters);
  motion::Coordinates start{};
  for (const motion::Coordinates& point : points) {
    motion::PathSlot slot;
    slot.is_segment = true;
    slot.segment = *motion::MakeLine(start, point);
    slot.velocity = 10;
    slot.acceleration = 1;
    EXPECT_TRUE(core->CrdAt(0).Append(0, slot));
    start = point;
  }
}

/// What is found of a program that starts lines in line 4, with the drive of axis 1 on.
std::vector<std::string> WarningsOfLines(const std::vector<motion::Coordinates>& points) {
  Controller controller;
  EXPECT_TRUE(controller.Load(CompileForTest(Program("  GT_CrdStart(1, 0);\n"))).ok());
  Supervisor supervisor(&controller);
  controller.motion().AxisAt(0).ServoOn();
  AppendLines(points, &controller.motion());
  EXPECT_EQ(controller.machine().Bind(0, 1, 0), vm::kOk);
  EXPECT_EQ(controller.machine().Run(0), vm::kOk);
  controller.RunCycles(400);
  EXPECT_FALSE(controller.motion().state().crds[0].run.running);
  std::vector<std::string> texts;
  for (const CardFinding& finding : supervisor.findings()) {
    texts.push_back(DescribeFinding(finding, "p.c").en);
  }
  return texts;
}

TEST(DriveOff, IsNothingOfACoordinateThatNoSegmentMoves) {
  EXPECT_THAT(WarningsOfLines({{100, 0}, {200, 0}}), IsEmpty());
}

// From 0.25 ms on, a line of 100 pulses takes 10 ms to 10 pulse/ms, and as much to rest.
TEST(DriveOff, IsWarnedOfWhenASegmentMovesTheCoordinate) {
  EXPECT_THAT(
      WarningsOfLines({{100, 0}, {100, 100}, {200, 200}}),
      ElementsAre(AllOf(StartsWith("p.c:4: thread 0 f: axis 2 moves while its drive is off"),
                        HasSubstr("call GT_AxisOn first (first at 20.5 ms, 2 times)"),
                        HasSubstr("[drive-off]"))));
}

/// A path of axes 1 and 2 that begins with a command for another axis.
std::vector<std::string> WarningsOfPath(const motion::BufferedCommand& command,
                                        const std::set<size_t>& on) {
  Controller controller;
  Supervisor supervisor(&controller);
  motion::MotionCore& core = controller.motion();
  for (const size_t axis : on) core.AxisAt(axis).ServoOn();
  motion::CrdParameters parameters;
  parameters.dimension = 2;
  parameters.coordinates = {1, 2};
  parameters.velocity_max = 100;
  parameters.acceleration_max = 10;
  core.CrdAt(0).SetUp(parameters);
  motion::PathSlot slot;
  slot.command = command;
  EXPECT_TRUE(core.CrdAt(0).Append(0, slot));
  slot = {};
  slot.is_segment = true;
  slot.segment = *motion::MakeLine({}, {100, 0});
  slot.velocity = 10;
  slot.acceleration = 1;
  EXPECT_TRUE(core.CrdAt(0).Append(0, slot));
  core.CrdAt(0).Start(0, false);
  controller.RunCycles(200);
  std::vector<std::string> texts;
  for (const CardFinding& finding : supervisor.findings()) {
    texts.push_back(DescribeFinding(finding, "").en);
  }
  return texts;
}

TEST(DriveOff, IsWarnedOfAnAxisThatAPathStarts) {
  using motion::BufferedKind;
  for (const motion::BufferedCommand& command :
       {motion::BufferedCommand{BufferedKind::kMove, 2, 0, {50, 10, 1}},
        motion::BufferedCommand{BufferedKind::kGear, 2, 0, {50}}}) {
    EXPECT_THAT(WarningsOfPath(command, {0, 1}),
                ElementsAre(AllOf(HasSubstr("of coordinate system 1 moves axis 3 while its drive "
                                            "is off, call GT_AxisOn first (at 0.25 ms)"),
                                  HasSubstr("[drive-off]"))));
    EXPECT_THAT(WarningsOfPath(command, {0, 1, 2}), IsEmpty());
  }
}

// --- update-mask ---------------------------------------------------------------------------------

TEST(UpdateMask, IsNotTheNumberOfAnAxis) {
  const auto warnings =
      WarningsOf(Program("  GT_AxisOn(3);\n  GT_PrfTrap(3);\n"
                         "  GT_SetVel(3, 10);\n  GT_SetPos(3, 100);\n"
                         "  GT_Update(3);\n"));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0],
              StartsWith("p.c:8: thread 0 f: the mask starts axis 1, 2, for which nothing has been "
                         "set; the mask of axis 3 is 4"));
  EXPECT_THAT(warnings[0], HasSubstr(" [update-mask]"));
}

TEST(UpdateMask, LeavesNoAxisOutThatIsNeverStarted) {
  const auto warnings =
      WarningsOf(Program("  GT_AxisOn(1);\n  GT_AxisOn(2);\n  GT_PrfTrap(1);\n  GT_PrfTrap(2);\n"
                         "  GT_SetVel(1, 10);\n  GT_SetVel(2, 10);\n  GT_SetPos(1, 100);\n"
                         "  GT_SetPos(2, 100);\n  GT_Update(1);\n" +
                         WaitFor(1)));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0],
              StartsWith("p.c:12: thread 0 f: the mask leaves out axis 2, which is set "
                         "up and never started; its mask is 2"));
}

TEST(UpdateMask, MayStartAxesOneAfterTheOther) {
  EXPECT_THAT(
      WarningsOf(Program("  GT_AxisOn(1);\n  GT_AxisOn(2);\n  GT_PrfTrap(1);\n  GT_PrfTrap(2);\n"
                         "  GT_SetVel(1, 10);\n  GT_SetVel(2, 10);\n  GT_SetPos(1, 100);\n"
                         "  GT_SetPos(2, 100);\n  GT_Update(1);\n" +
                         WaitFor(1) + "  GT_Update(2);\n" + WaitFor(2))),
      IsEmpty());
}

TEST(UpdateMask, OfAnotherThreadLeavesNothingOut) {
  const std::string program =
      "int a, b;\nint f()\n{\n  GT_AxisOn(1);\n  GT_PrfTrap(1);\n  GT_SetVel(1, 10);\n"
      "  GT_SetPos(1, 100);\n  GT_Delay(10);\n  GT_AxisOff(1);\n  return 0;\n}\n"
      "int g()\n{\n  GT_AxisOn(2);\n  GT_PrfTrap(2);\n  GT_SetVel(2, 100);\n  GT_SetPos(2, 10);\n"
      "  GT_Delay(2);\n  GT_Update(2);\n  GT_Delay(100);\n  return 0;\n}\n";
  EXPECT_THAT(WarningsOf(program,
                         "[[thread]]\nthread = 0\nfunction = \"f\"\n"
                         "[[thread]]\nthread = 1\nfunction = \"g\"\n"),
              IsEmpty());
}

// --- no-velocity ---------------------------------------------------------------------------------

TEST(NoVelocity, IsWarnedOfWhenItWasNeverSet) {
  const auto warnings = WarningsOf(
      Program("  GT_AxisOn(1);\n  GT_PrfTrap(1);\n  GT_SetPos(1, 100);\n  GT_Update(1);\n"));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], StartsWith("p.c:7: thread 0 f: axis 1 is started without a velocity"));
  EXPECT_THAT(warnings[0], HasSubstr(" [no-velocity]"));
}

TEST(NoVelocity, IsWarnedOfWhenItIsZero) {
  EXPECT_THAT(WarningsOf(Program("  GT_AxisOn(1);\n  GT_PrfTrap(1);\n  GT_SetVel(1, 0);\n"
                                 "  GT_SetPos(1, 100);\n  GT_Update(1);\n")),
              ElementsAre(HasSubstr("axis 1 is started with the velocity 0")));
}

TEST(NoVelocity, MayStopAJog) {
  EXPECT_THAT(WarningsOf(Program("  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n"
                                 "  GT_Update(1);\n  GT_Delay(50);\n  GT_SetVel(1, 0);\n"
                                 "  GT_Update(1);\n" +
                                 WaitFor(1) + "  GT_Update(1);\n")),
              IsEmpty());
}

// --- axis-stopped --------------------------------------------------------------------------------

constexpr const char* kIntoSoftLimit =
    "  GT_AxisOn(1);\n  GT_SetSoftLimit(1, 50, -50);\n  GT_PrfTrap(1);\n  GT_SetVel(1, 10);\n"
    "  GT_SetPos(1, 1000);\n  GT_Update(1);\n";

TEST(AxisStopped, SaysWhichLimitEndedTheMotionOfWhichStart) {
  const auto warnings = WarningsOf(Program(kIntoSoftLimit + WaitFor(1)));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0],
              StartsWith("p.c:9: thread 0 f: axis 1 passed its positive soft limit 50 at "));
  EXPECT_THAT(warnings[0], HasSubstr(" [axis-stopped]"));
}

TEST(AxisStopped, IsNothingOnceTheProgramHasTakenNote) {
  EXPECT_THAT(WarningsOf(Program(kIntoSoftLimit + WaitFor(1) + "  GT_ClrSts(1, 1);\n")), IsEmpty());
  EXPECT_THAT(WarningsOf(Program(kIntoSoftLimit + WaitFor(1) +
                                 "  GT_SetPos(1, 0);\n  GT_Update(1);\nback:\n"
                                 "  GT_GetSts(1, &sts, 1, &clock);\n  moving = sts & 0x400;\n"
                                 "  if (moving) goto back;\n")),
              IsEmpty());
}

TEST(AxisStopped, TellsOfASwitchAndOfAStopInput) {
  EXPECT_THAT(WarningsOf(Program(kJogging),
                         "[[world.input]]\ntype = \"limit_positive\"\nindex = 1\nvalue = 1\n"
                         "at_ms = 20\n"),
              ElementsAre(HasSubstr("axis 1 reached its positive limit switch")));
  EXPECT_THAT(WarningsOf(Program(kJogging),
                         "[[world.input]]\ntype = \"alarm\"\nindex = 1\nvalue = 1\nat_ms = 20\n"),
              ElementsAre(HasSubstr("the drive of axis 1 reports an alarm")));
}

TEST(AxisStopped, IsNothingOfALimitThatTheAxisMovesAwayFrom) {
  EXPECT_THAT(WarningsOf(Program("  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_SetVel(1, -10);\n"
                                 "  GT_Update(1);\n  GT_Delay(50);\n  GT_Stop(1, 0);\n" +
                                 WaitFor(1)),
                         "[[world.input]]\ntype = \"limit_positive\"\nindex = 1\nvalue = 1\n"
                         "at_ms = 20\n"),
              IsEmpty());
}

// --- two-threads ---------------------------------------------------------------------------------

/// Thread 0 executes f(), as in Program(), thread 1 g().
std::vector<std::string> WarningsOfTwo(const std::string& f, const std::string& g) {
  return WarningsOf(Program(f) + "int g()\n{\n" + g + "  return 0;\n}\n",
                    "[[thread]]\nthread = 0\nfunction = \"f\"\n"
                    "[[thread]]\nthread = 1\nfunction = \"g\"\n");
}

constexpr const char* kOwnTarget =
    "  GT_AxisOn(1);\n  GT_PrfTrap(1);\n  GT_SetVel(1, 10);\n  GT_SetPos(1, 1000);\n";

TEST(TwoThreads, AreToldOfATargetThatIsLost) {
  const auto warnings =
      WarningsOfTwo(std::string(kOwnTarget) + "  GT_Delay(10);\n  GT_Update(1);\n" + WaitFor(1),
                    "  GT_Delay(5);\n  GT_SetPos(1, 500);\n  GT_Delay(2);\n");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0],
              HasSubstr(" thread 1 g: axis 1 gets a target while the one that thread 0 "
                        "has set in line 7 is not started yet"));
  EXPECT_THAT(warnings[0], HasSubstr(" [two-threads]"));
}

TEST(TwoThreads, AreToldOfAMotionThatIsSentElsewhere) {
  EXPECT_THAT(
      WarningsOfTwo(std::string(kOwnTarget) + "  GT_Update(1);\n" + WaitFor(1),
                    "  GT_Delay(5);\n  GT_SetPos(1, 500);\n  GT_Update(1);\n"),
      ElementsAre(HasSubstr(" thread 1 g: axis 1 gets a new target while it still moves for "
                            "thread 0, which started it in line 8")));
}

TEST(TwoThreads, MayChangeAVelocityAndTakeTurns) {
  EXPECT_THAT(WarningsOfTwo(std::string(kOwnTarget) + "  GT_Update(1);\n" + WaitFor(1),
                            "  GT_Delay(5);\n  GT_SetVel(1, 20);\n  GT_Update(1);\n"),
              IsEmpty());
  // The other thread has ended.
  EXPECT_THAT(
      WarningsOfTwo(kOwnTarget,
                    "  GT_Delay(50);\n  GT_SetPos(1, 500);\n  GT_Update(1);\n  GT_Delay(500);\n"),
      IsEmpty());
}

// --- axis-limit ----------------------------------------------------------------------------------

/// Axis 1 jogs for 50 ms and stops.
std::string JogAndStop() { return Program(kJogging + "  GT_Stop(1, 0);\n" + WaitFor(1)); }

TEST(AxisLimit, TellsOfTheVelocityAndTheAccelerationOfAStart) {
  EXPECT_THAT(WarningsOf(JogAndStop(), "[[world.axis]]\naxis = 1\nmax_vel = 5\n"),
              ElementsAre(AllOf(StartsWith("p.c:7: thread 0 f: axis 1 is planned with "),
                                HasSubstr(" pulse/ms, its drive follows up to 5 (max_vel) ("),
                                HasSubstr(" [axis-limit]"))));
  EXPECT_THAT(WarningsOf(JogAndStop(), "[[world.axis]]\naxis = 1\nmax_acc = 0.001\n"),
              ElementsAre(AllOf(StartsWith("p.c:7: thread 0 f: the velocity of axis 1 changes by "),
                                HasSubstr(" its drive follows up to 0.001 (max_acc) ("))));
}

TEST(AxisLimit, IsNothingOfOtherAxesAndAtTheLimitItself) {
  EXPECT_THAT(WarningsOf(JogAndStop(), "[[world.axis]]\naxis = 1\nmax_vel = 10\n"), IsEmpty());
  EXPECT_THAT(WarningsOf(JogAndStop(), "[[world.axis]]\naxis = 2\nmax_vel = 5\n"), IsEmpty());
}

// --- period-overrun ------------------------------------------------------------------------------

// 450 statements of 100 in a millisecond last 4.5 ms: runs begin at 0, 6 and 12 ms, and each misses
// the starts 2 and 4 ms after its own.
constexpr const char* kLongRun =
    "int i, more;\nint f()\n{\n  i = 0;\nlbl:\n  i = i + 1;\n  more = i < 149;\n"
    "  if (more) goto lbl;\n  i = 1;\n  return 0;\n}\n";

TEST(PeriodOverrun, SaysHowOftenAndHowLong) {
  const auto warnings = WarningsOf(kLongRun,
                                   "until_ms = 17.5\n[[thread]]\nthread = 3\nfunction = \"f\"\n"
                                   "period_ms = 2\n");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], StartsWith("p.c:"));
  EXPECT_THAT(warnings[0],
              HasSubstr("thread 3 f: the thread overruns its period of 2 ms here, its longest run "
                        "lasts more than 4 ms (first at 2 ms, 6 times) [period-overrun]"));
}

TEST(PeriodOverrun, KeepsTheLongestRunWhenTheCardGoesBack) {
  Controller controller;
  ASSERT_TRUE(controller.Load(CompileForTest(kLongRun)).ok());
  Supervisor supervisor(&controller);
  const Supervisor::HistoryPointer before = supervisor.history();
  ASSERT_EQ(controller.machine().Bind(3, 1, 0), vm::kOk);
  ASSERT_EQ(controller.machine().RunPeriodic(3, 8, 0), vm::kOk);
  controller.RunCycles(18);
  ASSERT_EQ(supervisor.findings().size(), 1u);
  EXPECT_THAT(supervisor.findings()[0].text.en, HasSubstr("lasts more than 4 ms"));
  // From there another schedule misses one start only.
  supervisor.PutBack(before);
  supervisor.Overran(3);
  EXPECT_THAT(supervisor.findings()[0].text.en, HasSubstr("lasts more than 4 ms"));
}

TEST(PeriodOverrun, IsNothingOfAThreadInTime) {
  EXPECT_THAT(
      WarningsOf("int i;\nint f()\n{\n  i = i + 1;\n  return 0;\n}\n",
                 "until_ms = 20\n[[thread]]\nthread = 3\nfunction = \"f\"\nperiod_ms = 2\n"),
      IsEmpty());
}

// --- work-left -----------------------------------------------------------------------------------

TEST(WorkLeft, IsAnAxisThatMovesWhenTheRunEnds) {
  EXPECT_THAT(WarningsOf(Program("  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_SetVel(1, 10);\n"
                                 "  GT_Update(1);\n  GT_Delay(50);\n")),
              ElementsAre(StartsWith("p.c:7: thread 0 f: axis 1 still moves at the end")));
}

TEST(WorkLeft, IsNotASlaveWhoseMasterRests) {
  EXPECT_THAT(WarningsOf(Program("  GT_AxisOn(2);\n  GT_PrfGear(2, 0);\n"
                                 "  GT_SetGearMaster(2, 1, 2, 0);\n"
                                 "  GT_SetGearRatio(2, 1, 1, 0);\n  GT_GearStart(2);\n"
                                 "  GT_Delay(10);\n")),
              IsEmpty());
}

// --- All of them ---------------------------------------------------------------------------------

constexpr const char* kWithoutVelocity =
    "  GT_AxisOn(1);\n  GT_PrfTrap(1);\n  GT_SetPos(1, 100);\n  GT_Update(1);\n";

TEST(Supervisor, FailsARunThatIsStrict) {
  RunOptions options;
  options.strict_commands = true;
  const ScenarioResult result = RunForTest(Program(kWithoutVelocity), "", options);
  ASSERT_EQ(result.failures.size(), 1u);
  EXPECT_THAT(result.failures[0].message.en, HasSubstr("[no-velocity]"));
  EXPECT_THAT(result.warnings, IsEmpty());
}

TEST(Supervisor, IsSilentAboutWhatIsSwitchedOff) {
  RunOptions options;
  ASSERT_TRUE(ReadSilentWarning("no-no-velocity", &options.silent));
  EXPECT_THAT(WarningsOf(Program(kWithoutVelocity), "", options), IsEmpty());
  ASSERT_FALSE(ReadSilentWarning("no-such", &options.silent));
  ASSERT_FALSE(ReadSilentWarning("no-velocity", &options.silent));
}

// Axis 2 jogs all the time. From 5 ms on, axis 1 starts three times with its drive off.
const std::string kJogAndThreeStarts =
    "int sts, clock, moving, n, more;\nint f()\n{\n  GT_AxisOn(2);\n  GT_PrfJog(2);\n"
    "  GT_SetVel(2, 10);\n  GT_Update(2);\n  GT_Delay(5);\n  GT_PrfTrap(1);\n"
    "  GT_SetVel(1, 10);\nagain:\n  n = n + 1;\n  GT_SetPos(1, n);\n  GT_Update(1);\n" +
    WaitFor(1) + "  GT_Delay(20);\n  more = n < 3;\n  if (more) goto again;\n  return 0;\n}\n";

/// The names of the findings with their numbers.
std::vector<std::string> NamesOf(const Supervisor& supervisor) {
  std::vector<std::string> names;
  for (const CardFinding& finding : supervisor.findings()) {
    names.push_back(fmt::format("{} {}", InfoOf(finding.warning).name, finding.count));
  }
  return names;
}

TEST(Supervisor, TakesBackWhatItHasFoundAndWhatTheEndHasShown) {
  Controller controller;
  ASSERT_TRUE(controller.Load(CompileForTest(kJogAndThreeStarts)).ok());
  Supervisor supervisor(&controller);
  ASSERT_EQ(controller.machine().Bind(0, 1, 0), vm::kOk);
  ASSERT_EQ(controller.machine().Run(0), vm::kOk);
  controller.RunCycles(16);
  const Supervisor::FoundPointer nothing = supervisor.found();
  EXPECT_THAT(NamesOf(supervisor), IsEmpty());
  supervisor.JudgeEnd();
  const Supervisor::FoundPointer end = supervisor.found();
  EXPECT_THAT(NamesOf(supervisor), ElementsAre("work-left 0"));
  // The run goes on all the same: what it shows stays when the end is forgotten.
  controller.RunCycles(40);
  EXPECT_THAT(NamesOf(supervisor), ElementsAre("work-left 0", "drive-off 1"));
  supervisor.ForgetEnd();
  EXPECT_THAT(NamesOf(supervisor), ElementsAre("drive-off 1"));
  controller.RunCycles(400);
  EXPECT_THAT(NamesOf(supervisor), ElementsAre("drive-off 3"));
  supervisor.PutBack(end);
  EXPECT_THAT(NamesOf(supervisor), ElementsAre("work-left 0"));
  supervisor.PutBack(nothing);
  EXPECT_THAT(NamesOf(supervisor), IsEmpty());
}

TEST(Supervisor, SpeaksChinese) {
  const ScenarioResult result = RunForTest(Program(kWithoutVelocity), "");
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_THAT(result.warnings[0].zh,
              StartsWith("p.c:7：线程 0 f：轴 1 启动时未设置速度，不会运动，请调用 GT_SetVel"));
}

TEST(CardWarnings, HaveNamesOfTheirOwnAndTextsInBothLanguages) {
  std::set<std::string_view> names;
  for (const CardWarningInfo& info : CardWarningTable()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(FindCardWarning(info.name), &info);
    EXPECT_EQ(&InfoOf(info.warning), &info);
    for (const std::string_view text : {info.en, info.zh, info.why_en, info.why_zh}) {
      EXPECT_NE(text, "") << info.name;
    }
  }
}

// --- What it remembers ---------------------------------------------------------------------------

/// What it remembers after so many cycles of a program that executes one statement in each.
struct Memory {
  std::vector<int64_t> words;
  uint32_t awaited = 0;
};
Memory MemoryAfter(const std::string& statements, int cycles) {
  const Scenario scenario = ScenarioForTest("rate = 4\n");
  Controller card(CardOptions(scenario));
  EXPECT_TRUE(StartScenario(scenario, CompileForTest(Program(statements)), &card).ok());
  const Supervisor supervisor(&card);
  card.RunCycles(cycles);
  Memory memory;
  Supervisor::AddTo(supervisor.history(), &memory.words);
  memory.awaited = Supervisor::AwaitedProfiles(supervisor.history());
  return memory;
}

TEST(SupervisorMemory, SaysWhatItCanTellApart) {
  const std::string moves =
      "  GT_PrfTrap(2);\n  GT_SetVel(2, 10);\n  GT_SetPos(2, 100);\n  GT_Update(2);\n";
  const Memory none = MemoryAfter(moves, 1);
  EXPECT_EQ(none.words, MemoryAfter(moves, 1).words);
  EXPECT_EQ(none.awaited, 0u);
  const Memory set_up = MemoryAfter(moves, 3);
  EXPECT_NE(set_up.words, none.words);
  EXPECT_EQ(set_up.awaited, 2u);
  const Memory started = MemoryAfter(moves, 4);
  EXPECT_NE(started.words, set_up.words);
  EXPECT_EQ(started.awaited, 0u);
}

}  // namespace
}  // namespace oncard::runtime
