// Smart homing through its commands.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/gtcalls/command_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

using Cells = std::vector<double>;
constexpr size_t kCells = 22;

/// The example of the application notes.
Cells Example(CommandTestCard& card) {
  Cells cells(kCells);
  EXPECT_EQ(card.Call("GT_GetHomePrm", {1, &cells}), 0);
  cells[0] = 20;
  cells[1] = 1;
  cells[2] = 1;
  cells[3] = 0;
  cells[8] = 5;
  cells[9] = 1;
  cells[10] = 0.1;
  cells[11] = 0.1;
  cells[17] = 200000;
  cells[18] = 30000;
  cells[19] = 1000;
  return cells;
}

Cells Status(CommandTestCard& card) {
  Cells status(6);
  EXPECT_EQ(card.Call("GT_GetHomeStatus", {1, &status}), 0);
  return status;
}

int RunToEnd(CommandTestCard& card) {
  int ticks = 0;
  while (Status(card)[0] == 1 && ticks < 1000000) {
    card.motion.Tick();
    ++ticks;
  }
  return ticks;
}

void AddSwitch(CommandTestCard& card, motion::DiType type, double first, double last) {
  card.motion.AddSwitch({.axis = 0, .type = type, .first = first, .last = last});
  card.motion.Tick();
}

TEST(GoHome, TheExampleAcceleratesInFiftyMsAndEndsAtTheFallingEdge) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  AddSwitch(card, motion::DiType::kHome, 4000, 6000);
  Cells cells = Example(card);
  cells[16] = 250;  // homeOffset
  ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
  EXPECT_EQ(Status(card)[0], 1);
  EXPECT_EQ(Status(card)[1], 20);
  for (int i = 0; i < 200; ++i) card.motion.Tick();
  EXPECT_NEAR(card.motion.state().profiles[0].now.position, 125, 1e-9);
  EXPECT_NEAR(card.motion.state().profiles[0].now.velocity, 5, 1e-9);
  RunToEnd(card);
  EXPECT_EQ(Status(card), (Cells{0, 100, 0, 0, 6000, 6250}));
  EXPECT_EQ(card.motion.state().encoders[0].position, 6250);
}

TEST(GoHome, FailsWhenTheSearchDistanceIsPassed) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  Cells cells = Example(card);
  ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
  RunToEnd(card);
  EXPECT_EQ(Status(card)[2], 8);
  EXPECT_EQ(card.motion.state().profiles[0].now.position, 200000);
}

TEST(GoHome, EveryModeEndsAtItsOrigin) {
  struct {
    double mode, edge, captured;
  } const cases[] = {{11, 1, 6000}, {13, 1, 4000}, {12, 0, 18000}, {20, 1, 4000},
                     {22, 1, 5000}, {30, 0, 1000}, {40, 1, 4000},  {41, 1, 5000}};
  for (const auto& c : cases) {
    CommandTestCard card;
    ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
    card.motion.SetIndexMarks(0, {.offset = 0, .period = 1000});
    AddSwitch(card, motion::DiType::kHome, 4000, 6000);
    AddSwitch(card, motion::DiType::kLimitPositive, 18000, 1e9);
    Cells cells = Example(card);
    cells[0] = c.mode;
    cells[3] = c.edge;
    if (c.mode == 12 || c.mode == 13) cells[2] = -1;
    ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0) << c.mode;
    RunToEnd(card);
    EXPECT_EQ(Status(card)[2], 0) << c.mode;
    EXPECT_EQ(Status(card)[1], 100) << c.mode;
    if (c.mode == 13) {
      EXPECT_EQ(Status(card)[4], 5000);
    } else {
      EXPECT_EQ(Status(card)[4], c.captured) << c.mode;
    }
    EXPECT_EQ(card.motion.state().profiles[0].now.position, Status(card)[4]) << c.mode;
  }
}

TEST(GoHome, EndsAtTheSamePlaceWithAnInputShaper) {
  for (const int count : {0, 250}) {
    CommandTestCard card;
    ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
    ASSERT_EQ(card.Call("GT_SetAxisInputShaping", {1, count > 0 ? 1 : 0, count, 0.8}), 0);
    card.motion.SetIndexMarks(0, {.offset = 0, .period = 1000});
    AddSwitch(card, motion::DiType::kHome, 4300, 6000);
    Cells cells = Example(card);
    cells[0] = 22;
    cells[3] = 1;
    ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
    RunToEnd(card);
    EXPECT_EQ(Status(card)[2], 0) << count;
    // The motor is there at once when homing has ended.
    EXPECT_EQ(card.motion.state().plants[0].position, 5000) << count;
    EXPECT_EQ(card.Call("GT_ZeroPos", {1, 1}), 0);
    EXPECT_EQ(card.motion.state().encoders[0].position, 0) << count;
  }
}

