// The hand wheel of GE cards for paths. Source: GE manual 10.3.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gtcalls/ge/path_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::ges {
namespace {

using ge::kPathState;
using ::testing::ElementsAre;

/// Turns the wheel at once.
void Turn(PathTestCard* card, double counts) {
  const double position = card->Read("GT_EncPos", {1});
  ChangeState(card->motion).encoders[motion::kAuxiliaryFirst].position = position + counts;
}

TEST(GeHandWheel, LeadsAnAxisToWhereItPoints) {
  PathTestCard card;
  card.Refuses(7, ge::kIllegal, "GT_HandWheel", {1, 0});
  card.Refuses(4, kPathState, "GT_HandWheel", {1, 10});
  card.SetRates(10, 1);
  card.Do("GT_HandWheel", {2, -10});
  card.Cycle();
  Turn(&card, 50);
  card.Run(1);
  card.Refuses(1, kPathState, "GT_LnXY", {10, 10});
  card.Refuses(1, kPathState, "GT_StrtMtn");
  card.Refuses(1, kPathState, "GT_HandWheel", {1, 5});  // within 2 s
  card.Run(100);
  EXPECT_THAT(card.Point(), ElementsAre(0, -500, 0));
  card.Run(2000);
  card.Do("GT_HandWheel", {1, 5});
  card.Do("GT_ExitHWheel");
  card.Do("GT_LnXY", {10, 10});
  card.RunPath();
  EXPECT_THAT(card.Point(), ElementsAre(10, 10, 0));
}

TEST(GeHandWheel, NeedsTheListClosedAndNoPath) {
  PathTestCard card;
  card.SetRates(10, 1);
  card.Do("GT_StrtList");
  card.Refuses(1, kPathState, "GT_HandWheel", {1, 1});
  card.Do("GT_EndList");
  card.Do("GT_LnXY", {100, 0});
  card.Refuses(1, kPathState, "GT_HandWheel", {1, 1});
}

TEST(GeAuxiliaryEncoders, AreSetTo0) {
  PathTestCard card;
  card.motion.EncoderAt(motion::kAuxiliaryFirst + 1).SetPosition(77);
  EXPECT_EQ(card.Read("GT_EncPos", {2}), 77);
  card.Do("GT_ClrEncPos", {2});
  EXPECT_EQ(card.Read("GT_EncPos", {2}), 0);
  EXPECT_EQ(card.Read("GT_EncVel", {2}), 0);
  card.Refuses(7, ge::kIllegal, "GT_EncPos", {3});
}

}  // namespace
}  // namespace oncard::gtcalls::ges
