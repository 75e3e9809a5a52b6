// Captures: the edges that they wait for, what they latch, and what the probe does.
#include <gtest/gtest.h>

#include <memory>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

using motion::DiType;

/// Axis 1 moves upwards at 4 pulse/ST. Its home switch is from 600 on, which is not a whole number
/// of ticks away; its index marks are at 300, 1300 ...
class Gt400Capture : public ::testing::Test {
 protected:
  Gt400Capture() {
    card_.motion.SetIndexMarks(0, {.offset = 300, .period = 1000});
    card_.Enable(1);
  }

  void AddHomeSwitch(bool active_low) {
    card_.motion.AddSwitch(
        {.axis = 0, .type = DiType::kHome, .first = 603, .last = 700, .active_low = active_low});
    card_.Cycle();
  }
  void Move() { card_.MoveT(5000, 4, 1); }

  Gt400TestCard card_;
};

TEST_F(Gt400Capture, LatchesThePlaceOfTheEdgeOnce) {
  for (const bool rising : {false, true}) {
    Gt400TestCard card;
    card.Enable(1);
    card.motion.AddSwitch(
        {.axis = 0, .type = DiType::kHome, .first = 603, .last = 700, .active_low = !rising});
    card.Cycle();
    card.Do("GT_HomeSns", {rising ? 1.0 : 0.0});
    card.Do("GT_CaptHome");
    EXPECT_EQ(card.Status(), 0x4B00u);
    card.MoveT(5000, 4, 1);
    while (!card.StatusBit(kBitCaptured)) card.Cycle();
    EXPECT_EQ(card.Status(), 0x0F08u);
    EXPECT_EQ(card.Read("GT_GetCapt"), 603);
    EXPECT_GE(card.Read("GT_GetAtlPos"), 603);
    EXPECT_LT(card.Read("GT_GetAtlPos"), 607);
    card.Do("GT_ClrSts");
    EXPECT_EQ(card.Status(), 0x0F00u);
    card.RunToRest();
    EXPECT_FALSE(card.StatusBit(kBitCaptured));
    EXPECT_EQ(card.Read("GT_GetCapt"), 603) << "until the next capture";
  }
}

// The other edge is where the switch is left.
TEST_F(Gt400Capture, EdgesAreChosenForEachAxis) {
  AddHomeSwitch(false);
  card_.Do("GT_HomeSense", {0b1110});
  card_.Do("GT_CaptHome");
  Move();
  card_.RunToRest();
  EXPECT_EQ(card_.Read("GT_GetCapt"), 700);
}

TEST_F(Gt400Capture, OfTheIndexLatchesTheNextMark) {
  Move();
  card_.Run(100);
  card_.Do("GT_CaptIndex");
  EXPECT_TRUE(card_.StatusBit(kBitIndexArmed));
  EXPECT_FALSE(card_.StatusBit(kBitHomeArmed));
  card_.RunToRest();
  EXPECT_EQ(card_.Read("GT_GetCapt"), 1300);
  EXPECT_EQ(card_.Status(), 0x0B09u);
}

TEST_F(Gt400Capture, IsRefusedWhileItIsArmedOrItsEventIsNotCleared) {
  card_.Do("GT_CaptHome");
  card_.Refuses(kHomeBusy, "GT_CaptHome");
  card_.Refuses(kIndexBusy, "GT_CaptIndex");
  card_.Do("GT_ClrSts");
  EXPECT_TRUE(card_.StatusBit(kBitHomeArmed)) << "clearing events leaves it armed";
  AddHomeSwitch(true);
  Move();
  card_.RunToRest();
  EXPECT_TRUE(card_.StatusBit(kBitCaptured));
  card_.Refuses(kHomeBusy, "GT_CaptHome");
  card_.Refuses(kIndexBusy, "GT_CaptIndex");
  card_.Do("GT_RstSts", {0xF7});
  card_.Do("GT_CaptIndex");
}

TEST(Gt400IndexCapture, IsForSvCards) {
  for (const char* name : {"GT-400-SG", "GT-400-SE", "GT-400-SD", "GT-400-SP"}) {
    Gt400TestCard card(name);
    card.Refuses(kIllegal, "GT_CaptIndex");
    card.Do("GT_CaptHome");
  }
}

