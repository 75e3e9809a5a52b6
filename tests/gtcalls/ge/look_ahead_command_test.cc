// The look-ahead of GE cards for paths. Source: GE manual 6.4 and 6.5; velocities by hand:
// amax T / (2 sin(angle / 2)) at corners, sqrt(amax R) on arcs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/gtcalls/ge/path_test_card.h"

namespace oncard::gtcalls::ges {
namespace {

using ge::kPathState;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

/// Calls a command with a message; {mtnNum, num, error}.
std::vector<double> Message(PathTestCard* card, std::string_view name,
                            const std::vector<double>& values, int16_t code = 0) {
  std::vector<double> message = {-1, -1, -1};
  EXPECT_EQ(card->Call(name, values, &message), code) << name << ": " << card->reason.en;
  return message;
}

/// T 0.002 s, amax 500, am 200 mm/s^2, 2000 pulses per mm.
void Prepare(PathTestCard* card) {
  card->Do("GT_InitLookAheadEx", {0.002, 500, 200, 200, 2000});
  card->Do("GT_StrtList");
  card->Do("GT_MvXYEx", {0, 0, 50});
}

TEST(GeLookAhead, PassesCornersAsFastAsTheirAngleAllows) {
  PathTestCard card;
  card.Do("GT_SetStrtVel", {0.1});
  Prepare(&card);
  EXPECT_THAT(Message(&card, "GT_LnXYEx", {10, 0, 50, 0, 17}), ElementsAre(17, 0, 0));
  EXPECT_THAT(Message(&card, "GT_LnXYEx", {10, 10, 50, 0, 18}), ElementsAre(18, 0, 0));
  EXPECT_THAT(Message(&card, "GT_M30", {}), ElementsAre(0, 0, 0));
  // 500 mm/s^2 * 0.002 s / sqrt(2) = 0.70711 mm/s.
  const motion::CrdFifo& list = CrdOf(card.card).fifos[kListFifo];
  ASSERT_EQ(list.slots.size(), 3u);
  EXPECT_NEAR(list.slots.At(1).end_velocity, 1.414214, 1e-6);
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  card.RunPath();
  EXPECT_THAT(card.Point(), ElementsAre(20000, 20000, 0));
  EXPECT_EQ(card.Read("GT_GetMtnNm"), 2);
}

TEST(GeLookAhead, LimitsTheVelocityOnArcs) {
  PathTestCard card;
  Prepare(&card);
  Message(&card, "GT_ArcXYEx", {0, 2, 360, 50, 0, 1});
  Message(&card, "GT_M30", {});
  // sqrt(500 * 2) = 31.62 mm/s = 63.25 pulse/ms.
  const motion::CrdFifo& list = CrdOf(card.card).fifos[kListFifo];
  EXPECT_NEAR(list.slots.At(1).velocity_limit, 63.2456, 1e-3);
}

TEST(GeLookAhead, RestsWhereItIsTold) {
  PathTestCard card;
  Prepare(&card);
  Message(&card, "GT_LnXYEx", {10, 0, 50, 1, 1});
  Message(&card, "GT_LnXYG0Ex", {20, 0, 50, 0, 2});
  Message(&card, "GT_M30", {});
  const motion::CrdFifo& list = CrdOf(card.card).fifos[kListFifo];
  EXPECT_TRUE(list.slots.At(1).ends_at_rest);
  EXPECT_FALSE(list.slots.At(2).ends_at_rest);
  EXPECT_TRUE(list.slots.At(2).second_override);
}

TEST(GeLookAhead, SaysWhyItRefuses) {
  PathTestCard card;
  card.Refuses(1, kPathState, "GT_MvXYEx", {0, 0, 50});
  EXPECT_EQ(Message(&card, "GT_LnXYEx", {1, 0, 50, 0, 1}, 1)[2], 8);
  Prepare(&card);
  EXPECT_EQ(Message(&card, "GT_LnXYEx", {0, 0, 50, 0, 1}, 1)[2], 1);
  EXPECT_EQ(Message(&card, "GT_LnXYEx", {1, 0, 0, 0, 1}, 1)[2], 8);
  EXPECT_EQ(Message(&card, "GT_LnXYZEx", {1, 0, 1, 50, 0, 1}, 1)[2], 8);
  EXPECT_EQ(Message(&card, "GT_ArcXYPEx", {4, 0, 1, 1, 50, 0, 1}, 1)[2], 8);
  card.Refuses(1, kPathState, "GT_LnXY", {100, 0});
  card.Do("GT_EndList");
  EXPECT_EQ(Message(&card, "GT_M30", {}, 1)[2], 8);
}

TEST(GeLookAhead, TakesNothingWhenTheBufferIsFull) {
  PathTestCard card;
  Prepare(&card);
  std::vector<double> message(3);
  int taken = 0;
  while (card.Call("GT_LnXYEx", {0.1 * (taken + 1), 0, 50, 0, 1}, &message) == 0) ++taken;
  EXPECT_EQ(message[2], 3);
  EXPECT_GT(taken, 800);
  EXPECT_EQ(card.Call("GT_M30", {}, &message), 9);
  EXPECT_EQ(message[2], 3);
  card.Do("GT_StrtMtn");
  while (card.Call("GT_M30", {}, &message) == 9) card.Run(10);
  card.Do("GT_EndList");
  card.RunPath();
  EXPECT_THAT(card.Point(), Pointwise(DoubleNear(1e-6), {200.0 * taken, 0.0, 0.0}));
  EXPECT_EQ(card.Read("GT_GetMtnNm"), taken);
}

TEST(GeLookAhead, KeepsOutputsAndDelaysInOrder) {
  PathTestCard card;
  Prepare(&card);
  card.Do("GT_BufIOEx", {1});
  Message(&card, "GT_LnXYEx", {1, 0, 50, 0, 1});
  card.Do("GT_BufIOBitEx", {3, 1});
  card.Do("GT_DelayEx", {100});
  Message(&card, "GT_LnXYEx", {2, 0, 50, 0, 2});
  Message(&card, "GT_M30", {});
  card.Do("GT_EndList");
  card.Do("GT_StrtMtn");
  card.Run(2);
  EXPECT_EQ(card.Read("GT_GetExOpt"), 1);
  card.RunPath();
  EXPECT_EQ(card.Read("GT_GetExOpt"), 9);
}

TEST(GeVelocityTable, GivesTheEndVelocitiesOfAPath) {
  PathTestCard card;
  std::vector<double> cell = {-1};
  EXPECT_EQ(card.Call("GT_CalVel", {}, &cell), 1);
  EXPECT_EQ(card.Cause(), kPathState);
  card.Do("GT_InitLookAhead", {0.002, 500, 200, 100, 10, 2000});
  const auto add = [&](double code, double x, double y, double flag) {
    return card.Call("GT_AddLookData", {code, 17, 0, x, y, 0, 50, 0, 0, 0, x + y, flag});
  };
  EXPECT_EQ(add(1, 10, 0, 0), 0);
  EXPECT_EQ(add(1, 10, 0, 0), 1);  // the same point
  EXPECT_EQ(add(1, 10, 10, 0), 0);
  EXPECT_EQ(card.Call("GT_CalVel", {}, &cell), 0);
  EXPECT_EQ(cell[0], 10);  // the number of the segment is written last
  EXPECT_EQ(card.Call("GT_CalVel", {}, &cell), 1);
  EXPECT_EQ(cell[0], 20);
}

}  // namespace
}  // namespace oncard::gtcalls::ges
