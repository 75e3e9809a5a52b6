// What two threads can race for (runtime/observe/race_steps.h). Most cells are named in
// card_races_test.cc; here are those of coordinate systems, which only a host sets up.
#include "runtime/observe/race_steps.h"

#include <gtest/gtest.h>

#include "explore_programs.h"

namespace oncard::explore {
namespace {

using runtime::RaceStep;

/// Starts thread 0 with the only function of the program.
void StartOn(runtime::Controller* card, const CardModel& model) {
  EXPECT_TRUE(card->Load(model.image()->object).ok());
  EXPECT_EQ(card->machine().Bind(0, 1, 0), vm::kOk);
  EXPECT_EQ(card->machine().Run(0), vm::kOk);
}

/// What a command sets on a card whose coordinate system 1 has the axes 2 and 3.
std::vector<std::string> SetBy(const std::string& command) {
  const CardModel model = CardOf("int t0() {\n " + command + "\n}\n", "rate = 1000\n");
  runtime::Controller card;
  StartOn(&card, model);
  motion::CrdParameters parameters;
  parameters.dimension = 2;
  parameters.coordinates = {0, 1, 2};
  parameters.velocity_max = 100;
  parameters.acceleration_max = 1;
  card.motion().CrdAt(0).SetUp(parameters);
  std::vector<std::string> names;
  for (const auto& [kind, cell] : NextRaceSteps(card, 0, {})) {
    EXPECT_EQ(kind, RaceStep::Kind::kWrite);
    EXPECT_TRUE(runtime::IsSetByCommands(cell));
    names.push_back(runtime::NameOfCell(cell, model.image()->object).en);
  }
  return names;
}

using CellNames = std::vector<std::string>;

TEST(RaceStepsTest, AStartedCoordinateSystemTakesItsAxes) {
  EXPECT_EQ(SetBy("GT_CrdStart(1, 0);"), (CellNames{"coordinate system 1", "axis 2", "axis 3"}));
  EXPECT_EQ(SetBy("GT_CrdStart(2, 0);"), (CellNames{"coordinate system 2"}));
}

TEST(RaceStepsTest, AStopReachesCoordinateSystems) {
  EXPECT_EQ(SetBy("GT_Stop(1, 0);"), (CellNames{"axis 1"}));
  EXPECT_EQ(SetBy("GT_Stop(2, 0);"), (CellNames{"axis 2", "axis 3", "coordinate system 1"}));
  EXPECT_EQ(SetBy("GT_Stop(256, 0);"), (CellNames{"axis 2", "axis 3", "coordinate system 1"}));
  EXPECT_EQ(SetBy("GT_Stop(4097, 0);"),
            (CellNames{"axis 1", "axis 2", "axis 3", "coordinate system 1"}));
  EXPECT_EQ(SetBy("GT_Stop(8192, 0);"), (CellNames{"coordinate system 2"}));
  EXPECT_EQ(SetBy("GT_AxisOff(1);"), (CellNames{"axis 1", "output 1 of word 10"}));
}

TEST(RaceStepsTest, PositionsOfACoordinateSystemAreThoseOfItsAxes) {
  EXPECT_EQ(SetBy("GT_SynchAxisPos(256);"), (CellNames{"axis 2", "axis 3"}));
}

TEST(RaceStepsTest, TheServoOfAnAxisIsTheAxis) {
  EXPECT_EQ(SetBy("GT_SetPosErr(4, 9);"), (CellNames{"axis 4"}));
  EXPECT_EQ(SetBy("GT_EncOn(4);"), (CellNames{"axis 4"}));
}

TEST(RaceStepsTest, WhatIsNoAxisOrOutputIsNotSet) {
  EXPECT_EQ(SetBy("GT_SetDataPage(1);"), CellNames{});
  EXPECT_EQ(SetBy("GT_Delay(3);"), CellNames{});
}

// The other thread may acquire what this one has written.
TEST(RaceStepsTest, AStatementReleasesWhenItHasDoneAllElse) {
  const CardModel model =
      CardOf("int flag, n;\nint t0() {\n GT_GetSoftLimit(1, &flag, &n);\n}\n", "rate = 1000\n");
  runtime::Controller card;
  StartOn(&card, model);
  const std::vector<RaceStep> steps = NextRaceSteps(card, 0, {true});
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].kind, RaceStep::Kind::kWrite);
  EXPECT_EQ(runtime::NameOfCell(steps[0].cell, model.image()->object).en, "n");
  EXPECT_EQ(steps[1].kind, RaceStep::Kind::kRelease);
  EXPECT_EQ(runtime::NameOfCell(steps[1].cell, model.image()->object).en, "flag");
}

}  // namespace
}  // namespace oncard::explore