// --- The probe ---------------------------------------------------------------------------------

/// Axes 1 and 2 move at 1 and 2 pulse/ST; the probe is touched between two ticks.
class Gt400Probe : public ::testing::Test {
 protected:
  Gt400Probe() {
    card_.motion.PowerOn(std::make_shared<const motion::WorldEvents>(
        motion::WorldEvents{Probe(1, true), Probe(50'250, false), Probe(100'500, true),
                            Probe(150'000, false), Probe(200'000, true)}));
    card_.Enable(2);
    card_.Enable(1);
    for (const int axis : {1, 2}) {
      card_.Do("GT_Axis", {static_cast<double>(axis)});
      card_.Do("GT_PrflV");
      card_.Do("GT_SetAcc", {1});
      card_.Do("GT_SetVel", {static_cast<double>(axis)});
    }
    ChangeState(card_.motion).plants[motion::kAuxiliaryFirst + 1].hand = 10;
  }

  static motion::WorldEvent Probe(motion::Micros at, bool level) {
    return {.at = at,
            .kind = motion::WorldEventKind::kPin,
            .item = static_cast<uint8_t>(DiType::kGpi),
            .index = 0,
            .value = level ? 1.0 : 0.0};
  }
  void RunTo(int64_t cycle) {
    while (card_.motion.cycle() < cycle) card_.Cycle();
  }

  Gt400TestCard card_;
};

// The motions begin at tick 1; their accelerations take 1 and 2 ST, and lose 0.5 and 2 pulses. The
// edge is at 100.5 ST.
TEST_F(Gt400Probe, LatchesAllAxesAndAuxiliaryEncodersAtTheNextRisingEdge) {
  card_.Do("GT_MltiUpdt", {3});
  ASSERT_EQ(card_.motion.cycle(), 1);
  card_.Do("GT_CaptProb");
  EXPECT_FALSE(card_.StatusBit(kBitHomeArmed));
  RunTo(100);
  EXPECT_FALSE(card_.StatusBit(kBitCaptured));
  RunTo(101);
  EXPECT_EQ(card_.Read("GT_GetCapt"), 2 * 99.5 - 2);
  for (const int axis : {1, 2, 3, 4}) {
    card_.Do("GT_Axis", {static_cast<double>(axis)});
    EXPECT_TRUE(card_.StatusBit(kBitCaptured)) << axis;
  }
  card_.Do("GT_Axis", {1});
  EXPECT_EQ(card_.Read("GT_GetCapt"), 99.5 - 0.5);
  const motion::Capture& auxiliary =
      card_.motion.state().capture.capture(motion::kAuxiliaryFirst + 1);
  EXPECT_TRUE(auxiliary.captured);
  EXPECT_EQ(auxiliary.value, 1005);
  card_.Do("GT_ClrSts");
  RunTo(250);
  EXPECT_FALSE(card_.StatusBit(kBitCaptured)) << "once";
  EXPECT_TRUE(card_.StatusBit(kBitMoves));
}

TEST_F(Gt400Probe, ReplacesOtherCaptures) {
  card_.Do("GT_CaptHome");
  card_.Do("GT_CaptProb");
  EXPECT_FALSE(card_.StatusBit(kBitHomeArmed));
}

TEST_F(Gt400Probe, StopsAllAxesIfTheHostWantsThat) {
  card_.Do("GT_ProbStopOn");
  card_.Do("GT_MltiUpdt", {3});
  card_.Do("GT_CaptProb");
  RunTo(101);
  for (const int axis : {1, 2}) {
    card_.Do("GT_Axis", {static_cast<double>(axis)});
    EXPECT_EQ(card_.Status() & 0xFFF, 0xB09u);
    EXPECT_EQ(card_.Read("GT_GetVel"), 0) << "as GT_AbptStp does";
  }
  card_.Do("GT_ClrSts");
  card_.Do("GT_ProbStopOff");
  card_.Do("GT_CaptProb");
  card_.Do("GT_SetVel", {1});
  card_.Do("GT_Update");
  RunTo(210);
  EXPECT_EQ(card_.Status(), 0x1F08u);
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
