// The interrupt unit: what interrupts the host, and how an interrupt ends. Source: GT manual
// chapter 8 and the commands in chapter 11.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/gtcalls/gt400/gt400_test_card.h"

namespace oncard::gtcalls::gt400 {
namespace {

/// A card that notes its interrupts. A handler answers them, unless a test says otherwise.
class InterruptedCard : public Gt400TestCard {
 public:
  InterruptedCard() {
    card.interrupt_host = [this](const Message& what) { interrupts.push_back(what.en); };
    Hook();
  }

  void Hook() {
    std::vector<double> given;
    EXPECT_EQ(Call("GT_HookIsr", {}, &given), 0);
  }
  /// The host waits for an event, which a driver sets.
  void Synchronise() {
    std::vector<double> given;
    EXPECT_EQ(Call("GT_SetIntSyncEvent", {}, &given), 0);
  }
  /// An enabled axis without events becomes the current one; these of its events interrupt.
  void Watch(int axis, double mask) {
    Enable(axis);
    Do("GT_SetIntrMsk", {mask});
  }
  /// A motion without length: the axis is where it is to be, and bit 0 is set.
  void Complete(int axis) {
    Do("GT_Axis", {static_cast<double>(axis)});
    Do("GT_SetPos", {0});
    Do("GT_Update");
  }
  /// The interrupts since this was asked last.
  std::vector<std::string> Take() { return std::exchange(interrupts, {}); }