TEST(GoHome, LimitModeComesBackSlowly) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  AddSwitch(card, motion::DiType::kLimitPositive, 18000, 1e9);
  Cells cells = Example(card);
  cells[0] = 10;
  ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
  RunToEnd(card);
  EXPECT_EQ(Status(card)[1], 100);
  // At 1 pulse/ms the filter's three cycles of 250 us are one pulse.
  EXPECT_NEAR(Status(card)[4], 18000, 2);
}

TEST(GoHome, ForcedHomeTurnsAtTheLimit) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  AddSwitch(card, motion::DiType::kHome, -6000, -4000);
  AddSwitch(card, motion::DiType::kLimitPositive, 3000, 1e9);
  Cells cells = Example(card);
  cells[0] = 40;
  cells[3] = 1;
  ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
  RunToEnd(card);
  EXPECT_EQ(Status(card), (Cells{0, 100, 0, 0, -4000, -4000}));
}

TEST(GoHome, AStopFromOutsideIsError4) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  Cells cells = Example(card);
  ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
  for (int i = 0; i < 100; ++i) card.motion.Tick();
  ASSERT_EQ(card.Call("GT_Stop", {1, 0}), 0);
  RunToEnd(card);
  EXPECT_EQ(Status(card)[2], 4);
}

TEST(GoHome, RefusalsAreErrorsOfTheStatusToo) {
  CommandTestCard card;
  Cells cells = Example(card);
  EXPECT_EQ(card.Call("GT_GoHome", {1, &cells}), 1);
  EXPECT_EQ(Status(card)[2], 2);
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  cells[0] = 21;
  EXPECT_EQ(card.Call("GT_GoHome", {1, &cells}), 7);
  EXPECT_EQ(Status(card)[2], 6);
  cells[0] = 20;
  ASSERT_EQ(card.Call("GT_PrfJog", {1}), 0);
  EXPECT_EQ(card.Call("GT_GoHome", {1, &cells}), 1);
  EXPECT_EQ(Status(card)[2], 1);
}

TEST(GoHome, AnAlarmIsError3) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  Cells cells = Example(card);
  ChangeState(card.motion).axes[0].latched |= motion::kAlarmBit;
  EXPECT_EQ(card.Call("GT_GoHome", {1, &cells}), 1);
  EXPECT_EQ(Status(card)[2], 3);
}

TEST(GoHome, NoIndexWithinItsDistanceIsError10) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.motion.SetIndexMarks(0, {.offset = 30001, .period = 1e6});
  Cells cells = Example(card);
  cells[0] = 30;
  ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
  EXPECT_EQ(Status(card)[1], 30);
  RunToEnd(card);
  EXPECT_EQ(Status(card)[2], 10);
  EXPECT_EQ(card.motion.state().profiles[0].now.position, 30000);
}

TEST(GoHome, AnEncoderWithoutMarksIsSearchedToTheEnd) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.motion.SetIndexMarks(0, {.offset = 0, .period = 0});
  Cells cells = Example(card);
  cells[0] = 30;
  ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
  RunToEnd(card);
  EXPECT_EQ(Status(card)[2], 10);
  EXPECT_EQ(card.motion.state().profiles[0].now.position, 30000);
}

TEST(GoHome, AnInactiveEncoderIsError9) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  ChangeState(card.motion).encoders[0].active = false;
  Cells cells = Example(card);
  cells[0] = 30;
  ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
  RunToEnd(card);
  EXPECT_EQ(Status(card)[2], 9);
}

TEST(GoHome, EndsAtTheSwitchWhateverPositionsAreCalled) {
  // The switch's falling edge is at position 6000 of the machine, which is at 0; homeOffset is 250.
  struct Case {
    std::string_view name, command;
    std::vector<Argument> arguments;
    double machine, captured, profile;
  };
  const Case cases[] = {
      {"as it is", "GT_ProfileScale", {1, 1, 1}, 6250, 6000, 6250},
      {"two of the profile for one of the axis", "GT_ProfileScale", {1, 2, 1}, 6125, 6000, 12250},
      {"the profile counts the other way", "GT_ProfileScale", {1, -1, 1}, 5750, 6000, -5750},
      {"a set profile position", "GT_SetPrfPos", {1, 1000}, 6250, 6000, 7250},
      {"a set encoder position", "GT_SetEncPos", {1, -3000}, 6250, 3000, 6250},
  };
  for (const Case& c : cases) {
    CommandTestCard card;
    ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
    AddSwitch(card, motion::DiType::kHome, 4000, 6000);
    ASSERT_EQ(card.Call(c.command, c.arguments), 0) << c.name;
    Cells cells = Example(card);
    cells[16] = 250;
    if (c.profile < 0) cells[1] = -1;
    ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0) << c.name;
    RunToEnd(card);
    EXPECT_EQ(Status(card)[2], 0) << c.name;
    EXPECT_EQ(Status(card)[4], c.captured) << c.name;
    EXPECT_EQ(card.motion.state().profiles[0].now.position, c.profile) << c.name;
    EXPECT_EQ(card.motion.state().plants[0].position, c.machine) << c.name;
  }
}

