// Commands of the card as a whole. Source: GT manual 2.2, 3.1, chapter 11.
#include <gtest/gtest.h>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

TEST(Gt400Card, HasTheVersionOfItsFirmware) {
  EXPECT_EQ(Gt400TestCard().Read("GT_GetVrsn"), 0x250);
}

TEST(Gt400Clock, CountsSampleTimesSinceTheReset) {
  Gt400TestCard card;
  EXPECT_EQ(card.Read("GT_GetClock"), 0);
  card.Run(7);
  EXPECT_EQ(card.Read("GT_GetClock"), 7);
  card.motion.Reset();
  EXPECT_EQ(card.Read("GT_GetClock"), 0);
  ChangeState(card.motion).clock_cycle = 0x1'0000'0005;
  EXPECT_EQ(card.Read("GT_GetClock"), 5) << "it has 32 bits";
}

TEST(Gt400SampleTime, IsSetAtOnceAndRegistersKeepTheirNumbers) {
  Gt400TestCard card;
  int64_t cycle_ns = 0;
  card.card.set_cycle_ns = [&](int64_t ns) { cycle_ns = ns; };
  EXPECT_EQ(card.Read("GT_GetSmplTm"), 200);
  card.Do("GT_SetVel", {3.5});
  const struct {
    double us;
    int64_t ns;
  } cases[] = {{48, 48'000}, {400, 400'000}, {1966.08, 1'966'080}, {200.03, 200'030}};
  for (const auto& c : cases) {
    card.Do("GT_SetSmplTm", {c.us});
    EXPECT_EQ(cycle_ns, c.ns);
    EXPECT_EQ(card.Read("GT_GetSmplTm"), c.us);
  }
  EXPECT_EQ(card.Read("GT_GetVel"), 3.5);
  EXPECT_EQ(Gt400TestCard().family.cycle_ns, 200'000);
}

TEST(Gt400SampleTime, HasARangeAndCannotChangeInMotion) {
  Gt400TestCard card;
  for (const double us : {47.9, 1966.09}) card.RefusesParameter("GT_SetSmplTm", {us});
  card.Enable(2);
  card.MoveT(1000, 1, 0.1);
  card.Do("GT_Axis", {1});
  card.Refuses(kInMotion, "GT_SetSmplTm", {400});
  EXPECT_EQ(card.Read("GT_GetSmplTm"), 200);
  card.Do("GT_Axis", {2});
  card.RunToRest();
  card.Do("GT_SetSmplTm", {400});
}

TEST(Gt400SampleTime, CannotChangeWhileAPathRunsWithoutAxes) {
  Gt400TestCard card;
  card.Do("GT_SetSynVel", {1});
  card.Do("GT_SetSynAcc", {0.1});
  card.Do("GT_LnXY", {100, 0});
  card.Refuses(kInMotion, "GT_SetSmplTm", {400});
  card.Run(200);
  card.Do("GT_SetSmplTm", {400});
}

// --- The command register --------------------------------------------------------------------

TEST(Gt400CommandRegister, HoldsTheCauseOfTheLastOperatingCommand) {
  Gt400TestCard card;
  card.Refuses(kIllegal, "GT_SetVel", {-1});
  EXPECT_EQ(card.Cause(), kIllegal) << "reading does not change it";
  card.Read("GT_GetVel");
  EXPECT_EQ(card.Cause(), kIllegal) << "nor does another command that only reads";
  card.Do("GT_SetVel", {1});
  EXPECT_EQ(card.Cause(), 0);
}

TEST(Gt400CommandRegister, DoesNotHearOfWhatTheLibraryRefuses) {
  Gt400TestCard card;
  card.Refuses(kIllegal, "GT_SetVel", {-1});
  card.Do("GT_ClrSts");
  card.Refuses(kOverflow, "GT_SetVel", {16385});
  card.RefusesParameter("GT_Axis", {5});
  EXPECT_EQ(card.Cause(), kOverflow);
  EXPECT_EQ(card.Call("GT_GetPos"), 7) << "NULL";
  EXPECT_EQ(card.Cause(), kOverflow);
}

TEST(Gt400CommandRegister, ARefusalIsAnEventOfTheCurrentAxis) {
  Gt400TestCard card;
  card.Do("GT_Axis", {3});
  card.Refuses(kIllegal, "GT_SetVel", {-1});
  EXPECT_TRUE(card.StatusBit(7));
  card.Do("GT_SetVel", {1});
  EXPECT_TRUE(card.StatusBit(7)) << "until the host clears it";
  card.Do("GT_Axis", {1});
  EXPECT_FALSE(card.StatusBit(7));
  card.Do("GT_Axis", {3});
  card.Do("GT_ClrSts");
  EXPECT_FALSE(card.StatusBit(7));
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
