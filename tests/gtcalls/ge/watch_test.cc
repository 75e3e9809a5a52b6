// The watch of GE cards. Source: GE manual 10.1.
#include "gtcalls/ge/watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gtcalls/ge/ge_test_card.h"

namespace oncard::gtcalls::ge {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

int16_t SetWatch(GeTestCard* card, std::vector<double> config, double size) {
  config.resize(kAxisMax);
  return card->Call("GT_SetWatch", {size}, &config);
}

TEST(GeWatch, SamplesTheChosenValuesOfEachAxis) {
  GeTestCard card;
  // Axis 1: profile position and velocity; axis 3: actual position.
  ASSERT_EQ(SetWatch(&card, {0b0101, 0, 0b0010}, 2), 0);
  card.Do("GT_StartWatch", {0});
  card.MoveT(1, 1000, 10, 4);
  card.Do("GT_SetAtlPos", {3, 33});
  card.Cycle();
  EXPECT_THAT(card.state().watch.batches.FullBank(), IsEmpty());
  card.Cycle();
  // Velocities of 1 and 2 after 0.25 and 0.5 ms; 1/8 and 1/2 of a pulse.
  EXPECT_THAT(card.state().watch.batches.FullBank(), ElementsAre(0, 1, 33, 1, 2, 33));
}

TEST(GeWatch, LeavesCyclesOutBetweenSamples) {
  GeTestCard card;
  ASSERT_EQ(SetWatch(&card, {kWatchPrfVel}, 3), 0);
  card.Do("GT_StartWatch", {2});
  card.MoveT(1, 1000, 10, 4);
  for (int i = 0; i < 7; ++i) card.Cycle();
  EXPECT_THAT(card.state().watch.batches.FullBank(), ElementsAre(1, 4, 7));
}

TEST(GeWatch, LosesSamplesWhileBothBanksAreFull) {
  GeTestCard card;
  ASSERT_EQ(SetWatch(&card, {kWatchPrfVel}, 2), 0);
  card.Do("GT_StartWatch", {0});
  card.MoveT(1, 1000, 10, 4);
  for (int i = 0; i < 6; ++i) card.Cycle();
  Watch& watch = card.state().watch;
  EXPECT_THAT(watch.batches.FullBank(), ElementsAre(1, 2));
  watch.batches.FreeBank();
  EXPECT_THAT(watch.batches.FullBank(), ElementsAre(3, 4));
  watch.batches.FreeBank();
  EXPECT_THAT(watch.batches.FullBank(), IsEmpty());
  card.Cycle();
  card.Do("GT_StopWatch");
  card.Cycle();
  EXPECT_THAT(watch.batches.FullBank(), IsEmpty());
}

/// The cells of the arrays of eight axes with as many samples; the host has only one of them.
constexpr size_t kArrays = 8 * 5;
constexpr size_t kVelocityOfAxis1 = 2;
std::vector<double> ArraysOfHost(size_t samples) {
  std::vector<double> cells((samples + 1) * kArrays);
  cells[kVelocityOfAxis1] = 1;
  return cells;
}

TEST(GeWatch, GivesAFullBatchToTheArraysOfTheHost) {
  GeTestCard card;
  ASSERT_EQ(SetWatch(&card, {kWatchPrfVel}, 2), 0);
  card.Do("GT_StartWatch", {0});
  card.MoveT(1, 1000, 10, 4);
  card.Cycle();
  std::vector<double> cells = ArraysOfHost(0);
  EXPECT_EQ(card.Call("GT_GetWatch", {}, &cells), 0);
  EXPECT_EQ(cells[0], 0) << "nothing is available yet";
  card.Cycle();
  cells = ArraysOfHost(2);
  EXPECT_EQ(card.Call("GT_GetWatch", {}, &cells), 0);
  EXPECT_EQ(cells[0], 1);
  EXPECT_EQ(cells[kArrays + kVelocityOfAxis1], 1);
  EXPECT_EQ(cells[2 * kArrays + kVelocityOfAxis1], 2);
  EXPECT_THAT(card.state().watch.batches.FullBank(), IsEmpty());
}

TEST(GeWatch, NeedsAnArrayForEachWatchedValue) {
  GeTestCard card;
  ASSERT_EQ(SetWatch(&card, {kWatchPrfVel | kWatchPrfPos}, 1), 0);
  card.Do("GT_StartWatch", {0});
  card.Cycle();
  std::vector<double> cells = ArraysOfHost(1);
  EXPECT_EQ(card.Call("GT_GetWatch", {}, &cells), 7);
  EXPECT_EQ(card.Cause(), kIllegal);
  EXPECT_THAT(card.state().watch.batches.FullBank(), ElementsAre(0, 0));
}

TEST(GeWatch, MustFitABank) {
  GeTestCard card;
  // Five values of eight axes are 72 words.
  const std::vector<double> all(kAxisMax, 0x4F);
  EXPECT_EQ(SetWatch(&card, all, 113), 0);  // 8136 words
  EXPECT_EQ(SetWatch(&card, all, 114), 7);  // 8208
  EXPECT_EQ(SetWatch(&card, {1}, 4096), 0);
  EXPECT_EQ(SetWatch(&card, {1}, 4097), 7);
  EXPECT_EQ(SetWatch(&card, {1}, 0), 7);
}

TEST(GeWatch, NeedsToBeSetUp) {
  GeTestCard card;
  card.Refuses(1, kIllegal, "GT_StartWatch", {0});
  card.Do("GT_StopWatch");
}

}  // namespace
}  // namespace oncard::gtcalls::ge
