// Units of axes ([[world.axis]] unit): 1000 pulses are a millimetre, so that 20 pulse/ms are 20
// mm/s and 0.5 pulse/ms^2 are 500 mm/s^2.
#include "runtime/sim/axis_unit.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "runtime/observe/plot.h"
#include "runtime/observe/trace.h"
#include "runtime/scenario/run/requirement_watch.h"
#include "runtime/scenario/run/scenario_card.h"
#include "tests/runtime/scenario_support.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kMillimetres =
    "[[world.axis]]\naxis = 1\nunit = \"mm\"\npulses_per_unit = 1000\n";

/// Jogs axis 1 with 20 pulse/ms and 0.5 pulse/ms^2, and axis 2 with 4 pulse/ms: they are fast after
/// 40 and 8 ms.
constexpr const char* kTwoJogs =
    "int f()\n{\n  TJogPrm jog;\n  jog.acc = 0.5;\n  jog.dec = 0.5;\n  jog.smooth = 0;\n"
    "  GT_AxisOn(1);\n  GT_PrfJog(1);\n  GT_SetJogPrm(1, &jog);\n  GT_SetVel(1, 20);\n"
    "  GT_AxisOn(2);\n  GT_PrfJog(2);\n  GT_SetJogPrm(2, &jog);\n  GT_SetVel(2, 4);\n"
    "  GT_Update(3);\n  return 0;\n}\n";

TEST(AxisUnit, VelocitiesArePerSecond) {
  const AxisUnit mm = {"mm", 2000};
  EXPECT_EQ(mm.ToPulses(12.5, AxisMeasure::kPosition), 25000);
  EXPECT_EQ(mm.ToPulses(10, AxisMeasure::kVelocity), 20);
  EXPECT_EQ(mm.ToPulses(250, AxisMeasure::kAcceleration), 0.5);
  EXPECT_EQ(mm.FromPulses(25000, AxisMeasure::kPosition), 12.5);
  EXPECT_EQ(mm.FromPulses(20, AxisMeasure::kVelocity), 10);
  EXPECT_EQ(mm.FromPulses(0.5, AxisMeasure::kAcceleration), 250);
  EXPECT_EQ(mm.NameOf(AxisMeasure::kAcceleration), "mm/s²");
  const AxisUnit pulses;
  EXPECT_EQ(pulses.ToPulses(0.1, AxisMeasure::kVelocity), 0.1);
  EXPECT_EQ(pulses.FromPulses(0.1, AxisMeasure::kVelocity), 0.1);
}

TEST(AxisUnits, ConditionsAreInThem) {
  const ScenarioResult result = RunForTest(
      kTwoJogs, std::string("until_ms = 30\nexpect = [\"axis1.prfAcc == 500 +- 0.001 @ 20ms\", "
                            "\"axis1.prfVel == 10 +- 0.2 @ 20ms\", "
                            "\"axis2.prfVel == 4 @ 20ms\", \"axis1.prfPos == 0 @ 30ms\", "
                            "\"axis2.prfPos == 0 @ 30ms\"]\n") +
                    kMillimetres);
  ASSERT_EQ(result.failures.size(), 2u);
  EXPECT_THAT(result.failures[0].message.en, testing::MatchesRegex("axis1.prfPos is 0.2[0-9]* mm"));
  EXPECT_THAT(result.failures[1].message.en,
              testing::MatchesRegex("axis2.prfPos is [0-9]+[.][0-9]+"));
}

TEST(AxisUnits, ChangeNothingThatTheCardComputes) {
  RunOptions options;
  options.show = {"axis1.prfPos", "axis1.prfVel"};
  const ScenarioResult pulses = RunForTest(kTwoJogs, "until_ms = 60\n", options);
  const ScenarioResult mm =
      RunForTest(kTwoJogs, std::string("until_ms = 60\n") + kMillimetres, options);
  EXPECT_EQ(mm.hash, pulses.hash);
  EXPECT_EQ(pulses.values[1].elements.front(), "20.0");
  EXPECT_EQ(pulses.values[1].unit, "");
  EXPECT_EQ(mm.values[0].unit, "mm");
  EXPECT_EQ(mm.values[1].elements.front(), "20.0");
  EXPECT_EQ(mm.values[1].unit, "mm/s");
}

TEST(AxisUnits, TracesNameThem) {
  RunOptions options;
  options.trace = true;
  const ScenarioResult result =
      RunForTest(kTwoJogs,
                 std::string("until_ms = 60\ntrace = [\"axis1.prfPos\", \"axis2.prfPos\", "
                             "\"axis1.prfVel\", \"axis2.prfVel\"]\n") +
                     kMillimetres,
                 options);
  const auto text = [&](const TextSource& source) {
    std::string written;
    source([&](std::string_view part) { written += part; });
    return written;
  };
  const std::string csv = text(std::bind_front(&Trace::WriteCsv, &*result.trace));
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "time_ms,axis1.prfPos [mm],axis2.prfPos,axis1.prfVel [mm/s],axis2.prfVel");
  // They start at 0.25 ms: 400 pulses in 40 ms and 20 in each of 19.75 more; 16 pulses in 8 ms and
  // 4 in each of 51.75.
  EXPECT_THAT(csv, HasSubstr("\n60,0.795,223.0,20.0,4.0\n"));
  EXPECT_THAT(text(std::bind_front(&Trace::WriteVcd, &*result.trace)),
              HasSubstr(" prfPos $end\n$comment axis1.prfPos [mm] $end\n"));
}

