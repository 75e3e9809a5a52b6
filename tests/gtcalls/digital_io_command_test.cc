// Digital inputs and outputs through their commands.
#include <gtest/gtest.h>

#include <string>

#include "tests/gtcalls/command_test_card.h"

namespace oncard::gtcalls::gts {
namespace {

using motion::DiType;

constexpr double kEnable = 10;
constexpr double kGpo = 12;
constexpr double kGpi = 4;

double Do(CommandTestCard& card, double type) {
  std::vector<double> value(1);
  EXPECT_EQ(card.Call("GT_GetDo", {type, &value}), 0);
  return value[0];
}

double Di(CommandTestCard& card, double type) {
  std::vector<double> value(1);
  EXPECT_EQ(card.Call("GT_GetDi", {type, &value}), 0);
  return value[0];
}

std::string Trace(CommandTestCard& card, int cycles) {
  std::string levels;
  for (int i = 0; i < cycles; ++i) {
    card.Cycle();
    levels += Do(card, kGpo) != 0 ? '1' : '0';
  }
  return levels;
}

TEST(DoCommand, SetDoWritesTheWholeWord) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_SetDo", {kGpo, 0x8001}), 0);
  EXPECT_EQ(Do(card, kGpo), 0x8001);
  EXPECT_EQ(card.Call("GT_SetDo", {kGpo, 0x1FFFF}), 0);
  EXPECT_EQ(Do(card, kGpo), 0xFFFF);
  EXPECT_EQ(card.Call("GT_SetDo", {kEnable, 0xFFFF}), 0);
  EXPECT_EQ(Do(card, kEnable), 0xFF);
}

TEST(DoCommand, SetDoMaskWritesTheMaskedBits) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_SetDo", {kGpo, 0x00FF}), 0);
  EXPECT_EQ(card.Call("GT_SetDoMask", {kGpo, 0x0FF0, 0xFF00}), 0);
  EXPECT_EQ(Do(card, kGpo), 0x0F0F);
}

TEST(DoCommand, SetDoBitCountsFromOne) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_SetDoBit", {kGpo, 1, 1}), 0);
  EXPECT_EQ(card.Call("GT_SetDoBit", {kGpo, 16, 1}), 0);
  EXPECT_EQ(Do(card, kGpo), 0x8001);
  EXPECT_EQ(card.Call("GT_SetDoBit", {kGpo, 1, 0}), 0);
  EXPECT_EQ(Do(card, kGpo), 0x8000);
}

TEST(DoCommand, TypeAndIndexAreCheckedAtBothEnds) {
  struct {
    double type;
    double index;
    int code;
  } const cases[] = {{9, 1, 7},  {10, 1, 0},  {10, 8, 0},  {10, 9, 7}, {11, 8, 0}, {11, 9, 7},
                     {12, 0, 7}, {12, 16, 0}, {12, 17, 7}, {13, 1, 7}, {12, -1, 7}};
  for (const auto& c : cases) {
    CommandTestCard card;
    EXPECT_EQ(card.Call("GT_SetDoBit", {c.type, c.index, 1}), c.code) << c.type << " " << c.index;
    EXPECT_EQ(card.Call("GT_SetDoBitReverse", {c.type, c.index, 1, 1}), c.code);
    EXPECT_EQ(card.Call("GT_EnableDoBitPulse", {c.type, c.index, 1, 1, 1, 1}), c.code);
    EXPECT_EQ(card.Call("GT_DisableDoBitPulse", {c.type, c.index}), c.code);
  }
}

TEST(DoBitReverse, ReturnsAfterItsTimeAtBothCycleLengths) {
  for (const auto& [cycle_us, levels] :
       {std::pair{int64_t{250}, "11100"}, {int64_t{1000}, "000"}}) {
    CommandTestCard card({.cycle_us = cycle_us});
    EXPECT_EQ(card.Call("GT_SetDoBitReverse", {kGpo, 1, 1, 4}), 0);  // 4 x 250 us
    EXPECT_EQ(Do(card, kGpo), 1);
    EXPECT_EQ(Trace(card, static_cast<int>(std::string(levels).size())), levels) << cycle_us;
  }
}

TEST(DoBitReverse, TimeIsCheckedAtBothEnds) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_SetDoBitReverse", {kGpo, 1, 1, 0}), 0);
  EXPECT_EQ(Trace(card, 4), "1111");
  EXPECT_EQ(card.Call("GT_SetDoBitReverse", {kGpo, 1, 1, 32767}), 0);
  EXPECT_EQ(card.Call("GT_SetDoBitReverse", {kGpo, 1, 1, 32768}), 7);
  EXPECT_EQ(card.Call("GT_SetDoBitReverse", {kGpo, 1, 1, -1}), 7);
}

TEST(DoBitPulse, SendsItsPulsesInUnitsOf250Us) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_EnableDoBitPulse", {kGpo, 1, 2, 1, 2, 1}), 0);
  EXPECT_EQ(Do(card, kGpo), 1);
  EXPECT_EQ(Trace(card, 8), "10110000");
}

TEST(DoBitPulse, EndsWhenDisabled) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_EnableDoBitPulse", {kGpo, 1, 1, 1, 0, 0}), 0);
  EXPECT_EQ(Trace(card, 5), "10101");
  EXPECT_EQ(card.Call("GT_DisableDoBitPulse", {kGpo, 1}), 0);
  EXPECT_EQ(Trace(card, 4), "1111");
}

