// Analogue outputs and inputs through their commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

TEST(DacCommand, OutputsAreSetAndReadForConsecutiveChannels) {
  CommandTestCard card;
  std::vector<double> values = {32767, -32767, 5};
  EXPECT_EQ(card.Call("GT_SetDac", {6, &values, 3}), 0);
  std::vector<double> read(3);
  std::vector<double> clock(1);
  for (const char* name : {"GT_GetDac", "GT_GetDacValue"}) {
    EXPECT_EQ(card.Call(name, {6, &read, 3, &clock}), 0);
    EXPECT_EQ(read, values) << name;
  }
}

TEST(DacCommand, ChannelCountAndValueAreCheckedAtBothEnds) {
  CommandTestCard card;
  std::vector<double> values(8, 1);
  const uint64_t before = card.Hash();
  for (const auto& [dac, count, code] : {std::tuple{0, 1, 7}, {9, 1, 7}, {8, 2, 7}, {1, 0, 7}}) {
    EXPECT_EQ(card.Call("GT_SetDac", {dac, &values, count}), code) << dac << " " << count;
  }
  for (const double value : {-32769, 32768}) {
    values[1] = value;
    EXPECT_EQ(card.Call("GT_SetDac", {1, &values, 2}), 7) << value;
  }
  EXPECT_EQ(card.Hash(), before);
  for (const double value : {-32768, 32767}) {
    values[1] = value;
    EXPECT_EQ(card.Call("GT_SetDac", {1, &values, 2}), 0) << value;
  }
  // Below -10 V the output is limited.
  values[1] = -32768;
  EXPECT_EQ(card.Call("GT_SetDac", {1, &values, 2}), 0);
  EXPECT_EQ(card.Call("GT_GetDac", {2, &values, 1, nullptr}), 0);
  EXPECT_EQ(values[0], -32767);
}

TEST(DacCommand, AChannelOfAServoControllerIsRefused) {
  CommandTestCard card;
  ChangeState(card.motion).dacs[1].control = 1;
  std::vector<double> values = {1, 2};
  const uint64_t before = card.Hash();
  EXPECT_EQ(card.Call("GT_SetDac", {1, &values, 2}), 1);
  EXPECT_EQ(card.Hash(), before);
  EXPECT_EQ(card.Call("GT_SetDac", {1, &values, 1}), 0);
}

TEST(DacCommand, BiasAndLimitActOnTheOutput) {
  CommandTestCard card;
  std::vector<double> value = {1000};
  EXPECT_EQ(card.Call("GT_SetDac", {2, &value, 1}), 0);
  EXPECT_EQ(card.Call("GT_SetMtrBias", {2, -400}), 0);
  EXPECT_EQ(card.Call("GT_GetDac", {2, &value, 1, nullptr}), 0);
  EXPECT_EQ(value[0], 600);
  EXPECT_EQ(card.Call("GT_SetMtrLmt", {2, 500}), 0);
  EXPECT_EQ(card.Call("GT_GetDac", {2, &value, 1, nullptr}), 0);
  EXPECT_EQ(value[0], 500);
  EXPECT_EQ(card.Call("GT_GetMtrBias", {2, &value}), 0);
  EXPECT_EQ(value[0], -400);
  EXPECT_EQ(card.Call("GT_GetMtrLmt", {2, &value}), 0);
  EXPECT_EQ(value[0], 500);
}

TEST(DacCommand, BiasAndLimitAreCheckedAtBothEnds) {
  CommandTestCard card;
  for (const auto& [bias, code] : {std::pair{-32767, 0}, {32767, 0}, {-32768, 7}, {32768, 7}}) {
    EXPECT_EQ(card.Call("GT_SetMtrBias", {1, bias}), code) << bias;
  }
  for (const auto& [limit, code] : {std::pair{0, 0}, {32767, 0}, {-1, 7}, {32768, 7}}) {
    EXPECT_EQ(card.Call("GT_SetMtrLmt", {1, limit}), code) << limit;
  }
}

TEST(AdcCommand, ReadsVoltsAndConverterValues) {
  CommandTestCard card;
  ChangeState(card.motion).adcs[6].volts = 5;
  ChangeState(card.motion).adcs[7].volts = -12.5;
  card.Cycle();
  std::vector<double> read(2);
  EXPECT_EQ(card.Call("GT_GetAdcValue", {7, &read, 2, nullptr}), 0);
  EXPECT_EQ(read, (std::vector<double>{13107, -32768}));
  EXPECT_EQ(card.Call("GT_GetAdc", {7, &read, 2, nullptr}), 0);
  EXPECT_NEAR(read[0], 5, 0.0002);
  EXPECT_EQ(read[1], -12.5);
}

TEST(AdcCommand, ChannelAndCountAreCheckedAtBothEnds) {
  CommandTestCard card;
  std::vector<double> read(9);
  for (const auto& [adc, count, code] :
       {std::tuple{0, 1, 7}, {1, 8, 0}, {8, 1, 0}, {9, 1, 7}, {8, 2, 7}, {1, 0, 7}, {1, 9, 7}}) {
    EXPECT_EQ(card.Call("GT_GetAdc", {adc, &read, count, nullptr}), code) << adc << " " << count;
    EXPECT_EQ(card.Call("GT_GetAdcValue", {adc, &read, count, nullptr}), code);
  }
}

TEST(AdcCommand, TheFilterSlowsTheInput) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_SetAdcFilter", {1, 2}), 0);
  ChangeState(card.motion).adcs[0].volts = 10;
  card.Cycle();
  std::vector<double> read(1);
  EXPECT_EQ(card.Call("GT_GetAdcValue", {1, &read, 1, nullptr}), 0);
  EXPECT_EQ(read[0], 13107);  // half of the change
  for (const auto& [time, code] : {std::pair{-1, 7}, {0, 0}, {32767, 0}, {32768, 7}}) {
    EXPECT_EQ(card.Call("GT_SetAdcFilter", {1, time}), code) << time;
  }
}

}  // namespace
}  // namespace oncard::gtcalls::gts
