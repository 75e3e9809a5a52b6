// Servo controllers of the SV card: U = Kp E + Kd (E - E1) + Ki sum(E) / 256 + Kvff v + Kaff a +
// bias within the limit of the output, once in each sample time. Source: GT manual 3.2.3.
#include <gtest/gtest.h>

#include <limits>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

/// Axis 1 in closed loop with a motor that does not turn; all gains are 0.
class StalledCard : public Gt400TestCard {
 public:
  StalledCard() {
    Do("GT_AxisOn");
    ChangeState(motion).plants[0].stalled = true;
  }
  /// The motor stays 100 pulses behind the plan.
  void Lag() {
    MoveT(100, 10, 1);
    RunToRest();
    EXPECT_EQ(Read("GT_GetAtlErr"), 100);
  }
  void SetAndUpdate(std::string_view name, double value) {
    Do(name, {value});
    Do("GT_Update");
  }
  double Output() const { return motion.state().dacs[0].Output(); }
};

TEST(Gt400Servo, MultipliesTheErrorAndAddsTheBiasWithinTheLimit) {
  const struct {
    std::vector<std::pair<const char*, double>> registers;
    double output;
  } cases[] = {
      {{{"GT_SetKp", 20}}, 2000},
      {{{"GT_SetKpEx", 0.5}}, 50},
      {{{"GT_SetKp", 20}, {"GT_SetMtrBias", 10}}, 2010},
      {{{"GT_SetKp", 20}, {"GT_SetMtrBias", -3000}}, -1000},
      {{{"GT_SetKp", 20}, {"GT_SetMtrLmt", 1500}}, 1500},
      {{{"GT_SetKp", 20}, {"GT_SetMtrBias", -3000}, {"GT_SetMtrLmt", 400}}, -400},
      {{{"GT_SetMtrLmt", 0}, {"GT_SetMtrBias", 30}}, 0},
  };
  for (const auto& c : cases) {
    StalledCard card;
    card.Lag();
    for (const auto& [name, value] : c.registers) card.Do(name, {value});
    card.Run(2);
    EXPECT_EQ(card.Output(), 0) << "the registers wait";
    card.Do("GT_Update");
    card.Cycle();
    EXPECT_EQ(card.Output(), c.output) << c.registers[0].first;
  }
}

TEST(Gt400Servo, AddsUpTheErrorWithinItsLimit) {
  StalledCard card;
  card.Lag();
  card.SetAndUpdate("GT_SetILmt", 0);
  EXPECT_EQ(card.Read("GT_GetIntgr"), 0);
  card.Do("GT_SetILmt", {1050});
  card.SetAndUpdate("GT_SetKi", 128);
  for (const double sum : {100, 200, 300}) {
    card.Cycle();
    EXPECT_EQ(card.Read("GT_GetIntgr"), sum);
    EXPECT_EQ(card.Output(), sum / 2);
  }
  card.SetAndUpdate("GT_SetKiEx", 25.6);
  card.Run(10);
  EXPECT_EQ(card.Read("GT_GetIntgr"), 1050);
  EXPECT_EQ(card.Output(), 105);
}

// GT manual 3.2.3: a limit of 0 clears the sum.
TEST(Gt400Servo, ForgetsTheSumWhenItsLimitIsZero) {
  StalledCard card;
  card.Lag();
  card.Do("GT_AxisOff");
  const double sum = card.Read("GT_GetIntgr");
  EXPECT_GT(sum, 0);
  card.Do("GT_SetILmt", {0});
  EXPECT_EQ(card.Read("GT_GetIntgr"), sum);
  card.Do("GT_Update");
  EXPECT_EQ(card.Read("GT_GetIntgr"), 0);
}

// The plan accelerates by 0.5 to 4 pulse/ST in 8 ST. The error grows as fast as it moves; at the
// end of the fourth sample time it is that of its beginning, 2.25 pulses after 1.
TEST(Gt400Servo, FeedsForwardThePlan) {
  const struct {
    const char* name;
    double value;
    double accelerating;
    double moving;
  } cases[] = {{"GT_SetKvff", 100, 200, 400}, {"GT_SetKvffEx", 12.5, 25, 50},
               {"GT_SetKaff", 1000, 500, 0},  {"GT_SetKaffEx", 1001.5, 500.75, 0},
               {"GT_SetKd", 10, 12.5, 40},    {"GT_SetKdEx", 0.25, 0.3125, 1}};
  for (const auto& c : cases) {
    StalledCard card;
    card.SetAndUpdate(c.name, c.value);
    card.Do("GT_PrflV");
    card.Do("GT_SetVel", {4});
    card.Do("GT_SetAcc", {0.5});
    card.Do("GT_Update");
    card.Run(4);
    EXPECT_NEAR(card.Output(), c.accelerating, 0.5) << c.name;
    card.Run(20);
    EXPECT_EQ(card.Output(), c.moving) << c.name;
  }
}

