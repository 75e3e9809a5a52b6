// Position/time motion through its commands.
#include <gtest/gtest.h>

#include <tuple>

#include "tests/gtcalls/command_test_card.h"
#include "tests/motion/change_state.h"

namespace oncard::gtcalls::gts {
namespace {

double Read(CommandTestCard& card, const char* command, int profile = 1) {
  std::vector<double> value(1);
  EXPECT_EQ(card.Call(command, {profile, &value}), 0) << card.reason.en;
  return value[0];
}

double Space(CommandTestCard& card, int buffer = 0, int profile = 1) {
  std::vector<double> value(1);
  EXPECT_EQ(card.Call("GT_PtSpace", {profile, &value, buffer}), 0) << card.reason.en;
  return value[0];
}

/// The three segments of example 7-3 of the GTS manual.
void SendExample73(CommandTestCard& card, int buffer = 0, int profile = 1) {
  EXPECT_EQ(card.Call("GT_PtData", {profile, 1024, 1024, 0, buffer}), 0);
  EXPECT_EQ(card.Call("GT_PtData", {profile, 3072, 2048, 0, buffer}), 0);
  EXPECT_EQ(card.Call("GT_PtData", {profile, 4096, 3072, 0, buffer}), 0);
}

TEST(PtCommand, Example73) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_PrfPt", {1, 0}), 0);
  EXPECT_EQ(card.Call("GT_PtClear", {1, 0}), 0);
  EXPECT_EQ(Space(card), 32);
  SendExample73(card);
  EXPECT_EQ(Space(card), 29);
  EXPECT_EQ(Read(card, "GT_GetPtRemainder"), 3);
  EXPECT_EQ(card.Call("GT_PtStart", {1, 0}), 0);
  card.Cycles(4 * 512);
  EXPECT_EQ(card.motion.state().profiles[0].now.position, 256);
  EXPECT_EQ(Read(card, "GT_GetPtRemainder"), 2);
  card.Cycles(4 * 2560);
  EXPECT_EQ(card.motion.state().profiles[0].now, motion::AtRest(4096));
  EXPECT_EQ(Read(card, "GT_GetPtLoop"), 1);
  EXPECT_EQ(Space(card), 29);
}

TEST(PtCommand, AllNeedModePt) {
  CommandTestCard card;
  std::vector<double> value(1);
  const uint64_t before = card.Hash();
  EXPECT_EQ(card.Call("GT_SetPtMemory", {1, 0}), 1);
  EXPECT_EQ(card.Call("GT_GetPtMemory", {1, &value}), 1);
  EXPECT_EQ(card.Call("GT_PtSpace", {1, &value, 0}), 1);
  EXPECT_EQ(card.Call("GT_PtData", {1, 0, 1, 0, 0}), 1);
  EXPECT_EQ(card.Call("GT_PtDataWN", {1, 0, 1, 0, 0, 0}), 1);
  EXPECT_EQ(card.Call("GT_PtGetSegNum", {1, &value}), 1);
  EXPECT_EQ(card.Call("GT_GetPtRemainder", {1, &value}), 1);
  EXPECT_EQ(card.Call("GT_PtClear", {1, 0}), 1);
  EXPECT_EQ(card.Call("GT_SetPtLoop", {1, 1}), 1);
  EXPECT_EQ(card.Call("GT_GetPtLoop", {1, &value}), 1);
  EXPECT_EQ(card.Call("GT_PtStart", {1, 0}), 1);
  EXPECT_EQ(card.Hash(), before);
}

TEST(PtCommand, ParametersAreCheckedAtBothEnds) {
  CommandTestCard card;
  EXPECT_EQ(card.Call("GT_PrfPt", {1, 2}), 7);
  EXPECT_EQ(card.Call("GT_PrfPt", {1, -1}), 7);
  EXPECT_EQ(card.Call("GT_PrfPt", {9, 0}), 7);
  EXPECT_EQ(card.Call("GT_PrfPt", {1, 0}), 0);
  EXPECT_EQ(card.Call("GT_SetPtMemory", {1, 2}), 7);
  EXPECT_EQ(card.Call("GT_SetPtMemory", {1, -1}), 7);
  EXPECT_EQ(card.Call("GT_SetPtLoop", {1, -1}), 7);
  EXPECT_EQ(card.Call("GT_SetPtLoop", {1, 0}), 0);
  EXPECT_EQ(card.Call("GT_PtClear", {1, 2}), 7);
  struct {
    double position, time, type, buffer;
    int code;
  } const cases[] = {{1073741823, 1, 0, 0, 0},  {1073741824, 1, 0, 0, 7}, {-1073741823, 1, 2, 1, 0},
                     {-1073741824, 1, 0, 0, 7}, {0, 0, 0, 0, 7},          {0, 2147483647, 1, 0, 0},
                     {0, 1, 3, 0, 7},           {0, 1, -1, 0, 7},         {0, 1, 0, 2, 7},
                     {0, 1, 0, -1, 7}};
  for (const auto& c : cases) {
    for (int buffer = 0; buffer < 2; ++buffer) card.Call("GT_PtClear", {1, buffer});
    EXPECT_EQ(card.Call("GT_PtData", {1, c.position, c.time, c.type, c.buffer}), c.code)
        << c.position << " " << c.time << " " << c.type << " " << c.buffer;
  }
}

TEST(PtCommand, TimesMustGrow) {
  CommandTestCard card;
  card.Call("GT_PrfPt", {1, 0});
  EXPECT_EQ(card.Call("GT_PtData", {1, 10, 100, 0, 0}), 0);
  EXPECT_EQ(card.Call("GT_PtData", {1, 20, 100, 0, 0}), 7);
  EXPECT_EQ(card.Call("GT_PtData", {1, 20, 99, 0, 1}), 0);  // the other buffer has its own times
  EXPECT_EQ(card.Call("GT_PtData", {1, 20, 101, 0, 0}), 0);
}

TEST(PtCommand, AFullBufferTakesNoMore) {
  for (const auto& [mode, memory, size] :
       {std::tuple{0, 0, 32}, {0, 1, 1024}, {1, 0, 64}, {1, 1, 2048}}) {
    CommandTestCard card;
    card.Call("GT_PrfPt", {1, mode});
    EXPECT_EQ(card.Call("GT_SetPtMemory", {1, memory}), 0);
    EXPECT_EQ(Read(card, "GT_GetPtMemory"), memory);
    for (int i = 1; i <= size; ++i) ASSERT_EQ(card.Call("GT_PtData", {1, 0, i, 0, 0}), 0) << i;
    EXPECT_EQ(Space(card), 0);
    const uint64_t before = card.Hash();
    EXPECT_EQ(card.Call("GT_PtData", {1, 0, size + 1, 0, 0}), 1);
    EXPECT_EQ(card.Hash(), before);
    EXPECT_EQ(card.Call("GT_PtClear", {1, 0}), 0);
    EXPECT_EQ(Space(card), size);
  }
}

TEST(PtCommand, TheSizeChangesOnlyWithoutData) {
  CommandTestCard card;
  card.Call("GT_PrfPt", {1, 0});
  SendExample73(card);
  EXPECT_EQ(card.Call("GT_SetPtMemory", {1, 1}), 1);
  EXPECT_EQ(card.Call("GT_SetPtMemory", {1, 0}), 0);
  EXPECT_EQ(card.Call("GT_PtClear", {1, 0}), 0);
  EXPECT_EQ(card.Call("GT_SetPtMemory", {1, 1}), 0);
}

TEST(PtCommand, ARunInMotionRefusesWhatWouldDisturbIt) {
  CommandTestCard card;
  card.Call("GT_PrfPt", {1, 0});
  SendExample73(card, 1);
  EXPECT_EQ(card.Call("GT_PtStart", {1, 0}), 1);  // buffer 1 has no data
  EXPECT_EQ(card.Call("GT_PtStart", {1, 1}), 0);
  card.Cycles(10);
  const uint64_t before = card.Hash();
  EXPECT_EQ(card.Call("GT_PrfPt", {1, 1}), 1);
  EXPECT_EQ(card.Call("GT_SetPtMemory", {1, 0}), 1);
  EXPECT_EQ(card.Call("GT_PtClear", {1, 1}), 1);
  EXPECT_EQ(card.Call("GT_PtStart", {1, 1}), 1);
  EXPECT_EQ(card.Hash(), before);
  EXPECT_EQ(card.Call("GT_PtClear", {1, 0}), 0);
}

TEST(PtCommand, ADynamicRunKeepsBothBuffers) {
  CommandTestCard card;
  card.Call("GT_PrfPt", {1, 1});
  EXPECT_EQ(card.Call("GT_PtStart", {1, 0}), 1);
  SendExample73(card);
  EXPECT_EQ(card.Call("GT_PtStart", {1, 1}), 0);  // the option means nothing
  card.Cycle();
  EXPECT_EQ(card.Call("GT_PtClear", {1, 0}), 1);
  EXPECT_EQ(card.Call("GT_PtClear", {1, 1}), 1);
  card.Cycles(4 * 3072);
  EXPECT_EQ(card.motion.state().profiles[0].now, motion::AtRest(4096));
  EXPECT_EQ(Space(card), 64);
}

TEST(PtCommand, NumbersAreThoseOfTheSegmentInExecution) {
  CommandTestCard card;
  card.Call("GT_PrfPt", {1, 0});
  EXPECT_EQ(card.Call("GT_PtDataWN", {1, 10, 10, 0, -7, 0}), 0);
  EXPECT_EQ(card.Call("GT_PtDataWN", {1, 20, 20, 0, 2147483647, 0}), 0);
  EXPECT_EQ(Read(card, "GT_PtGetSegNum"), 0);
  card.Call("GT_PtStart", {1, 0});
  EXPECT_EQ(Read(card, "GT_PtGetSegNum"), -7);
  card.Cycles(40);
  EXPECT_EQ(Read(card, "GT_PtGetSegNum"), 2147483647);
}

TEST(PtStart, AllProfilesOfTheMaskOrNone) {
  CommandTestCard card;
  for (const int profile : {1, 3}) card.Call("GT_PrfPt", {profile, 0});
  SendExample73(card, 0, 1);
  EXPECT_EQ(card.Call("GT_PtStart", {5, 0}), 1);
  EXPECT_FALSE(card.motion.state().profiles[0].now.moving);
  SendExample73(card, 1, 3);
  EXPECT_EQ(card.Call("GT_PtStart", {5, 4}), 0);
  card.Cycles(2048);
  EXPECT_EQ(card.motion.state().profiles[0].now.position, 256);
  EXPECT_EQ(card.motion.state().profiles[2].now.position, 256);
  EXPECT_EQ(card.Call("GT_PtStart", {0, 0}), 1);
}

TEST(PtStart, IsRefusedWhileAnAlarmIsLatched) {
  CommandTestCard card;
  card.Call("GT_PrfPt", {1, 0});
  SendExample73(card);
  ChangeState(card.motion).axes[0].latched = motion::kAlarmBit;
  EXPECT_EQ(card.Call("GT_PtStart", {1, 0}), 1);
}

}  // namespace
}  // namespace oncard::gtcalls::gts