TEST(GoHome, RunIs1UntilTheAxisRests) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  Cells cells = Example(card);
  ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
  for (int i = 0; i < 400; ++i) card.motion.Tick();
  ASSERT_EQ(card.Call("GT_SetStopDec", {1, 0.1, 10}), 0);
  ASSERT_EQ(card.Call("GT_Stop", {1, 0}), 0);
  // 5 pulse/ms at 0.1 pulse/ms^2: 50 ms.
  EXPECT_NEAR(RunToEnd(card), 200, 2);
  EXPECT_EQ(Status(card)[2], 4);
  EXPECT_FALSE(card.motion.state().profiles[0].now.moving);
}

TEST(GoHome, NothingElseCommandsTheAxisMeanwhile) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  Cells cells = Example(card);
  ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
  card.motion.Tick();
  card.Expect(1, "GT_SetPos", {1, 100});
  EXPECT_EQ(card.reason.en, "axis 1 is homing, wait until it is done or call GT_Stop");
  card.Expect(1, "GT_SetVel", {1, 100.0});
  card.Expect(1, "GT_Update", {1});
  card.Expect(1, "GT_PrfJog", {1});
  card.Expect(0, "GT_SetPos", {2, 100});
  ASSERT_EQ(card.Call("GT_Stop", {1, 1}), 0);
  RunToEnd(card);
  card.Expect(0, "GT_SetPos", {1, 100});
  card.Expect(0, "GT_Update", {1});
}

TEST(GoHome, TheLastWayIsSlowUnlessPad1SaysFast) {
  for (const bool fast : {false, true}) {
    CommandTestCard card;
    ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
    AddSwitch(card, motion::DiType::kHome, 4000, 6000);
    Cells cells = Example(card);
    cells[5] = fast ? 1 : 0;
    cells[16] = 5000;
    ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
    double fastest = 0;
    while (Status(card)[0] == 1) {
      card.motion.Tick();
      if (Status(card)[1] == 80) {
        fastest = std::max(fastest, card.motion.state().profiles[0].now.velocity);
      }
    }
    EXPECT_NEAR(fastest, fast ? 5 : 1, 1e-9);
    EXPECT_EQ(card.motion.state().profiles[0].now.position, 11000);
  }
}

TEST(GoHome, LeavesASwitchItStandsOnWhenAskedTo) {
  // On the switch, searching forwards for its rising edge at 4000: the escape of 1000 is backwards.
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.motion.PlaceMotor(0, 4500);
  AddSwitch(card, motion::DiType::kHome, 4000, 6000);
  for (int i = 0; i < 3; ++i) card.motion.Tick();  // to pass the input's filter
  Cells cells = Example(card);
  cells[3] = 1;
  cells[14] = 1;
  ASSERT_EQ(card.Call("GT_GoHome", {1, &cells}), 0);
  card.motion.Tick();
  EXPECT_EQ(Status(card)[1], 2);
  RunToEnd(card);
  EXPECT_EQ(Status(card)[2], 0);
  // The encoder was set to 0 at 4500.
  EXPECT_EQ(card.motion.state().encoders[0].position, -500);
}

TEST(GoHome, MembersAreChecked) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  const uint64_t before = card.Hash();
  for (const auto& [cell, value] : {std::pair<size_t, double>{1, 0},
                                    {3, 2},
                                    {4, 9},
                                    {8, 0},
                                    {9, 0},
                                    {10, 0},
                                    {11, -1},
                                    {12, 51},
                                    {17, -1},
                                    {18, -1},
                                    {19, -1}}) {
    Cells cells = Example(card);
    cells[cell] = value;
    EXPECT_EQ(card.Call("GT_GoHome", {1, &cells}), 7) << cell;
  }
  EXPECT_EQ(card.Hash(), before);
}

// --- Simple homing -------------------------------------------------------------------------------