TEST(Gt400Servo, KeepsTheValuesOfItsRegisters) {
  const struct {
    const char* set;
    const char* get;
    std::vector<double> values;
    std::vector<double> refused;
    double at_power_on;
  } cases[] = {
      {"GT_SetKp", "GT_GetKp", {0, 32767}, {32768}, 0},
      {"GT_SetKi", "GT_GetKi", {0, 32767}, {32768}, 0},
      {"GT_SetKd", "GT_GetKd", {0, 32767}, {65535}, 0},
      {"GT_SetKvff", "GT_GetKvff", {0, 32767}, {32768}, 0},
      {"GT_SetKaff", "GT_GetKaff", {0, 32767}, {32768}, 0},
      {"GT_SetKpEx", "GT_GetKp", {0, 2.5, 32767}, {-0.1, 32767.1}, 0},
      {"GT_SetKiEx", "GT_GetKi", {0, 2.5, 32767}, {-0.1, 32767.1}, 0},
      {"GT_SetKdEx", "GT_GetKd", {0, 2.5, 32767}, {-0.1, 32767.1}, 0},
      {"GT_SetKvffEx", "GT_GetKvff", {0, 2.5, 32767}, {-0.1, 32767.1}, 0},
      {"GT_SetKaffEx", "GT_GetKaff", {0, 2.5, 32767}, {-0.1, 32767.1}, 0},
      {"GT_SetILmt", "GT_GetILmt", {0, 32766}, {32768}, 32767},
      {"GT_SetMtrLmt", "GT_GetMtrLmt", {0, 32766}, {32768}, 32767},
      {"GT_SetMtrBias", "GT_GetMtrBias", {-32768, 32767}, {}, 0},
      {"GT_SetPosErr", "GT_GetPosErr", {0, 32766}, {32768}, 32767},
      {"GT_SetMtrCmd", "GT_GetMtrCmd", {-32767, 32767}, {-32768}, 0},
  };
  for (const auto& c : cases) {
    Gt400TestCard card;
    EXPECT_EQ(card.Read(c.get), c.at_power_on) << c.get;
    for (const double value : c.refused) {
      card.Refuses(kIllegal, c.set, {value});
      EXPECT_EQ(card.Read(c.get), c.at_power_on) << c.set << value;
    }
    for (const double value : c.values) {
      card.Do(c.set, {value});
      EXPECT_EQ(card.Read(c.get), value) << c.set;
    }
  }
}

TEST(Gt400Servo, IsOnTheSvCardOnly) {
  const std::string_view commands[] = {
#define COMMAND(number, name, ...) #name,
#include "gtcalls/gt400/servo.def"
#undef COMMAND
#undef TOPIC
  };
  for (const char* type : {"GT-400-SG", "GT-400-SE", "GT-400-SD", "GT-400-SP"}) {
    Gt400TestCard card(type);
    for (const std::string_view name : commands) card.Refuses(kIllegal, name, {0});
  }
}

// --- Open loop -------------------------------------------------------------------------------

TEST(Gt400OpenLoop, PutsOutWhatTheHostSays) {
  StalledCard card;
  card.Do("GT_SetMtrBias", {100});
  card.SetAndUpdate("GT_SetMtrLmt", 500);
  card.Cycle();
  EXPECT_EQ(card.Output(), 100);
  card.Do("GT_SetMtrCmd", {-2000});
  card.Cycle();
  EXPECT_EQ(card.Output(), 100) << "in closed loop the value is kept for later";
  EXPECT_EQ(card.Read("GT_GetMtrCmd"), -2000);
  card.Do("GT_OpenLp");
  EXPECT_EQ(card.Output(), -2000) << "without bias and limit";
  card.Do("GT_SetMtrCmd", {32767});
  card.SetAndUpdate("GT_SetMtrBias", 200);
  EXPECT_EQ(card.Output(), 32767);
  card.Do("GT_CloseLp");
  card.Cycle();
  EXPECT_EQ(card.Output(), 200);
}

// --- The position error ----------------------------------------------------------------------

TEST(Gt400PositionError, IsJudgedWithItsLimitInClosedLoop) {
  const struct {
    const char* setup;
    std::vector<double> values;
    bool error;
  } cases[] = {{"GT_CloseLp", {}, true}, {"GT_OpenLp", {}, false}, {"GT_CtrlMode", {1}, false}};
  for (const auto& c : cases) {
    StalledCard card;
    card.SetAndUpdate("GT_SetPosErr", 50);
    card.Do("GT_ClrSts");
    card.Lag();
    EXPECT_TRUE(card.StatusBit(4));
    card.Do(c.setup, c.values);
    card.Do("GT_ClrSts");
    card.Cycle();
    EXPECT_EQ(card.StatusBit(4), c.error) << c.setup;
  }
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
