// Breakpoints: when they are met, once, and what an automatic update does then. All motions here
// begin at 0 with 0.1 pulse/ST^2, so that 1 pulse/ST is reached after 10 ST and 5 pulses.
#include <gtest/gtest.h>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

class Gt400Breakpoint : public ::testing::Test {
 protected:
  Gt400Breakpoint() { card_.Enable(1); }

  bool Met() { return card_.StatusBit(kBitBreakpoint); }
  /// Begins a motion, whose Update also makes the position of the breakpoint valid.
  void Move(double target, double breakpoint) {
    card_.Do("GT_SetBrkCn", {breakpoint});
    card_.MoveT(target, 1, 0.1);
  }

  Gt400TestCard card_;
};

TEST_F(Gt400Breakpoint, IsMetAtItsPositionOrBehindIt) {
  const struct {
    const char* command;
    double sign;
  } cases[] = {{"GT_PosBrk", 1}, {"GT_NegBrk", -1}};
  for (const auto& c : cases) {
    Gt400TestCard card;
    card.Enable(1);
    card.Do("GT_SetBrkCn", {c.sign * 200});
    card.MoveT(c.sign * 1000, 1, 0.1);
    card.Do(c.command);
    // 10 ST, then 195 pulses.
    card.Run(204);
    EXPECT_FALSE(card.StatusBit(kBitBreakpoint)) << c.command;
    card.Run(1);
    EXPECT_TRUE(card.StatusBit(kBitBreakpoint)) << c.command;
    EXPECT_EQ(card.Read("GT_GetAtlPos"), c.sign * 200);
    card.Do("GT_ClrSts");
    card.Run(10);
    EXPECT_FALSE(card.StatusBit(kBitBreakpoint)) << "it acts once";
  }
}

TEST_F(Gt400Breakpoint, IsMetAtOnceWhereTheAxisIsThereAlready) {
  for (const char* command : {"GT_PosBrk", "GT_NegBrk"}) {
    card_.Do(command);
    EXPECT_FALSE(Met()) << "it is judged in ticks";
    card_.Cycle();
    EXPECT_TRUE(Met()) << command;
    card_.Do("GT_ClrSts");
  }
}

TEST_F(Gt400Breakpoint, TakesItsValidPosition) {
  card_.Do("GT_SetBrkCn", {500});
  EXPECT_EQ(card_.Read("GT_GetBrkCn"), 500);
  card_.Do("GT_PosBrk");
  card_.Cycle();
  EXPECT_TRUE(Met()) << "500 waits for an Update, 0 is valid";
}

TEST_F(Gt400Breakpoint, RefusesPositionsThatNoRegisterHolds) {
  card_.Refuses(kOverflow, "GT_SetBrkCn", {1073741824});
  card_.Refuses(kOverflow, "GT_SetBrkCn", {-1073741825});
  card_.Do("GT_SetBrkCn", {1073741823});
  card_.Do("GT_SetBrkCn", {-1073741824});
}

// The breakpoint is armed while bit 0 is still set by GT_AxisOn.
TEST_F(Gt400Breakpoint, ForMotionWaitsForTheNextEnd) {
  card_.Do("GT_AxisOn");
  card_.Do("GT_MtnBrk");
  card_.Run(5);
  EXPECT_TRUE(card_.StatusBit(kBitComplete));
  EXPECT_FALSE(Met());
  card_.MoveT(100, 1, 0.1);
  card_.Run(109);
  EXPECT_FALSE(Met());
  card_.Run(1);
  EXPECT_TRUE(Met());
}

TEST_F(Gt400Breakpoint, ForMotionCountsAnEndByACommand) {
  card_.Do("GT_MtnBrk");
  card_.Do("GT_AbptStp");
  card_.Cycle();
  EXPECT_TRUE(Met());
}

TEST_F(Gt400Breakpoint, ForACaptureWaitsForTheNext) {
  using motion::DiType;
  card_.Do("GT_HomeSns", {1});
  card_.SetInput(DiType::kHome, 0, false);
  card_.Do("GT_CaptHome");
  // World events are edges that the card sees; a pin that is set here is not.
  motion::MotionState& state = ChangeState(card_.motion);
  state.capture.Edge(DiType::kHome, 0, true, [](size_t) { return 7.0; });
  card_.Cycle();
  EXPECT_TRUE(card_.StatusBit(kBitCaptured));
  card_.Do("GT_ExtBrk");
  card_.Run(3);
  EXPECT_FALSE(Met()) << "captured before";
  card_.Do("GT_ClrSts");
  card_.Do("GT_CaptHome");
  ChangeState(card_.motion).capture.Edge(DiType::kHome, 0, true, [](size_t) { return 8.0; });
  card_.Cycle();
  EXPECT_TRUE(Met());
  EXPECT_TRUE(card_.StatusBit(kBitCaptured));
}

