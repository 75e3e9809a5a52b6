// Inputs and outputs of GE cards. Source: GE manual chapters 9 and 10.2.
#include <gtest/gtest.h>

#include "tests/gtcalls/ge/ge_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::ge {
namespace {

using motion::DiType;
using motion::DoType;

TEST(GeInputs, AreLevels) {
  GeTestCard card;
  card.SetInput(DiType::kGpi, 15, true);
  EXPECT_EQ(card.Read("GT_ExInpt"), 0x8000);
  card.SetInput(DiType::kHome, 2, true);
  card.Do("GT_HomeSns", {0xFF});  // the edge of a capture: no sense of the level
  EXPECT_EQ(card.Read("GT_GetHomeSwt"), 4);
  card.SetInput(DiType::kLimitPositive, 7, true);
  card.SetInput(DiType::kLimitNegative, 0, true);
  EXPECT_EQ(card.Read("GT_GetLmtSwt"), 0x4002);
}

TEST(GeInputs, AreFilteredForThreeCycles) {
  GeTestCard card;
  ChangeState(card.motion).io.SetPin(DiType::kGpi, 0, true);
  card.Cycle();
  card.Cycle();
  EXPECT_EQ(card.Read("GT_ExInpt"), 0);
  card.Cycle();
  EXPECT_EQ(card.Read("GT_ExInpt"), 1);
}

TEST(GeOutputs, AreWrittenAllAtOnce) {
  GeTestCard card;
  card.Do("GT_ExOpt", {0xFFFF});
  card.Do("GT_ExOpt", {0x0102});
  EXPECT_EQ(card.motion.state().io.Register(DoType::kGpo), 0x0102u);
}

TEST(GeAdc, HasTwelveBits) {
  const struct {
    double volts;
    double value;
  } cases[] = {{0, 0}, {10, 2047}, {-10, -2048}, {5, 1024}, {-0.01, -2}, {12, 2047}};
  GeTestCard card;
  for (const auto& c : cases) {
    ChangeState(card.motion).adcs[7].volts = c.volts;
    EXPECT_EQ(card.Read("GT_GetAdc", {8}), c.value) << c.volts;
  }
  for (const double channel : {0.0, 9.0}) card.Refuses(7, kIllegal, "GT_GetAdc", {channel});
}

}  // namespace
}  // namespace oncard::gtcalls::ge