TEST(DoBitPulse, RefusesTimesOfZeroAndNegativeCounts) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_EnableDoBitPulse", {kGpo, 1, 0, 1, 1, 1}), 7);
  EXPECT_EQ(card.Call("GT_EnableDoBitPulse", {kGpo, 1, 1, 0, 1, 1}), 7);
  EXPECT_EQ(card.Call("GT_EnableDoBitPulse", {kGpo, 1, 1, 1, -1, 1}), 7);
  EXPECT_EQ(card.Call("GT_EnableDoBitPulse", {kGpo, 1, 65535, 65535, 2147483647, 1}), 0);
  EXPECT_EQ(card.Call("GT_EnableDoBitPulse", {kGpo, 1, 65536, 1, 1, 1}), 7);
}

TEST(DiCommand, RawIsThePinAndGetDiTheFilteredLevel) {
  CommandTestCard card;
  card.motion.digital_io().SetPin(DiType::kGpi, 9, true);
  std::vector<double> raw(1);
  EXPECT_EQ(card.Call("GT_GetDiRaw", {kGpi, &raw}), 0);
  EXPECT_EQ(raw[0], 0x200);
  card.Cycles(2);
  EXPECT_EQ(Di(card, kGpi), 0);
  card.Cycle();
  EXPECT_EQ(Di(card, kGpi), 0x200);
}

TEST(DiCommand, TypeIsCheckedAtBothEnds) {
  CommandTestCard card;
  std::vector<double> value(1);
  for (const auto& [type, code] : {std::pair{-1, 7}, {0, 0}, {6, 0}, {7, 7}}) {
    EXPECT_EQ(card.Call("GT_GetDi", {double(type), &value}), code) << type;
    EXPECT_EQ(card.Call("GT_GetDiRaw", {double(type), &value}), code) << type;
  }
}

TEST(DiReverseCount, CountsAreSetAndReadForConsecutiveInputs) {
  CommandTestCard card;
  std::vector<double> counts = {10, 20, 4294967295.0, 40};
  EXPECT_EQ(card.Call("GT_SetDiReverseCount", {kGpi, 13, &counts, 4}), 0);
  card.motion.digital_io().SetPin(DiType::kGpi, 14, true);  // input 15
  card.motion.digital_io().SetPin(DiType::kGpi, 12, true);  // input 13
  card.Cycles(3);
  card.motion.digital_io().SetPin(DiType::kGpi, 12, false);
  card.Cycles(3);
  EXPECT_EQ(card.Call("GT_GetDiReverseCount", {kGpi, 13, &counts, 4}), 0);
  EXPECT_EQ(counts, (std::vector<double>{12, 20, 0, 40}));
}

TEST(DiReverseCount, IndexAndCountStayWithinTheWord) {
  struct {
    double type, index, count;
    int code;
  } const cases[] = {{4, 1, 4, 0}, {4, 16, 1, 0}, {4, 13, 4, 0}, {4, 14, 4, 7}, {4, 17, 1, 7},
                     {4, 0, 1, 7}, {0, 8, 1, 0},  {0, 8, 2, 7},  {0, 9, 1, 7},  {6, 7, 1, 0},
                     {6, 8, 1, 7}, {4, 1, 0, 7},  {4, 1, 5, 7},  {4, 1, -1, 7}, {7, 1, 1, 7}};
  for (const auto& c : cases) {
    CommandTestCard card;
    std::vector<double> counts(8, 3);
    const uint64_t before = card.Hash();
    EXPECT_EQ(card.Call("GT_GetDiReverseCount", {c.type, c.index, &counts, c.count}), c.code)
        << c.type << " " << c.index << " " << c.count;
    EXPECT_EQ(card.Call("GT_SetDiReverseCount", {c.type, c.index, &counts, c.count}), c.code)
        << c.type << " " << c.index << " " << c.count;
    if (c.code != 0) {
      EXPECT_EQ(card.Hash(), before);
    }
  }
}

TEST(LmtSns, InvertsTheLimitsOfEachAxis) {
  // All pins are high: with sense 0 the limits are active, with sense 1 they are not.
  CommandTestCard card;
  for (int bit = 0; bit < 8; ++bit) {
    card.motion.digital_io().SetPin(DiType::kLimitPositive, bit, true);
    card.motion.digital_io().SetPin(DiType::kLimitNegative, bit, true);
  }
  card.Cycles(3);
  EXPECT_EQ(Di(card, 0), 0xFF);
  EXPECT_EQ(Di(card, 1), 0xFF);
  // Axis 1: both; axis 2: positive only; axis 8: negative only.
  EXPECT_EQ(card.Call("GT_LmtSns", {0x8007}), 0);
  EXPECT_EQ(Di(card, 0), 0xFC);
  EXPECT_EQ(Di(card, 1), 0x7E);
  EXPECT_EQ(card.Call("GT_LmtSns", {0xFFFF}), 0);
  EXPECT_EQ(Di(card, 0), 0);
  EXPECT_EQ(Di(card, 1), 0);
}

TEST(LmtSns, LimitsWithoutWiringAreNeverTriggered) {
  CommandTestCard card;
  for (const double sense : {0.0, 65535.0, 0x5555 * 1.0}) {
    EXPECT_EQ(card.Call("GT_LmtSns", {sense}), 0);
    card.Cycles(5);
    EXPECT_EQ(Di(card, 0), 0);
    EXPECT_EQ(Di(card, 1), 0);
  }
}

TEST(GpiSns, InvertsGeneralInputs) {
  CommandTestCard card;
  card.motion.digital_io().SetPin(DiType::kGpi, 0, true);
  card.motion.digital_io().SetPin(DiType::kGpi, 15, false);
  card.Cycles(3);
  EXPECT_EQ(card.Call("GT_GpiSns", {0x8001}), 0);
  EXPECT_EQ(Di(card, kGpi), 0x8000);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