TEST_F(Gt400Breakpoint, IsReplacedOrTakenAway) {
  Move(1000, 200);
  card_.Do("GT_PosBrk");
  card_.Do("GT_MtnBrk");
  card_.Run(300);
  EXPECT_FALSE(Met());
  card_.Do("GT_PosBrk");
  card_.Do("GT_BrkOff");
  card_.Run(10);
  EXPECT_FALSE(Met());
}

TEST_F(Gt400Breakpoint, BelongsToItsAxis) {
  card_.Enable(2);
  card_.Do("GT_Axis", {1});
  Move(1000, 200);
  card_.Do("GT_PosBrk");
  card_.Do("GT_Axis", {2});
  card_.Do("GT_MtnBrk");
  card_.Run(300);
  EXPECT_FALSE(Met());
  card_.Do("GT_Axis", {1});
  EXPECT_TRUE(Met());
}

// --- The automatic update ----------------------------------------------------------------------

TEST_F(Gt400Breakpoint, OnlySetsItsBitWithoutAutomaticUpdates) {
  Move(1000, 200);
  card_.Do("GT_PosBrk");
  card_.Do("GT_SetVel", {4});
  card_.Run(300);
  EXPECT_TRUE(Met());
  EXPECT_EQ(card_.Read("GT_GetPrfVel"), 1);
}

TEST_F(Gt400Breakpoint, UpdatesInTheTickThatMeetsIt) {
  card_.Do("GT_AuUpdtOn");
  Move(1000, 200);
  card_.Do("GT_PosBrk");
  card_.Do("GT_SetVel", {4});
  card_.Run(205);
  EXPECT_TRUE(Met());
  EXPECT_EQ(card_.motion.profile(0).now.position, 200);
  card_.Run(1);
  EXPECT_NEAR(card_.Read("GT_GetPrfVel"), 1.1, 1e-12);
  EXPECT_NEAR(card_.motion.profile(0).now.position, 201.05, 1e-9);
  card_.Do("GT_SetVel", {2});
  card_.Run(50);
  EXPECT_EQ(card_.Read("GT_GetPrfVel"), 4) << "what is set afterwards waits for the next Update";
}

// Bit 10 has no gap between the motions: 100 pulses at 1 pulse/ST, then back with a peak of 3.16.
TEST_F(Gt400Breakpoint, TheNextMotionBeginsWhereTheLastOneEnds) {
  card_.Do("GT_AuUpdtOn");
  card_.MoveT(100, 1, 0.1);
  card_.Do("GT_MtnBrk");
  card_.Do("GT_SetPos", {0});
  card_.Do("GT_SetVel", {4});
  for (int i = 0; i < 110; ++i) {
    EXPECT_TRUE(card_.StatusBit(kBitMoves));
    card_.Cycle();
  }
  EXPECT_TRUE(card_.StatusBit(kBitMoves));
  EXPECT_TRUE(card_.StatusBit(kBitComplete));
  EXPECT_TRUE(Met());
  EXPECT_EQ(card_.RunToRest(), 64);  // 2 sqrt(100 / 0.1) = 63.2
  EXPECT_EQ(card_.Read("GT_GetPrfPos"), 0);
}

TEST_F(Gt400Breakpoint, AnUpdateThatWouldBeRefusedIsDroppedInSilence) {
  card_.Do("GT_AuUpdtOn");
  Move(1000, 200);
  card_.Do("GT_PosBrk");
  card_.Do("GT_SetAcc", {0.2});  // not in motion
  card_.Do("GT_SetVel", {4});
  card_.Run(300);
  EXPECT_TRUE(Met());
  EXPECT_FALSE(card_.StatusBit(kBitRefused));
  EXPECT_EQ(card_.Cause(), 0);
  EXPECT_EQ(card_.Read("GT_GetPrfVel"), 1);
  EXPECT_EQ(card_.Read("GT_GetVel"), 4);
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