// Of curves with different units each says its own.
TEST(AxisUnits, PicturesNameThem) {
  const auto script = [](const std::string& columns) {
    RunOptions options;
    options.trace = true;
    const ScenarioResult result =
        RunForTest(kTwoJogs, "until_ms = 60\ntrace = [" + columns + "]\n" + kMillimetres, options);
    return PlotScript(*result.trace, {"t", PictureFormat::kSvg}).value();
  };
  const std::string one = script("\"axis1.prfVel\"");
  EXPECT_THAT(one, HasSubstr("'velocity [mm/s]'"));
  EXPECT_THAT(one, Not(HasSubstr("axis1.prfVel [")));
  const std::string both = script("\"axis1.prfVel\", \"axis2.prfVel\"");
  EXPECT_THAT(both, HasSubstr("'velocity'"));
  EXPECT_THAT(both, HasSubstr("axis1.prfVel [mm/s]"));
  EXPECT_THAT(both, HasSubstr("axis2.prfVel [pulse/ms]"));
  EXPECT_THAT(script("\"axis2.prfVel\""), HasSubstr("'velocity [pulse/ms]'"));
}

TEST(AxisUnits, TheWorldOfTheAxisIsInThem) {
  const char* rest =
      "[[world.switch]]\naxis = 1\nfrom = {0}\nto = {1}\n[[world.move]]\nswitch = 1\nto = {1}\n"
      "at_ms = 5\n[[world.fault]]\nkind = \"slip\"\naxis = 1\nvelocity = {2}\n";
  const std::string axis =
      "drive = \"velocity\"\ngain = {2}\nfriction = {2}\nposition = {0}\nindex_offset = {1}\n"
      "index_period = {1}\nmax_vel = {2}\nmax_acc = {3}\n";
  const auto written = [&](double from, double to, double velocity, double acceleration) {
    return fmt::format(fmt::runtime(axis + rest), from, to, velocity, acceleration);
  };
  const Scenario mm = ScenarioForTest(kMillimetres + written(12.5, 20, 500, 50'000));
  const Scenario pulses =
      ScenarioForTest("[[world.axis]]\naxis = 1\n" + written(12'500, 20'000, 500, 50));
  Controller one(CardOptions(mm));
  Controller other(CardOptions(pulses));
  ApplyWorld(mm, &one);
  ApplyWorld(pulses, &other);
  one.RunCycles(40);
  other.RunCycles(40);
  EXPECT_EQ(one.Hash(), other.Hash());
  EXPECT_EQ(one.motion().config().drive_limits[0].velocity, 500);
  EXPECT_EQ(one.motion().config().drive_limits[0].acceleration, 50);
  EXPECT_EQ(one.motion().state().plants[0].position, 12'500);
}

TEST(AxisUnits, WhatHoldsWithoutAKeyIsTheSame) {
  const std::string drive = "drive = \"velocity\"\n";
  const Scenario mm = ScenarioForTest(kMillimetres + drive);
  Controller one(CardOptions(mm));
  ApplyWorld(mm, &one);
  const Scenario pulses = ScenarioForTest("[[world.axis]]\naxis = 1\n" + drive);
  Controller other(CardOptions(pulses));
  ApplyWorld(pulses, &other);
  EXPECT_EQ(one.Hash(), other.Hash());
  const Scenario again = ParseScenario(FormatScenario(mm), "t.toml").value();
  EXPECT_EQ(again.world, mm.world);
  EXPECT_THAT(FormatScenario(mm), HasSubstr("unit = \"mm\"\npulses_per_unit = 1000\n"));
  EXPECT_THAT(FormatScenario(pulses), Not(HasSubstr("unit")));
}

struct UnitMistake {
  const char* keys;
  const char* message;
};

class AxisUnitMistakeTest : public testing::TestWithParam<UnitMistake> {};

TEST_P(AxisUnitMistakeTest, SaysWhatToDo) {
  const auto scenario = ParseScenario(
      std::string("program = \"p.c\"\n[[world.axis]]\naxis = 1\n") + GetParam().keys, "t.toml");
  ASSERT_FALSE(scenario.ok());
  EXPECT_THAT(scenario.error().message.en, HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Mistakes, AxisUnitMistakeTest,
    testing::Values(
        UnitMistake{"unit = \"mm\"\n",
                    "'pulses_per_unit' is missing: how many pulses are one 'unit'"},
        UnitMistake{"pulses_per_unit = 10\n", "t.toml:4:19: 'pulses_per_unit' needs a 'unit'"},
        UnitMistake{"unit = \"m m\"\npulses_per_unit = 10\n",
                    "t.toml:4:8: 'unit' must be the name of a unit of at most 16 bytes"},
        UnitMistake{"unit = 5\npulses_per_unit = 10\n", "'unit' must be a string"},
        UnitMistake{"unit = \"mm\"\npulses_per_unit = 0\n",
                    "'pulses_per_unit' must be a number from 0.001"},
        UnitMistake{"unit = \"mm\"\npulses_per_unit = 1000\nmax_vel = 40000\n",
                    "'max_vel' must be a number from 0.001 to 32767"},
        UnitMistake{"unit = \"mm\"\npulses_per_unit = 1000\n[[world.switch]]\naxis = 1\n"
                    "from = 3000000\n",
                    "'from' must be a number from -2147483.648 to 2147483.648"}));

TEST(AxisUnits, CardsThatCountCyclesHaveNone) {
  const auto scenario = ParseScenario(std::string("card = \"GT-400-SV\"\n") + kMillimetres,
                                      "t.toml", ScenarioUse::kHost);
  ASSERT_FALSE(scenario.ok());
  EXPECT_THAT(
      scenario.error().message.en,
      HasSubstr("t.toml:4:8: the card GT-400-SV counts velocities in cycles, so that axis 1 has no "
                "'unit': remove it, and give its numbers in pulses"));
}

}  // namespace
}  // namespace oncard::runtime
