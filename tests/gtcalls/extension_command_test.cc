// Extension modules through their commands.
#include <gtest/gtest.h>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

TEST(ExtensionCommand, DigitalOutputsAreWrittenByWordAndByBit) {
  CommandTestCard card;
  const auto& module = card.motion.state().modules[15];
  EXPECT_EQ(card.Call("GT_SetExtIoValue", {15, 0xA5A5}), 0);
  EXPECT_EQ(module.outputs, 0xA5A5);
  EXPECT_EQ(card.Call("GT_SetExtIoBit", {15, 1, 1}), 0);
  EXPECT_EQ(card.Call("GT_SetExtIoBit", {15, 15, 0}), 0);
  EXPECT_EQ(module.outputs, 0x25A7);
}

TEST(ExtensionCommand, DigitalInputsAreReadByWordAndByBit) {
  CommandTestCard card;
  card.motion.module(0).inputs = 0x8001;
  std::vector<double> value(1);
  EXPECT_EQ(card.Call("GT_GetExtIoValue", {0, &value}), 0);
  EXPECT_EQ(value[0], 0x8001);
  for (const auto& [bit, level] : {std::pair{0, 1}, {1, 0}, {15, 1}}) {
    EXPECT_EQ(card.Call("GT_GetExtIoBit", {0, bit, &value}), 0);
    EXPECT_EQ(value[0], level) << bit;
  }
}

TEST(ExtensionCommand, AnalogueChannelsConvert) {
  CommandTestCard card;
  auto& module = card.motion.module(3);
  EXPECT_EQ(card.Call("GT_SetExtDaVoltage", {3, 7, -2.5}), 0);
  EXPECT_EQ(module.output_volts[7], -2.5);
  EXPECT_EQ(card.Call("GT_SetExtDaValue", {3, 0, 65535}), 0);
  EXPECT_EQ(module.output_volts[0], 10);
  module.input_volts[2] = 10;
  std::vector<double> value(1);
  EXPECT_EQ(card.Call("GT_GetExtAdValue", {3, 2, &value}), 0);
  EXPECT_EQ(value[0], 65535);
  module.input_volts[2] = 1;
  EXPECT_EQ(card.Call("GT_GetExtAdVoltage", {3, 2, &value}), 0);
  EXPECT_NEAR(value[0], 1, 10.0 / 65535);
}

TEST(ExtensionCommand, NumbersAreCheckedAtBothEnds) {
  CommandTestCard card;
  std::vector<double> value(1);
  for (const auto& [module, code] : {std::pair{-1, 7}, {0, 0}, {15, 0}, {16, 7}}) {
    EXPECT_EQ(card.Call("GT_SetExtIoValue", {module, 0}), code) << module;
    EXPECT_EQ(card.Call("GT_GetStsExtMdl", {module, 0, &value}), code) << module;
  }
  for (const auto& [bit, code] : {std::pair{-1, 7}, {0, 0}, {15, 0}, {16, 7}}) {
    EXPECT_EQ(card.Call("GT_SetExtIoBit", {0, bit, 1}), code) << bit;
    EXPECT_EQ(card.Call("GT_GetExtIoBit", {0, bit, &value}), code) << bit;
  }
  for (const auto& [channel, code] : {std::pair{-1, 7}, {0, 0}, {7, 0}, {8, 7}}) {
    EXPECT_EQ(card.Call("GT_GetExtAdValue", {0, channel, &value}), code) << channel;
    EXPECT_EQ(card.Call("GT_GetExtAdVoltage", {0, channel, &value}), code) << channel;
    EXPECT_EQ(card.Call("GT_SetExtDaValue", {0, channel, 1}), code) << channel;
    EXPECT_EQ(card.Call("GT_SetExtDaVoltage", {0, channel, 1}), code) << channel;
  }
  for (const auto& [volts, code] : {std::pair{-10.0, 0}, {10.0, 0}, {-10.01, 7}, {10.01, 7}}) {
    EXPECT_EQ(card.Call("GT_SetExtDaVoltage", {0, 0, volts}), code) << volts;
  }
  for (const auto& [level, code] : {std::pair{-1, 7}, {0, 0}, {1, 0}, {2, 7}}) {
    EXPECT_EQ(card.Call("GT_SetExtIoBit", {0, 0, level}), code) << level;
  }
}

TEST(ExtensionCommand, AMissingModuleIsRefusedAndReportedAsAFault) {
  CommandTestCard card;
  std::vector<double> value(1);
  EXPECT_EQ(card.Call("GT_GetStsExtMdl", {2, 0, &value}), 0);
  EXPECT_EQ(value[0], 0);
  card.motion.module(2).present = false;
  const uint64_t before = card.Hash();
  EXPECT_EQ(card.Call("GT_SetExtIoValue", {2, 1}), 1);
  EXPECT_EQ(card.Call("GT_GetExtIoValue", {2, &value}), 1);
  EXPECT_EQ(card.Call("GT_SetExtIoBit", {2, 0, 1}), 1);
  EXPECT_EQ(card.Call("GT_GetExtIoBit", {2, 0, &value}), 1);
  EXPECT_EQ(card.Call("GT_GetExtAdValue", {2, 0, &value}), 1);
  EXPECT_EQ(card.Call("GT_GetExtAdVoltage", {2, 0, &value}), 1);
  EXPECT_EQ(card.Call("GT_SetExtDaValue", {2, 0, 1}), 1);
  EXPECT_EQ(card.Call("GT_SetExtDaVoltage", {2, 0, 1}), 1);
  EXPECT_EQ(card.Hash(), before);
  EXPECT_EQ(card.Call("GT_GetStsExtMdl", {2, 0, &value}), 0);
  EXPECT_EQ(value[0], 1);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