  std::vector<std::string> interrupts;
};

using Interrupts = std::vector<std::string>;

// --- Masks and kinds -------------------------------------------------------------------------

TEST(Gt400Interrupt, AxesHaveMasksOfTheirOwn) {
  InterruptedCard card;
  card.Do("GT_Axis", {2});
  card.Do("GT_SetIntrMsk", {0x28});
  EXPECT_EQ(card.Read("GT_GetIntrMsk"), 0x28);
  card.Do("GT_Axis", {3});
  EXPECT_EQ(card.Read("GT_GetIntrMsk"), 0);
}

TEST(Gt400Interrupt, ThePeriodOfTimeInterruptsHas15Bits) {
  InterruptedCard card;
  EXPECT_EQ(card.Read("GT_GetIntrTm"), 0);
  card.Do("GT_SetIntrTm", {32767});
  EXPECT_EQ(card.Read("GT_GetIntrTm"), 32767);
  card.RefusesParameter("GT_SetIntrTm", {32768});
}

TEST(Gt400Interrupt, OnlyEventsOfTheMaskInterrupt) {
  InterruptedCard card;
  card.Watch(1, 0x7E);
  card.Complete(1);
  EXPECT_EQ(card.Take(), Interrupts());
  card.Do("GT_SetIntrMsk", {0x01});
  card.Cycle();
  // Bits 0, 8, 9 and 11: complete, closed loop, drive on, limits watched.
  EXPECT_EQ(card.Take(), Interrupts{"irq axis 1 0x0B01"});
}

TEST(Gt400Interrupt, ARefusedCommandDoesNotInterrupt) {
  InterruptedCard card;
  card.Watch(1, 0xFFFF);
  card.Refuses(kEmptyMask, "GT_MltiUpdt", {0});
  card.Cycle();
  EXPECT_EQ(card.Take(), Interrupts());
}

// The manual, 8.1: the other events cannot interrupt then.
TEST(Gt400Interrupt, OfAnAxisThatIsOffOnlyAlarmsAndErrorsInterrupt) {
  InterruptedCard card;
  card.Watch(1, 0x7F);
  card.Complete(1);
  EXPECT_EQ(card.Take().size(), 1u);
  card.Do("GT_RstIntr", {0xFF});
  card.Do("GT_AxisOff");
  card.Cycle();
  EXPECT_TRUE(card.StatusBit(0));
  EXPECT_EQ(card.Take(), Interrupts());
  card.Do("GT_Axis", {2});
  card.Do("GT_SetIntrMsk", {0x02});
  card.SetInput(motion::DiType::kAlarm, 1, true);
  EXPECT_EQ(card.Take(), Interrupts{"irq axis 2 0x1903"}) << "an alarm also ends a motion";
}

// --- Service ---------------------------------------------------------------------------------

// Both complete in one tick: the axis with the lowest number is the first, and the other one
// interrupts when that is served.
TEST(Gt400Interrupt, OneIsInServiceAtATime) {
  InterruptedCard card;
  card.Watch(2, 1);
  card.Watch(3, 1);
  card.Do("GT_Axis", {2});
  card.Do("GT_SetPos", {0});
  card.Do("GT_Axis", {3});
  card.Do("GT_SetPos", {0});
  card.Do("GT_MltiUpdt", {6});
  card.Run(5);
  EXPECT_EQ(card.Take(), Interrupts{"irq axis 2 0x1B01"});
  EXPECT_EQ(card.Read("GT_GetIntr"), 0x1B01);
  EXPECT_EQ(card.Status() >> 12 & 3, 2u) << "the current axis is the third one";
  card.Do("GT_AxisI");
  EXPECT_EQ(card.Status() >> 12 & 3, 1u);
  card.Do("GT_RstIntr", {0});
  EXPECT_FALSE(card.StatusBit(0));
  EXPECT_EQ(card.Take(), Interrupts());
  card.Run(2);
  EXPECT_EQ(card.Take(), Interrupts{"irq axis 3 0x2B01"});
}

// Table 8-1: of two events one is handled after the other.
TEST(Gt400Interrupt, WhatIsStillSetInterruptsAgain) {
  InterruptedCard card;
  card.Watch(3, 0x21);
  card.SetInput(motion::DiType::kLimitPositive, 2, true);
  card.Do("GT_SetPos", {0});
  card.Do("GT_Update");
  EXPECT_EQ(card.Take(), Interrupts{"irq axis 3 0x2B20"});
  card.Do("GT_RstIntr", {0xDF});
  EXPECT_FALSE(card.StatusBit(5));
  EXPECT_TRUE(card.StatusBit(0));
  card.Cycle();
  EXPECT_EQ(card.Take(), Interrupts{"irq axis 3 0x2B01"});
  card.Do("GT_RstIntr", {0xFE});
  card.Cycle();
  EXPECT_EQ(card.Take(), Interrupts());
}

TEST(Gt400Interrupt, RstIntrLeavesTheBitOfRefusedCommands) {
  InterruptedCard card;
  card.Watch(1, 1);
  card.Complete(1);
  card.Refuses(kEmptyMask, "GT_MltiUpdt", {0});
  card.Do("GT_RstIntr", {0});
  EXPECT_EQ(card.Status() & 0xFF, 0x80u);
}

TEST(Gt400Interrupt, ClrStsDoesNotEndTheService) {
  InterruptedCard card;
  card.Watch(1, 1);
  card.Complete(1);
  card.Do("GT_ClrSts");
  card.Complete(1);
  EXPECT_EQ(card.Take().size(), 1u);
  card.Do("GT_ClearInt", {0});  // ends only time interrupts
  card.Cycle();
  EXPECT_EQ(card.Take(), Interrupts());
  EXPECT_EQ(card.Read("GT_GetIntr"), 0x0B01);
}

TEST(Gt400Interrupt, ClearIntNamesOneOf16Cards) {
  InterruptedCard card;
  card.Do("GT_ClearInt", {15});
  for (const double number : {16.0, 65535.0}) {
    const uint64_t before = card.Hash();
    EXPECT_EQ(card.Call("GT_ClearInt", {number}), -1) << number;
    EXPECT_EQ(card.Hash(), before) << number;
  }
}

TEST(Gt400Interrupt, WithoutServiceThereIsNoAxisThatInterrupts) {
  InterruptedCard card;
  card.Enable(2);
  card.Refuses(kNoInterrupt, "GT_AxisI");
  card.Refuses(kNoInterrupt, "GT_RstIntr", {0});
  EXPECT_EQ(card.Call("GT_RstIntr", {0}), 1);
  EXPECT_NE(card.reason.en.find("no event interrupt"), std::string::npos);
  EXPECT_EQ(card.Read("GT_GetIntr"), card.Status());
}

// --- Time ------------------------------------------------------------------------------------

TEST(Gt400TimeInterrupt, ComesInItsPeriodFromTmrIntrOn) {
  InterruptedCard card;
  card.Do("GT_SetIntrTm", {10});
  card.Run(7);
  card.Do("GT_TmrIntr");
  card.Run(9);
  EXPECT_EQ(card.Take(), Interrupts());
  card.Cycle();
  EXPECT_EQ(card.Take(), Interrupts{"irq time"});
  card.Do("GT_ClearInt", {0});
  card.Run(20);
  EXPECT_EQ(card.Take(), Interrupts{"irq time"}) << "the second one came while one was in service";
  card.Do("GT_ClearInt", {0});
  card.Run(4);
  card.Do("GT_SetIntrTm", {3});  // counts anew
  card.Run(2);
  EXPECT_EQ(card.Take(), Interrupts());
  card.Cycle();
  EXPECT_EQ(card.Take(), Interrupts{"irq time"});
}

TEST(Gt400TimeInterrupt, NeverComesWithAPeriodOf0) {
  InterruptedCard card;
  card.Do("GT_TmrIntr");
  card.Run(100);
  EXPECT_EQ(card.Take(), Interrupts());
}

TEST(Gt400TimeInterrupt, TakesThePlaceOfEventInterrupts) {
  InterruptedCard card;
  card.Watch(1, 1);
  card.Do("GT_SetIntrTm", {50});
  card.Do("GT_TmrIntr");
  card.Complete(1);
  card.Run(10);
  EXPECT_EQ(card.Take(), Interrupts());
  card.Do("GT_EvntIntr");
  card.Cycle();
  EXPECT_EQ(card.Take(), Interrupts{"irq axis 1 0x0B01"});
  card.Run(100);
  EXPECT_EQ(card.Take(), Interrupts());
}

// Table 2-2 of the manual: bit 4 is for event interrupts.
TEST(Gt400TimeInterrupt, HasNoAxis) {
  InterruptedCard card;
  card.Enable(2);
  card.Do("GT_SetIntrTm", {1});
  card.Do("GT_TmrIntr");
  card.Cycle();
  card.Refuses(kNoInterrupt, "GT_AxisI");
  card.Refuses(kNoInterrupt, "GT_RstIntr", {0});
  EXPECT_EQ(card.Read("GT_GetIntr"), card.Status());
}

// --- Answers of the host -----------------------------------------------------------------------

TEST(Gt400Driver, EndsAnInterruptAtOnceAndKeepsItsWord) {
  InterruptedCard card;
  card.Synchronise();
  card.Watch(2, 0x01);
  card.Watch(4, 0x41);
  EXPECT_EQ(card.Read("GT_GetIntr"), 0) << "no interrupt yet";
  card.SetInput(motion::DiType::kLimitNegative, 3, true);
  card.Complete(4);
  EXPECT_EQ(card.Take(), (Interrupts{"irq axis 4 0x3B40", "irq axis 4 0x3B01"}));
  EXPECT_EQ(card.Read("GT_GetIntr"), 0x3B01);
  EXPECT_EQ(card.Status() & 0xFF, 0u) << "the driver has cleared the causes";
  card.Complete(2);
  EXPECT_EQ(card.Take(), Interrupts{"irq axis 2 0x1B01"});
  card.Refuses(kNoInterrupt, "GT_AxisI");
  card.Refuses(kNoInterrupt, "GT_RstIntr", {0});
  EXPECT_EQ(card.Call("GT_RstIntr", {0}), 1);
  EXPECT_NE(card.reason.en.find("the driver has ended it"), std::string::npos);
}

TEST(Gt400Driver, HasNoWordOfTimeInterrupts) {
  InterruptedCard card;
  card.Synchronise();
  card.Watch(1, 1);
  card.Complete(1);
  EXPECT_EQ(card.Read("GT_GetIntr"), 0x0B01);
  card.Do("GT_SetIntrTm", {2});
  card.Do("GT_TmrIntr");
  card.Run(6);
  EXPECT_EQ(card.Take().size(), 4u) << "the event and three periods";
  EXPECT_EQ(card.Read("GT_GetIntr"), 0);
}

// Nobody answers: the first request stays. A handler that is hooked later gets it anew.
TEST(Gt400Interrupt, WaitsForSomebodyToAnswer) {
  InterruptedCard card;
  card.Do("GT_UnhookIsr");
  card.Watch(1, 1);
  card.Complete(1);
  card.Run(3);
  EXPECT_EQ(card.Take().size(), 1u);
  card.Hook();
  card.Cycle();
  EXPECT_EQ(card.Take(), Interrupts{"irq axis 1 0x0B01"});
}

TEST(Gt400Interrupt, WithoutAHandlerThereIsNoneToUnhook) {
  InterruptedCard card;
  card.Do("GT_UnhookIsr");
  card.Refuses(kEmptyMask, "GT_MltiUpdt", {0});
  EXPECT_EQ(card.Call("GT_UnhookIsr"), -1);
  EXPECT_EQ(card.Cause(), kEmptyMask) << "the driver refuses, and the card does not hear of it";
}

TEST(Gt400Interrupt, AResetKeepsTheAnswersOfTheHost) {
  InterruptedCard card;
  card.Watch(1, 1);
  card.Do("GT_SetIntrTm", {5});
  card.Do("GT_TmrIntr");
  card.family.reset(card.family_state);
  card.motion.Reset();
  EXPECT_EQ(card.Read("GT_GetIntrMsk"), 0);
  EXPECT_EQ(card.Read("GT_GetIntrTm"), 0);
  card.Watch(1, 1);
  card.Complete(1);
  EXPECT_EQ(card.Take(), Interrupts{"irq axis 1 0x0B01"}) << "event interrupts again";
  card.Do("GT_UnhookIsr");
}

// --- When the next one can come ----------------------------------------------------------------

TEST(Gt400Interrupt, SaysHowLongNoneCanCome) {
  InterruptedCard card;
  const auto before = [&] { return card.family.cycles_before_interrupt(card.card.view()); };
  EXPECT_EQ(before(), kNeverActs);
  card.Watch(2, 0xFF80);  // the bits of no event
  EXPECT_EQ(before(), kNeverActs);
  card.Do("GT_SetIntrMsk", {1});
  EXPECT_EQ(before(), 1);
  card.Complete(2);
  EXPECT_EQ(before(), kNeverActs) << "one is in service";
  card.Do("GT_TmrIntr");
  EXPECT_EQ(before(), kNeverActs);
  card.Do("GT_SetIntrTm", {10});
  card.Run(4);
  EXPECT_EQ(before(), 6);
}

}  // namespace
}  // namespace oncard::gtcalls::gt400