int RunSimply(CommandTestCard& card) {
  Cells done(1);
  int ticks = 0;
  while (card.motion.state().homing[0].running && ticks < 1000000) {
    card.motion.Tick();
    ++ticks;
  }
  EXPECT_EQ(card.Call("GT_HomeSts", {1, &done}), 0);
  return static_cast<int>(done[0]);
}

TEST(SimpleHome, GoesToTheSwitchAndTheOffset) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  AddSwitch(card, motion::DiType::kHome, 4000, 6000);
  card.Expect(1, "GT_Home", {1, 100000, 10.0, 1.0, 100});  // not prepared
  card.Expect(0, "GT_HomeInit");
  card.Expect(7, "GT_Home", {1, 100000, 0.0, 1.0, 100});
  card.Expect(7, "GT_Home", {1, 100000, 10.0, 0.0, 100});
  card.Expect(1, "GT_Home", {2, 100000, 10.0, 1.0, 100});  // not enabled
  card.Expect(0, "GT_Home", {1, 100000, 10.0, 1.0, 100});
  EXPECT_EQ(RunSimply(card), 1);
  // The falling edge is at the end of the switch.
  EXPECT_NEAR(card.motion.state().profiles[0].now.position, 6100, 1);
}

TEST(SimpleHome, StopsBehindTheSwitch) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  AddSwitch(card, motion::DiType::kHome, 4000, 6000);
  card.Expect(0, "GT_HomeInit");
  card.Expect(0, "GT_HomeStop", {1, 100000, 10.0, 1.0});
  EXPECT_EQ(RunSimply(card), 1);
  // 10 pulse/ms at 1 pulse/ms^2: 50 pulses, starting within a cycle.
  EXPECT_NEAR(card.motion.state().profiles[0].now.position, 6050, 3);
}

TEST(SimpleHome, EndsWithStatus2AtTheSearchPosition) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.Expect(0, "GT_HomeInit");
  card.Expect(0, "GT_Home", {1, 5000, 10.0, 1.0, 100});
  EXPECT_EQ(RunSimply(card), 2);
  EXPECT_EQ(card.motion.state().profiles[0].now.position, 5000);
  card.Expect(0, "GT_HomeInit");
  EXPECT_EQ(RunSimply(card), 0);
}

TEST(SimpleHome, AnIndexSearchSetUpBeforeItFollowsTheSwitch) {
  // The home switch's falling edge at 60000, its offset 2000; the next index mark within 20000
  // after it, at 66123, and its offset 2000.
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.motion.SetIndexMarks(0, {.offset = 6123, .period = 10000});
  AddSwitch(card, motion::DiType::kHome, 58000, 60000);
  card.Expect(0, "GT_HomeInit");
  card.Expect(0, "GT_Index", {1, 20000, 2000});
  EXPECT_FALSE(card.motion.state().profiles[0].now.moving);
  card.Expect(0, "GT_Home", {1, 200000, 10.0, 0.5, 2000});
  double fastest = 0;
  Cells done(1);
  while (done[0] == 0) {
    card.motion.Tick();
    EXPECT_EQ(card.Call("GT_HomeSts", {1, &done}), 0);
    const motion::Sample& now = card.motion.state().profiles[0].now;
    if (now.position > 62500) fastest = std::max(fastest, now.velocity);
  }
  EXPECT_EQ(done[0], 1);
  EXPECT_EQ(card.motion.state().profiles[0].now.position, 68123);
  EXPECT_NEAR(fastest, 5, 1e-9);
}

TEST(SimpleHome, AnIndexThatIsNotFoundEndsWithStatus2) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  card.motion.SetIndexMarks(0, {.offset = 9000, .period = 100000});
  AddSwitch(card, motion::DiType::kHome, 4000, 6000);
  card.Expect(0, "GT_HomeInit");
  card.Expect(0, "GT_Index", {1, 2000, 0});
  card.Expect(0, "GT_Home", {1, 200000, 10.0, 0.5, 500});
  EXPECT_EQ(RunSimply(card), 2);
  EXPECT_EQ(card.motion.state().profiles[0].now.position, 8500);
}

TEST(SimpleHome, IndexFollowsAtHalfTheVelocity) {
  CommandTestCard card;
  ASSERT_EQ(card.Call("GT_AxisOn", {1}), 0);
  AddSwitch(card, motion::DiType::kHome, 4000, 6000);
  card.Expect(0, "GT_HomeInit");
  card.Expect(0, "GT_Home", {1, 100000, 10.0, 1.0, 0});
  RunSimply(card);
  card.Expect(0, "GT_Index", {1, 100000, 0});
  EXPECT_EQ(RunSimply(card), 1);
  EXPECT_NEAR(card.motion.state().profiles[0].now.position, 10000, 1);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
